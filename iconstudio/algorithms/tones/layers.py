"""Pale layers of a drawing (duotone icons), told as what they look like on paper."""

import numpy as np
import scipy
from numpy.typing import NDArray

_FAINT, _FULL = 0.2, 0.8
"""Opacities, as parts of the drawing's own, between which a layer is pale."""
_EVEN = 6
"""Grey levels by which alpha may differ between neighbouring pixels of a layer."""
_SHARE = 0.02
"""Part of the drawing that its pale layers must make."""


def flattened(rgba: NDArray[np.uint8]) -> NDArray[np.uint8]:
    """Return a drawing (n, n, 4), straight alpha, whose even pale layers are opaque tints.

    A layer of black at half opacity becomes grey, so that what lies upon it is told from it by its
    colour. A drawing that is pale all over stays as it is, and so do soft shadows and edges.
    """
    alpha = rgba[..., 3].astype(np.float32)
    visible = alpha > 4
    if not visible.any():
        return rgba
    body = float(np.quantile(alpha[visible], 0.99))
    even = scipy.ndimage.maximum_filter(alpha, 3) - scipy.ndimage.minimum_filter(alpha, 3) <= _EVEN
    pale = even & (alpha > _FAINT * body) & (alpha < _FULL * body)
    pale = scipy.ndimage.binary_opening(pale, np.ones((3, 3)))
    if pale.sum() < _SHARE * visible.sum():
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
