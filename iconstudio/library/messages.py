"""What is said of how a keyword was read, and of what is near it."""

import re
from collections.abc import Iterable, Set

from iconstudio.library.phrases import Answer
from iconstudio.library.words import query, symbols
from iconstudio.library.words.naming import is_negated

THING = "Name the thing to draw, such as 'dog'."
ENGLISH = (
    "Icons have English names, and logos of brands are left out: "
    "try another English word for the thing."
)
FORBIDDING = "Signs of what is forbidden, or switched off, are left out."
FLAGS = "Flags of countries are left out: in one colour, they are not told apart."
NO_SIGNS = "the collection has hardly any signs of what is forbidden, or switched off."
ALL_WORDS = "No icon has all of these words"
_IDENTIFIER = re.compile(r"([a-z0-9]+(?:-[a-z0-9]+)*):[a-z0-9]+(?:-[a-z0-9]+)*")
_LONGEST = 60
"""Most characters of a keyword that a message repeats."""


def said(keyword: str) -> str:
    """Return a keyword as a message has it: quoted, a symbol with its name."""
    name = query.plain(keyword) if symbols.has_symbols(keyword) else ""
    return f"'{shortened(keyword.strip())}'" + (f" ({name})" if name else "")


def shortened(text: str) -> str:
    """Return a text that is too long to be repeated without its end."""
    return text if len(text) <= _LONGEST else f"{text[:_LONGEST]}…"


def hint(near: tuple[str, ...]) -> str:
    """Return what else may have been meant, if anything, after a blank."""
    return f" Did you mean {', '.join(near)}?" if near else ""


def all_excluded(keyword: str) -> str:
    """Return that all icons of a keyword are left out."""
    return f"Every icon for {said(keyword)} is excluded. Exclude fewer."


def no_set(identifier: str, sets: Set[str]) -> str:
    """Return that none of the ``sets`` is that of an identifier; empty if one is, or it is none."""
    found = _IDENTIFIER.fullmatch(identifier.strip())
    if found is None or found[1] in sets:
        return ""
    return f"The collection has no set “{shortened(found[1])}”: icons of other sets are shown."


def remark(
    answer: Answer,
    near: tuple[str, ...],
    wider: tuple[str, ...] = (),
    unheeded: tuple[str, ...] = (),
) -> str:
    """Return how words were read if not as typed, and what else may have been meant.

    ``wider`` are those of them that more icons answer, ``unheeded`` those for a style that none is
    said to have.
    """
    if not answer:
        return ""
    sentences = [corrected(answer.read_as)] if answer.read_as else []
    if answer.left_out:
        were = "was" if len(answer.left_out) == 1 else "were"
        words = f"{named(answer.left_out)} {were} left out"
        negated = is_negated(answer.left_out)
        sentences.append(f"{words}: {NO_SIGNS}" if negated else f"{ALL_WORDS}: {words}.")
    if answer.looked_up:
        sentences.append(only(answer))
    if wider:
        sentences.append(f"Few icons are of these words together; more are of {named(wider)}.")
    if unheeded:
        sentences.append(
            f"No icon of it is called {named(unheeded)}: those of other styles are shown."
        )
    return (" ".join(sentences) + hint(near)).strip()


def named(words: tuple[str, ...]) -> str:
    """Return words in a sentence."""
    *before, last = (f"“{word}”" for word in words)
    return f"{', '.join(before)} and {last}" if before else last


def corrected(read_as: Iterable[tuple[str, str]]) -> str:
    """Return which words were taken for others."""
    return " ".join(f"“{typed}” was read as “{right}”." for typed, right in read_as)


def only(answer: Answer) -> str:
    """Return that not all words were looked up, if so."""
    return f"Only the first {answer.looked_up} words were looked up." if answer.looked_up else ""
