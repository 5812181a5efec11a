"""How long tracing takes, and how far its outlines are from the icons', in canvas units.

Run with ``python -m pytest tests/benchmarks --benchmark-only``; figures are medians.
"""

import re

import numpy as np
import pytest
from scipy import ndimage

from iconstudio.algorithms.redraw import SCALE, two_tone
from iconstudio.algorithms.vectorize import trace
from iconstudio.library.resvg import render_coverage, render_placed
from iconstudio.model import CANVAS, Frame, Placement
from iconstudio.session import Session

WORDS = ("house", "cat", "car", "tree", "camera", "chess", "bicycle", "flower", "gear", "music")
FINE = 16 * CANVAS
FAR = 1.0
"""A distance, in canvas units, beyond which a speck is missing rather than a line astray."""


@pytest.fixture(scope="module")
def icons():
    """Three icons a word, drawn as the program draws them, and their ink in full detail."""
    drawn = []
    with Session() as session:
        for word in WORDS:
            for pictogram in session.search(word)[:60:20]:
                one = session.exemplar(pictogram)
                whole = pictogram.svg, one.frame, Placement()
                coverage = two_tone(render_placed(*whole, SCALE * CANVAS))
                drawn.append((coverage, render_placed(*whole, FINE) > 127))
    return drawn


def edge(ink: np.ndarray) -> np.ndarray:
    return ink & ~ndimage.binary_erosion(ink, border_value=1)


def astray(path: str, truth: np.ndarray) -> np.ndarray:
    """Distances from the outline of the path to that of the icon."""
    svg = f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 256 256"><path d="{path}"/></svg>'
    ours = edge(render_coverage(svg, Frame(0, 0, CANVAS), FINE) > 127)
    away = ndimage.distance_transform_edt(~edge(truth)) * CANVAS / FINE
    return np.minimum(away[ours], FAR)


@pytest.mark.benchmark(group="tracing a drawing of 1024 x 1024")
def test_trace(benchmark, icons):
    coverages = iter([coverage for coverage, _ in icons])
    benchmark.pedantic(trace, setup=lambda: ((next(coverages),), {}), rounds=len(icons))
    paths = [trace(coverage) for coverage, _ in icons]
    errors = [astray(path, truth) for path, (_, truth) in zip(paths, icons, strict=True)]
    segments = [len(re.findall("[LHVC]", path)) for path in paths]
    benchmark.extra_info["mean distance"] = round(float(np.mean([e.mean() for e in errors])), 4)
    benchmark.extra_info["worst distance, median"] = round(
        float(np.median([e.max() for e in errors])), 3
    )
    benchmark.extra_info["segments, mean"] = float(np.mean(segments))
    benchmark.extra_info["bytes, mean"] = float(np.mean([len(path) for path in paths]))
    assert np.mean([e.mean() for e in errors]) < 0.03
