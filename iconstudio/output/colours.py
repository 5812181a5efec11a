"""Colour coding by source (section 4.1): a hue a pictogram, a lightness a placement (HSL)."""

from collections import Counter, defaultdict
from collections.abc import Sequence
from colorsys import hls_to_rgb

import numpy as np
from numpy.typing import NDArray

from iconstudio.algorithms.extremes import maximum_filter, minimum_filter
from iconstudio.algorithms.iconification.blending import at, in_blocks, soft_regions
from iconstudio.algorithms.raster import solid
from iconstudio.model import CANVAS, Composite, Drawing, Placement, Source

Key = tuple[str, Placement]
"""A source: the pictogram's identifier, and where it lies."""
RGB = tuple[int, int, int]
Palette = dict[Key, RGB]

HUES = (
    (0.595, 0.70, 0.47),  # blue
    (0.083, 0.92, 0.52),  # orange
    (0.435, 0.68, 0.35),  # green
    (0.900, 0.62, 0.60),  # pink
    (0.138, 0.85, 0.48),  # yellow
    (0.745, 0.50, 0.54),  # violet
    (0.525, 0.75, 0.55),  # sky
    (0.010, 0.72, 0.47),  # red
    (0.245, 0.55, 0.42),  # leaf
    (0.060, 0.42, 0.34),  # brown
)
"""Hue, saturation and lightness, all 0 to 1. Neighbours in the list differ in blue and yellow
content or in lightness too, so that who does not see red and green can tell them apart."""
_LIGHTER = (0.0, 0.17, -0.15, 0.28, -0.08, 0.09)
"""Added to the lightness for the first, second... placement of a pictogram."""
TINT = 0.16
"""Opacity of the interior, the white that the icon encloses."""
SIGNIFICANT = 0.02
"""Least part of the ink for a source to be shown beside a result."""
_BLUR = 1.2
"""Standard deviation, in canvas pixels, that rounds the staircase between two owners off."""
_REACH = 4
_NEAR = 2
"""How far from the staircase, in canvas pixels, the smooth border may run."""


def palette(composites: Sequence[Composite]) -> Palette:
    """Return one colour for each source of ``composites``, which share their sources.

    A pictogram prefers the hue of its rank among the sources, which is the same in all results of a
    style. Of two that prefer one hue, the smaller contributor takes a free one, so that the ten
    largest always differ.
    """
    owned: defaultdict[Key, float] = defaultdict(float)
    for composite in composites:
        for source, share in zip(composite.sources, composite.shares, strict=True):
            owned[key_of(source)] += share
    matched = [name for name, _ in Counter(name for name, _ in owned).most_common()]
    largest = dict.fromkeys(matched, 0.0)
    for (name, _), share in owned.items():
        largest[name] += share
    hues: dict[str, int] = {}
    for name in sorted(largest, key=largest.__getitem__, reverse=True):
        taken = Counter(hues.values())
        wanted = matched.index(name)
        order = [(wanted + step) % len(HUES) for step in range(len(HUES))]
        hues[name] = min(order, key=taken.__getitem__)
    colours: Palette = {}
    placed: Counter[str] = Counter()
    for key in sorted(owned, key=owned.__getitem__, reverse=True):
        colours[key] = _colour(hues[key[0]], placed[key[0]])
        placed[key[0]] += 1
    return colours


def source_colours(composite: Composite, colours: Palette | None = None) -> NDArray[np.uint8]:
    """Return the colour of every source, (K, 3) uint8 RGB; by default from its own palette."""
    colours = palette([composite]) if colours is None else colours
    return np.array([colours[key_of(source)] for source in composite.sources], np.uint8)


def numbered_colour(number: int) -> RGB:
    """Return the colour of icon ``number``, from 0: those of the first ten differ in hue."""
    return _colour(number % len(HUES), number // len(HUES))


def colour_code(
    composite: Composite, drawing: Drawing, size: int, colours: Palette | None = None
) -> NDArray[np.uint8]:
    """Paint every pixel of a result in the colour of its owner.

    Ink is opaque, the interior tinted, and what lies outside is transparent.

    Returns
    -------
    (size, size, 4) uint8 RGBA, alpha not multiplied in
    """
    owners = composite.labels if drawing.owners is None else drawing.owners
    m = len(owners)
    scale = -(-size // m)
    coverage = _resized(drawing.coverage, m * scale)
    alpha = np.maximum(coverage, np.where(solid(coverage > 127), round(255 * TINT), 0))
    painted = _painted(owners, source_colours(composite, colours), alpha > 0)
    picture = np.dstack([painted, alpha.astype(np.uint8)])
    return _resized(picture, size)


def key_of(source: Source) -> Key:
    """Return what two sources have in common that draw the same."""
    return source.exemplar.id, source.placement


def _painted(
    labels: NDArray[np.uint8], colours: NDArray[np.uint8], seen: NDArray[np.bool_]
) -> NDArray[np.uint8]:
    """Paint the label map, enlarged, with smooth borders where they are seen: (n, n, 3).

    Each owner's region is blurred; its high power makes borders an edge a pixel wide again.
    ``seen`` is (n, n) bool.
    """
    m, n = len(labels), len(seen)
    s = n // m
    picture = colours[labels].repeat(s, axis=0).repeat(s, axis=1)
    around = 2 * (_NEAR * m // CANVAS) + 1
    highest = maximum_filter(labels, around)
    border = highest != minimum_filter(labels, around)
    blocks = np.argwhere(border)
    blocks = blocks[in_blocks(seen, s)[at(blocks)].any(axis=(1, 2))]
    total, paint = (np.zeros((len(blocks), s, s, depth), np.float32) for depth in (1, 3))
    for share in soft_regions(labels, _BLUR, _REACH):
        rows = share.rows(blocks)
        weight = np.maximum(share.weights(blocks[rows], s), 1e-4)[..., None]
        for _ in range(3):
            weight *= weight
        total[rows] += weight
        paint[rows] += weight * colours[share.label].astype(np.float32)
    in_blocks(picture, s)[at(blocks)] = (paint / total).round()
    return picture


def _colour(hue: int, placement: int) -> RGB:
    h, s, lightness = HUES[hue]
    lightness += _LIGHTER[placement % len(_LIGHTER)]
    red, green, blue = hls_to_rgb(h, lightness, s)
    return round(255 * red), round(255 * green), round(255 * blue)


def _resized(picture: NDArray[np.uint8], size: int) -> NDArray[np.uint8]:
    from PIL import Image

    if len(picture) == size:
        return picture
    smooth = Image.Resampling.LANCZOS
    return np.asarray(Image.fromarray(picture).resize((size, size), smooth))
