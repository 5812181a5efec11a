"""Salient region detection (section 3.2, equations 1 to 3; for edits equation 10)."""

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
import scipy
from numpy.typing import NDArray

from iconstudio.model import CANVAS, Point, Polygon

REGIONS = 9
SPACING = 75
"""Delta_S: least distance between two centres, in canvas pixels."""
LAMBDA_B = 0.1
"""Weight of the black/white balance in equation 3."""
LAMBDA_D = 100.0
"""Weight of the changed area in equation 10."""
SQUARE, SIGMA = 100, 40
"""The mask M: a square of this side, smoothed by a Gaussian of this deviation, in pixels."""


@dataclass(frozen=True, slots=True)
class Extent:
    """How large salient regions are, in canvas pixels."""

    square: float = SQUARE
    sigma: float = SIGMA
    spacing: float = SPACING

    @property
    def reach(self) -> int:
        """How far from its centre the mask ends: three standard deviations outside the square."""
        return math.floor(self.square / 2 + 3 * self.sigma)


PAPER = Extent()
SMALL = Extent(SQUARE * 0.4, SIGMA * 0.4, SPACING * 0.4)
"""That of regions of fine details, which the paper does not have."""


@dataclass(frozen=True, eq=False)
class Region:
    """A salient region: its centre in canvas pixels, and its mask M_i.

    The mask is separable: ``mask[y, x] = down[y] * across[x]``, both (CANVAS,) float32.
    """

    centre: Point
    down: NDArray[np.float32]
    across: NDArray[np.float32]

    @property
    def mask(self) -> NDArray[np.float32]:
        """M_i, (CANVAS, CANVAS) float32."""
        return np.outer(self.down, self.across)


_EVERYWHERE = np.ones(CANVAS, np.float32)
WHOLE = Region((CANVAS // 2, CANVAS // 2), _EVERYWHERE, _EVERYWHERE)
"""The whole canvas, every pixel of which counts alike."""


def profile(
    offsets: NDArray[np.signedinteger | np.floating], extent: Extent = PAPER
) -> NDArray[np.float64]:
    """Return the mask's cross-section at ``offsets`` pixels from its centre.

    The mask M is separable: M(x, y) = profile(x) profile(y), 1 for an infinitely large square.
    It ends three standard deviations outside the square.

    >>> profile(np.array([0, 50, 100, 200])).round(2)  # the square ends at 50
    array([0.79, 0.49, 0.11, 0.  ])
    """
    half, root = extent.square / 2, extent.sigma * math.sqrt(2)
    upper, lower = (scipy.special.erf((offsets + end) / root) for end in (half, -half))
    value = (upper - lower) / 2
    return np.where(np.abs(offsets) <= extent.reach, value, 0.0)


def exterior_angles(polygon: Polygon) -> NDArray[np.float64]:
    """Return the unsigned exterior angle at each vertex, (n,) in radians, 0 to pi.

    >>> np.degrees(exterior_angles(Polygon(((0, 0), (4, 0), (4, 4), (0, 4)))))
    array([90., 90., 90., 90.])
    """
    v = np.array(polygon.vertices)
    before, after = v - np.roll(v, 1, axis=0), np.roll(v, -1, axis=0) - v
    turn = np.arctan2(after[:, 1], after[:, 0]) - np.arctan2(before[:, 1], before[:, 0])
    angles: NDArray[np.float64] = np.abs((turn + np.pi) % (2 * np.pi) - np.pi)
    return angles


def saliency(
    outlines: Sequence[Polygon],
    filled: NDArray[np.bool_],
    change: NDArray[np.float32] | None = None,
    extent: Extent = PAPER,
) -> NDArray[np.float64]:
    """Return the saliency map S of a shape, (CANVAS, CANVAS) (equation 3).

    M is normalised to sum to 1, so that the balance B (equation 2) lies between 0 and 0.5 and the
    turning angles T (equation 1), which lie between 0 and 1, weigh more. The canvas goes on white.

    Parameters
    ----------
    outlines
        The shape's contours, in canvas pixels.
    filled
        (CANVAS, CANVAS): the shape.
    change
        (CANVAS, CANVAS): D_E of an edit, 0 inside the changed area. It draws the regions there
        (equation 10).
    extent
        How large the regions will be.
    """
    theta = np.zeros((CANVAS, CANVAS))
    for outline in outlines:
        xs, ys = np.clip(np.array(outline.vertices).T.astype(int), 0, CANVAS - 1)
        np.add.at(theta, (ys, xs), exterior_angles(outline))
    turning = _smooth(theta, 0.0, extent)
    turning /= turning.max() or 1.0
    balance = np.abs(_smooth(0.5 - filled, 0.5, extent))
    score = turning - LAMBDA_B * balance
    if change is not None:
        score += LAMBDA_D * _smooth(1.0 - change, 0.0, extent)
    return score


def salient_regions(
    score: NDArray[np.float64], count: int = REGIONS, extent: Extent = PAPER
) -> tuple[Region, ...]:
    """Return the most salient regions of a saliency map (CANVAS, CANVAS), most salient first.

    Greedily: the pixel of highest saliency, then all within the spacing of it are invalid. There
    are fewer than ``count`` if no valid pixel is left.
    """
    score = score.copy()
    ys, xs = np.mgrid[:CANVAS, :CANVAS]
    along = np.arange(CANVAS)
    regions: list[Region] = []
    while len(regions) < count:
        y, x = np.unravel_index(np.argmax(score), score.shape)
        if score[y, x] == -np.inf:
            break
        down, across = (profile(along - at, extent).astype(np.float32) for at in (y, x))
        regions.append(Region((int(x), int(y)), down, across))
        score[(xs - x) ** 2 + (ys - y) ** 2 < extent.spacing**2] = -np.inf
    return tuple(regions)


def _smooth(picture: NDArray[np.floating], outside: float, extent: Extent) -> NDArray[np.float64]:
    """Convolve with M; the picture goes on as ``outside`` beyond its borders."""
    across = np.arange(CANVAS, dtype=float)
    sum_of_all = profile(np.arange(-extent.reach, extent.reach + 1.0), extent).sum()
    kernel = profile(across[:, None] - across, extent) / sum_of_all
    smooth: NDArray[np.float64] = kernel @ (picture - outside) @ kernel + outside
    return smooth
