"""How long drawing and tracing take, and how far the outlines are from the icons', in canvas units.

Run with ``pytest -n 0 tests/benchmarks --benchmark-only``; figures are medians.
"""

import numpy as np
import pytest
from PIL import Image
from scipy import ndimage

from iconstudio.algorithms.iconification.redraw import SCALE, binarised, redraw
from iconstudio.algorithms.tracing.vectorize import trace
from iconstudio.model import CANVAS, Frame, Path, Placement
from iconstudio.session import Session
from iconstudio.svg.placed import render_placed
from iconstudio.svg.resvg import render_coverage
from iconstudio.workflows.drawing import PREVIEW

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
                coverage = binarised(render_placed(*whole, SCALE * CANVAS))
                drawn.append((coverage, render_placed(*whole, FINE) > 127))
    return drawn


def edge(ink: np.ndarray) -> np.ndarray:
    return ink & ~ndimage.binary_erosion(ink, border_value=1)


def document(path: Path) -> str:
    drawn = f'<path d="{path.svg()}"/>'
    return f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 256 256">{drawn}</svg>'


def astray(path: Path, truth: np.ndarray) -> np.ndarray:
    """Distances from the outline of the path to that of the icon."""
    ours = edge(render_coverage(document(path), Frame(0, 0, CANVAS), FINE) > 127)
    away = ndimage.distance_transform_edt(~edge(truth)) * CANVAS / FINE
    return np.minimum(away[ours], FAR)


@pytest.mark.benchmark(group="tracing a drawing of 1024 x 1024")
def test_trace(benchmark, icons):
    coverages = iter([coverage for coverage, _ in icons])
    benchmark.pedantic(trace, setup=lambda: ((next(coverages),), {}), rounds=len(icons))
    paths = [trace(coverage) for coverage, _ in icons]
    errors = [astray(path, truth) for path, (_, truth) in zip(paths, icons, strict=True)]
    segments = [sum(len(contour.segments) for contour in path.contours) for path in paths]
    benchmark.extra_info["mean distance"] = round(float(np.mean([e.mean() for e in errors])), 4)
    benchmark.extra_info["worst distance, median"] = round(
        float(np.median([e.max() for e in errors])), 3
    )
    benchmark.extra_info["segments, mean"] = float(np.mean(segments))
    benchmark.extra_info["bytes, mean"] = float(np.mean([len(path.svg()) for path in paths]))
    assert np.mean([e.mean() for e in errors]) < 0.03


@pytest.mark.benchmark(group="drawing a result as SVG")
@pytest.mark.parametrize("scale", [SCALE, PREVIEW], ids=["at 1024 px", "at 512 px, as a preview"])
def test_draw(benchmark, icons, scale):
    """Four icons in each, whose regions have nothing to do with them: the worst of results."""
    noise = np.random.default_rng(0).normal(size=(4, CANVAS, CANVAS))
    labels = ndimage.gaussian_filter(noise, (0, 15, 15)).argmax(axis=0).astype(np.uint8)
    smaller = SCALE // scale
    drawn = [np.asarray(Image.fromarray(coverage).reduce(smaller)) for coverage, _ in icons]
    results = [dict(enumerate(drawn[k : k + 4])) for k in range(0, len(drawn) - 3, 2)]

    def draw(coverages):
        joined = redraw(labels, coverages)
        return joined, trace(joined)

    rounds = iter(results * 2)
    benchmark.pedantic(draw, setup=lambda: ((next(rounds),), {}), rounds=2 * len(results))
    least = 1.0
    for joined, path in map(draw, results):
        again = render_coverage(document(path), Frame(0, 0, CANVAS), len(joined)) > 127
        truth = joined > 127
        least = min(least, (again & truth).sum() / (again | truth).sum())
    benchmark.extra_info["least overlap with the redrawn sources"] = round(float(least), 4)
    assert scale < SCALE or least > 0.99
