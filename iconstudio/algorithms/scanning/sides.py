"""A sheet of paper on a photo is told by its sides, however it is lit and whatever lies upon it."""

from collections.abc import Iterator

import numpy as np
import scipy
from numpy.typing import NDArray

from iconstudio.algorithms.scanning.margin import rim_of
from iconstudio.algorithms.scanning.quadrangle import quadrangle

_BLUR = 1.0
"""Pixels over which brightness is averaged before it is asked how steeply it falls."""
_STEEP = (0.06, 0.03, 0.015, 0.008)
"""Where the logarithm of brightness changes by more from pixel to pixel, something may end."""
_DIM = 0.1
"""Brightness below which logarithms would tell of noise alone."""
_GLINT = 3
"""Half the width in pixels of what is too slim to be part of a sheet."""
_LEAST, _MOST = 0.12, 0.9997
"""How much of a picture a sheet covers that lies on something darker."""
_BEYOND = 0.5
"""How much of the edge of the picture that is not of the sheet is of the desk, at least."""
_BESIDE = (5, 8)
"""Pixels on either side of an edge that are compared."""
_STEP, _FARTHER = 0.035, 15
"""By how much a desk is darker than the paper beside it, as part of it, at least, besides what the
light falls by that far into the sheet, in pixels."""
_ALONG, _ALL_BUT = 48, 0.8
"""At how many points of a side that is asked; and at how many it is so, as the drawing may touch
the side somewhere."""
_SLACK = 0.0005
"""What may be missing at a corner, as part of a sheet."""
_STRAIGHT = 1.08
"""So many times the convex hull of a sheet is its quadrangle, at most: no disc's is."""
_SIDES, _FEWEST = 4, 16
"""Sides of a sheet, and of a picture on which one can be seen, in pixels."""
_ENDS = 0.06
"""What part of a side, at either end, does not tell: the corners of paper are bent."""


def sheet_by_its_sides(picture: NDArray[np.float32]) -> NDArray[np.bool_] | None:
    """Return (h, w) where a sheet lies, (h, w, 3) in sRGB from 0 to 1; None if no desk is seen.

    Light changes by degrees, and falls steeply where a sheet ends: at straight sides, beyond which
    it is darker, or more colourful, nearly all along.
    """
    from skimage.draw import polygon2mask

    best, found = 0.0, None
    if min(picture.shape[:2]) < _FEWEST:
        return None
    for light in (picture @ np.array([0.2126, 0.7152, 0.0722], np.float32), picture.min(axis=2)):
        even = scipy.ndimage.gaussian_filter(light, _BLUR, mode="nearest")
        for piece in _pieces(light):
            corners, own = quadrangle(piece, _SLACK)
            if not 0 < own.sum() <= _SIDES or _area(corners) > _STRAIGHT * _hull(piece):
                continue
            support = _support(even, corners, own)
            if support <= max(best, _ALL_BUT):
                continue
            sheet = polygon2mask(piece.shape, corners)
            if _LEAST < sheet.mean() < _MOST and _goes_on(light, sheet):
                best, found = support, sheet
    return found


def _pieces(light: NDArray[np.float32]) -> Iterator[NDArray[np.bool_]]:
    """Yield large pieces in which brightness does not fall steeply, of several steepnesses."""
    slope = scipy.ndimage.gaussian_gradient_magnitude(
        np.log(np.clip(light, 0, None) + _DIM), _BLUR, mode="nearest"
    )
    for steep in _STEEP:
        smooth = scipy.ndimage.binary_erosion(slope < steep, border_value=1)
        smooth = scipy.ndimage.binary_opening(
            np.pad(smooth, _GLINT, mode="edge"), iterations=_GLINT
        )
        labels, _ = scipy.ndimage.label(smooth[_GLINT:-_GLINT, _GLINT:-_GLINT])
        sizes = np.bincount(labels.ravel())
        for one in 1 + np.flatnonzero(sizes[1:] > _LEAST * labels.size / 2):
            yield labels == one


def _hull(shape: NDArray[np.bool_]) -> float:
    from scipy.spatial import ConvexHull

    rim = shape & ~scipy.ndimage.binary_erosion(shape)
    return float(ConvexHull(np.argwhere(rim)).volume)  # in the plane, that is its area


def _area(corners: NDArray[np.float64]) -> float:
    rows, columns = corners.T
    return abs(float(rows @ np.roll(columns, -1) - columns @ np.roll(rows, -1))) / 2


def _support(
    light: NDArray[np.float32], corners: NDArray[np.float64], own: NDArray[np.bool_]
) -> float:
    """Return along how much of the least sure side it is darker outside, from 0 to 1."""
    ends = np.roll(corners, -1, axis=0)
    least = 1.0
    middle = corners.mean(axis=0)
    for one, other in zip(corners[own], ends[own], strict=True):
        way = other - one
        across = np.array([-way[1], way[0]]) / max(float(np.hypot(*way)), 1e-9)
        if (middle - one) @ across < 0:
            across = -across
        at = one + np.linspace(_ENDS, 1 - _ENDS, _ALONG)[:, None] * way
        inner, outer = (
            np.stack([_at(light, at + sign * far * across) for far in _BESIDE]) for sign in (1, -1)
        )
        seen = np.isfinite(inner).all(axis=0) & np.isfinite(outer).all(axis=0)
        if not seen.any():
            continue
        paper = inner.min(axis=0)[seen]
        # Where the light falls steeply by itself, nothing ends.
        within = np.nan_to_num(_at(light, at + _FARTHER * across)[seen])
        fall = paper - outer.max(axis=0)[seen] - np.clip(within - inner[0][seen], 0, None)
        least = min(least, float((fall > _STEP * paper).mean()))
    return least


def _goes_on(light: NDArray[np.float32], sheet: NDArray[np.bool_]) -> bool:
    """Whether a desk reaches the edge of the picture: what does not is drawn on the sheet."""
    inner = scipy.ndimage.binary_erosion(sheet, iterations=_BESIDE[0], border_value=1)
    outer = scipy.ndimage.binary_dilation(sheet, iterations=_BESIDE[1]) & ~sheet
    outer &= ~scipy.ndimage.binary_dilation(sheet, iterations=_GLINT)
    inner &= ~scipy.ndimage.binary_erosion(sheet, iterations=_BESIDE[1], border_value=1)
    beyond = rim_of(light)[rim_of(~sheet)]
    if not (inner.any() and outer.any() and beyond.size):
        return True
    level = (np.median(light[inner]) + np.median(light[outer])) / 2
    return bool((beyond < level).mean() > _BEYOND)


def _at(light: NDArray[np.float32], points: NDArray[np.float64]) -> NDArray[np.float32]:
    """Return the brightness at (n, 2) points; NaN beyond the picture."""
    values: NDArray[np.float32] = scipy.ndimage.map_coordinates(
        light, points.T, order=1, mode="constant", cval=np.nan
    )
    return values
