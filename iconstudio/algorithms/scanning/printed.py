"""Paper that is printed with lines, squares or dots to write on: these are no part of a drawing.

Lines are told where the edge of the picture cuts them, equidistant on both sides; dots by their
equal distances. Each becomes the paper around it.
"""

from typing import NamedTuple

import numpy as np
import scipy
from numpy.typing import NDArray

from iconstudio.algorithms.extremes import greatest_channel
from iconstudio.algorithms.scanning.resampling import shrunk
from iconstudio.algorithms.tones.regions import Mask

_LONGEST, _SHORTEST = 1024, 120
"""Pixels of the longer side of the picture that is looked at; and of one in which it is told."""
_SLIM = 0.025
"""Width of what is drawn or printed upon paper, as part of the longer side, at most."""
_LIGHT = 110.0
"""Levels of paper, at least."""
_SEEN = 0.04
"""How much darker than paper print is, at least."""
_RIM = 0.012
"""Width of the rim at which lines are cut, as part of the picture."""
_FEWEST, _STRAY, _THICK = 4, 0.1, 0.25
"""Lines at either side, at least; by how much their distances differ, and how thick they are, as
part of these, at most."""
_ASKEW = 0.03
"""How far from straight across the other end of a line is, as part of the picture, at most."""
_AS_DARK, _INK = 1.4, 1.6
"""How many times as dark as the lines at the rim a line is at most, and ink at least."""
_LONG = 0.5
"""Length of a piece of a line, as part of the distance between two, at least."""
_DOTS, _DOT = 30, 0.014
"""Dots on paper, at least; and how large these are at most, as part of the longer side."""
_ALIKE, _EQUAL, _APART = 0.12, 0.7, 3.5
"""By how much the distances of dots differ, as part of them; how many do by no more, of all; and
how many times as far apart as wide they are, at least."""
_SQUARE = 0.8
"""How much dots are in rows and columns, from 0 to 1."""
_SPREAD, _FILLED = 0.7, 0.4
"""What part of the height and of the width of a picture its dots span, at least; and how much of
what they span has some."""


class _Lines(NamedTuple):
    """What one side of a picture cuts."""

    at: NDArray[np.float64]
    """(n,): the middles, in pixels."""
    thick: float
    """Pixels across, in the median."""
    level: float
    """How much darker than paper, from 0 to 1, in the median."""

    def step(self) -> float | None:
        """Return how far they are apart, if they are equidistant, and thin for it."""
        if len(self.at) < _FEWEST:
            return None
        steps = np.diff(self.at)
        step = float(np.median(steps))
        even = (abs(steps - step) < _STRAY * step).mean() > 1 - _STRAY
        return step if even and self.thick < _THICK * step else None


class Blank(NamedTuple):
    """A picture of paper without what it is printed with."""

    pixels: NDArray[np.uint8]
    """(h, w, 3), which may be smaller than what was given."""
    whole: bool
    """Whether the paper is known to reach the edges, as its lines do: no desk is seen."""


def without_print(pixels: NDArray[np.uint8]) -> Blank | None:
    """Return a picture (h, w, 3) of blank paper, if its paper is printed; else None."""
    if pixels.shape[2] != 3 or min(pixels.shape[:2]) < _SHORTEST:
        return None
    levels = shrunk(pixels, -(-max(pixels.shape[:2]) // _LONGEST)) * np.float32(255)
    slim = 2 * round(_SLIM * max(levels.shape) / 2) + 1
    paper = scipy.ndimage.grey_closing(levels, (slim, slim, 1))
    if np.median(paper.mean(axis=2)) < _LIGHT:
        return None
    dark = greatest_channel((paper - levels) / np.maximum(paper, 1))
    dark = np.clip(dark - np.median(dark), 0, 1)  # of noise, the brightest is no paper
    rules = _rules(dark)
    dots = _dots(dark) if rules is None else None
    if rules is not None:
        for lines, axis in zip(rules, (0, 1), strict=True):
            levels = _bridged(levels, _without_ink(lines, dark), axis)
    elif dots is not None:
        levels = np.where(scipy.ndimage.binary_dilation(dots)[..., None], paper, levels)
    else:
        return None
    return Blank(np.rint(levels).astype(np.uint8), whole=rules is not None)


def _without_ink(lines: Mask, dark: NDArray[np.float32]) -> Mask:
    """Return lines (h, w) and what is beside them, but for what is darker than they are."""
    if not lines.any():
        return lines
    wide: Mask = scipy.ndimage.binary_dilation(lines, np.ones((3, 3)))
    return wide & (dark < _INK * np.quantile(dark[lines], 0.9))


def _bridged(levels: NDArray[np.float32], mask: Mask, axis: int) -> NDArray[np.float32]:
    """Return a picture (h, w, 3) that goes on across a mask (h, w) along an axis."""
    turned, gaps = levels.swapaxes(0, axis), mask.swapaxes(0, axis)
    rows = np.broadcast_to(np.arange(len(gaps))[:, None], gaps.shape)
    before = np.maximum.accumulate(np.where(gaps, 0, rows))
    after = np.minimum.accumulate(np.where(gaps, len(gaps) - 1, rows)[::-1])[::-1]
    columns = np.arange(gaps.shape[1])
    # Ink goes on across a line if it is on both sides.
    lighter = np.maximum(turned[before, columns], turned[after, columns])
    bridged: NDArray[np.float32] = np.where(gaps[..., None], lighter, turned)
    return bridged.swapaxes(0, axis)


def _rules(dark: NDArray[np.float32]) -> tuple[Mask, Mask] | None:
    """Return where there are lines (h, w) across, and down, told by how dark it is; or None."""
    across, down = (_ends(turned) for turned in (dark, dark.T))
    steps = [_common_step(*ends) for ends in (across, down)]
    told = [step for step in steps if step is not None]
    if not told:
        return None
    # Beside such lines, a single one may be the margin of a page.
    return _traced(dark, *across, min(told)), _traced(dark.T, *down, min(told)).T


def _common_step(one: _Lines, other: _Lines) -> float | None:
    steps = one.step(), other.step()
    if steps[0] is None or steps[1] is None or abs(steps[0] - steps[1]) > _STRAY * steps[0]:
        return None
    return min(steps[0], steps[1])


def _ends(dark: NDArray[np.float32]) -> tuple[_Lines, _Lines]:
    """Return the lines that the left and the right side of a picture cut."""
    wide = max(3, round(_RIM * dark.shape[1]))
    return _cut(np.median(dark[:, :wide], axis=1)), _cut(np.median(dark[:, -wide:], axis=1))


def _cut(profile: NDArray[np.float32]) -> _Lines:
    runs, count = scipy.ndimage.label(profile > max(_SEEN, 0.4 * float(profile.max(initial=0))))
    every = np.arange(1, count + 1)
    if not count:
        return _Lines(np.empty(0), 0.0, 0.0)
    at = np.asarray(scipy.ndimage.mean(np.arange(len(profile)), runs, every), np.float64)
    darkest = scipy.ndimage.maximum(profile, runs, every)
    return _Lines(at, float(np.median(np.bincount(runs)[1:])), float(np.median(darkest)))


def _traced(dark: NDArray[np.float32], left: _Lines, right: _Lines, step: float) -> Mask:
    """Return where the lines run (h, w) that both sides cut: slim, long, and as dark as there."""
    height, width = dark.shape
    found = np.zeros(dark.shape, bool)
    if not (len(left.at) and len(right.at)):
        return found
    level = max(left.level, right.level)
    thick = max(left.thick, right.thick)
    near = np.zeros_like(found)
    columns = np.arange(width)
    for one in left.at:
        other = right.at[abs(right.at - one).argmin()]
        if abs(other - one) > min(_ASKEW * width, step / 2):
            continue
        middle = one + (other - one) * columns / width
        for off in np.arange(-thick - 1, thick + 2):
            rows = np.clip(np.rint(middle + off).astype(np.intp), 0, height - 1)
            near[rows, columns] = True
    pale = near & (dark > _SEEN / 2) & (dark < _AS_DARK * level + _SEEN)
    long = max(3, round(_LONG * step))
    found = scipy.ndimage.binary_opening(
        scipy.ndimage.binary_dilation(pale, np.ones((3, 1))), np.ones((1, long))
    )
    lines: Mask = found & pale
    return lines


def _dots(dark: NDArray[np.float32]) -> Mask | None:
    """Return where there are dots (h, w) in rows and columns, told by how dark it is; or None."""
    pieces, count = scipy.ndimage.label(dark > 2 * _SEEN, np.ones((3, 3)))
    darkest = np.asarray(scipy.ndimage.maximum(dark, pieces, np.arange(1, count + 1)))
    most = _DOT * max(dark.shape) + 2
    boxes = scipy.ndimage.find_objects(pieces)
    sides = np.array([max(side.stop - side.start for side in box) for box in boxes])
    small = np.flatnonzero(sides <= most) + 1
    if len(small) < _DOTS:
        return None
    small = small[darkest[small - 1] > 0.5 * np.quantile(darkest[small - 1], 0.9)]  # no noise
    sizes = np.bincount(pieces.ravel(), minlength=count + 1)
    usual = np.median(sizes[small])
    small = small[(sizes[small] > usual / 3) & (sizes[small] < 3 * usual)]
    at = np.array(scipy.ndimage.center_of_mass(dark, pieces, small))
    distances, neighbours = scipy.spatial.cKDTree(at).query(at, min(5, len(at)))
    apart = np.median(distances[:, 1])
    equal = (abs(distances[:, 1:] - apart) < _ALIKE * apart).any(axis=1)
    ways = at[neighbours[equal, 1]] - at[equal]
    turned = np.exp(4j * np.arctan2(ways[:, 0], ways[:, 1]))
    spread = np.ptp(at[equal], axis=0) / dark.shape if equal.any() else np.zeros(2)
    room = spread.prod() * dark.size / apart**2
    if (
        equal.sum() < max(_DOTS, _EQUAL * len(at))
        or apart < _APART * np.median(sides[small - 1])
        or abs(turned.mean()) < _SQUARE
        or (spread < _SPREAD).any()
        or equal.sum() < _FILLED * room
    ):
        return None
    found: Mask = np.isin(pieces, small[equal])
    return found
