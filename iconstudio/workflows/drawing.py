"""Drawing a labelling from the SVG of its sources (section 3.4, post-processing), in a process.

A source is drawn only where it is needed: a renderer takes longer the more pixels there are.
"""

from collections.abc import Mapping, Sequence
from concurrent.futures import Future
from dataclasses import dataclass, field
from functools import lru_cache
from typing import Protocol

import numpy as np
import scipy
from numpy.typing import NDArray

from iconstudio.algorithms.energy import Labels
from iconstudio.algorithms.fragments import fragments
from iconstudio.algorithms.raster import Bitmap, inked_tiles
from iconstudio.algorithms.redraw import FAR, REACH, SCALE, erase, redraw, two_tone
from iconstudio.model import CANVAS, Drawing, Exemplar, Frame, Placement, Source
from iconstudio.workers import Workers

PREVIEW = 2
"""Drawn pixels to a canvas pixel, in previews."""
_TILES = 64
"""What is needed of a source is told by tiles, so many to a side of the canvas."""
_BLOCKS = 8
"""Sources are drawn by blocks, so many to a side: larger ones have more than is needed, and of
smaller ones each costs half a millisecond."""
_AROUND = -(-(REACH + FAR) * _TILES // CANVAS)
"""Tiles around a region in which its owner's drawing counts."""
_COVERAGE = 2 * CANVAS
"""Side of a drawing's coverage, in pixels."""


class Render(Protocol):
    """Draws exemplars at their placement."""

    def __call__(
        self,
        svg: str,
        frame: Frame,
        placement: Placement,
        size: int,
        window: tuple[int, int, int, int] | None = None,
    ) -> NDArray[np.uint8]:
        """Draw the canvas, (size, size) uint8, or a window of it.

        ``window`` is left, top, right and bottom in pixels, and may reach beyond the canvas.
        """
        ...


def draw(
    labels: Labels,
    ink: NDArray[np.bool_],
    sources: Sequence[Source],
    render: Render,
    scale: int = SCALE,
) -> Drawing:
    """Redraw a labelling from its owners' SVG without its crumbs, and trace it.

    Parameters
    ----------
    labels
        (m, m): index of each pixel's owner.
    ink
        (K, m, m) bool: the sources on the canvas.
    scale
        Drawn pixels to a canvas pixel: 2, 4 or 8, and no fewer than there are labels.
    """
    from iconstudio.algorithms.vectorize import trace

    coverage = redraw(labels, _drawn(labels, sources, render, scale * CANVAS))
    erase(coverage, fragments(labels, ink))
    return Drawing(trace(coverage), _reduced(coverage))


def draw_whole(
    source: Source, ink: NDArray[np.bool_], workers: Workers, render: Render
) -> "Future[Drawing]":
    """Begin to draw one source as results are drawn; ``ink`` is its, (CANVAS, CANVAS)."""
    nobody = np.zeros((CANVAS, CANVAS), dtype=np.uint8)
    return workers.submit(draw, nobody, ink[None], [source], render)


def _drawn(
    labels: Labels, sources: Sequence[Source], render: Render, side: int
) -> Mapping[int, NDArray[np.uint8]]:
    """Draw every owner, (side, side) uint8, wherever it counts."""
    m = len(labels)
    tile = np.arange(m) * _TILES // m
    owned = np.zeros((len(sources), _TILES, _TILES), dtype=bool)
    owned[labels, tile[:, None], tile] = True
    coverages = {}
    for label in np.flatnonzero(owned.any(axis=(1, 2))):
        near = scipy.ndimage.maximum_filter(owned[label], 2 * _AROUND + 1)
        coverages[int(label)] = _sheet(_Wanted.of(sources[label], render, side)).shown(near)
    return coverages


@dataclass(frozen=True)
class _Wanted:
    """What tells one sheet from another."""

    render: Render
    svg: str
    frame: Frame
    placement: Placement
    side: int
    exemplar: Exemplar = field(compare=False)

    @classmethod
    def of(cls, source: Source, render: Render, side: int) -> "_Wanted":
        one = source.exemplar
        return cls(render, one.pictogram.svg, one.frame, source.placement, side, one)


class _Sheet:
    """A source at its placement, drawn block by block as they are needed, in two tones.

    A renderer draws a curve a little differently where a window ends. So the blocks are always the
    same: a drawing does not depend on what was drawn before.
    """

    def __init__(self, wanted: _Wanted) -> None:
        self._wanted = wanted
        self._coverage = np.zeros((wanted.side, wanted.side), dtype=np.uint8)
        self._missing = inked_tiles(wanted.exemplar, wanted.placement, _TILES)

    def shown(self, needed: Bitmap) -> NDArray[np.uint8]:
        """Return the drawing, (side, side) uint8, complete in the ``needed`` tiles at least."""
        step = _TILES // _BLOCKS
        missing = (needed & self._missing).reshape(_BLOCKS, step, _BLOCKS, step)
        for row, column in np.argwhere(missing.any(axis=(1, 3))):
            self._draw(row, column)
            self._missing[row * step : (row + 1) * step, column * step : (column + 1) * step] = 0
        return self._coverage

    def _draw(self, row: int, column: int) -> None:
        wanted = self._wanted
        step = wanted.side // _BLOCKS
        top, left = int(row) * step, int(column) * step
        bottom, right = top + step, left + step
        # One more pixel around, for the edges between ink and paper.
        window = left - 1, top - 1, right + 1, bottom + 1
        drawn = wanted.render(wanted.svg, wanted.frame, wanted.placement, wanted.side, window)
        self._coverage[top:bottom, left:right] = two_tone(drawn)[1:-1, 1:-1]


@lru_cache(maxsize=64)
def _sheet(wanted: _Wanted) -> _Sheet:
    """Remember sheets, 1 MiB each at most: the results of a style share most of their sources."""
    return _Sheet(wanted)


def _reduced(coverage: NDArray[np.uint8]) -> NDArray[np.uint8]:
    from PIL import Image

    factor = len(coverage) // _COVERAGE
    if factor == 1:
        return coverage
    return np.asarray(Image.fromarray(coverage).reduce(factor))
