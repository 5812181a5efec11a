import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy import ndimage

from iconstudio.algorithms.fragments import fragments
from iconstudio.algorithms.redraw import SCALE, erase, redraw, signed_distance, two_tone
from iconstudio.algorithms.vectorize import trace
from iconstudio.library.resvg import render_coverage
from iconstudio.model import CANVAS, Frame
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


@settings(max_examples=15, deadline=None)
@given(st.integers(0, 1000))
def test_signed_distance_equals_the_distance_transform(seed):
    ink = ndimage.zoom(blob(seed)[64:192, 64:192].astype(float), 1, order=0) > 0.5
    ink[0, 0] = False
    coverage = np.where(ink, 255, 0).astype(np.uint8)
    points = np.argwhere(np.ones_like(ink))[::37]
    distance = signed_distance(coverage, points)
    outside = ndimage.distance_transform_edt(~ink)
    inside = ndimage.distance_transform_edt(ink)
    # The contour runs half a pixel before the nearest pixel of the other side.
    expected = np.where(ink, 0.5 - inside, outside - 0.5)[tuple(points.T)]
    assert np.abs(distance - expected).max() < 0.75
    assert ((distance < 0) == ink[tuple(points.T)]).all()


def test_distance_in_a_picture_without_contour():
    blank = np.zeros((8, 8), np.uint8)
    assert (signed_distance(blank, np.array([[1, 1]])) == 8).all()
    assert (signed_distance(blank + 255, np.array([[1, 1]])) == -8).all()


def test_a_trace_redraws_its_bitmap():
    ink = blob(3) & ~blob(8, level=0.9)
    coverage = np.where(ink.repeat(SCALE, 0).repeat(SCALE, 1), 255, 0).astype(np.uint8)
    again = drawn(trace(coverage)) > 127
    truth = coverage > 127
    assert (again & truth).sum() / (again | truth).sum() > 0.985


def test_a_hole_stays_a_hole_and_nothing_traces_to_nothing():
    ring = np.zeros((N, N), np.uint8)
    ring[200:800, 200:800] = 255
    ring[400:600, 400:600] = 0
    path = trace(ring)
    assert path.count("M") == 2
    assert drawn(path)[500, 500] == 0
    assert drawn(path)[300, 300] == 255
    assert trace(np.zeros((N, N), np.uint8)) == ""
    assert drawn(trace(np.full((N, N), 255, np.uint8)))[500, 500] == 255


def test_specks_are_left_out():
    dots = np.zeros((N, N), np.uint8)
    dots[100:400, 100:400] = 255
    dots[700:704, 700:704] = 255  # one canvas pixel
    assert trace(dots).count("M") == 1


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
    flat = two_tone(drawing)
    assert not flat[:, 0].any()
    assert (flat[3:5, 3:5] == 255).all()
    assert (flat[3:5, 6] == 60).all()
    assert np.array_equal(flat > 127, drawing > 127)


def test_a_large_piece_is_never_a_fragment():
    whole = np.zeros((1, CANVAS, CANVAS), bool)
    whole[0, 20:200, 20:200] = True
    assert not fragments(np.zeros((CANVAS, CANVAS), np.uint8), whole).any()
