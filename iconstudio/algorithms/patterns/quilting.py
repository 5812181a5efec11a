"""The start: image quilting with channels of signed distances (section 2; Efros and Freeman 2001).

Patches are laid in rows. Each is one of those that fit best on what it overlaps, of all places
of the exemplar; among the best few, one whose seam is the cheapest. On a tile, patches overlap
across the borders as well.
"""

from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

from iconstudio.algorithms.extremes import minimum_filter
from iconstudio.algorithms.patterns.energy import Channels
from iconstudio.algorithms.patterns.exemplar import Places
from iconstudio.algorithms.patterns.fourier import Searched
from iconstudio.algorithms.patterns.seams import minimum_seam

_TOLERANCE = 0.1
"""Seams that cost at most so much more than the cheapest are as good (Efros and Freeman)."""
_TRIED = 12
"""Of how many patches that fit the seams are found."""
_AGREEMENT = 0.2
"""How much it counts that a patch differs beside the seam: one through the ground alone costs
nothing, but may move what is regular."""
_RESISTANCE = 20.0
"""How many times more it costs to cross an element."""


def quilted(
    exemplar: Channels,
    solidity: NDArray[np.float32],
    shape: tuple[int, int],
    patch: int,
    tile: bool,
    random: np.random.Generator,
    ask: Callable[[], None] = lambda: None,
) -> Places:
    """Return where in the exemplar (h, w, C) each pixel of a picture comes from.

    Parameters
    ----------
    solidity
        (h, w), how much of each pixel lies in an element, which a seam had better not cross.
    shape
        Of the picture.
    patch
        The side of the patches; a third of it overlaps.
    ask
        Called every few milliseconds; what it raises ends the work.
    """
    side = min(patch, *exemplar.shape[:2], *shape)
    overlap = max(2, side // 3)
    quilt = _Quilt(exemplar, solidity, shape, side, tile, random)
    for top in _places(shape[0], side, overlap, tile):
        for left in _places(shape[1], side, overlap, tile):
            ask()
            quilt.add(top, left)
    return quilt.source


def _places(length: int, side: int, overlap: int, tile: bool) -> list[int]:
    """Return where patches begin along an axis: evenly, overlapping at least so much."""
    span = length if tile else length - side
    count = -(-span // (side - overlap))
    if tile:
        return [k * length // count for k in range(count)]
    return [k * span // count for k in range(count + 1)] if count else [0]


class _Quilt:
    """A picture that patches are added to."""

    def __init__(
        self,
        exemplar: Channels,
        solidity: NDArray[np.float32],
        shape: tuple[int, int],
        side: int,
        tile: bool,
        random: np.random.Generator,
    ) -> None:
        self._exemplar = exemplar.astype(np.float32)
        self._resistance = 1 + _RESISTANCE * solidity
        self._searched = Searched(self._exemplar.transpose(2, 0, 1))
        self._side, self._tile, self._random = side, tile, random
        self.source = np.zeros((*shape, 2), np.int32)
        self._there = np.zeros(shape, np.bool_)

    def add(self, top: int, left: int) -> None:
        """Lay a patch there that fits on what is there."""
        height, width = self._there.shape
        rows = (top + np.arange(self._side)) % height
        columns = (left + np.arange(self._side)) % width
        at = np.ix_(rows, columns)
        there = self._there[at]
        old = self.source[at]
        current = self._exemplar[old[..., 0], old[..., 1]]
        resistance = self._resistance[old[..., 0], old[..., 1]]
        # A frame of the patch stays as it is where anything lies beyond it.
        kept = there & self._beyond(rows, columns)
        seams = [self._seam(y, x, current, resistance, there, kept)
                 for y, x in self._fitting(current, there)]  # fmt: skip
        least = min(cost for cost, *_ in seams)
        cheap = [seam for seam in seams if seam[0] <= least * (1 + _TOLERANCE)]
        _, taken, places = cheap[self._random.integers(len(cheap))]
        self.source[at] = np.where(taken[..., None], places, old)
        self._there[at] = True

    def _seam(
        self,
        y: int,
        x: int,
        current: NDArray[np.float32],
        resistance: NDArray[np.float32],
        there: NDArray[np.bool_],
        kept: NDArray[np.bool_],
    ) -> tuple[float, NDArray[np.bool_], Places]:
        """Return the cost of the seam of a patch, which pixels are taken, and whence."""
        at = slice(y, y + self._side), slice(x, x + self._side)
        difference = np.sqrt(((self._exemplar[at] - current) ** 2).sum(axis=2))
        weighted = difference * np.maximum(self._resistance[at], resistance)
        taken, cost = minimum_seam(weighted, there, kept)
        cost += _AGREEMENT * float(difference[there].sum())
        places = np.indices(there.shape, np.int32).transpose(1, 2, 0) + np.array([y, x], np.int32)
        return cost, taken, places

    def _fitting(self, current: NDArray[np.float32], there: NDArray[np.bool_]) -> NDArray[np.int64]:
        """Return where in the exemplar patches begin that fit on what is there (n, 2)."""
        if not there.any():
            most = np.array(self._exemplar.shape[:2]) - self._side + 1
            return self._random.integers(0, most)[None]
        errors = self._searched.squared_differences(
            current.transpose(2, 0, 1), there.astype(np.float32)
        )
        lowest = errors == minimum_filter(errors, 3)
        fitting = np.argwhere(lowest)
        order = np.argsort(errors[lowest], kind="stable")
        return fitting[order[:_TRIED]]

    def _beyond(self, rows: NDArray[np.int64], columns: NDArray[np.int64]) -> NDArray[np.bool_]:
        """Return the pixels at a patch's border next to which, outside, anything is there."""
        height, width = self._there.shape
        frame = np.zeros((self._side, self._side), np.bool_)
        for edge, y in ((0, rows[0] - 1), (-1, rows[-1] + 1)):
            if self._tile or 0 <= y < height:
                frame[edge] |= self._there[y % height, columns]
        for edge, x in ((0, columns[0] - 1), (-1, columns[-1] + 1)):
            if self._tile or 0 <= x < width:
                frame[:, edge] |= self._there[rows, x % width]
        return frame
