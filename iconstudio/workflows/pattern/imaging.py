"""An image becomes an exemplar: its colours are layers, as far as nobody has corrected them."""

import hashlib
from collections.abc import Sequence
from dataclasses import dataclass, field
from functools import lru_cache

import numpy as np
from numpy.typing import NDArray
from scipy import ndimage

from iconstudio.algorithms.patterns.elements import components, grouped
from iconstudio.algorithms.patterns.exemplar import LARGEST, MOST_LAYERS, Exemplar, Masks
from iconstudio.algorithms.patterns.flat_colours import has_gradient, is_grainy, is_noisy
from iconstudio.algorithms.patterns.periods import period
from iconstudio.algorithms.patterns.separation import Layers, Separated, separated
from iconstudio.algorithms.patterns.shapes import element_shapes
from iconstudio.algorithms.patterns.thickening import thickened
from iconstudio.grammar import joined
from iconstudio.model import (
    CANVAS,
    Correction,
    IconstudioError,
    Patterning,
    Photo,
    Separation,
    hex_colour,
)
from iconstudio.model.patterning import GROUND
from iconstudio.workflows.pattern.layout import Layout

_THINNEST = 1.5
"""Pixels of an exemplar that the lines of its layers are wide, at least."""
_SMALLEST = 16
"""Pixels of a side of an image."""
_NOISY_MOST = 400
"""Pixels of the longer side of an image with noise: reduced to fewer, it has less of it."""
_TIGHT = 0.7
"""How much of an image a mosaic covers, at least."""
_SOFT = 0.02
"""What a layer covers of a pixel at its soft edge, at least."""


@dataclass(frozen=True, slots=True)
class ImageExemplar:
    """An image, no larger than need be."""

    pixels: NDArray[np.uint8] = field(compare=False)
    """(h, w, 3)"""
    digest: str
    """Of the pixels."""
    colours: int | None
    corrections: tuple[Correction, ...]
    """In pixels of the original."""
    reduction: float
    """The original's pixels to one."""
    transparent: bool = False
    """Whether its ground is left out."""

    @classmethod
    def of(cls, image: Separation, transparent: bool = False) -> "ImageExemplar":
        """Return the image of some work, over white; ``transparent``: without its ground.

        Raises
        ------
        IconstudioError
            If it is too small.
        """
        check_size(image.photo)
        pixels, digest = _reduced(image.photo)
        reduction = image.photo.width / pixels.shape[1]
        return cls(pixels, digest, image.colours, image.corrections, reduction, transparent)

    def layers(self) -> Layers:
        """Return its layers, corrected: (h, w), from the ground, 0, up."""
        return self.separated().seen

    def separated(self) -> Separated:
        """Return its layers, corrected."""
        found = separated(self.pixels, self.colours)
        if not self.corrections:
            return found
        return found.corrected(corrected(found.seen, self.corrections, self.reduction))

    def layout(self, samples: float) -> Layout:
        """Return it as an exemplar, its longer side as long as a canvas.

        Parameters
        ----------
        samples
            Pixels of the exemplar to a unit of the canvas.

        Raises
        ------
        IconstudioError
            If it cannot be an exemplar.
        """
        found = self.separated()
        masks = found.masks()
        height, width = found.seen.shape
        factor = round(CANVAS * samples) / max(height, width)
        size = tuple(max(_SMALLEST, round(side * factor)) for side in (height, width))
        thick = np.stack([thickened(mask, _THINNEST / factor) for mask in masks])
        reduced = np.stack([_resized(mask, size) for mask in thick])
        labels = _labels(reduced)
        pixels = found.repainted(self.pixels, thick)
        colours = np.stack([_resized(one, size) for one in np.moveaxis(pixels, 2, 0)], axis=2) / 255
        shapes = element_shapes(found, masks, labels)
        own = hex_colour(found.flat.colours[int(np.argmin(found.layer))])
        ground = "" if self.transparent else own
        exemplar = Exemplar(colours.astype(np.float32), reduced, labels)
        remark = remark_of(found, self.pixels)
        return Layout(exemplar, shapes, ground, period(reduced[0]), remark)


def check_size(photo: Photo) -> None:
    """Refuse an image that is too small to be an exemplar.

    Raises
    ------
    IconstudioError
        If it is.
    """
    if min(photo.width, photo.height) < _SMALLEST:
        raise IconstudioError(
            f"The image has {photo.width} x {photo.height} pixels. "
            f"Give one of at least {_SMALLEST} x {_SMALLEST}."
        )


def reduction_of(photo: Photo) -> str:
    """Return a sentence about an image that is larger than an exemplar can be; empty if not."""
    if max(photo.width, photo.height) <= LARGEST:
        return ""
    return f"The image of {photo.width} x {photo.height} pixels is reduced to {LARGEST} a side."


@lru_cache(2)  # each edit runs on the same photo again
def _reduced(photo: Photo) -> tuple[NDArray[np.uint8], str]:
    """Return the pixels to look at, (h, w, 3), and their digest."""
    pixels = _calm(over_white(photo))
    digest = hashlib.sha256(pixels.tobytes() + repr(pixels.shape).encode()).hexdigest()
    return pixels, digest


def over_white(photo: Photo) -> NDArray[np.uint8]:
    """Return the pixels of an image over white, (h, w, 3), at most ``LARGEST`` a side."""
    from PIL import Image

    words = [photo.levels[0], *(one for one in photo.levels if max(one.shape) >= LARGEST)][-1]
    alpha = words >> 24
    shown = np.stack([((words >> shift) & 255) + 255 - alpha for shift in (16, 8, 0)], axis=2)
    pixels: NDArray[np.uint8] = np.minimum(shown, 255).astype(np.uint8)
    if max(pixels.shape) > LARGEST:
        image = Image.fromarray(pixels)
        image.thumbnail((LARGEST, LARGEST), Image.Resampling.BOX)
        pixels = np.array(image)
    return pixels


def corrected(layers: Layers, corrections: Sequence[Correction], reduction: float) -> Layers:
    """Return layers where strokes of the brush say others."""
    from PIL import Image, ImageDraw

    image = Image.fromarray(layers)
    draw = ImageDraw.Draw(image)
    for one in corrections:
        points = [(x / reduction, y / reduction) for x, y in one.stroke.points]
        half = one.stroke.width / reduction / 2
        draw.line(points, one.layer, max(1, round(2 * half)), "curve")
        for x, y in (points[0], points[-1]):
            draw.ellipse((x - half, y - half, x + half, y + half), one.layer)
    return np.array(image)


def remark_of(found: Separated, pixels: NDArray[np.uint8]) -> str:
    """Return sentences about layers that were joined, and gradients; empty if there are none."""
    remarks = []
    if found.found > MOST_LAYERS:
        remarks.append(
            f"The image has {found.found} layers, and a pattern at most {MOST_LAYERS}: the "
            "smallest went to those of the nearest colours. Fewer colours give clearer layers."
        )
    if has_gradient(pixels, found.flat):
        remarks.append("A gradient of the image becomes one even colour.")
    return " ".join(remarks)


def unheeded(work: Patterning) -> str:
    """Return a sentence about what an image does not heed of what is wanted; empty if nothing."""
    if work.image is None:
        return ""
    asked = {
        "density": work.density != 1,
        "turn": work.turn % 360 != 0,
        "ground": work.ground not in ("", GROUND),
    }
    names = [name for name, was in asked.items() if was]
    if not names:
        return ""
    own = joined(names)
    return f"An image keeps its own {own}; what was asked for is passed over."


def _labels(masks: Masks) -> NDArray[np.int32]:
    """Return which element each pixel of each layer belongs to, from 1; 0 where there is none.

    Those of a mosaic fit each other, and not other places: it is one that goes on.
    """
    labels = []
    for mask in masks:
        ink = mask > 0.5
        own = grouped(*components(ink)) if ink.mean() < _TIGHT else ink.astype(np.int32)
        around = ndimage.grey_dilation(own, size=(3, 3))
        labels.append(np.where((own == 0) & (mask > _SOFT), around, own))
    return np.stack(labels)


def _calm(pixels: NDArray[np.uint8]) -> NDArray[np.uint8]:
    """Return an image with noise, as lossy compression leaves, at a lower resolution."""
    from PIL import Image, ImageFilter

    if not is_noisy(pixels):
        return pixels
    image = Image.fromarray(pixels)
    while max(image.size) > _NOISY_MOST:
        image = image.reduce(2)
    if is_grainy(np.asarray(image)):
        image = image.filter(ImageFilter.MedianFilter(3))
    return np.array(image)


def _resized(
    channel: NDArray[np.float32] | NDArray[np.uint8], size: tuple[int, ...]
) -> NDArray[np.float32]:
    """Return a channel (h, w) at another size, each pixel the mean of those in its place."""
    from PIL import Image

    rows, columns = size
    large = Image.fromarray(np.ascontiguousarray(channel, np.float32))
    shrinks = channel.shape[0] > rows
    way = Image.Resampling.BOX if shrinks else Image.Resampling.BICUBIC
    resized: NDArray[np.float32] = np.array(large.resize((columns, rows), way))
    return resized.clip(channel.min(), channel.max())
