import math

import numpy as np
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from iconstudio.model import (
    CANVAS,
    MARGIN,
    Credit,
    Frame,
    IconstudioError,
    Pictogram,
    Placement,
    Polygon,
)

coordinates = st.floats(-1e6, 1e6)


@given(st.lists(st.tuples(coordinates, coordinates), min_size=3, max_size=20))
def test_fitting_centres_and_fills_the_canvas(points):
    try:
        fitted = Polygon.of(points).fitted()
    except IconstudioError:
        assume(False)
    left, top, right, bottom = fitted.bounds
    assert max(right - left, bottom - top) == pytest.approx(CANVAS - 2 * MARGIN)
    assert (left + right) / 2 == pytest.approx(CANVAS / 2)
    assert (top + bottom) / 2 == pytest.approx(CANVAS / 2)


@given(st.floats(1e-3, 1e5), st.floats(-1e5, 1e5), st.integers(3, 12), st.integers(0, 2**32 - 1))
def test_units_do_not_matter(unit, shift, count, seed):
    points = np.random.default_rng(seed).uniform(0, 100, (count, 2))
    points[:3] = [(0, 0), (100, 0), (0, 100)]
    ours = Polygon.of(points.tolist()).fitted().vertices
    theirs = Polygon.of((points * unit + shift).tolist()).fitted().vertices
    assert np.allclose(ours, theirs, atol=0.05)


@pytest.mark.parametrize(
    ("points", "words"),
    [
        ([], "at least 3"),
        ([(5, 5)] * 3, "has 1 point; draw at least 3"),
        ([(0, 0), (1, 1)], "at least 3"),
        ([(0, 0), (0, 0), (1, 1), (1, 1)], "at least 3"),
        ([(0, 0), (1, 1), (2, 2)], "no area"),
        ([(0, 0), (100, 0), (200, 1e-9)], "no area"),
        ([(0, 0), (math.nan, 1), (2, 2)], "not finite"),
        ([(0, 0), (math.inf, 1), (2, 2)], "not finite"),
        ([(0, 0), (1e30, 1), (2, 2)], "out of all scale"),
        ([(0, 0), (1,), (2, 2)], "not a pair"),
        ([(0, 0), "ab", (2, 2)], "not a pair"),
        ([(0, 0), None, (2, 2)], "not a pair"),
        ([(0, 0), 7, (2, 2)], "not a pair"),
    ],
)
def test_bad_polygons_are_refused_in_a_sentence(points, words):
    with pytest.raises(IconstudioError, match=words):
        Polygon.of(points).fitted()


def test_repeated_and_closing_points_are_dropped():
    polygon = Polygon.of([(0, 0), (0, 0), (4, 0), (4, 4), (0, 4), (0, 0)])
    assert polygon.vertices == ((0, 0), (4, 0), (4, 4), (0, 4))


@given(
    st.sampled_from([0.8, 0.9, 1.0, 1.1, 1.25]),
    st.booleans(),
    st.integers(-100, 100),
    st.integers(-100, 100),
    st.floats(0, 256),
    st.floats(0, 256),
)
def test_a_placements_frame_shows_what_the_placement_says(scale, flip, dx, dy, px, py):
    placement, frame = Placement(scale, flip, dx, dy), Frame(10, -20, 64)
    centre = CANVAS / 2
    qx = centre + scale * (centre - px if flip else px - centre) + dx
    qy = centre + scale * (py - centre) + dy
    shown = placement.frame(frame)
    # Where user space's point lands when the frame is drawn, and mirrored if flipped.
    ux, uy = frame.x + px * frame.size / CANVAS, frame.y + py * frame.size / CANVAS
    x = (ux - shown.x) / shown.size * CANVAS
    y = (uy - shown.y) / shown.size * CANVAS
    assert (CANVAS - x if flip else x) == pytest.approx(qx, abs=1e-6)
    assert y == pytest.approx(qy, abs=1e-6)


SCALARS = st.sampled_from([np.float64, np.float32, float])


@given(SCALARS, SCALARS, st.integers(-200, 200), st.booleans())
def test_numbers_of_numpy_become_plain_ones(scale, unit, shift, flip):
    placement = Placement(scale(0.9), np.bool_(flip), np.int64(shift), np.int16(-shift))
    frame = placement.frame(Frame(unit(1.5), unit(-2), np.int64(24)))
    assert "np." not in repr((placement, frame))
    assert placement == Placement(float(scale(0.9)), flip, shift, -shift)
    kinds = [type(value) for value in (placement.scale, placement.flip, placement.dx, frame.size)]
    assert kinds == [float, bool, int, float]


CREDIT = Credit("my cat.svg", "an unnamed author", "MIT", "", "")


@pytest.mark.parametrize(
    ("identifier", "made_of", "name"),
    [
        ("mdi:cat", (), "mdi:cat"),
        ("own:cat-fd22ec99", (), "my cat.svg"),
        (
            "made:cat-1",
            (Pictogram("mdi:cat", "", Credit("cat", "A", "MIT", "", "")),),
            "my cat.svg",
        ),
    ],
)
def test_what_is_the_users_own_is_called_by_its_title(identifier, made_of, name):
    assert Pictogram(identifier, "<svg/>", CREDIT, made_of).name == name
