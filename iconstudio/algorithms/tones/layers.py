"""Pale layers of a drawing (duotone icons), told as what they look like on paper."""

import numpy as np
import scipy
from numpy.typing import NDArray

from iconstudio.algorithms.extremes import maximum_filter, minimum_filter
from iconstudio.algorithms.tones.regions import Mask

_FAINT, _ROUNDING = 0.2, 1.5
"""Opacity, as part of the drawing's own, of the palest layer that is no shadow; by how many
grey levels it may come out paler."""
_SHARE = 0.02
"""Part of the drawing that layers of less than half its opacity must make."""
_EVEN = 6
"""Grey levels by which alpha may differ between neighbouring pixels of a layer."""
_GENTLE = 0.4
"""By how much of the body's opacity a blur of the body differs within five pixels, at most."""
_VISIBLE = 4
"""Grey levels of alpha from which something is to be seen."""
_FEW = 256
"""Pixels that faint parts must have, on 1024 by 1024."""
_EDGE = 12
"""Pixels around a faint part in which are its edges and tips."""


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
    opaque = _palest(alpha, visible, body)
    if opaque is None:
        return rgba
    # An edge has the colour of the layer that it bounds.
    layer = scipy.ndimage.distance_transform_edt(
        ~(_even(alpha) & visible), return_distances=False, return_indices=True
    )
    rows, columns = layer
    level = np.where(visible, alpha[rows, columns], body)
    shown = level > opaque * body - (_ROUNDING if opaque == _FAINT else 0)
    tint = np.clip(level / body, 0, 1)[..., None]
    flat = rgba.copy()
    flat[..., :3] = (rgba[rows, columns, :3] * tint + 255 * (1 - tint) + 0.5).astype(np.uint8)
    flat[..., 3] = np.clip(alpha * (255 / np.where(shown, level, body)), 0, 255)
    # Of what fades, the end is no part of its own.
    flat[_fading(visible & ~shown, shown, alpha, body), 3] = 0
    return flat


def left_out(rgba: NDArray[np.uint8], flat: NDArray[np.uint8], coverage: NDArray[np.uint8]) -> bool:
    """Whether much of the pale layers of a drawing is no ink in its pictogram ``coverage`` (n, n).

    Where they overlap they are darker: what is no paler than the ink is parted from it as paper.
    ``flat`` is the drawing as ``flattened`` gives it.
    """
    visible = rgba[..., 3] > _VISIBLE
    ink = coverage > 127
    alpha, usual = rgba[..., 3], np.median(rgba[visible & ink, 3]) if ink.any() else 255
    tinted = visible & (alpha < flat[..., 3]) & (rgba[..., :3] != flat[..., :3]).any(axis=2)
    paler = tinted & ~ink & (alpha < usual - _EVEN)
    return bool(_opened(paler).sum() >= _SHARE * visible.sum())


def _palest(alpha: NDArray[np.float32], visible: Mask, body: float) -> float | None:
    """Return the opacity, as part of the body's, from which layers show; None if all are opaque."""
    pale = (alpha > _FAINT * body - _ROUNDING) & (alpha < body - _EVEN)
    half = pale & (alpha > body / 2)
    few = _FEW * (len(alpha) / 1024) ** 2
    share = _SHARE * visible.sum()
    # Nearly always there are none, which is sooner known than what is even.
    if _opened(pale).sum() < share and _opened(half).sum() < few:
        return None
    even = _even(alpha)
    # What mostly slopes is a blur, whose shape is where it is half as opaque.
    if (pale & _even(alpha, 9, 3)).sum() < _opened(pale).sum() / 2:
        return None
    if _opened(even & pale).sum() >= share:
        return _FAINT
    return 0.5 if _opened(even & half).sum() >= few else None


def without_faint(alpha: NDArray[np.float32], body: float) -> tuple[NDArray[np.float32], bool]:
    """Return the alpha (n, n) of a drawing without its faint parts, and whether it has any.

    These are even, or blurred, and less than half as opaque as its ``body``; edges and hairlines,
    which are as pale, are not, nor is what the body fades into, which ends where it is half as
    opaque. What is more opaque keeps its edges.
    """
    between = (alpha > _VISIBLE) & (alpha <= body / 2)
    least = _FEW * (len(alpha) / 1024) ** 2
    if _opened(between).sum() < least:
        return alpha, False
    fading = _fading(between, alpha > body / 2, alpha, body)
    faint = _opened(_even(alpha) & between & ~fading)
    if fading.any():
        alpha = np.where(_even(alpha, 5, _GENTLE * body), _ended(alpha, body), alpha)
    if faint.sum() < least:
        return alpha, False
    away, (rows, columns) = scipy.ndimage.distance_transform_edt(~faint, return_indices=True)
    level = np.where(away <= _EDGE, alpha[rows, columns], 0)
    rest = np.maximum(alpha - level, 0) * (body / (body - level))
    return np.where(alpha > body, alpha, rest).astype(np.float32), True


def _ended(alpha: NDArray[np.float32], body: float) -> NDArray[np.float32]:
    """Return alpha with an edge where it is half that of the body."""
    slope = np.maximum(np.hypot(*np.gradient(alpha)), 1e-3)
    ended: NDArray[np.float32] = body * np.clip((alpha - body / 2) / slope + 0.5, 0, 1)
    return ended


def _even(alpha: NDArray[np.float32], size: int = 3, levels: float = _EVEN) -> Mask:
    """Return where alpha is as in the pixels around."""
    high, low = maximum_filter(alpha, size), minimum_filter(alpha, size)
    even: Mask = high - low <= levels
    return even


def _fading(pale: Mask, rest: Mask, alpha: NDArray[np.float32], body: float) -> Mask:
    """Return the pale parts into which the rest goes over by degrees, as in blurs and gradients."""
    parts, count = scipy.ndimage.label(pale, np.ones((3, 3)))
    meets = pale & scipy.ndimage.binary_dilation(rest, np.ones((3, 3)))
    gentle = meets & _even(alpha, 5, _GENTLE * body)
    whole, by_degrees = (np.bincount(parts[mask], minlength=count + 1) for mask in (meets, gentle))
    fading: Mask = (by_degrees > whole / 2)[parts]
    return fading


def _opened(mask: Mask) -> Mask:
    """Return a mask without what is narrower than three pixels."""
    opened: Mask = scipy.ndimage.binary_opening(mask, np.ones((3, 3)))
    return opened
