"""An icon made by hand: who owns what is known."""

from dataclasses import replace

import numpy as np

from iconstudio.algorithms.iconification.energy import remix_problem
from iconstudio.algorithms.iconification.tsdf import tsdf
from iconstudio.algorithms.raster import fill_polygon
from iconstudio.model import (
    CANVAS,
    Composite,
    Credit,
    Exemplar,
    Placement,
    Polygon,
    Remix,
    Sketch,
    Source,
)
from iconstudio.svg.placed import render_placed
from iconstudio.workflows.remixing import remix_of
from iconstudio.workflows.solving import CutSeries, Posed, Step, finished
from tests.shapes import exemplar

SQUARE = Polygon.of([(0, 0), (100, 0), (100, 100), (0, 100)])
SKETCH = Sketch(SQUARE, "dog & cat")
TARGET = fill_polygon(SQUARE.fitted())

_Y, _X = np.mgrid[:CANVAS, :CANVAS] + 0.5 - CANVAS / 2
RADIUS = np.hypot(_X, _Y)
RING = exemplar((RADIUS < 100) & (RADIUS > 50), "ring")
DISC = exemplar(RADIUS < 90, "disc")
BLOCK = exemplar(np.maximum(abs(_X), abs(_Y)) < 80, "block")
SOURCES = (
    Source(RING, Placement(), 0.5, 0),
    Source(RING, Placement(1.1, True, 12, -3), 0.75, 0),
    Source(BLOCK, Placement(), 1.0, 0),
    Source(DISC, Placement(0.9), 1.25, 1),
)
"""The last one owns nothing in the results below."""


def quarters() -> np.ndarray:
    """The left half is the first source's; the right half has the second above the third."""
    labels = np.zeros((CANVAS, CANVAS), np.uint8)
    labels[:128, 128:], labels[128:, 128:] = 1, 2
    return labels


def credited(one: Exemplar, credit: Credit) -> Exemplar:
    return replace(one, pictogram=replace(one.pictogram, credit=credit))


def made(
    labels: np.ndarray,
    lambda_s: float = 0.1,
    style: str = "light",
    sources: tuple[Source, ...] = SOURCES,
) -> Remix:
    """The icon of a labelling, with its true energy."""
    posed = Posed(remix_problem(tsdf(TARGET), sources), TARGET)
    series = CutSeries(style, sources, lambda: posed, (lambda_s,))
    step = Step(lambda_s)
    return remix_of(series, step, finished(posed, series, step, labels, render_placed))


def titled(icon: Remix, title: str, composite: Composite | None = None) -> Remix:
    """The icon of a drawing with another title, and perhaps other sources."""
    return Remix.of(composite or icon.composite, icon.drawing, icon.score, title)


def with_shares(one: Composite, *shares: float) -> Composite:
    return replace(one, shares=shares)
