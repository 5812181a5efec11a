"""Soft borders between the regions of a label map: each owner's share near them.

An addition to section 3.4, which traces the label map as it is.

The regions are blurred, and all shares sum to 1. A *block* is the square of drawn pixels that one
label covers.
"""

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np
import scipy
from numpy.typing import NDArray

from iconstudio.algorithms.iconification.energy import Labels
from iconstudio.algorithms.raster import Scalar
from iconstudio.model import CANVAS

Window = tuple[slice, slice]
Blocks = NDArray[np.intp]
"""(b, 2): rows of (y, x) in the label map."""


@dataclass(frozen=True, eq=False)
class SoftRegion:
    """A region with soft borders: its owner's share of the pixels of a window of the label map."""

    label: int
    window: Window
    soft: NDArray[np.float32]
    """(h + 2, w + 2): its share at the middle of each block, with a frame."""

    @property
    def touched(self) -> NDArray[np.bool_]:
        """(h, w): the blocks any of whose pixels it has a share of."""
        return spread(self.soft > 0)[1:-1, 1:-1]

    def rows(self, blocks: Blocks) -> NDArray[np.intp]:
        """Return the numbers of those ``blocks`` that it has a share of."""
        here = blocks - _corner(self.window)
        size = [side.stop - side.start for side in self.window]
        rows = np.flatnonzero(((here >= 0) & (here < size)).all(axis=1))
        within: NDArray[np.intp] = rows[self.touched[tuple(here[rows].T)]]
        return within

    def weights(self, blocks: Blocks, s: int) -> NDArray[np.float32]:
        """Return its share of each of the ``s`` x ``s`` pixels of ``blocks``, (b, s, s)."""
        ys, xs = (blocks - _corner(self.window)).T
        around = np.stack([self.soft[ys + y, xs + x] for y in range(3) for x in range(3)], axis=1)
        return (around @ _bilinear(s)).reshape(-1, s, s)


def regions(labels: Labels) -> dict[int, Window]:
    """Return the window of the label map that each owner's region fills."""
    found = scipy.ndimage.find_objects(labels.astype(np.int32) + 1)
    return {label: window for label, window in enumerate(found) if window is not None}


def soft_regions(labels: Labels, fade: float, reach: int) -> Iterator[SoftRegion]:
    """Yield each owner's region.

    Parameters
    ----------
    labels
        (m, m): index of each pixel's owner.
    fade
        Standard deviation of the blur, in canvas pixels.
    reach
        How far a share reaches beyond its region, in canvas pixels.
    """
    m = len(labels)
    radius = max(1, reach * m // CANVAS)
    for label, region in regions(labels).items():
        ys, xs = (
            slice(max(0, side.start - radius - 1), min(m, side.stop + radius + 1))
            for side in region
        )
        own = (labels[ys, xs] == label).astype(np.float32)
        soft = scipy.ndimage.gaussian_filter(own, fade * m / CANVAS, radius=radius)
        yield SoftRegion(label, (ys, xs), np.pad(soft, 1, mode="edge"))


def enlarged(window: Window, s: int) -> Window:
    """Return the window of the drawn pixels."""
    ys, xs = (slice(side.start * s, side.stop * s) for side in window)
    return ys, xs


def in_blocks(picture: NDArray[Scalar], s: int) -> NDArray[Scalar]:
    """Return a view of a picture (n, n, ...) by blocks, (n/s, s, n/s, s, ...).

    It is to be indexed by ``at(blocks)``, which gives (b, s, s, ...).
    """
    n = len(picture)
    return picture.reshape(n // s, s, n // s, s, *picture.shape[2:])


def at(blocks: Blocks) -> tuple[NDArray[np.intp], slice, NDArray[np.intp], slice]:
    """Return what indexes a picture ``in_blocks``."""
    return blocks[:, 0], slice(None), blocks[:, 1], slice(None)


def spread(bitmap: NDArray[np.bool_]) -> NDArray[np.bool_]:
    """Add all eight neighbours. (SciPy's dilation takes ten times as long.)"""
    rows = bitmap.copy()
    rows[1:] |= bitmap[:-1]
    rows[:-1] |= bitmap[1:]
    both = rows.copy()
    both[:, 1:] |= rows[:, :-1]
    both[:, :-1] |= rows[:, 1:]
    return both


def _corner(window: Window) -> tuple[int, int]:
    return window[0].start, window[1].start


def _bilinear(s: int) -> NDArray[np.float32]:
    """Return how the pixels of a block mix those of 3 x 3 blocks, (9, s * s)."""
    offset = (np.arange(s) + 0.5) / s - 0.5
    near = np.clip(1 - abs(np.array([-1, 0, 1])[:, None] - offset), 0, None)
    parts: NDArray[np.float64] = np.einsum("iy,jx->ijyx", near, near)
    return parts.reshape(9, s * s).astype(np.float32)
