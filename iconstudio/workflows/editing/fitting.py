"""Whole icons that fit a green area: a hat for a cat comes as large as it was sketched.

Of those that fit about as well, the ones come first whose strokes are then as wide as the icon's.
"""

import math
from collections.abc import Iterable, Iterator, Sequence
from typing import NamedTuple

from scipy.ndimage import binary_erosion

from iconstudio.algorithms.raster import Bitmap, overlap, placed_ink, solid
from iconstudio.algorithms.scanning.margin import box_of
from iconstudio.model import CANVAS, Exemplar, Placement, Source

COUNT = 3
"""Most icons that are fitted to one area."""
ALIKE = 0.5
"""Overlap with the area from which an icon fits."""
_NEARLY = 0.1
"""Icons whose overlap with the area is less by so much fit about as well as the best."""
_SMALLEST, _LARGEST = 0.2, 0.8
"""Scales that icons are fitted by; what is larger is found by matching."""


class _Extent(NamedTuple):
    """The box of a shape: its middle, from that of the canvas, and its size."""

    x: float
    y: float
    width: int
    height: int


def fitted(
    areas: Iterable[Bitmap], ink: Bitmap, exemplars: Sequence[Exemplar]
) -> tuple[tuple[Source, ...], ...]:
    """Return the icons that, made smaller as a whole, fit each of some areas best.

    The areas, and the ``ink`` of the icon that they are added to, are (CANVAS, CANVAS).
    """
    goals, pen = [(area, _extent(area)) for area in areas], _pen(ink)
    extents = [(one, _extent(solid(one.ink)), _pen(one.ink)) for one in exemplars if goals]
    found: list[tuple[Source, ...]] = []
    for area, goal in goals:
        tried = [
            (overlap(placed_ink(one, place)[1], area), own * place.scale, one, place)
            for one, extent, own in extents
            for place in _placements(extent, goal)
        ]
        nearly = max((each[0] for each in tried), default=0.0) - _NEARLY
        off = {id(each): abs(math.log(each[1] / pen)) for each in tried if each[0] >= nearly}
        tried.sort(key=lambda each: (off.get(id(each), math.inf), -each[0]))
        once: dict[str, Source] = {}
        for part, _, one, place in tried:
            if part >= ALIKE:
                once.setdefault(one.id, Source(one, place))
        found.append(tuple(once.values())[:COUNT])
    return tuple(found)


def _pen(ink: Bitmap) -> float:
    """Return about how wide the strokes of ink are, in pixels; at least 1."""
    return max(1.0, 2 * float(ink.sum()) / max(1, int((ink & ~binary_erosion(ink)).sum())))


def _placements(extent: _Extent | None, goal: _Extent | None) -> Iterator[Placement]:
    """Yield how an icon may lie so that its box is about another; nothing if it cannot."""
    if extent is None or goal is None:
        return
    across, down = goal.width / extent.width, goal.height / extent.height
    scale = math.sqrt(across * down)
    if min(across, down) < ALIKE * max(across, down) or not _SMALLEST <= scale <= _LARGEST:
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
