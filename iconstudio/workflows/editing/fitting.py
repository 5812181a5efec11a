"""Whole icons that fit a green area: a hat for a cat comes as large as it was sketched."""

import math
from collections.abc import Iterable, Sequence

import numpy as np

from iconstudio.algorithms.raster import Bitmap, overlap, placed_ink, solid
from iconstudio.model import CANVAS, Exemplar, Placement, Source

COUNT = 3
"""Most icons that are fitted to one area."""
_ALIKE = 0.5
"""Overlap with the area from which an icon fits."""
_SMALLEST, _LARGEST = 0.2, 0.8
"""Scales that icons are fitted by; what is larger is found by matching."""


def fitted(areas: Iterable[Bitmap], exemplars: Sequence[Exemplar]) -> tuple[Source, ...]:
    """Return the icons that, made smaller as a whole, fit areas (CANVAS, CANVAS) best."""
    found: list[Source] = []
    for area in areas:
        tried = [
            (overlap(placed_ink(one, place)[1], area), one, place)
            for one in exemplars
            for place in _placements(one, area)
        ]
        best = sorted((each for each in tried if each[0] >= _ALIKE), key=lambda each: -each[0])
        once: dict[str, Source] = {}
        for _, one, place in best:
            once.setdefault(one.id, Source(one, place))
        found += list(once.values())[:COUNT]
    return tuple(found)


def _placements(exemplar: Exemplar, area: Bitmap) -> tuple[Placement, ...]:
    """Return how an icon may lie so that its box is about that of an area; none if it cannot."""
    left, top, right, bottom = _box(solid(exemplar.ink))
    goal = _box(area)
    width, height = goal[2] - goal[0], goal[3] - goal[1]
    if not width or not height or right == left:
        return ()
    across, down = width / (right - left), height / (bottom - top)
    if min(across, down) < _ALIKE * max(across, down):
        return ()
    scale = math.sqrt(across * down)
    if not _SMALLEST <= scale <= _LARGEST:
        return ()
    half = CANVAS / 2
    middle = (left + right) / 2 - half, (top + bottom) / 2 - half
    x, y = (goal[0] + goal[2]) / 2 - half, (goal[1] + goal[3]) / 2 - half
    return tuple(
        Placement(
            scale,
            flip,
            round(x - scale * middle[0] * (-1 if flip else 1)),
            round(y - scale * middle[1]),
        )
        for flip in (False, True)
    )


def _box(shape: Bitmap) -> tuple[int, int, int, int]:
    ys, xs = np.nonzero(shape)
    if not len(xs):
        return 0, 0, 0, 0
    return int(xs.min()), int(ys.min()), int(xs.max()) + 1, int(ys.max()) + 1
