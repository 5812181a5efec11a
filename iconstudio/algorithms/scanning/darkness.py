"""How dark each pixel of a picture is: of a transparent one, or compared with its paper."""

from collections.abc import Callable

import numpy as np
import scipy
from numpy.typing import NDArray

from iconstudio.algorithms.extremes import greatest_channel
from iconstudio.algorithms.scanning.doubts import LEAST
from iconstudio.algorithms.scanning.free import veil
from iconstudio.algorithms.scanning.paper import lighting, page
from iconstudio.model import IconstudioError

_BLACK = 0.1
"""A channel of the paper that is darker tells of noise alone."""
_PLAIN = 0.25
"""Colours that differ by no more are one."""

Seeing = Callable[[NDArray[np.float32]], NDArray[np.float32]]
"""Tells how dark a picture is, of its colours."""


def seen_through(small: NDArray[np.float32], inverted: bool | None) -> tuple[Seeing, bool]:
    """Return how dark a transparent picture (h, w, 4) is, as a function, and if it is inverted.

    Raises
    ------
    IconstudioError
        If there is nothing to be seen.
    """
    alpha = small[..., 3]
    solid = (alpha > max(alpha.max(), LEAST) / 2) & ~veil(alpha)
    if not solid.any():
        raise IconstudioError("It is transparent all over.")
    inner = scipy.ndimage.binary_erosion(solid, border_value=1)
    colours = small[inner if inner.any() else solid][:, :3]
    if (np.ptp(np.percentile(colours, (4, 96), axis=0), axis=0) < _PLAIN).all():
        # Of one colour: the shape is what counts.
        inverted = bool(inverted)
        return (lambda picture: abs(picture[..., 3] - inverted)), inverted
    if inverted is None:
        inverted = bool((colours.min(axis=1) < 0.5).mean() < 0.01)

    def see(picture: NDArray[np.float32]) -> NDArray[np.float32]:
        # As on paper: a bright colour is as good as black.
        colours, alpha = picture[..., :3], picture[..., 3]
        ink = greatest_channel(colours) if inverted else 1 - colours.min(axis=2)
        dark: NDArray[np.float32] = np.where(veil(alpha), 0, alpha) * ink
        return dark

    return see, inverted


def ground_of(
    small: NDArray[np.float32], inverted: bool | None, sheet: NDArray[np.bool_] | None
) -> tuple[NDArray[np.float32], NDArray[np.bool_], bool]:
    """Return the paper (h, w, 3) of a picture, where there is paper (h, w), and if it is dark."""
    valid = page(small, sheet)
    ground = lighting(small, valid)
    if inverted is None:
        off = _luminance(small - ground)[valid]
        lighter, darker = (np.clip(side - LEAST, 0, None).sum() for side in (off, -off))
        inverted = bool(lighter > darker)
    return lighting(1 - small, valid) if inverted else ground, valid, inverted


def darkness(
    picture: NDArray[np.float32], ground: NDArray[np.float32], inverted: bool
) -> NDArray[np.float32]:
    """Return how much darker than paper (h, w, 3) each pixel is, in the channel where most so.

    Where a channel of the paper is black already, nothing can be darker in it.
    """
    off = ground - (1 - picture if inverted else picture)
    part = (off / np.maximum(ground, _BLACK)).astype(np.float32, copy=False)
    dark = greatest_channel(part)
    paper = dark[dark < LEAST]
    return np.clip(dark - np.median(paper) if paper.size else dark, 0, 1)


def _luminance(picture: NDArray[np.float32]) -> NDArray[np.float32]:
    return picture[..., :3] @ np.array([0.2126, 0.7152, 0.0722], np.float32)
