"""What an icon's name says: its style, its size, its badges, and the words that are left.

``dog-side-24-filled`` draws "dog side", filled, for 24 pixels.
"""

import re
from dataclasses import dataclass

from iconstudio.library.words.vocabulary import LEADING_STYLES, NEGATIONS, STYLES
from iconstudio.library.words.vocabulary import words as word_set

_SIZES = word_set("8 10 12 14 15 16 18 20 21 22 24 25 26 28 30 32 36 40 42 44 48 56 64 72 96 128")
_TAIL_NUMBER = re.compile(r"(?<=[a-z]{2})x?\d{1,2}$")


@dataclass(frozen=True, slots=True)
class Name:
    """A name taken apart."""

    words: tuple[str, ...]
    """What is drawn, lower case, without numbers, style and size."""
    styles: tuple[str, ...] = ()
    size: int | None = None
    """Pixels that the drawing is meant for; None if the name does not say."""
    variant: tuple[str, ...] = ()
    """Numbers that tell drawings of one thing apart."""

    @property
    def phrase(self) -> str:
        """The words, joined by spaces."""
        return " ".join(self.words)

    @property
    def drawing(self) -> tuple[str, ...]:
        """The same for two icons of a set exactly if they differ in size alone."""
        return (*self.words, "|", *self.styles, "|", *self.variant)


def take_apart(name: str) -> Name:
    """Return the parts of an icon's name, whose words are joined by hyphens."""
    tokens = [token for token in re.split(r"[-_\s.]+", name.lower()) if token]
    words: list[str] = []
    styles: list[str] = []
    variant: list[str] = []
    size: int | None = None
    for position, token in enumerate(tokens):
        number = token.removesuffix("px").removesuffix("dp")
        if position and number in _SIZES and _ends(tokens[position + 1 :]):
            size = int(number)
        elif position and token in STYLES and not _keeps(tokens, position):
            styles.append(token)
        elif number.isdigit() or (position and len(token) == 1 and not _says(tokens, position)):
            variant.append(token)
        else:
            bare = without_number(token)
            if bare != token:
                variant.append(token[len(bare) :])
            words.append(bare)
    if not words:
        words, styles = tokens, []
    while len(words) > 1 and words[0] in LEADING_STYLES:
        styles.append(words.pop(0))
    return Name(tuple(words), tuple(styles), size, tuple(variant))


def without_number(word: str) -> str:
    """Return a word without the number at its end: *mp3* as *mp*."""
    return _TAIL_NUMBER.sub("", word)


_KEPT = {
    "light": word_set(
        "traffic street flash head night stage spot brake tail pot wall ceiling floor track "
        "warning signal christmas bike fog rear sun moon day siren emergency search "
        "strip string lime"
    ),
    "line": word_set("clothes fishing zip power pipe chalk bee"),
    "glyph": word_set("hiero"),
    "o": word_set("jack"),
    "broken": word_set(
        "bone cd chain dental disc document file glass goblet heart ice image link location "
        "shield trophy"
    ),
}


def _ends(rest: list[str]) -> bool:
    return all(token in STYLES for token in rest)


def _says(tokens: list[str], position: int) -> bool:
    """Whether a letter is a word: an *x* with a circle, a jack *o* lantern."""
    return tokens[position] == "x" or _keeps(tokens, position)


def _keeps(tokens: list[str], position: int) -> bool:
    """Whether a style word belongs to the thing: a traffic *light*, a clothes *line*."""
    return tokens[position - 1] in _KEPT.get(tokens[position], frozenset())


def is_negated(words: tuple[str, ...]) -> bool:
    """Whether a name says that the thing is absent, forbidden or switched off."""
    return any(word in NEGATIONS for word in words)
