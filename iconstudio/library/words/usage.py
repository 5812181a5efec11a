"""What collections of icons mean by words, and designers, where WordNet says something else."""


def _listed(text: str) -> dict[str, tuple[str, ...]]:
    """Return word: terms, of a text of "word: term term, word: term, ..."."""
    pairs = (pair.strip().partition(": ") for pair in text.split(","))
    return {word: tuple(terms.split()) for word, _, terms in pairs}


USAGE = {
    "bike": "bicycle",
    "plane": "airplane",
    "chicken": "hen",
    "mouse": "rodent",
    "glass": "drinking glass",
    "lamb": "sheep",
    "turkey": "fowl",
    "apple": "fruit",
    "boot": "footwear",
    "crane": "lifting device",
    "tank": "vehicle",
}
"""What collections of icons mean by a word, where WordNet puts another meaning first."""

SYNONYMS = (
    "home house", "bike bicycle", "motorbike motorcycle", "plane airplane aeroplane aircraft",
    "couch sofa settee", "puppy dog", "kitten cat", "bunny rabbit", "hare rabbit",
    "phone telephone", "tv television", "car automobile auto", "truck lorry", "hen chicken",
    "pc computer", "ship boat", "cup mug", "cow cattle", "pony horse", "lamp lantern",
    "flashlight torch", "glasses eyeglasses spectacles", "bulb lightbulb", "rocket spaceship",
    "present gift", "bag handbag", "purse handbag", "photo photograph", "film movie",
    "cactus cacti", "helicopter chopper", "ax axe", "donut doughnut", "airplane airliner",
    "sneaker trainer", "trashcan bin", "bin trash", "sailboat boat", "eggplant aubergine",
    "subway metro", "shop store", "mailbox postbox", "suitcase luggage", "gear cog cogwheel",
    "pitcher jug", "tap faucet", "t_rex tyrannosaurus dinosaur",
)  # fmt: skip
"""Words that collections of icons use for the same drawing."""

STAND_INS = _listed(
    """
    alligator: lizard reptile, ankle: foot, antelope: deer, baker: chef cook, basil: herb leaf,
    beak: bird, belly: stomach body, blouse: shirt, bobsled: sled sledge, bonfire: campfire fire,
    braid: hair, calf: cow, casket: coffin, cheek: face, chickpea: bean,
    chimpanzee: monkey gorilla, chin: face, cod: fish, cooler: refrigerator, creche: nursery,
    crocodile: lizard reptile, cub: bear, eyelid: eye, feast: meal dinner, ferret: otter badger,
    fig: fruit, gazelle: deer, gymnast: gymnastics, hay: haystack, hornet: wasp bee,
    hovercraft: boat, jackal: wolf dog, jade: gem gemstone, jockey: horse, jungle: forest tree,
    kilt: skirt, lamb: sheep, lampshade: lamp, lemur: monkey, lentil: bean, lifeboat: boat,
    lioness: lion, locket: necklace, lute: guitar, meadow: grass, mink: otter badger,
    mint: leaf herb, moth: butterfly, mud: puddle, mule: donkey horse, nectarine: fruit,
    nostril: nose, oboe: clarinet flute, ointment: medicine, omelette: egg, opal: gem gemstone,
    orca: whale, oregano: herb leaf, ox: cow cattle, papaya: fruit, parachutist: parachute,
    paragliding: parachute, parsley: herb leaf, photocopier: printer, plank: wood,
    pomegranate: fruit, porch: house, pouch: bag, princess: queen, raisin: fruit, ravioli: pasta,
    rosemary: herb leaf, rye: wheat, sage: herb leaf, saint bernard: dog, salmon: fish,
    samosa: dumpling, sardine: fish, seashell: shell, shawl: scarf, shoelace: shoe,
    sieve: strainer filter, snout: nose, snowball: snow, stingray: fish, stirrup: saddle,
    tablecloth: table, tailor: sewing, thimble: sewing, thistle: flower, thyme: herb leaf,
    toe: foot, trapdoor: door, tricycle: bicycle, tuna: fish, verandah: house, warrior: knight,
    warthog: pig, washbasin: sink, wasp: bee, weasel: otter badger, whirlpool: spiral,
    yak: ox cow, zither: harp guitar
    """
)
"""What is taken for a thing that has no drawings, or few."""
