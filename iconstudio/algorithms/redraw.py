"""Drawing a labelling at high resolution, without visible seams.

The label map says who owns each pixel of the canvas; the owners are drawn anew from their SVG at
``SCALE`` times its resolution. Where two sources meet and disagree, their signed distance fields
are cross-faded over a few canvas pixels, so that the contour of one runs smoothly into the
other's. The paper (section 3.4, post-processing) traces the 256-pixel bitmap instead, which shows
its staircases.
"""

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from PIL import Image
from scipy import ndimage
from scipy.spatial import KDTree

from iconstudio.algorithms.energy import Labels
from iconstudio.model import CANVAS

SCALE = 4
"""Drawn pixels to a canvas pixel."""
FADE = 2.0
"""Standard deviation, in canvas pixels, of the cross-fade across a seam."""
_REACH = 8
"""How far, in canvas pixels, an owner's share reaches beyond its region."""
_AGREED = 1e-3


@dataclass(frozen=True, eq=False)
class _Part:
    """What one owner contributes: its soft share of the drawn pixels in a window around its own."""

    window: tuple[slice, slice]
    weight: NDArray[np.float32]
    whole: NDArray[np.uint8]
    """The owner's drawing of the whole canvas."""

    @property
    def coverage(self) -> NDArray[np.uint8]:
        """The owner's drawing in the window."""
        return self.whole[self.window]


def redraw(labels: Labels, coverages: Mapping[int, NDArray[np.uint8]]) -> NDArray[np.uint8]:
    """Join the sources as the labelling says.

    Parameters
    ----------
    labels
        (CANVAS, CANVAS): index of each pixel's owner.
    coverages
        For every label that occurs: its source drawn at its placement, (n, n) uint8, 255 = ink.

    Returns
    -------
    (n, n) uint8, ``n = SCALE * CANVAS``, 255 = ink
    """
    owners = np.unique(labels)
    if len(owners) == 1:
        return coverages[int(owners[0])].copy()
    parts = [_part(labels, int(owner), coverages[int(owner)]) for owner in owners]
    n = SCALE * CANVAS
    mean, inked = np.zeros((2, n, n), dtype=np.float32)
    for part in parts:
        mean[part.window] += part.weight * part.coverage
        inked[part.window] += part.weight * (part.coverage > 127)
    # Where all owners agree, so does any mean of their distance fields: only the rest needs them.
    disagreed = (inked > _AGREED) & (inked < 1 - _AGREED)
    distance = np.zeros((n, n), dtype=np.float32)
    for part in parts:
        concerned = disagreed[part.window] & (part.weight > 0)
        points = np.argwhere(concerned)
        if len(points):
            corner = [side.start for side in part.window]
            own = signed_distance(part.whole, points + corner)
            distance[part.window][concerned] += part.weight[concerned] * own
    mean[disagreed] = 255 * np.clip(0.5 - distance[disagreed], 0, 1)
    return mean.round().astype(np.uint8)


def _part(labels: Labels, owner: int, coverage: NDArray[np.uint8]) -> _Part:
    """Blur the owner's region, so that shares of neighbours cross-fade; all shares sum to 1."""
    own = labels == owner
    window = tuple(
        slice(max(0, int(at[0]) - _REACH), min(CANVAS, int(at[-1]) + 1 + _REACH))
        for at in (np.flatnonzero(own.any(axis=1)), np.flatnonzero(own.any(axis=0)))
    )
    soft = ndimage.gaussian_filter(own[window].astype(np.float32), FADE, radius=_REACH - 1)
    large = tuple(slice(side.start * SCALE, side.stop * SCALE) for side in window)
    size = soft.shape[1] * SCALE, soft.shape[0] * SCALE
    weight = np.asarray(Image.fromarray(soft).resize(size, Image.Resampling.BILINEAR))
    return _Part(large, weight, coverage)


def two_tone(coverage: NDArray[np.uint8]) -> NDArray[np.uint8]:
    """Make a drawing (h, w) uint8 ink or paper, but for the soft edge between the two.

    A duotone's pale layer is no ink, and its dark one is all ink (section 3.1: black and white).
    """
    ink = coverage > 127
    square = np.ones((3, 3), dtype=bool)
    edge = ndimage.binary_dilation(ink, square) & ndimage.binary_dilation(~ink, square)
    return np.where(edge, coverage, np.where(ink, np.uint8(255), np.uint8(0)))


def erase(coverage: NDArray[np.uint8], fragments: NDArray[np.bool_]) -> None:
    """Take pieces off a drawing, in place.

    ``fragments`` is (CANVAS, CANVAS) bool; what lies within a pixel of it and touches it goes too.
    """
    if fragments.any():
        near = ndimage.binary_dilation(fragments, iterations=2)
        coverage[near.repeat(SCALE, axis=0).repeat(SCALE, axis=1)] = 0


def signed_distance(coverage: NDArray[np.uint8], points: NDArray[np.int64]) -> NDArray[np.float64]:
    """Return the distance in pixels from ``points`` (p, 2), rows of (y, x), to the contour.

    Negative inside. The contour is where the coverage, interpolated, is one half. A picture all ink
    or all paper is as far from its contour as the picture is wide.
    """
    contour = _contour(coverage)
    inside = coverage[points[:, 0], points[:, 1]] > 127
    if len(contour) == 0:
        distance = np.full(len(points), float(coverage.shape[0]))
    else:
        distance, _ = KDTree(contour).query(points)
    return np.where(inside, -distance, distance)


def _contour(coverage: NDArray[np.uint8]) -> NDArray[np.float64]:
    """Return points (p, 2) where the coverage crosses one half between neighbouring pixels."""
    ink = coverage > 127
    found = []
    for axis in (0, 1):
        before, after = ([slice(None)] * 2 for _ in range(2))
        before[axis], after[axis] = slice(None, -1), slice(1, None)
        at = np.argwhere(ink[tuple(before)] != ink[tuple(after)]).astype(np.float64)
        corner = at.astype(int)
        step = np.eye(2, dtype=int)[axis]
        first = coverage[tuple(corner.T)].astype(np.float64)
        second = coverage[tuple((corner + step).T)].astype(np.float64)
        at[:, axis] += (127.5 - first) / (second - first)
        found.append(at)
    return np.concatenate(found)
