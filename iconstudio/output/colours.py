"""Colour code by source (section 4.1): a hue for each pictogram, a lightness for each placement."""

import colorsys
from collections.abc import Iterable

import numpy as np
from numpy.typing import NDArray
from PIL import Image
from scipy import ndimage

from iconstudio.model import Composite, Drawing, Placement, Source

RGB = tuple[int, int, int]
Palette = dict[tuple[str, Placement], RGB]
"""The colour of an exemplar at a placement."""

SIGNIFICANT = 0.02
"""Least share of the ink for a source to be shown beside a result."""

# Degrees. Each is far from those before it; the first ones differ in blue and yellow
# content, which colour-blind people see too.
_HUES = (212, 28, 150, 330, 48, 270, 186, 4, 95, 300)
_GOLDEN_ANGLE = 137.508
_SATURATION = 0.68
_LIGHTNESSES = (0.50, 0.70, 0.36, 0.80, 0.26)
_INTERIOR = 0.16
"""Opacity of the tint of white interior structure, so that its owner shows."""
_SOFTNESS = 1.0
"""Standard deviation, in canvas pixels, that rounds the steps of the label map."""


def significant_sources(composite: Composite, least: float = SIGNIFICANT) -> list[int]:
    """Return the labels that own at least ``least`` of the ink, largest share first."""
    labels = [label for label, share in enumerate(composite.shares) if share >= least]
    return sorted(labels, key=lambda label: -composite.shares[label])


def palette(composites: Iterable[Composite]) -> Palette:
    """Return one colour for each source, the same in all ``composites``.

    Pictograms with most ink get the hues that are easiest to tell apart.
    """
    ink: dict[tuple[str, Placement], float] = {}
    for composite in composites:
        for source, share in zip(composite.sources, composite.shares, strict=True):
            ink[_key(source)] = ink.get(_key(source), 0.0) + share
    pictograms: dict[str, float] = {}
    for (name, _), share in ink.items():
        pictograms[name] = pictograms.get(name, 0.0) + share
    ranks = {name: rank for rank, name in enumerate(sorted(pictograms, key=_most(pictograms)))}
    placements: dict[str, int] = {}
    colours: Palette = {}
    for key in sorted(ink, key=_most(ink)):
        name = key[0]
        number = placements[name] = placements.get(name, -1) + 1
        colours[key] = _colour(ranks[name], number)
    return colours


def source_colours(composite: Composite, colours: Palette | None = None) -> list[RGB]:
    """Return the colour of each source; ``colours`` is the composite's own palette by default."""
    if colours is None:
        colours = palette([composite])
    return [colours[_key(source)] for source in composite.sources]


def colour_code(
    composite: Composite, drawing: Drawing, size: int, colours: Palette | None = None
) -> NDArray[np.uint8]:
    """Paint every pixel of a drawing in the colour of its owner.

    Returns
    -------
    (size, size, 4) uint8, RGBA, alpha not multiplied in. White interior structure has a pale tint.
    """
    paint = _smooth(composite.labels, source_colours(composite, colours), size)
    picture = Image.fromarray(drawing.coverage).resize((size, size), Image.Resampling.BOX)
    coverage = np.asarray(picture)
    filled = ndimage.binary_fill_holes(coverage > 127)
    alpha = np.where(filled, np.maximum(coverage, round(255 * _INTERIOR)), coverage)
    return np.dstack([paint, alpha.astype(np.uint8)])


def _smooth(labels: NDArray[np.uint8], colours: list[RGB], size: int) -> NDArray[np.uint8]:
    """Paint the label map at ``size``, its pixel steps rounded."""
    total = np.zeros((size, size, 1), np.float32)
    paint = np.zeros((size, size, 3), np.float32)
    for label in np.unique(labels):
        soft = ndimage.gaussian_filter((labels == label).astype(np.float32), _SOFTNESS)
        large = Image.fromarray(soft).resize((size, size), Image.Resampling.BILINEAR)
        # The power sharpens the blur to an edge as wide as a pixel or two.
        weight = np.maximum(np.asarray(large), 1e-4)[..., None] ** 12
        total += weight
        paint += weight * np.array(colours[label], np.float32)
    return (paint / total).round().astype(np.uint8)


def _colour(rank: int, placement: int) -> RGB:
    hue = _HUES[rank] if rank < len(_HUES) else _HUES[-1] + _GOLDEN_ANGLE * (rank - len(_HUES) + 1)
    lightness = _LIGHTNESSES[placement % len(_LIGHTNESSES)]
    red, green, blue = colorsys.hls_to_rgb(hue / 360 % 1, lightness, _SATURATION)
    return round(255 * red), round(255 * green), round(255 * blue)


def _key(source: Source) -> tuple[str, Placement]:
    return source.exemplar.id, source.placement


def _most(ink: dict):
    """Order by falling ink; ties by name, so that the same run has the same colours."""
    return lambda key: (-round(ink[key], 9), key)
