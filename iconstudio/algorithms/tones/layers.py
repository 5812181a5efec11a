"""Pale layers of a drawing (duotone icons), told as what they look like on paper."""

import numpy as np
import scipy
from numpy.typing import NDArray

from iconstudio.algorithms.tones.regions import Mask

_FAINT, _FULL = 0.2, 0.8
"""Opacities, as parts of the drawing's own, between which a layer is pale."""
_EVEN = 6
"""Grey levels by which alpha may differ between neighbouring pixels of a layer."""
_VISIBLE = 4
"""Grey levels of alpha from which something is to be seen."""
_FEW = 256
"""Pixels that faint parts must have, on 1024 by 1024."""
_EDGE = 12
"""Pixels around a faint part in which are its edges and tips."""
_SHARE = 0.02
"""Part of the drawing that its pale layers must make."""


def flattened(rgba: NDArray[np.uint8]) -> NDArray[np.uint8]:
    """Return a drawing (n, n, 4), straight alpha, whose even pale layers are opaque tints.

    A layer of black at half opacity becomes grey, so that what lies upon it is told from it by its
    colour. A drawing that is pale all over stays as it is, and so do soft shadows and edges.
    """
    alpha = rgba[..., 3].astype(np.float32)
    visible = alpha > _VISIBLE
    if not visible.any():
        return rgba
    body = float(np.quantile(alpha[visible], 0.99))
    between = (alpha > _FAINT * body) & (alpha < _FULL * body)
    least = _SHARE * visible.sum()
    if _opened(between).sum() < least:  # nearly always, and sooner known than what is even
        return rgba
    even = _even(alpha)
    if _opened(even & between).sum() < least:
        return rgba
    tint = np.clip(alpha / body, 0, 1)[..., None]
    flat = rgba.copy()
    flat[..., :3] = (rgba[..., :3] * tint + 255 * (1 - tint) + 0.5).astype(np.uint8)
    flat[..., 3] = np.clip(alpha * (255 / (_FAINT * body)), 0, 255)
    # An edge has the colour of the layer that it bounds.
    rows, columns = scipy.ndimage.distance_transform_edt(
        ~even & visible, return_distances=False, return_indices=True
    )
    flat[..., :3] = flat[rows, columns, :3]
    return flat


def without_faint(alpha: NDArray[np.float32], body: float) -> tuple[NDArray[np.float32], bool]:
    """Return the alpha (n, n) of a drawing without its faint parts, and whether it has any.

    These are even, or blurred, and less than half as opaque as its ``body``; edges and hairlines,
    which are as pale, are not. What is more opaque keeps its edges.
    """
    between = (alpha > _VISIBLE) & (alpha <= body / 2)
    least = _FEW * (len(alpha) / 1024) ** 2
    if _opened(between).sum() < least:
        return alpha, False
    faint = _opened(_even(alpha) & between)
    if faint.sum() < least:
        return alpha, False
    away, (rows, columns) = scipy.ndimage.distance_transform_edt(~faint, return_indices=True)
    level = np.where(away <= _EDGE, alpha[rows, columns], 0)
    rest = np.maximum(alpha - level, 0) * (body / (body - level))
    return np.where(alpha > body, alpha, rest).astype(np.float32), True


def _even(alpha: NDArray[np.float32]) -> Mask:
    """Return where alpha is as in the pixels around."""
    high, low = scipy.ndimage.maximum_filter(alpha, 3), scipy.ndimage.minimum_filter(alpha, 3)
    even: Mask = high - low <= _EVEN
    return even


def _opened(mask: Mask) -> Mask:
    """Return a mask without what is narrower than three pixels."""
    opened: Mask = scipy.ndimage.binary_opening(mask, np.ones((3, 3)))
    return opened
