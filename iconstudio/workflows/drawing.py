"""Drawing a labelling from the SVG of its sources (section 3.4, post-processing), in a process."""

from collections.abc import Callable, Sequence
from concurrent.futures import Future
from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from iconstudio.algorithms.energy import Labels
from iconstudio.algorithms.fragments import fragments
from iconstudio.algorithms.redraw import SCALE, erase, redraw, two_tone
from iconstudio.model import CANVAS, Drawing, Frame, Placement, Source
from iconstudio.workers import Workers

Render = Callable[[str, Frame, Placement, int], NDArray[np.uint8]]
"""Draws (svg, frame, placement, n): the canvas with an exemplar at its placement, (n, n) uint8."""


def draw(
    labels: Labels,
    ink: NDArray[np.bool_],
    drawn: Sequence[tuple[str, Frame, Placement]],
    render: Render,
) -> Drawing:
    """Redraw a labelling from its owners' SVG without its crumbs, and trace it.

    ``ink`` is (K, CANVAS, CANVAS) bool: the sources on the canvas.
    """
    from iconstudio.algorithms.vectorize import trace

    coverages = {
        int(label): _rendered(render, *drawn[label], SCALE * CANVAS) for label in np.unique(labels)
    }
    coverage = redraw(labels, coverages)
    erase(coverage, fragments(labels, ink))
    half = coverage.reshape(CANVAS * SCALE // 2, 2, CANVAS * SCALE // 2, 2).mean(axis=(1, 3))
    return Drawing(trace(coverage), half.round().astype(np.uint8))


def draw_whole(
    source: Source, ink: NDArray[np.bool_], workers: Workers, render: Render
) -> "Future[Drawing]":
    """Begin to draw one source as results are drawn; ``ink`` is its, (CANVAS, CANVAS)."""
    nobody = np.zeros((CANVAS, CANVAS), dtype=np.uint8)
    return workers.submit(draw, nobody, ink[None], [drawn_from(source)], render)


def drawn_from(source: Source) -> tuple[str, Frame, Placement]:
    """Return what a worker process needs to know of a source."""
    return source.exemplar.pictogram.svg, source.exemplar.frame, source.placement


@lru_cache(maxsize=64)
def _rendered(
    render: Render, svg: str, frame: Frame, placement: Placement, size: int
) -> NDArray[np.uint8]:
    """Remember drawings, 1 MiB each: the results of one style share most of their sources."""
    return two_tone(render(svg, frame, placement, size))
