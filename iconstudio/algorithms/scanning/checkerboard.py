"""The checkerboard by which programs show that nothing is there, saved as a part of the picture.

It is told by the grid of two greys along the rim, and becomes nothing again.
"""

from typing import NamedTuple

import numpy as np
import scipy
from numpy.typing import NDArray

from iconstudio.algorithms.extremes import greatest_channel, maximum_filter
from iconstudio.algorithms.scanning.cutting import cut_out
from iconstudio.algorithms.scanning.margin import rim_of

_GREY = 12.0
"""Levels by which the channels of a grey differ at most."""
_APART = 80.0
"""Levels by which the two greys differ at most; those of a board to play on differ by more."""
_BLUR = 8
"""Levels on either side of the one grey that are not the other."""
_NOISE = 14.0
"""Levels by which lossy files change a grey, at most."""
_BLOCK, _STRAYS = 64, 64.0
"""Pixels of a block, in which lossy files leave noise beside edges, and levels of that, at most."""
_ON_RIM, _MATCHING = 0.5, 0.9
"""How much of the rim the two greys have at least, and how much of them is where the grid says."""
_FEWEST = 4
"""Squares along the edges of a picture from which a grid is told."""
_BLENDS = 4
"""Pixels beside it that may blend it: most such files are lossy."""
_ACROSS = 3
"""Pixels across, of a line between squares where the greys blend."""
_BOTH = 0.1
"""How much of a piece of the ground has the rarer of the two greys, at least."""


class _Lines(NamedTuple):
    """Equidistant lines between the squares of a board, along one axis."""

    first: float
    step: float

    def cells(self, count: int) -> NDArray[np.intp]:
        """Return in which column or row of squares each of so many pixels is, (count,)."""
        at = (np.arange(count) + 0.5 - self.first) / self.step
        cells: NDArray[np.intp] = np.floor(at).astype(np.intp)
        return cells


def without_checkerboard(pixels: NDArray[np.uint8]) -> NDArray[np.uint8]:
    """Return a picture with transparency, (h, w, 4), in place of a checkerboard; else as it is."""
    if pixels.shape[2] == 4 or min(pixels.shape[:2]) < 2 * _FEWEST:
        return pixels
    levels = pixels.astype(np.float32)
    greys = _greys(rim_of(levels))
    if greys is None:
        return pixels
    away = np.stack([greatest_channel(abs(levels - grey)) for grey in greys])
    number = np.where(away.min(axis=0) < _NOISE, away.argmin(axis=0), -1)
    columns, rows = _lines(number), _lines(number.T)
    if columns is None or rows is None:
        return pixels
    height, width = number.shape
    odd = (rows.cells(height)[:, None] + columns.cells(width)) % 2
    of_either = rim_of(number) >= 0
    same = (rim_of(odd) == rim_of(number))[of_either].mean()
    if max(same, 1 - same) < _MATCHING:
        return pixels
    board = odd if same > 0.5 else 1 - odd
    between = (levels > greys[0] - _NOISE).all(axis=2) & (levels < greys[1] + _NOISE).all(axis=2)
    ground = _ground(number == board, between, board, rows.step * columns.step)
    off = greatest_channel(abs(levels - greys[board][..., None]))
    ground |= _noise(off, ~ground)
    return pixels if ground.all() else cut_out(pixels, greys[board], ground, _BLENDS)


def _greys(rim: NDArray[np.float32]) -> NDArray[np.float32] | None:
    """Return the two greys (2,) that most of a rim (n, 3) has, or None."""
    grey = rim[np.ptp(rim, axis=1) < _GREY].mean(axis=1)
    if len(grey) < _ON_RIM * len(rim):
        return None
    counts = np.convolve(np.bincount(np.rint(grey).astype(np.intp), minlength=256), np.ones(5))
    one = int(counts.argmax())
    counts[max(0, one - _BLUR) : one + _BLUR + 1] = 0
    pair = np.sort([one, int(counts.argmax())]).astype(np.float32) - 2
    close = abs(grey[:, None] - pair).min(axis=1) < _NOISE
    pale = pair[1] - pair[0] < _APART
    return pair if pale and close.sum() > _ON_RIM * len(rim) else None


def _lines(number: NDArray[np.intp]) -> _Lines | None:
    """Return the lines between squares along the rows of a picture, if they are equidistant."""
    best = max((number[0], number[-1]), key=lambda row: len(_changes(row)))
    at = _changes(best)
    if len(at) < _FEWEST - 1:
        return None
    step = float(np.median(np.diff(at)))
    for _ in range(2):
        index = np.rint((at - at[0]) / step)
        step, first = np.polyfit(index, at, 1)
    if step < 2 or abs(first + index * step - at).mean() > 1:
        return None
    return _Lines(float(first), float(step))


def _changes(row: NDArray[np.intp]) -> NDArray[np.float64]:
    """Return where one grey goes over into the other."""
    known = np.flatnonzero(row >= 0)
    change = (np.diff(row[known]) != 0) & (np.diff(known) <= 3)
    changes: NDArray[np.float64] = (known[:-1][change] + known[1:][change] + 1) / 2
    return changes


def _ground(
    same: NDArray[np.bool_], between: NDArray[np.bool_], board: NDArray[np.intp], square: float
) -> NDArray[np.bool_]:
    """Return the pieces of a picture in which both greys are where the board says.

    Where the two meet, it may be anything ``between`` them.
    """
    beside = [maximum_filter(same & (board == grey), _ACROSS) for grey in (0, 1)]
    pieces, count = scipy.ndimage.label(same | (between & beside[0] & beside[1]))
    sizes = np.maximum(np.bincount(pieces.ravel(), minlength=count + 1), 1)
    odd = np.bincount(pieces.ravel(), board.ravel(), count + 1) / sizes
    both = (np.minimum(odd, 1 - odd) > _BOTH) & (sizes > square)
    both[0] = False
    ground: NDArray[np.bool_] = both[pieces]
    return ground


def _noise(off: NDArray[np.float32], drawn: NDArray[np.bool_]) -> NDArray[np.bool_]:
    """Return what lossy files leave beside what is drawn: slim or small, and nearly as the ground.

    ``off`` is by how many levels a pixel differs from that.
    """
    strong = drawn & (off > _STRAYS)
    wide = strong | scipy.ndimage.binary_opening(drawn, np.ones((_ACROSS, _ACROSS)))
    pieces, _ = scipy.ndimage.label(wide)
    kept = np.bincount(pieces.ravel()) >= _BLOCK
    kept[pieces[strong]] = True
    kept[0] = False
    noise: NDArray[np.bool_] = drawn & ~kept[pieces]
    return noise
