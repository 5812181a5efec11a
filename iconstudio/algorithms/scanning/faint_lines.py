"""Long straight lines, much paler than the rest of a drawing, as the grey axes of a chart."""

import numpy as np
import scipy
from numpy.typing import NDArray

from iconstudio.algorithms.extremes import maximum_filter
from iconstudio.algorithms.scanning.margin import rim_of

_VISIBLE, _GRAINS = 0.04, 8.0
"""How much darker than paper such lines are at least, also in grains of it."""
_BESIDE = 3
"""Pixels beside ink that its blurred edges reach."""
_SLIM, _LONG = 13, 0.2
"""Pixels across of what is no line; how long a line is at least, as part of the picture."""
_DASH = 9
"""Pixels of the shortest piece of a line that is interrupted."""
_ENDS = 7
"""Pixels beyond its end within which a line meets another."""
_FULL = 75
"""Percent of the pixels of a line that are no darker than it is."""
_CLEAN = 0.004
"""How dark three quarters of the paper are at most, if no camera saw it."""


def with_faint_lines(dark: NDArray[np.float32], threshold: float) -> NDArray[np.float32]:
    """Return a darkness (h, w), from 0 to 1, in which long faint lines are as dark as ink."""
    if not is_clean(dark, threshold):
        return dark
    padded = np.pad(dark, _ENDS)
    darker = padded.copy()
    pieces, _ = scipy.ndimage.label(
        np.pad(faint_lines(dark, threshold), _ENDS), np.ones((3, 3), bool)
    )
    for number, box in enumerate(scipy.ndimage.find_objects(pieces), 1):
        near = tuple(slice(side.start - _ENDS, side.stop + _ENDS) for side in box)
        line = pieces[near] == number
        grown = scipy.ndimage.binary_dilation(line, np.ones((3, 3)), iterations=_ENDS)
        full = np.percentile(padded[near][line], _FULL)
        raised = np.where(grown, np.minimum(padded[near] / full * 2 * threshold, 1), 0)
        darker[near] = np.maximum(darker[near], raised)
    return darker[_ENDS:-_ENDS, _ENDS:-_ENDS]


def is_clean(dark: NDArray[np.float32], threshold: float) -> bool:
    """Whether a computer painted the paper, that is what is paler than a threshold."""
    paper = dark[dark < threshold]
    return paper.size > 0 and bool(np.percentile(paper, 75) < _CLEAN)


def faint_lines(dark: NDArray[np.float32], threshold: float) -> NDArray[np.bool_]:
    """Return (h, w) level and upright lines paler than a threshold; rules reach the rim."""
    paper = dark[dark < threshold]
    middle = np.median(paper)
    grain = 1.48 * np.median(abs(paper - middle))
    seen = dark > middle + max(_VISIBLE, _GRAINS * grain)
    wide = scipy.ndimage.binary_opening(seen, np.ones((_SLIM, _SLIM)))
    beside = scipy.ndimage.binary_dilation(wide | (dark > threshold), iterations=_BESIDE)
    slim = seen & ~beside
    pieces, count = scipy.ndimage.label(slim, np.ones((3, 3)))
    # What is round may be the rest of a shadow.
    kept = np.zeros(count + 1, bool)
    dashed = _dashed(slim) | _dashed(slim.T).T
    kept[pieces[dashed]] = True
    kept[rim_of(pieces)] = False
    lines: NDArray[np.bool_] = kept[pieces]
    return lines


def _dashed(slim: NDArray[np.bool_]) -> NDArray[np.bool_]:
    """Return which pixels (h, w) are of level lines that others interrupt, as bars on an axis."""
    level = scipy.ndimage.binary_opening(slim, np.ones((1, _DASH)))
    across = maximum_filter(level, (_BESIDE, 1)).sum(axis=1)
    dashed: NDArray[np.bool_] = level & (across > _LONG * max(slim.shape))[:, None]
    return dashed
