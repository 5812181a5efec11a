"""Lines between neighbours of one tone: the one in front keeps its contour, the other gives way.

Which of two is in front is told where their border ends, at T-junctions: the contour that goes
straight on belongs to what is in front. If the other were, its corner would bite into that contour.
If neither goes on, each gives way by half. What is so thin that nothing would be left does not give
way, nor does anything to a scrap of a thin line, as of a grid that peeks out behind.
"""

from collections.abc import Iterator

import numpy as np
import scipy
from numpy.typing import NDArray

from iconstudio.algorithms.tones.regions import Mask, Regions, nearest

LINE = 7.0
"""Width of the lines drawn between regions, in pixels: 3.5 on the canvas of 256."""
_BLENDS = 4.0
"""Pixels on either side of an edge that may blend its colours."""
_EATEN = 0.4
"""How much of a region may be lost to a line, if its neighbour can give way."""
_THIN = 1.5 * LINE
"""Width in pixels of regions that do not give way, as of an axis below bars."""
_SCRAP = 150
"""Pixels of a thin line that is shorter than it would be with its ends set off."""
_WIDER = 0.02
"""Part of a full turn by which the angles of two at their junctions differ, if one is in front."""

_Window = tuple[slice, slice]


def separating(rgb: NDArray[np.uint8], found: Regions, lines: Mask) -> NDArray[np.float32]:
    """Return how much of each pixel (n, n), from 0 to 1, belongs to the lines between neighbours.

    ``lines`` (k + 1, k + 1) says which have one between them.
    """
    drawn = np.zeros(found.labels.shape, np.float32)
    scraps = (found.widths < LINE) & (found.areas < _SCRAP) & (found.lengths[0] > 0)
    for front, back, window, width in _pairs(found, lines):
        if found.widths[back] < _THIN or scraps[front]:
            continue
        labels, line = found.labels[window], drawn[window]
        away = scipy.ndimage.distance_transform_edt(labels != front)
        # Smoothing takes the staircase off the lines.
        away = scipy.ndimage.gaussian_filter(away, LINE / 4)
        behind = found.extended[window] == back
        between = np.where(behind, np.clip(width + 0.5 - away, 0, 1), 0)
        pure = found.pure[window] & (labels > 0)
        own = pure & (labels == front)
        mixed, share, at = blend(rgb[window], own, pure & ~own, pure)
        border = labels[at] == back
        edge = 1 - share if width == LINE else 1
        between[mixed] = np.where(border, edge, between[mixed])
        np.maximum(line, between, out=line)
    return drawn


def blend(
    rgb: NDArray[np.uint8], one: Mask, other: Mask, pure: Mask
) -> tuple[Mask, NDArray[np.float32], tuple[NDArray[np.int32], NDArray[np.int32]]]:
    """Return which pixels (m, n) blend the colours of one and the other.

    With them come the share of the one in each, and rows and columns of the nearest pixels of the
    other. ``pure`` are the pixels that blend no colours, the one's and the other's among them.
    """
    if not one.any() or not other.any():
        nowhere = np.zeros(0, np.int32)
        return np.zeros_like(one), nowhere.astype(np.float32), (nowhere, nowhere)
    at_one, at_other = nearest(one), nearest(other)
    here = np.indices(one.shape)
    near = [np.hypot(*(np.array(at) - here)) <= _BLENDS for at in (at_one, at_other)]
    mixed = near[0] & near[1] & ~pure
    rows, columns = (each[mixed] for each in at_other)
    full, none = rgb[at_one][mixed].astype(np.float32), rgb[rows, columns].astype(np.float32)
    way = full - none
    share = ((rgb[mixed] - none) * way).sum(axis=1) / np.maximum((way**2).sum(axis=1), 1)
    return mixed, np.clip(share, 0, 1).astype(np.float32), (rows, columns)


def _pairs(found: Regions, lines: Mask) -> Iterator[tuple[int, int, _Window, float]]:
    """Yield what is in front, what is behind, a window around their border, and the line's width.

    Two of which neither is in front come twice, with half of it.
    """
    boxes = scipy.ndimage.find_objects(found.labels, len(lines) - 1)
    for one, other in np.argwhere(np.triu(lines)).tolist():
        window = _common(boxes[one - 1], boxes[other - 1])
        if window is None:
            continue
        order = _order(found, window, one, other)
        if order >= 0:
            yield one, other, window, LINE if order else LINE / 2
        if order <= 0:
            yield other, one, window, LINE if order else LINE / 2


def _common(one: _Window | None, other: _Window | None) -> _Window | None:
    """Return where two windows, made larger by a line, overlap; None if that is nowhere."""
    if one is None or other is None:
        return None
    margin = round(LINE + _BLENDS)
    spans = [
        slice(max(a.start, b.start, margin) - margin, min(a.stop, b.stop) + margin)
        for a, b in zip(one, other, strict=True)
    ]
    return (spans[0], spans[1]) if all(s.start < s.stop for s in spans) else None


def _order(found: Regions, window: _Window, one: int, other: int) -> int:
    """Return 1 if one of two regions is in front of the other, -1 if behind it, 0 if neither."""
    labels = found.labels[window]
    masks = labels == one, labels == other
    lost = [_lost(front, back) for front, back in (masks, masks[::-1])]
    eaten = lost[0] / found.areas[other], lost[1] / found.areas[one]
    if max(eaten) > _EATEN:
        return 1 if eaten[0] < eaten[1] else -1
    junctions = _grown(masks[0]) & _grown(masks[1]) & _grown(~masks[0] & ~masks[1])
    if not junctions.any():  # one is within the other
        return 1 if found.areas[one] < found.areas[other] else -1
    angles = [
        scipy.ndimage.gaussian_filter(mask.astype(np.float32), LINE / 2)[junctions].mean()
        for mask in masks
    ]
    wider = float(angles[0] - angles[1])
    return 0 if abs(wider) < _WIDER else 1 if wider > 0 else -1


def _lost(front: Mask, back: Mask) -> int:
    """Return how many pixels of what is behind go to the line."""
    return int((back & (scipy.ndimage.distance_transform_edt(~front) < LINE)).sum())


def _grown(mask: Mask) -> Mask:
    grown: Mask = scipy.ndimage.binary_dilation(mask, np.ones((3, 3)))
    return grown
