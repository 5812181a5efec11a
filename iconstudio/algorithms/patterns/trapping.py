"""Trapping: where layers abut, the lower one runs on beneath the upper one (prepress).

Were it to end where the upper one begins, a renderer would blend both edges with what lies below
them, and a hairline of that would show. Only where the edge of a lower layer *crosses* that of an
upper one is nothing to be done: the lower one goes on already.
"""

import numpy as np
from numpy.typing import NDArray
from scipy import ndimage

from iconstudio.algorithms.patterns.distance import CLAMP, Field, bordered
from iconstudio.algorithms.patterns.elements import EIGHT

TRAP = 2.0
"""Pixels by which a layer runs on."""
_GAP, _OVERLAP = 0.5, 1.0
"""Pixels by which layers that abut are apart, or overlap, at most; the gaps are closed."""
_ALONG = 12
"""Pixels at edges that abut, at least; where edges cross, there are fewer."""
_SLOPE = 2.0
"""How much farther the lower layer may be than the upper one's edge, so that what runs on does not
come out beside the upper one where they part."""


def run_on(below: Field, above: Field, tile: bool) -> Field:
    """Return the field of a layer (H, W) that runs on beneath those above it, where they abut.

    It is negative in the layer, and its contour is that of the layer but beneath the others.

    Parameters
    ----------
    below, above
        Signed distances of the layer, and of all together that are above it.
    """
    apart = below + above
    meeting = (apart > -_OVERLAP) & (apart < _GAP) & (abs(above) < 1)
    beneath = (below + _SLOPE * above) / (1 + _SLOPE) - _GAP / 2
    reach = np.maximum(below - TRAP, beneath)
    field: Field = np.where(_near(meeting, tile), np.minimum(below, reach), below)
    return field


def _near(meeting: NDArray[np.bool_], tile: bool) -> NDArray[np.bool_]:
    """Return which pixels (H, W) are near edges that meet along some way."""
    margin = int(CLAMP) if tile else 0
    rows, columns = meeting.shape
    labels, _ = ndimage.label(bordered(meeting.astype(np.float32), margin, tile), EIGHT)
    sizes = np.bincount(labels.ravel())
    sizes[0] = 0
    along = sizes[labels] >= _ALONG
    if not along.any():
        return np.zeros(meeting.shape, np.bool_)
    near = ndimage.distance_transform_edt(~along) <= TRAP + 1
    inside: NDArray[np.bool_] = near[margin : margin + rows, margin : margin + columns]
    return inside
