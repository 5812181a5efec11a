"""How else a keyword may be spelt: joined or parted, as icons are called."""

from collections.abc import Callable, Iterable, Sequence
from itertools import pairwise
from typing import Any

from iconstudio.library.words import query

Rows = Callable[[str, Sequence[Any]], list[tuple[Any, ...]]]
"""Runs a query with values, and returns its rows."""

_SHORT = 4
"""Of a keyword of so many words each, and each two together, are spelt as icons spell them."""


class Spellings:
    """Spells keywords. ``rows`` asks the database."""

    def __init__(self, rows: Rows) -> None:
        self._rows = rows

    def of(self, words: tuple[str, ...]) -> list[tuple[str, ...]]:
        """Return words as they are, and as icons have them, in one or parted.

        So a word with a hyphen finds what it finds joined and in several words.
        """
        found = [words, ("".join(words),)]
        if len(words) <= _SHORT:
            known = self._known(first + second for first, second in pairwise(words))
            found += (one for one in query.joinings(words) if not known.isdisjoint(one))
            for place, word in enumerate(words):
                for parted in sorted(self._known(query.partings(word))):
                    found.append((*words[:place], *parted.split(), *words[place + 1 :]))
        return list(dict.fromkeys(found))

    def _known(self, terms: Iterable[str]) -> set[str]:
        """Return which of some terms icons are called by, or lead to icons."""
        wanted = list(dict.fromkeys(terms))
        marks = ",".join("?" * len(wanted))
        sql = (
            f"SELECT term FROM reading WHERE term IN ({marks}) "
            f"UNION SELECT word FROM relation WHERE word IN ({marks})"
        )
        return {row[0] for row in self._rows(sql, wanted * 2)}
