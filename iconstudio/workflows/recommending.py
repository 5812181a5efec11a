"""Which result of a row to look at first.

An icon that comes out as it went in is no remix, and is named only where it is plausible and no
remix is.
"""

from collections import defaultdict
from collections.abc import Generator, Iterable, Sequence

from iconstudio.model import Composite, Remix
from iconstudio.workflows.events import Event, Recommended, Result

UNTOUCHED = 0.98
"""A source with this part of the ink is the result, but for crumbs."""

PLAUSIBLE = 0.5
"""Least probability of a result that is called plausible."""

NEARLY = 0.9
"""A result that was made symmetric comes first from this part of the best one's score on."""


class Recommending:
    """Names the best result of each style once all ``count`` are there.

    With ``alone``, an icon by itself is as good as a remix: a part was taken off it before.
    """

    def __init__(self, count: int, alone: bool = False) -> None:
        self._count = count
        self._alone = alone
        self._remixes: dict[str, list[Remix]] = {}
        self.inside: float | None = None
        """How much the best of what was named shows of what was drawn inside; None: of nothing."""

    def after(self, events: Iterable[Event]) -> Generator[Event]:
        """Pass events on, with a ``Recommended`` after the last result of a style."""
        for event in events:
            yield event
            match event:
                case Result(icon=Remix() as icon, preview=False):
                    style = icon.composite.style
                    row = self._remixes.setdefault(style, [])
                    row.append(icon)
                    if len(row) == self._count:
                        yield Recommended(style, self._name(row))

    def _name(self, row: Sequence[Remix]) -> float | None:
        best = best_of(row, self._alone)
        if best is None:
            return None
        self.inside = max(self.inside or 0.0, best.score.inside)
        return best.composite.lambda_s


def best_of(row: Sequence[Remix], alone: bool = False) -> Remix | None:
    """Return the best remix of a row, or an icon as it went in if that must stand for one.

    Where the outline is nearly symmetric, one that is quite so comes first if it is nearly as good.
    Of equals, that of the highest lambda_S: a row comes in any order. ``alone`` is as in
    ``Recommending``.
    """
    remixes = [one for one in row if alone or not _is_untouched(one.composite)]
    best = _first(remixes)
    even = _first(one for one in remixes if one.composite.symmetry is not None)
    if best is not None and even is not None and even.score.total >= NEARLY * best.score.total:
        best = even
    if best is not None and _is_plausible(best):
        return best
    untouched = (one for one in row if _is_untouched(one.composite))
    return _first(filter(_is_plausible, untouched)) or best


def _is_untouched(composite: Composite) -> bool:
    """Return whether nearly all of a result is one source, or one source and its mirror image."""
    if composite.symmetry is None:
        return max(composite.shares) >= UNTOUCHED
    shares: dict[tuple[str, float, int], float] = defaultdict(float)
    for source, share in zip(composite.sources, composite.shares, strict=True):
        shares[source.exemplar.id, source.placement.scale, source.placement.dy] += share
    return max(shares.values()) >= UNTOUCHED


def _first(icons: Iterable[Remix]) -> Remix | None:
    """Return the best, if any is good for anything."""
    some = [one for one in icons if one.score.total > 0]
    return max(some, key=lambda one: (one.score.total, one.composite.lambda_s), default=None)


def _is_plausible(icon: Remix) -> bool:
    return (icon.score.plausible or 0) >= PLAUSIBLE
