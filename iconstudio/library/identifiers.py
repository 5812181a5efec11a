"""Identifiers ``set:name``: of icons that are there, and what is near to those of others."""

from collections.abc import Callable, Iterable

from iconstudio.library import messages
from iconstudio.library.lookup import Lookup
from iconstudio.library.terms import Rows, Scores
from iconstudio.library.words import coded, query
from iconstudio.library.words.decency import is_rude
from iconstudio.library.words.nearness import nearest

_LOOK_UP = " Search for what it shows instead, with a word such as 'dog'."
_OTHERS = " Those of other sets are shown."
_ONCE = " Of icons that look alike it has one."


class Identifiers:
    """Looks identifiers up in the ``sets`` of a collection.

    ``rows`` asks the database; ``choose`` returns some of the icons with scores, the best first.
    """

    def __init__(
        self,
        rows: Rows,
        lookup: Lookup,
        sets: frozenset[str],
        choose: Callable[[Scores, int], list[int]],
    ) -> None:
        self._rows = rows
        self._lookup = lookup
        self._sets = sets
        self._choose = choose

    def numbers(self, identifiers: Iterable[str]) -> list[int]:
        """Return the numbers of the icons that are there."""
        ask = "SELECT number FROM icon WHERE id = ?"
        return [row[0] for one in identifiers for row in self._rows(ask, (one,))]

    def unknown(self, identifier: str) -> str:
        """Return that there is no such icon, and what is near, or what to do."""
        return self._without(identifier, self._near(identifier), _LOOK_UP)

    def missing(self, keyword: str) -> str:
        """Return that there is no icon of an identifier in its set, where others are found.

        Empty for what is no identifier, or one of an icon that is there.
        """
        if foreign := messages.no_set(keyword, self._sets):
            return foreign
        meant = self._read(keyword)
        if not meant or self.numbers(query.identifiers(keyword, self._sets)):
            return ""
        prefix = meant.partition(":")[0]
        near = tuple(one for one in self._near(meant) if one.startswith(f"{prefix}:"))
        return self._without(meant, near, _OTHERS)

    def near_to(self, keyword: str) -> tuple[str, ...]:
        """Return identifiers near to the one that a keyword is; none if it is none."""
        meant = self._read(keyword)
        return self._near(meant) if meant else ()

    def _read(self, keyword: str) -> str:
        """Return the identifier in a set that is here which a keyword is; empty if it is none."""
        spelt = query.identifiers(keyword, self._sets) if coded.names_set(keyword) else ()
        return next(iter(spelt), "")

    def _without(self, identifier: str, near: tuple[str, ...], advice: str) -> str:
        """Return that there is no such icon, and what is near, or else an advice."""
        prefix, _, name = identifier.partition(":")
        named = any(f"-{name}-" in f"-{one.partition(':')[2]}-" for one in near)
        once = _ONCE if prefix in self._sets and named else ""
        return (
            f"The collection has no icon '{messages.shortened(identifier)}'.{once}"
            f"{messages.hint(near) or advice}"
        )

    def _near(self, identifier: str) -> tuple[str, ...]:
        """Return identifiers of that name, those of the same set first, or else spelt alike."""
        prefix, _, name = identifier.rpartition(":")
        if is_rude(query.plain(name)):
            return ()
        ask = "SELECT number, id FROM icon WHERE id GLOB ?"
        own: dict[int, str] = dict(self._rows(ask, (f"{glob(prefix)}:*",)))
        scores = self._lookup.scores(name)
        if not own.keys() & scores.keys():
            if alike := nearest(name, [query.name(one) for one in own.values()]):
                return tuple(f"{prefix}:{one}" for one in alike)
            meant = map(self._lookup.scores, self._lookup.suggestions(name))
            scores = next((one for one in meant if own.keys() & one.keys()), scores)
        in_set = {number: score for number, score in scores.items() if number in own}
        named = dict.fromkeys((*self._choose(in_set, 2), *self._choose(scores, 4)))
        called = self._lookup.identifiers(named)
        return tuple(called[number] for number in named)[:4]


def glob(text: str) -> str:
    """Return a text as GLOB finds it, its signs meaning themselves."""
    return "".join(f"[{c}]" if c in "*?[" else c for c in text)
