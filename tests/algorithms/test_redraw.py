import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from PIL import Image
from scipy import ndimage
from scipy.spatial.distance import cdist

from iconstudio.algorithms.iconification.fragments import fragments
from iconstudio.algorithms.iconification.redraw import (
    FADE,
    FAR,
    REACH,
    SCALE,
    binarised,
    erase,
    redraw,
)
from iconstudio.algorithms.iconification.signed_distance import SignedDistance
from iconstudio.algorithms.tracing.vectorize import trace
from iconstudio.model import CANVAS, Frame
from iconstudio.svg.resvg import render_coverage
from tests.shapes import blob

N = SCALE * CANVAS


def bar(top, bottom, n=N):
    """A horizontal bar between two heights in canvas pixels, with its edges' coverage."""
    ys = np.arange(n) / SCALE
    cover = np.clip((bottom - ys) * SCALE, 0, 1) * np.clip((ys + 1 / SCALE - top) * SCALE, 0, 1)
    return np.repeat((255 * cover).round().astype(np.uint8)[:, None], n, axis=1)


def drawn(path, size=N):
    svg = f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 256 256"><path d="{path}"/></svg>'
    return render_coverage(svg, Frame(0, 0, CANVAS), size)


def edges(coverage):
    """Height of the upper edge of the ink in every column, in canvas pixels."""
    ink = coverage > 127
    return ink.argmax(axis=0) / SCALE


LEFT_RIGHT = np.repeat((np.arange(CANVAS) >= 128)[None].astype(np.uint8), CANVAS, axis=0)


def test_one_owner_is_drawn_as_it_is():
    coverage = bar(100, 120)
    labels = np.full((CANVAS, CANVAS), 3, np.uint8)
    assert np.array_equal(redraw(labels, {3: coverage}), coverage)


def test_where_owners_agree_nothing_changes():
    joined = redraw(LEFT_RIGHT, {0: bar(100, 120), 1: bar(100, 120)})
    assert abs(joined.astype(int) - bar(100, 120)).max() <= 1


@pytest.mark.parametrize("step", [0.5, 1.0, 2.0, 3.0])
def test_a_step_at_a_seam_becomes_a_slope(step):
    joined = redraw(LEFT_RIGHT, {0: bar(100, 120), 1: bar(100 + step, 120 + step)})
    upper = edges(joined)
    assert upper[0] == pytest.approx(100, abs=0.3)
    assert upper[-1] == pytest.approx(100 + step, abs=0.3)
    # From one canvas pixel to the next, sources that are a pixel apart rise by a quarter of one.
    rise = np.abs(upper[SCALE:] - upper[:-SCALE])
    assert rise.max() <= 0.25 * step + 1 / SCALE
    assert (np.diff(upper) >= 0).all()


def test_without_cross_fading_the_same_seam_has_a_notch():
    """The check above can fail: the plain join of the same sources does not pass it."""
    plain = np.where(
        LEFT_RIGHT.repeat(SCALE, 0).repeat(SCALE, 1) == 0, bar(100, 120), bar(103, 123)
    )
    upper = edges(plain)
    assert np.abs(upper[SCALE:] - upper[:-SCALE]).max() > 1.5


def contour(coverage):
    """Where the coverage crosses one half from one pixel to the next, one crossing at a time."""
    points = []
    for y, x in np.ndindex(coverage.shape):
        for dy, dx in ((1, 0), (0, 1)):
            if y + dy < len(coverage) and x + dx < len(coverage):
                a, b = float(coverage[y, x]), float(coverage[y + dy, x + dx])
                if (a > 127) != (b > 127):
                    part = (127.5 - a) / (b - a)
                    points.append((y + dy * part, x + dx * part))
    return np.array(points).reshape(-1, 2)


def plain_distance(coverage):
    """The signed distance of every pixel, at most FAR, to all points of the contour."""
    pixels = np.argwhere(np.ones_like(coverage))
    far = FAR * len(coverage) / CANVAS
    away = cdist(pixels, contour(coverage)).min(axis=1, initial=far).reshape(coverage.shape)
    return np.where(coverage > 127, -away, away)


def plain_redraw(labels, coverages):
    """The definition: every owner's share, drawing and distance at every pixel."""
    n, m = len(coverages[0]), len(labels)
    mean, inked, distance = np.zeros((3, n, n))
    for label, coverage in coverages.items():
        soft = ndimage.gaussian_filter(
            (labels == label).astype(np.float32), FADE * m / CANVAS, radius=REACH * m // CANVAS
        )
        share = np.asarray(Image.fromarray(soft).resize((n, n), Image.Resampling.BILINEAR))
        mean += share * coverage
        inked += share * (coverage > 127)
        distance += share * plain_distance(coverage)
    disagreed = (inked > 1e-3) & (inked < 1 - 1e-3)
    return np.where(disagreed, 255 * np.clip(0.5 - distance, 0, 1), mean)


def soft_shape(seed, n):
    """A smooth blob with soft edges, (n, n) uint8."""
    noise = ndimage.gaussian_filter(np.random.default_rng(seed).normal(size=(n, n)), 5)
    return np.clip(127 + 150 * noise / noise.std() * 2, 0, 255).astype(np.uint8)


@pytest.fixture
def small(monkeypatch):
    """A canvas of 32 pixels, on which the plain definition takes no minutes."""
    for module in ("redraw", "blending"):
        monkeypatch.setattr(f"iconstudio.algorithms.iconification.{module}.CANVAS", 32)
    monkeypatch.setitem(globals(), "CANVAS", 32)


@pytest.mark.parametrize(("m", "scale"), [(32, 4), (32, 2), (16, 8), (64, 2), (64, 1)])
@pytest.mark.parametrize("seed", [0, 1])
def test_redrawing_equals_its_definition(small, m, scale, seed):
    n = m * scale
    regions = ndimage.gaussian_filter(np.random.default_rng(seed).normal(size=(3, m, m)), (0, 3, 3))
    labels = regions.argmax(axis=0).astype(np.uint8)
    coverages = {label: soft_shape(10 * seed + label, n) for label in range(3)}
    coverages[2][: n // 2] = 0
    expected = plain_redraw(labels, coverages)
    joined = redraw(labels, coverages)
    assert len(np.unique(labels)) == 3
    assert abs(joined - expected).max() <= 1
    plain = np.choose(labels.repeat(scale, 0).repeat(scale, 1), [coverages[k] for k in range(3)])
    assert abs(joined - plain.astype(float)).max() > 60, "the seams make a difference"


def test_a_drawing_far_from_its_region_counts_for_nothing():
    one, other = soft_shape(1, N), soft_shape(2, N)
    joined = redraw(LEFT_RIGHT, {0: one, 1: other})
    cleared = other.copy()
    cleared[:, : (128 - REACH - FAR) * SCALE] = 0
    assert np.array_equal(redraw(LEFT_RIGHT, {0: one, 1: cleared}), joined)
    assert (cleared != other).any()


@settings(max_examples=15)
@given(st.integers(0, 1000))
def test_signed_distance_equals_the_distance_transform(seed):
    ink = blob(seed)[64:192, 64:192].copy()
    ink[0, 0] = False
    coverage = np.where(ink, 255, 0).astype(np.uint8)
    points = np.argwhere(np.ones_like(ink))[::37]
    far = FAR * len(ink) / CANVAS
    distance = SignedDistance(coverage, points, 0, far).at(points)
    outside = ndimage.distance_transform_edt(~ink)
    inside = ndimage.distance_transform_edt(ink)
    # The contour runs half a pixel before the nearest pixel of the other side.
    expected = np.where(ink, 0.5 - inside, outside - 0.5)[tuple(points.T)]
    assert np.abs(distance - np.clip(expected, -far, far)).max() < 0.75
    assert ((distance < 0) == ink[tuple(points.T)]).all()


def test_distance_in_a_picture_without_contour():
    blank, points, far = np.zeros((8, 8), np.uint8), np.array([[1, 1]]), 0.25
    assert (SignedDistance(blank, points, 0, far).at(points) == far).all()
    assert (SignedDistance(blank + 255, points, 0, far).at(points) == -far).all()


def test_a_trace_redraws_its_bitmap():
    ink = blob(3) & ~blob(8, level=0.9)
    coverage = np.where(ink.repeat(SCALE, 0).repeat(SCALE, 1), 255, 0).astype(np.uint8)
    again = drawn(trace(coverage).svg()) > 127
    truth = coverage > 127
    assert (again & truth).sum() / (again | truth).sum() > 0.985


def test_a_hole_stays_a_hole_and_nothing_traces_to_nothing():
    ring = np.zeros((N, N), np.uint8)
    ring[200:800, 200:800] = 255
    ring[400:600, 400:600] = 0
    path = trace(ring).svg()
    assert path.count("M") == 2
    assert drawn(path)[500, 500] == 0
    assert drawn(path)[300, 300] == 255
    assert not trace(np.zeros((N, N), np.uint8))
    assert drawn(trace(np.full((N, N), 255, np.uint8)).svg())[500, 500] == 255


def test_specks_are_left_out():
    dots = np.zeros((N, N), np.uint8)
    dots[100:400, 100:400] = 255
    dots[700:704, 700:704] = 255  # one canvas pixel
    assert len(trace(dots).contours) == 1


def test_a_crumb_of_a_cut_is_a_fragment_and_an_eye_is_not():
    body, other = np.zeros((2, CANVAS, CANVAS), bool)
    body[40:200, 40:120] = True
    other[40:60, 150:250] = True  # a long arm of which only the tip is taken
    other[150:156, 200:206] = True  # a dot of its own
    labels = np.zeros((CANVAS, CANVAS), np.uint8)
    labels[35:65, 240:] = 1
    labels[145:160, 195:210] = 1
    found = fragments(labels, np.stack([body, other]))
    assert found[40:60, 240:250].all()
    assert not found[150:156, 200:206].any()
    assert found.sum() == 200
    coverage = np.full((N, N), 255, np.uint8)
    erase(coverage, found)
    assert not coverage[40 * SCALE : 60 * SCALE, 240 * SCALE : 250 * SCALE].any()
    assert coverage[150 * SCALE, 200 * SCALE] == 255


def test_a_pale_layer_is_paper_and_edges_stay_soft():
    drawing = np.zeros((8, 8), np.uint8)
    drawing[:, :4] = 70  # a pale layer
    drawing[2:6, 2:6] = 200  # a dark one
    drawing[2:6, 6] = 60  # its soft edge
    flat = binarised(drawing)
    assert not flat[:, 0].any()
    assert (flat[3:5, 3:5] == 255).all()
    assert (flat[3:5, 6] == 60).all()
    assert np.array_equal(flat > 127, drawing > 127)


@given(st.integers(0, 1000))
def test_two_tones_equal_their_definition(seed):
    rng = np.random.default_rng(seed)
    coverage = rng.choice(np.array([0, 60, 127, 128, 200, 255], np.uint8), (9, 13))
    ink = coverage > 127
    square = np.ones((3, 3), bool)
    edge = ndimage.binary_dilation(ink, square) & ndimage.binary_dilation(~ink, square)
    assert np.array_equal(binarised(coverage), np.where(edge, coverage, 255 * ink))


def test_a_large_piece_is_never_a_fragment():
    whole = np.zeros((1, CANVAS, CANVAS), bool)
    whole[0, 20:200, 20:200] = True
    assert not fragments(np.zeros((CANVAS, CANVAS), np.uint8), whole).any()
