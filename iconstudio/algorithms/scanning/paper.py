"""Where the paper lies on a photo, and how brightly each part of it is lit."""

import numpy as np
import scipy
from numpy.typing import NDArray

_EDGE = 1 / 30
"""Width of the edge of the paper, as part of the picture's shorter side; it holds no drawing."""
_ROUNDS = 6
_NEAR = 0.06
"""By how much paper may differ from what its lighting is thought to be."""
_REACH = 1 / 14
"""How far paper tells of the lighting beside it, as part of the shorter side."""
_DARKEST = 0.04

_LEAST_PAGE, _MOST_PAGE = 0.2, 0.995
"""How much of a picture a sheet that lies on something darker may cover."""
_STRAIGHT = 0.9
"""How much of the smallest rectangle around it a sheet fills."""
_CONTRAST = 0.15
_GLINT = 3
"""Half the width in pixels of what is too slim to be part of a sheet."""
_FLAT = 1.5 / 255
"""What was photographed varies by more."""


def page(light: NDArray[np.float32]) -> NDArray[np.bool_]:
    """Return (h, w) where the sheet lies that is drawn upon; everywhere if no desk is seen.

    That is a light quadrangle with something darker around it. A picture that was not
    photographed has no desk: what is around there belongs to the drawing.
    """
    from skimage.filters import threshold_otsu

    whole = np.ones(light.shape, bool)
    if np.ptp(light) < _CONTRAST:
        return whole
    # Without glints on the desk that touch the sheet.
    bright = scipy.ndimage.binary_opening(light > threshold_otsu(light), iterations=_GLINT)
    labels, count = scipy.ndimage.label(bright)
    if not count:
        return whole
    largest = labels == 1 + int(np.argmax(np.bincount(labels.ravel())[1:]))
    sheet = scipy.ndimage.binary_fill_holes(largest)
    outside = ~sheet
    if not _LEAST_PAGE < sheet.mean() < _MOST_PAGE or _rectangularity(sheet) < _STRAIGHT:
        return whole
    if np.median(light[largest]) - np.median(light[outside]) < _CONTRAST:
        return whole
    if _spread(light[largest]) < _FLAT and _spread(light[outside]) < _FLAT:
        return whole
    edge = max(2, round(_EDGE * min(light.shape) / 2))
    inner: NDArray[np.bool_]
    inner = scipy.ndimage.binary_erosion(sheet, iterations=edge, border_value=1)
    return inner


def lighting(picture: NDArray[np.float32], valid: NDArray[np.bool_]) -> NDArray[np.float32]:
    """Return (h, w, 3) the colour of the paper everywhere, also below a drawing darker than it.

    A quadratic surface for each channel, fitted to the edge of the paper and then to all that is
    near to it; and, where there is paper, how it differs from that, smoothed.
    """
    height, width = valid.shape
    y, x = np.mgrid[-1 : 1 : height * 1j, -1 : 1 : width * 1j]
    terms = np.stack([np.ones_like(x), x, y, x * x, x * y, y * y], axis=-1).astype(np.float32)
    edge = max(2, round(_EDGE * min(height, width)))
    paper = valid & ~scipy.ndimage.binary_erosion(valid, iterations=edge)
    middle = np.median(picture[paper], axis=0)
    paper &= (abs(picture - middle) < 0.3).all(axis=-1)
    surface = np.broadcast_to(middle, picture.shape).astype(np.float32)
    for _ in range(_ROUNDS):
        if paper.sum() < 50:
            break
        # Every few pixels will do.
        some = np.flatnonzero(paper)[:: max(1, int(paper.sum()) // 20000)]
        fit, *_ = np.linalg.lstsq(
            terms.reshape(-1, 6)[some], picture.reshape(-1, 3)[some], rcond=None
        )
        surface = np.clip(terms @ fit, _DARKEST, 1.2)
        paper = valid & (abs(picture - surface) < _NEAR + 0.1 * surface).all(axis=-1)
    lit: NDArray[np.float32] = surface + _smoothed(picture - surface, paper)
    return np.clip(lit, _DARKEST, None)


def _smoothed(rest: NDArray[np.float32], paper: NDArray[np.bool_]) -> NDArray[np.float32]:
    """Return what paper differs by, averaged over paper near by; nothing where there is none."""
    reach = _REACH * min(paper.shape)
    known = scipy.ndimage.binary_erosion(paper, iterations=2, border_value=1).astype(np.float32)
    weight = scipy.ndimage.gaussian_filter(known, reach) + 0.02
    means = [scipy.ndimage.gaussian_filter(rest[..., c] * known, reach) / weight for c in range(3)]
    return np.stack(means, axis=-1)


def _spread(values: NDArray[np.float32]) -> float:
    low, high = np.percentile(values, (20, 80))
    return float(high - low)


def _rectangularity(shape: NDArray[np.bool_]) -> float:
    """Return how much of the smallest rectangle around it a shape fills, from 0 to 1."""
    from scipy.spatial import ConvexHull

    points = np.argwhere(shape ^ scipy.ndimage.binary_erosion(shape)).astype(float)
    corners = points[ConvexHull(points).vertices]
    sides = np.roll(corners, -1, axis=0) - corners
    angles = np.unique(np.arctan2(sides[:, 0], sides[:, 1]) % (np.pi / 2))
    sine, cosine = np.sin(angles), np.cos(angles)
    turned = np.stack([sine, cosine]), np.stack([cosine, -sine])  # rows come first
    areas = np.prod([np.ptp(corners @ axis, axis=0) + 1 for axis in turned], axis=0)
    return float(shape.sum() / areas.min())
