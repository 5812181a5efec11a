"""Lines that cross, as interlaced rings do: they run on, whatever their colours.

A line of paper between them would leave wedges of what is behind, hardly wider than itself. Two
lines cross if they meet along little of either, and one goes on beyond the other.
"""

import numpy as np
import scipy

from iconstudio.algorithms.tones.regions import ALIKE, Mask, Regions
from iconstudio.algorithms.tones.separation import LINE

_THICK = 4 * LINE
"""Width in pixels of the thickest line of which a line of paper would leave too little."""
_SHORT = 0.25
"""How much of its contour a line shares with one that it crosses, at most."""
_OVER = 0.5
"""How much of where they overlap is found anew by going on, at least, were they at right angles."""


def crossing(found: Regions) -> Mask:
    """Return which neighbours (k + 1, k + 1) are lines that cross."""
    count = len(found.areas)
    crossed = np.zeros((count, count), bool)
    line = found.widths < _THICK
    line[0] = False
    # What a line is divided into by others is one, as is what has its colour.
    same = np.linalg.norm(found.colours[:, None] - found.colours, axis=2) < ALIKE
    same &= line & line[:, None]
    along = same.astype(float)
    shared = along @ found.lengths @ along
    most = _SHORT * (along @ found.around)
    meet = (found.lengths > 0) & line & line[:, None] & ~same
    meet &= (shared < most) & (shared < most[:, None])
    boxes = scipy.ndimage.find_objects(found.labels, count - 1)
    for front, back in np.argwhere(meet).tolist():
        if not crossed[front, back] and _goes_on(found, front, same[back], boxes[front - 1]):
            crossed[front, back] = crossed[back, front] = True
    # Of a web of lines those that merely touch are joined, too.
    web = same[crossed.any(axis=1)].any(axis=0)
    joined: Mask = meet & web & web[:, None]
    return joined


def _goes_on(found: Regions, front: int, back: Mask, box: tuple[slice, slice]) -> bool:
    """Whether lines of one colour, ``back`` (k + 1,), go on beyond a region in front of them."""
    across = found.widths[front]
    margin = round(2 * across)
    labels = found.labels[tuple(slice(max(s.start - margin, 0), s.stop + margin) for s in box)]
    grown = scipy.ndimage.distance_transform_edt(~back[labels]) <= across
    closed = scipy.ndimage.distance_transform_edt(np.pad(grown, 1, mode="edge"))[1:-1, 1:-1]
    over = (closed > across) & (labels == front)
    width = np.average(found.widths[back], weights=found.areas[back])
    return bool(over.sum() > _OVER * across * width)
