"""The montage of a result: its sources as layers, scribbled over so that it comes out again."""

import numpy as np

from iconstudio.algorithms.iconification.energy import placed_sources
from iconstudio.algorithms.iconification.guidance import scribble
from iconstudio.algorithms.iconification.midlines import midlines
from iconstudio.algorithms.raster import Bitmap
from iconstudio.model import CANVAS, Composite, Layer, Montage, Stroke
from iconstudio.workflows.montage.montage import MOST
from iconstudio.workflows.montage.strokes import strokes_of

_WITHIN = 0.8
"""Strokes are so much narrower than what they mark: they keep off what belongs to others."""
_WORTH = 40.0
"""Strokes that mark fewer square units are left out: crumbs, and the corners of shapes."""


def reproduction(composite: Composite) -> Montage:
    """Return the montage of a composite's sources that reproduces it.

    Each source is scribbled over in the middle of the ink that it owns. Sources with hardly any are
    left out, and so are those with the least if there are too many.
    """
    finer = len(composite.labels) // CANVAS
    labels = composite.labels[::finer, ::finer]
    ink, _ = placed_sources(composite.sources)
    layers = []
    for label in sorted(composite.owners()[:MOST]):
        source = composite.sources[label]
        if strokes := strokes_over(ink[label] & (labels == label)):
            layers.append(Layer(source.exemplar.pictogram, source.placement, strokes))
    return Montage(tuple(layers))


def strokes_over(shape: Bitmap) -> tuple[Stroke, ...]:
    """Return strokes in the middle of a shape (m, m) bool, which cover most of it and no more.

    The widest come first; what would cover hardly more than those before it is left out.
    """
    side = len(shape)
    covered = np.zeros_like(shape)
    kept: list[Stroke] = []
    for points, widths in midlines(shape):
        strokes = strokes_of(points, [_WITHIN * width for width in widths])
        more = scribble(strokes, side) & ~covered
        if more.sum() * (CANVAS / side) ** 2 >= _WORTH:
            covered |= more
            kept.extend(strokes)
    return tuple(kept)
