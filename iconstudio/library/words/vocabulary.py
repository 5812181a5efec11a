"""The words that names of icons are made of, besides the names of things."""


def words(text: str) -> frozenset[str]:
    """Return the words of ``text``."""
    return frozenset(text.split())


STYLES = words(
    """
    fill filled outline outlined bold line linear duotone duo tone twotone thin light solid
    sharp rounded round regular remix broken baseline block flat stroke fat lineal glyph
    expressive curved basic alt alternative variant alternate o f rtl ltr mono
    monochrome rough bulk badged
    """
)
"""Words that name how a drawing is drawn, not what it shows."""

TYPED_STYLES = {"dark": "solid"}
"""What is typed for a style, but says of a drawing, in its name, that it is of the night."""

STYLE_GROUPS = tuple(
    tuple(words(group) for group in groups.split(","))
    for groups in (
        "fill filled solid glyph flat, outline outlined line linear lineal stroke,"
        "duotone duo tone twotone, bold fat, thin light, broken",
        "round rounded, sharp",
    )
)
"""Words for the same style; and beside them those for the styles that a drawing then has not."""

SOLID, LINES, _, HEAVY, THIN, _ = STYLE_GROUPS[0]
"""Words for drawings that are mostly ink, and for those that are mostly paper; for drawings with
much ink, filled or not, and with little."""

LEADING_STYLES = words(
    """
    outline baseline round sharp twotone rounded outlined solid filled
    """
)
"""Style words that some sets put first."""

NEGATIONS = words(
    """
    no not off slash slashed ban banned disabled disable disallowed prohibited forbidden never
    without non crossed mute muted unavailable negative none xmark
    """
)

BADGES = words(
    """
    plus add added minus remove removed subtract delete deleted check checked checkmark tick x
    cross cancel close closed lock locked unlock unlocked setting settings cog gear edit
    editing search find question exclamation alert alerted warning info information help error
    favorite favourite heart star starred clock time timer history pending sync refresh reload
    update share shared download upload export import arrow arrows up down dollar euro pound
    yen rupee bitcoin money cash percent discount location pin pinned marker wifi wireless
    signal ai sparkle sparkles spark code play pause stop stopped user account person profile
    users group link linked bolt lightning flash bluetooth circle square hexagon octagon
    rectangle triangle diamond box badge bubble dot dots shield protection security secure
    bell notification bookmark tag label flag manager management new all list multiple connect
    connected connection disconnect data chart message chat ok done verified approve approved
    reject success fail scan target move direction git source branch
    broken crack cracked
    """
)
"""Words that, put before or after a thing, mean a small sign on it, a frame around it or damage."""

ATTRIBUTES = words(
    """
    side front back rear top bottom left right center centre half full empty small large big
    medium little tiny giant mini single double simple detailed variation type old new modern
    classic standing sitting running walking jumping flying sleeping lying swimming seated
    riding rampant profile silhouette shape icon symbol sign emoji pictogram open opened
    closed shut one two three four five vertical horizontal diagonal tilted angle angled
    rotated upright view facing up down male female baby cute happy sad angry black white red
    green blue yellow dark cartoon round electric plain generic adult wild domestic farm pet
    pair set variant high low tall short wide long on off forward backward animal vehicle
    transport fast slow
    """
)
"""Words for a pose, a view, a size or a colour: the thing beside them stays what it is."""

PARTS = words(
    """
    face head bust portrait body
    """
)
"""Words for the part of a thing that is often drawn for the whole."""

CARRIERS = words(
    """
    file folder document page window browser laptop monitor calendar map earth globe shield
    tooltip ticket tickets rental repair parking wash charging directions
    """
)
"""Words that, beside a thing, mean what it is shown on, or a sign for what is done with it."""

PREPOSITIONS = words(
    """
    with of and in on for from by above over under inside below beside behind near to at into
    out around or against through beneath the a an
    """
)

PEOPLE = words(
    """
    person people man woman men women human user boy girl child kid rider figure hiker driver
    hand hands worker pedestrian passenger
    """
)

INTERFACE = words(
    """
    arrow chevron caret angle align alignment format text font letter number digit alpha
    numeric border column row grid layout panel sidebar navigation menu list button toggle
    checkbox radio cursor pointer selection crop square circle rectangle triangle hexagon
    octagon pentagon diamond ellipse dot line bracket brace parenthesis hashtag asterisk
    percent plus minus divide equal x check tick cross close add remove edit delete copy cut
    paste undo redo save file folder document page data database table chart graph sort filter
    zoom fullscreen resize move rotate flip swap sync refresh reload download upload export
    import share link signal wifi bluetooth network server cloud code terminal bug api window
    tab header footer heading paragraph quote bullet indent outdent spacing margin padding
    stroke fill layer merge split branch commit fork loop play pause stop record forward
    rewind skip next previous shuffle repeat volume mute
    """
) | {"bulls eye"}
"""Words of interfaces: their drawings are marks, of little use as parts of things."""

TECHNICAL = words(
    """
    charger mount retriever cycle remote pointer setter hunter jumper bay chestnut monitor
    tracker ray driver runner stalker worker browser scanner switch plug base sole perch skate
    carrier stock post beam block board chart deck diamond drum feed frame hub mill pad
    platform port rack ring screen seal shell spool stack tablet tap terminal track trunk
    adapter converter connector cell agent host mole pilot token swift kite ram buffer
    scoter myna lounge boxer springer clipper packer dingo
    thumbnail stream field draw set receiver result tool drone nut weed machine ruler
    """
)
"""Words that collections of icons use for machines and marks, though WordNet also knows a horse,
a dog or a fish of that name: they are no kinds of anything."""

FALSE_FRIENDS = words("doc ref tec eft server doge guardian copilot afters bum git bottom") | {
    "bulls eye",
    "four oclock",
}
"""Words that mean a living being, a dessert, a sole or a lamp in WordNet, but never in a collection
of icons: no other word leads to them."""

FIGURATIVE = frozenset(
    {
        "flying saucer", "poker hand", "session cookie", "silver bullet", "small cap",
        "tic tac toe", "traffic jam", "wind sock",
    }
)  # fmt: skip
"""Names that together mean no thing to WordNet, nor a kind of what their last word means."""

FAMILIAR = STYLES | NEGATIONS | BADGES | ATTRIBUTES | PARTS | PREPOSITIONS | PEOPLE | INTERFACE
"""Words that are not misspelt, whether or not icons are called so."""
