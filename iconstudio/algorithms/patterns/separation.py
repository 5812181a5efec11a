"""An image's layers, separated by colour, and what of them is hidden completed (section 3).

In the paper a person separates the layers and recovers what is hidden. Here areas of even colour
are found, the pixels of their soft edges go to the one of their neighbours that they are most like,
and a hole in a layer through which only upper layers are seen is filled; a person may correct it.
"""

import numpy as np
from numpy.typing import NDArray
from scipy import ndimage
from skimage.color import rgb2lab

from iconstudio.algorithms.patterns.exemplar import MOST_LAYERS, Colours, Masks
from iconstudio.algorithms.raster import solid
from iconstudio.model import IconstudioError

Layers = NDArray[np.uint8]
"""(h, w), the number of the layer that is seen in each pixel, from the ground, 0, up."""

_EVEN = 5.0
"""In areas of even colour, neighbours differ by less, in CIELAB."""
_ALIKE = 14.0
"""Colours that differ by less are one."""
_LEAST = 0.005
"""A colour covers so much of the image at least."""
_EVEN_LEAST = 0.1
"""So much of an image has to be of even colours."""
_EDGE = 4.0
"""Pixels from an area of even colour, in which its soft edge lies."""


def separated(colours: Colours, count: int | None = None) -> Layers:
    """Return the layers of an image: the ground, then the others from the largest down.

    The ground is what most of the border shows.

    Parameters
    ----------
    count
        How many colours there are, with the ground; None: as many as cover enough.

    Raises
    ------
    IconstudioError
        If there are no areas of even colour, or only one.
    """
    lab = rgb2lab(colours).astype(np.float32)
    spread = ndimage.maximum_filter(lab, (3, 3, 1)) - ndimage.minimum_filter(lab, (3, 3, 1))
    even = (spread < _EVEN).all(axis=2)
    if even.mean() < _EVEN_LEAST:
        raise IconstudioError(
            "The image has no areas of even colour to separate. "
            "Give one of flat colours, such as a drawing."
        )
    palette = _palette(lab[even], lab.shape[0] * lab.shape[1], count)
    if len(palette) < 2:
        raise IconstudioError("The exemplar has only one colour. Give one with a drawing on it.")
    seen = _nearest(lab, even, palette)
    return _ordered(seen, len(palette))


def _palette(lab: NDArray[np.float32], pixels: int, count: int | None) -> NDArray[np.float32]:
    """Return the commonest colours (n, 3) of even pixels (m, 3)."""
    palette: list[NDArray[np.float32]] = []
    left = lab
    while len(left) > _LEAST * pixels and len(palette) < (count or MOST_LAYERS + 1):
        _, which, sizes = np.unique(
            np.round(left / (_ALIKE / 2)), axis=0, return_inverse=True, return_counts=True
        )
        commonest = left[which.ravel() == sizes.argmax()].mean(axis=0)
        near = np.linalg.norm(left - commonest, axis=1) < _ALIKE
        if near.sum() > _LEAST * pixels:
            palette.append(left[near].mean(axis=0))
        elif count is None:
            break
        left = left[~near]
    return np.array(palette, np.float32)


def _nearest(
    lab: NDArray[np.float32], even: NDArray[np.bool_], palette: NDArray[np.float32]
) -> Layers:
    """Return which colour each pixel has; on soft edges only neighbours' colours count."""
    unlike = np.linalg.norm(lab[:, :, None] - palette, axis=3)
    surest = unlike.argmin(axis=2)
    sure = even & (unlike.min(axis=2) < 2 * _ALIKE)
    away = np.stack(
        [
            ndimage.distance_transform_edt(~(sure & (surest == number)))
            if (sure & (surest == number)).any()
            else np.full(sure.shape, np.inf)
            for number in range(len(palette))
        ],
        axis=2,
    )
    beside = np.where(away <= _EDGE, unlike, np.inf)
    alone = np.isinf(beside).all(axis=2)  # a line too thin for an even colour
    return np.where(alone, surest, beside.argmin(axis=2)).astype(np.uint8)


def _ordered(seen: Layers, count: int) -> Layers:
    """Return the layers with the ground first, and then from the largest down."""
    border = np.concatenate([seen[0], seen[-1], seen[:, 0], seen[:, -1]])
    ground = int(np.bincount(border, minlength=count).argmax())
    sizes = np.bincount(seen.ravel(), minlength=count)
    sizes[ground] = seen.size + 1
    rank = np.empty(count, np.uint8)
    rank[np.argsort(-sizes, kind="stable")] = np.arange(count)
    return rank[seen]


def completed(layers: Layers) -> Masks:
    """Return the masks (L, h, w) of the layers above the ground, the uppermost first.

    A hole in a layer in which only upper ones are seen is filled: it is hidden there.
    """
    masks = []
    for number in range(int(layers.max()), 0, -1):
        own = layers == number
        holes, count = ndimage.label(solid(own) & ~own)
        deepest = ndimage.minimum(layers, holes, np.arange(1, count + 1)) if count else []
        hidden = np.append(False, np.asarray(deepest) > number)[holes]
        masks.append(own | hidden)
    return np.stack(masks).astype(np.float32)
