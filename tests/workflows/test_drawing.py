"""Sources are drawn where they are needed, and look as if they had been drawn as a whole."""

import math
from functools import cache

import numpy as np
import pytest
from hypothesis import example, given, settings
from hypothesis import strategies as st
from PIL import Image
from scipy import ndimage

from iconstudio.algorithms.iconification.energy import placed_sources
from iconstudio.algorithms.iconification.fragments import fragments
from iconstudio.algorithms.iconification.redraw import SCALE, binarised, erase, redraw
from iconstudio.algorithms.raster import inked_tiles
from iconstudio.model import CANVAS, Exemplar, Frame, Path, Placement, Source
from iconstudio.svg.placed import Renderer, render_placed
from iconstudio.svg.rasterise import rasterise
from iconstudio.svg.resvg import render_coverage
from iconstudio.workflows.drawing import PREVIEW, draw
from tests.shapes import pictogram

pytestmark = pytest.mark.thorough(but=1)

SHAPES = (
    '<circle cx="128" cy="128" r="96" fill="none" stroke="#000" stroke-width="12"/>',
    '<path d="M128 20L230 220H26ZM128 80v60" fill="none" stroke="#000" stroke-width="16"/>',
    '<rect x="30" y="50" width="190" height="150" rx="30"/>',
    '<path d="M20 128H236" stroke="#000" stroke-width=".4"/>'
    '<path d="M20 20H99V99H20ZM190 190h40v40h-40z"/>',
)
UNEVEN = Placement(0.9, True, 7, -4)


@cache
def exemplar(number: int) -> Exemplar:
    icon = pictogram(str(number), SHAPES[number])
    return Exemplar(icon, *rasterise(icon.svg))


def source(number: int, placement: Placement) -> Source:
    return Source(exemplar(number), placement)


def regions(side: int, seed: int) -> np.ndarray:
    noise = np.random.default_rng(seed).normal(size=(len(SHAPES), 64, 64))
    smooth = ndimage.gaussian_filter(noise, (0, 5, 5))
    large = ndimage.zoom(smooth, (1, side / 64, side / 64), order=1)
    return large.argmax(axis=0).astype(np.uint8)


def likeness(one: np.ndarray, other: np.ndarray) -> float:
    a, b = one > 127, other > 127
    return (a & b).sum() / (a | b).sum()


def again(path: Path, size: int) -> np.ndarray:
    body = f'<path d="{path.svg()}"/>'
    svg = f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 256 256">{body}</svg>'
    return render_coverage(svg, Frame(0, 0, CANVAS), size)


def whole(labels, sources, scale):
    """The same drawing of sources that were drawn as a whole."""
    coverages = {}
    for label in np.unique(labels):
        one = sources[label]
        svg, frame = one.exemplar.pictogram.svg, one.exemplar.frame
        coverages[int(label)] = binarised(render_placed(svg, frame, one.placement, scale * CANVAS))
    return redraw(labels, coverages)


@pytest.fixture
def sources():
    placements = (Placement(), UNEVEN, Placement(1.1, dx=-3), Placement(dy=5))
    return [source(number, placement) for number, placement in enumerate(placements)]


@pytest.mark.parametrize(
    ("side", "scale"), [(256, SCALE), (256, PREVIEW), (128, PREVIEW), (512, 4)]
)
def test_a_drawing_is_that_of_whole_sources(sources, side, scale):
    for seed in range(3):  # the later ones find some tiles drawn already
        labels = regions(side, seed)
        ink, _ = placed_sources(sources, side)
        drawing = draw(labels, ink, sources, render_placed, scale, exact=False)
        expected = whole(labels, sources, scale)
        erase(expected, fragments(labels, ink))
        half = Image.fromarray(expected).resize((512, 512), Image.Resampling.BOX)
        off = abs(np.asarray(half).astype(int) - drawing.coverage)
        assert drawing.coverage.shape == (512, 512)
        assert (
            off.mean() < 0.05
        )  # of a missing tile 0.2; a window that cuts a curve alters it a bit
        assert likeness(again(drawing.path, 512), drawing.coverage) > 0.98


def test_the_picture_of_a_result_is_that_of_its_path(sources):
    """Also where sources were moved and seams made anew: near what was joined, and no overlaps."""
    for seed in range(3):
        labels = regions(256, seed)
        ink, _ = placed_sources(sources, 256)
        drawing = draw(labels, ink, sources, render_placed)
        assert np.array_equal(again(drawing.path, 512), drawing.coverage)
        plain = draw(labels, ink, sources, render_placed, exact=False)
        assert likeness(drawing.coverage, plain.coverage) > 0.95


def test_only_what_is_needed_is_drawn(sources):
    areas = []

    class Recording(Renderer):
        def __call__(self, svg, frame, placement, size, window=None):
            left, top, right, bottom = window or (0, 0, 0, 0)  # the result itself
            areas.append((right - left) * (bottom - top) / size**2)
            return super().__call__(svg, frame, placement, size, window)

    render = Recording()
    labels = np.zeros((CANVAS, CANVAS), np.uint8)
    labels[100:130, 20:50] = 2
    ink, _ = placed_sources(sources)
    first = draw(labels, ink, sources, render)
    once = sum(areas)
    assert once < 1
    second = draw(labels, ink, sources, render)
    assert sum(areas) == once, "what has been drawn is remembered"
    assert second.path == first.path
    labels[100:130, 20:90] = 2
    draw(labels, ink, sources, render)
    assert once < sum(areas) < once + 0.15


def placements():
    shifts = st.integers(-90, 90)
    scales = st.sampled_from([0.05, 0.7, 0.9, 1.0, 1.1, 3.3])
    return st.builds(Placement, scales, st.booleans(), shifts, shifts)


@settings(max_examples=40)
@given(st.integers(0, len(SHAPES) - 1), placements(), st.sampled_from([16, 64]))
@example(3, Placement(3.3, False, 0, -37), 64)
def test_no_tile_with_ink_is_left_out(number, placement, count):
    one = source(number, placement)
    svg, frame = one.exemplar.pictogram.svg, one.exemplar.frame
    drawn = render_placed(svg, frame, placement, 512)
    step = 512 // count
    inked = drawn.reshape(count, step, count, step).any(axis=(1, 3))
    tiles = inked_tiles(one.exemplar, placement, count)
    assert not (inked & ~tiles).any()
    near = ndimage.binary_dilation(inked, np.ones((3, 3)), iterations=count // 8)
    # There may be more just beyond the canvas: within two pixels of the exemplar, once placed.
    inner = slice(edge := 1 + math.ceil((2 * placement.scale + 1) * count / CANVAS), -edge)
    beyond = np.ones_like(near)
    beyond[inner, inner] = False
    near |= beyond
    assert not (tiles & ~near).any()


@settings(max_examples=20)
@given(st.integers(0, len(SHAPES) - 1), placements(), st.tuples(*[st.integers(-3, 250)] * 2))
def test_a_window_shows_its_part_of_the_picture(number, placement, corner):
    one = source(number, placement)
    svg, frame = one.exemplar.pictogram.svg, one.exemplar.frame
    picture = np.pad(render_placed(svg, frame, placement, 256), ((3, 60), (3, 60)))
    left, top = corner
    part = render_placed(svg, frame, placement, 256, (left, top, left + 40, top + 50))
    assert part.shape == (50, 40)
    inside = np.zeros_like(picture, bool)
    inside[3:259, 3:259] = True
    at = np.s_[top + 3 : top + 53, left + 3 : left + 43]
    off = abs(picture[at].astype(int) - part)[inside[at]]
    # The renderer draws curves a little differently if cut: a few pixels of an edge may be off.
    assert (off > 64).sum() <= 0.005 * part.size
    assert off.sum() <= 2 * part.size  # of 255 grey levels
