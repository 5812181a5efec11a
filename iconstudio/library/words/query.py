"""What somebody types to find icons, made plain: accents, emoji, hyphens, styles, identifiers.

An emoji stands for its name, and so does any other symbol.
"""

import re
import unicodedata
from collections.abc import Iterator
from dataclasses import dataclass
from itertools import takewhile

from iconstudio.library.words import symbols
from iconstudio.library.words.coded import of_one, uncoded
from iconstudio.library.words.inflections import singulars, verbs
from iconstudio.library.words.naming import Name, take_apart
from iconstudio.library.words.usage import INFORMAL
from iconstudio.library.words.vocabulary import (
    ATTRIBUTES,
    HEAVY,
    LINES,
    PREPOSITIONS,
    SOLID,
    STYLE_GROUPS,
    STYLES,
    THIN,
    TYPED_STYLES,
)

_LETTERS = str.maketrans(
    {"ß": "ss", "æ": "ae", "œ": "oe", "ø": "o", "đ": "d", "ð": "d", "þ": "th", "ł": "l", "ı": "i"}
)
"""Letters that Unicode does not compose from others."""
_SIGNS = (
    (r"['\u2018\u2019\u02bc`]", ""),
    ("&", " and "),
    (r"(?<=[a-z])\+\+", " plus plus"),
    (r"\b([acf])#", r"\1 sharp"),
    (r"(?:^|\basp)\.net\b", "dotnet"),
    (r"(?<=\d)\s*%", " percent"),
    (r"\btwo[\s_-]tone\b", "twotone"),
)
"""Signs within words, and how they are read: *C++*, *C#*, *50%*."""
_ALONE = {
    "@": "at sign", "#": "hashtag", "$": "dollar", "\u20ac": "euro", "\u00a3": "pound",
    "\u00a5": "yen", "%": "percent", "&": "ampersand", "*": "asterisk", "+": "plus", "-": "minus",
    "=": "equal", "?": "question mark", "!": "exclamation mark",
}  # fmt: skip
"""Signs that are looked for on their own."""
_LONGEST = 24
"""Most letters of a word that is taken for several."""
_PARTS = 3
"""Most words that one is parted into, or joined from."""
_PARTICLES = {"off", "out", "in", "up", "down", "over", "back"}
"""What verbs are joined with to nouns: *plane taking off*, *takeoff*."""
_FRAMING = {
    "black", "white", "heavy", "red", "blue", "green", "orange", "yellow", "purple", "brown",
    "grey", "pink", "suit", "sign", "symbol", "building", "face", "button",
}  # fmt: skip
"""Words of the names of symbols that say nothing of the thing: "black heart suit"."""
_FOLK = {
    "man", "men", "woman", "women", "person", "people", "adult", "boy", "girl", "child", "mx",
}  # fmt: skip
_FACING = {"facing", "right"}
"""Where such people look to."""


def plain(keyword: str) -> str:
    """Return the words of a keyword in lower case, without accents, joined by spaces."""
    spoken = "".join(map(_joining, symbols.spoken(uncoded(keyword))))
    if named := _ALONE.get(spoken.strip()):
        return named
    bare = "".join(
        character
        for character in unicodedata.normalize("NFKD", spoken)
        if not unicodedata.combining(character)
    )
    bare = bare.casefold().translate(_LETTERS)
    for written, read in _SIGNS:
        bare = re.sub(written, read, bare)
    return " ".join(re.findall(r"[^\W_]+", bare))


def name(identifier: str) -> str:
    """Return what an icon is called in its set: *home* of *mdi:home*."""
    bare = of_one(identifier).rpartition(":")[2]
    return bare if plain(bare) else identifier


def _joining(character: str) -> str:
    """Return a blank for what stands alone but is no letter; nothing else is changed."""
    alone = unicodedata.category(character) in ("Sk", "Cf", "Mn")
    return " " if alone and not unicodedata.combining(character) else character


def is_latin(keyword: str) -> bool:
    """Whether all letters of a keyword are Latin, with accents or without."""
    return all(
        unicodedata.name(character, "").startswith("LATIN")
        for character in unicodedata.normalize("NFKD", keyword)
        if character.isalpha()
    )


def forms(words: str) -> list[str]:
    """Return what plain words may be listed as: as they are, in the singular, and in one word."""
    listed = [words, *singulars(words), words + "s", joined(words)]  # a scissor
    return list(dict.fromkeys(form for form in listed if form.strip()))


def joined(words: str) -> str:
    """Return words in one: *fire truck* as *firetruck*."""
    return words.replace(" ", "")


def halves(word: str) -> Iterator[tuple[str, str]]:
    """Yield all pairs of words that one may have been joined from."""
    for cut in range(1, len(word)):
        yield word[:cut], word[cut:]


def partings(word: str) -> Iterator[str]:
    """Yield what a word, or its singular, may be in two or ``_PARTS`` words; none if it is long."""
    for form in (word, *singulars(word)):
        for first, rest in halves(form) if len(form) <= _LONGEST else ():
            yield f"{first} {rest}"
            yield from (f"{first} {second} {third}" for second, third in halves(rest))


def joinings(words: tuple[str, ...]) -> Iterator[tuple[str, ...]]:
    """Yield words with two neighbours in one each time: *wi fi router* as *wifi router*."""
    for i in range(1, len(words)):
        yield (*words[: i - 1], words[i - 1] + words[i], *words[i + 1 :])


def phrasal(words: tuple[str, ...]) -> Iterator[tuple[str, ...]]:
    """Yield words with a verb in the form in which names join it with what follows: *takeoff*."""
    for i in range(1, len(words)):
        if words[i] in _PARTICLES:
            for verb in verbs(words[i - 1]):
                yield (*words[: i - 1], verb + words[i], *words[i + 1 :])


def spelt_out(words: tuple[str, ...]) -> tuple[str, ...]:
    """Return words with what informal ones among them stand for: *xmas tree*, *christmas tree*."""
    meant: list[str] = []
    start = 0
    while start < len(words):
        for end in range(min(start + _PARTS, len(words)), start, -1):
            one = "".join(words[start:end])
            if formal := next((INFORMAL[w] for w in (one, *singulars(one)) if w in INFORMAL), None):
                break
        meant += formal or words[start:end]
        start = end
    return tuple(meant)


_KINDS_OF_PICTURES = ("icon", "icons", "pictogram", "pictograms")


def without_style(words: tuple[str, ...]) -> tuple[str, ...]:
    """Return words without those that say how the thing is drawn, and without numbers."""
    core = tuple(word for word in words if word not in _KINDS_OF_PICTURES) or words
    core = take_apart("-".join(core)).words
    while len(core) > 1 and (core[0] in STYLES or core[0] in TYPED_STYLES):
        core = core[1:]
    return core


SILENT = 3
"""What a name says of a style that it does not mention."""


@dataclass(frozen=True, slots=True)
class Style:
    """A style that a keyword asks for."""

    words: frozenset[str] = frozenset()
    """What it is called."""
    others: frozenset[str] = frozenset()
    """What other styles are called: a filled drawing is no outline."""
    solid: bool | None = None
    """Whether the drawing is to be solid, or else of lines; None if either will do."""
    thing: frozenset[str] = frozenset()
    """What else the keyword says."""

    def adds(self, name: Name) -> bool:
        """Whether a name says that more is drawn than the thing, however that stands or looks."""
        more = [one for one in name.words if one not in self.thing and one not in ATTRIBUTES]
        return len(more) > len(self.thing.difference(name.words))

    def strangeness(self, name: Name) -> int:
        """Return how much a name says beside the thing: more words, several of it, a variant."""
        several = not self.thing.issubset(name.words)
        return 3 * len(name.words) + 2 * several + bool(name.variant)

    def distance(self, name: str) -> int:
        """Return 0 if a name says that the drawing has the style, 2 if another, 1 if both.

        ``SILENT`` if it says neither.
        """
        tokens = set(re.split("[^a-z0-9]+", name))
        own, other = not tokens.isdisjoint(self.words), not tokens.isdisjoint(self.others)
        return 1 + other - own if own or other else SILENT


def style(words: tuple[str, ...]) -> Style:
    """Return the style that words ask for beside the thing, and its numbers."""
    thing = frozenset(without_style(words))
    dropped = set(words) - thing
    asked = {TYPED_STYLES.get(word, word) for word in dropped}
    asked = {word for word in asked if word in STYLES or word.isdigit()}
    same: set[str] = set(asked)
    others: set[str] = set()
    for groups in STYLE_GROUPS:
        if asked & frozenset().union(*groups):
            same.update(*(group for group in groups if group & asked))
            others.update(*groups)
    solid = bool(asked & (SOLID | HEAVY))
    if solid == bool(asked & (LINES | THIN)):
        return Style(frozenset(same), frozenset(others - same), None, thing)
    contrary = {"half", "empty" if solid else "full"}
    return Style(frozenset(same), frozenset((others - same) | (contrary - thing)), solid, thing)


def without_framing(words: tuple[str, ...]) -> tuple[str, ...]:
    """Return words without those at either end that only the names of symbols have."""
    while len(words) > 1 and words[0] in _FRAMING:
        words = words[1:]
    while len(words) > 1 and words[-1] in _FRAMING:
        words = words[:-1]
    return words


def without_people(words: tuple[str, ...]) -> tuple[str, ...]:
    """Return words without whom the names of joined symbols show, unless there are no others.

    *woman firefighter* as *firefighter*, *family man woman girl* as *family*, *man in tuxedo* as
    *tuxedo*.
    """
    left = words
    while left and left[0] in _FOLK | PREPOSITIONS:
        left = left[1:]
    while left and left[-1] in _FOLK | _FACING:
        left = left[:-1]
    return left or words


def headed(words: tuple[str, ...]) -> str:
    """Return what words name up to the first preposition: *couple with heart* as *couple*."""
    return " ".join(takewhile(lambda word: word not in PREPOSITIONS, words))


def telling(words: tuple[str, ...]) -> tuple[str, ...]:
    """Return words without articles and prepositions, unless there are no others."""
    return tuple(word for word in words if word not in PREPOSITIONS) or words


def tells(word: str) -> bool:
    """Whether a word says something of the thing, and not only how it is drawn."""
    only_how = STYLES.union(TYPED_STYLES, _KINDS_OF_PICTURES)
    return word not in PREPOSITIONS and word not in only_how


def identifiers(text: str, prefixes: frozenset[str]) -> Iterator[str]:
    """Yield the identifiers ``set:name`` that a text may stand for in another spelling.

    *mdi-home*, *mdi mdi-home*, *mdi/home*, *i-mdi-home*, *icon-[mdi--home]*, *MDI:Home*, *mdiHome*.
    """
    parted = re.sub(r"(?<=[a-z0-9])(?=[A-Z])", "-", of_one(text))
    tokens = re.findall(r"[a-z0-9]+", parted.casefold())
    if tokens[:1] in (["i"], ["icon"], ["iconify"]):
        tokens = tokens[1:]
    most = max((prefix.count("-") + 1 for prefix in prefixes), default=0)
    for count in range(min(len(tokens) - 1, most), 0, -1):
        prefix = "-".join(tokens[:count])
        if prefix in prefixes:
            yield f"{prefix}:{'-'.join(tokens[count:])}"
