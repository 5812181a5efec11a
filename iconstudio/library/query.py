"""What somebody types to find icons, made plain: accents, emoji, hyphens, styles, identifiers.

An emoji stands for its Unicode name; so does any other symbol.
"""

import re
import unicodedata
from collections.abc import Iterator

from iconstudio.library.naming import take_apart
from iconstudio.library.vocabulary import PREPOSITIONS, STYLES
from iconstudio.library.wordnet import singulars

_LETTERS = str.maketrans(
    {"ß": "ss", "æ": "ae", "œ": "oe", "ø": "o", "đ": "d", "ð": "d", "þ": "th", "ł": "l", "ı": "i"}
)
"""Letters that Unicode does not compose from others."""
_APOSTROPHES = re.compile(r"['\u2018\u2019\u02bc`]")
_FRAMING = {"black", "white", "heavy", "suit", "sign", "symbol", "building", "face"}
"""Words of the names of symbols that say nothing of the thing: "black heart suit"."""


def plain(keyword: str) -> str:
    """Return the words of a keyword in lower case, without accents, joined by spaces."""
    spoken = "".join(_spoken(character) for character in keyword)
    bare = "".join(
        character
        for character in unicodedata.normalize("NFKD", spoken)
        if not unicodedata.combining(character)
    )
    bare = _APOSTROPHES.sub("", bare.replace("&", " and ")).casefold().translate(_LETTERS)
    return " ".join(re.findall(r"[^\W_]+", bare))


def _spoken(character: str) -> str:
    """Return a symbol's name between spaces; a letter as it is; nothing for what only joins."""
    if unicodedata.category(character) not in ("So", "Sk", "Cf", "Mn"):
        return character
    name = unicodedata.name(character, "")
    if unicodedata.category(character) == "So" and not name.startswith("REGIONAL INDICATOR"):
        return f" {name.lower()} "
    return character if unicodedata.combining(character) else " "


def has_symbols(keyword: str) -> bool:
    """Whether a keyword holds an emoji or another symbol that has a name."""
    return any(unicodedata.category(character) == "So" for character in keyword)


def is_latin(keyword: str) -> bool:
    """Whether all letters of a keyword are Latin, with accents or without."""
    return all(
        unicodedata.name(character, "").startswith("LATIN")
        for character in unicodedata.normalize("NFKD", keyword)
        if character.isalpha()
    )


def forms(words: str) -> list[str]:
    """Return what plain words may be listed as: as they are, and in the singular."""
    listed = [words, *singulars(words), words + "s"]  # a scissor
    return list(dict.fromkeys(form for form in listed if form.strip()))


def joined(words: str) -> str:
    """Return words in one: *fire truck* as *firetruck*."""
    return words.replace(" ", "")


def halves(word: str) -> Iterator[tuple[str, str]]:
    """Yield all pairs of words that one may have been joined from."""
    for cut in range(1, len(word)):
        yield word[:cut], word[cut:]


_KINDS_OF_PICTURES = ("icon", "icons", "pictogram", "pictograms")


def without_style(words: tuple[str, ...]) -> tuple[str, ...]:
    """Return words without those that say how the thing is drawn, and without numbers."""
    core = tuple(word for word in words if word not in _KINDS_OF_PICTURES) or words
    core = take_apart("-".join(core)).words
    while len(core) > 1 and core[0] in STYLES:
        core = core[1:]
    return core


def without_framing(words: tuple[str, ...]) -> tuple[str, ...]:
    """Return words without those at either end that only the names of symbols have."""
    while len(words) > 1 and words[0] in _FRAMING:
        words = words[1:]
    while len(words) > 1 and words[-1] in _FRAMING:
        words = words[:-1]
    return words


def telling(words: tuple[str, ...]) -> tuple[str, ...]:
    """Return words without articles and prepositions, unless there are no others."""
    return tuple(word for word in words if word not in PREPOSITIONS) or words


def identifiers(text: str, prefixes: frozenset[str]) -> Iterator[str]:
    """Yield the identifiers ``set:name`` that a text may stand for in another spelling.

    *mdi-home*, *mdi/home*, *i-mdi-home*, *icon-[mdi--home]*, *MDI:Home*, *mdiHome*.
    """
    parted = re.sub(r"(?<=[a-z0-9])(?=[A-Z])", "-", text.strip())
    tokens = re.findall(r"[a-z0-9]+", parted.casefold())
    if tokens[:1] in (["i"], ["icon"], ["iconify"]):
        tokens = tokens[1:]
    for count in range(len(tokens) - 1, 0, -1):
        prefix = "-".join(tokens[:count])
        if prefix in prefixes:
            yield f"{prefix}:{'-'.join(tokens[count:])}"
