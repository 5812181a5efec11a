"""Whole icons that fit a green area: a hat for a cat comes as large as it was sketched."""

import math
from collections.abc import Iterable, Iterator, Sequence
from typing import NamedTuple

from iconstudio.algorithms.raster import Bitmap, overlap, placed_ink, solid
from iconstudio.algorithms.scanning.margin import box_of
from iconstudio.model import CANVAS, Exemplar, Placement, Source

COUNT = 3
"""Most icons that are fitted to one area."""
_ALIKE = 0.5
"""Overlap with the area from which an icon fits."""
_SMALLEST, _LARGEST = 0.2, 0.8
"""Scales that icons are fitted by; what is larger is found by matching."""


class _Extent(NamedTuple):
    """The box of a shape: its middle, from that of the canvas, and its size."""

    x: float
    y: float
    width: int
    height: int


def fitted(areas: Iterable[Bitmap], exemplars: Sequence[Exemplar]) -> tuple[Source, ...]:
    """Return the icons that, made smaller as a whole, fit areas (CANVAS, CANVAS) best."""
    goals = [(area, _extent(area)) for area in areas]
    extents = [(one, _extent(solid(one.ink))) for one in exemplars if goals]
    found: list[Source] = []
    for area, goal in goals:
        tried = [
            (overlap(placed_ink(one, place)[1], area), one, place)
            for one, extent in extents
            for place in _placements(extent, goal)
        ]
        best = sorted((each for each in tried if each[0] >= _ALIKE), key=lambda each: -each[0])
        once: dict[str, Source] = {}
        for _, one, place in best:
            once.setdefault(one.id, Source(one, place))
        found += list(once.values())[:COUNT]
    return tuple(found)


def _placements(extent: _Extent | None, goal: _Extent | None) -> Iterator[Placement]:
    """Yield how an icon may lie so that its box is about another; nothing if it cannot."""
    if extent is None or goal is None:
        return
    across, down = goal.width / extent.width, goal.height / extent.height
    scale = math.sqrt(across * down)
    if min(across, down) < _ALIKE * max(across, down) or not _SMALLEST <= scale <= _LARGEST:
        return
    for flip in (False, True):
        x = -extent.x if flip else extent.x
        dx, dy = goal.x - scale * x, goal.y - scale * extent.y
        yield Placement(scale, flip, round(dx), round(dy))


def _extent(shape: Bitmap) -> _Extent | None:
    """Return the box of a shape (CANVAS, CANVAS); None if it is empty."""
    box = box_of(shape)
    if box is None:
        return None
    rows, columns = box
    x, y = ((one.start + one.stop - CANVAS) / 2 for one in (columns, rows))
    return _Extent(x, y, columns.stop - columns.start, rows.stop - rows.start)
