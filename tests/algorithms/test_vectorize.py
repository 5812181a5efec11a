"""Traces against the shapes that were drawn: known outlines, in canvas units."""

from itertools import pairwise

import numpy as np
import pytest
from hypothesis import HealthCheck, assume, given, settings
from hypothesis import strategies as st
from scipy import ndimage

from iconstudio.algorithms.iconification.redraw import SCALE, redraw
from iconstudio.algorithms.tracing.bezier import direction, fit
from iconstudio.algorithms.tracing.vectorize import SPECK, TOLERANCE, trace
from iconstudio.model import CANVAS, Frame, Path
from iconstudio.svg.resvg import render_coverage
from tests.shapes import blob

N = SCALE * CANVAS
U = np.linspace(0, 1, 65)
EDGE = 1 / SCALE / 4
"""resvg places an edge to a quarter of a pixel, here in canvas units."""


def drawn(shape: str, size: int = N) -> np.ndarray:
    svg = f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 256 256">{shape}</svg>'
    return render_coverage(svg, Frame(0, 0, CANVAS), size)


def again(path: Path) -> np.ndarray:
    return drawn(f'<path d="{path.svg()}"/>')


def segments(path: Path) -> list[tuple[str, np.ndarray]]:
    """Every segment's kind and its control points (2 or 4), complex; the closing one is left out.

    The kinds are C for a cubic, H for a level line, V for an upright one and L for any other.
    """
    found = []
    for contour in path.contours:
        here = complex(*contour.start)
        for segment in contour.segments:
            points = np.array([here, *(complex(*point) for point in segment)])
            way = points[-1] - here
            line = "H" if way.imag == 0 else "V" if way.real == 0 else "L"
            found.append((line if len(points) == 2 else "C", points))
            here = points[-1]
    return found


def letters(path: Path) -> str:
    return "".join(sorted(letter for letter, _ in segments(path)))


def bezier(p: np.ndarray, u: np.ndarray) -> np.ndarray:
    v = 1 - u
    return v**3 * p[0] + 3 * v * v * u * p[1] + 3 * v * u * u * p[2] + u**3 * p[3]


def outline(path: Path) -> np.ndarray:
    """Points along all segments."""
    rows = []
    for _, p in segments(path):
        if len(p) == 2:
            rows.append(p[0] + (p[1] - p[0]) * U)
        else:
            rows.append(bezier(p, U))
    return np.concatenate(rows)


def likeness(one: np.ndarray, other: np.ndarray) -> float:
    a, b = one > 127, other > 127
    return (a & b).sum() / (a | b).sum()


def kinks(path: Path) -> list[float]:
    """By how many degrees the direction jumps where segments join."""
    ways = [(p[1] - p[0], p[-1] - p[-2]) for _, p in segments(path)]
    return [
        abs(float(np.angle(after / before, deg=True)))
        for (_, before), (after, _) in zip(ways, ways[1:] + ways[:1], strict=True)
    ]


@pytest.mark.parametrize("radius", [3.0, 12.3, 60.0, 100.7])
def test_a_circle_is_round_and_smooth(radius):
    path = trace(drawn(f'<circle cx="128.3" cy="127.6" r="{radius}"/>'))
    assert abs(abs(outline(path) - (128.3 + 127.6j)) - radius).max() < TOLERANCE + EDGE
    assert set(letters(path)) == {"C"}
    assert len(segments(path)) <= 8
    assert max(kinks(path)) < 1.5


def test_a_square_is_four_lines_along_the_axes():
    path = trace(drawn('<path d="M40.5 30.25H200.5V190.25H40.5Z"/>'))
    assert letters(path) == "HHVV"
    corners = {40.5 + 30.25j, 200.5 + 30.25j, 200.5 + 190.25j, 40.5 + 190.25j}
    for _, (_, at) in segments(path):
        assert min(abs(at - corner) for corner in corners) < EDGE


def test_a_turned_square_has_sharp_corners():
    path = trace(drawn('<path d="M128 20L236 128L128 236L20 128Z"/>'))
    assert letters(path) == "LLLL"
    for _, (_, at) in segments(path):
        assert (
            min(abs(at - corner) for corner in (128 + 20j, 236 + 128j, 128 + 236j, 20 + 128j)) < 0.1
        )


def test_a_rounded_square_is_lines_and_arcs_without_kinks():
    path = trace(drawn('<rect x="30" y="40" width="180" height="160" rx="30"/>'))
    assert letters(path).startswith("C")
    assert sum(letter in "HV" for letter in letters(path)) == 4
    assert len(segments(path)) <= 12
    assert max(kinks(path)) < 1.5
    assert (
        likeness(again(path), drawn('<rect x="30" y="40" width="180" height="160" rx="30"/>'))
        > 0.999
    )


def test_a_ring_keeps_its_hole_and_an_island_in_it():
    ring = (
        '<path fill-rule="evenodd" d="M20 20H236V236H20ZM60 60V196H196V60ZM100 100H150V150H100Z"/>'
    )
    path = trace(drawn(ring))
    assert len(path.contours) == 3 and all(one.closed for one in path.contours)
    assert np.array_equal(again(path) > 127, drawn(ring) > 127)


@pytest.mark.parametrize("width", [0.5, 0.8, 1.0, 2.0, 4.0])
@pytest.mark.parametrize("angle", [0, 23, 45])
def test_a_thin_line_stays_one(width, angle):
    shape = (
        f'<path transform="rotate({angle} 128 128)" d="M40 128.1H216" stroke="#000"'
        f' stroke-width="{width}"/>'
    )
    coverage = drawn(shape)
    path = trace(coverage)
    assert len(path.contours) == 1
    truth = (np.array([40, 216]) + 128.1j - 128 - 128j) * np.exp(1j * np.radians(angle))
    way = (truth[1] - truth[0]) / abs(truth[1] - truth[0])
    off = (outline(path) - 128 - 128j - truth[0]) * way.conjugate()
    assert abs(off.imag).max() < width / 2 + TOLERANCE + EDGE
    assert abs(off.real.min()) < 0.5
    assert off.real.max() == pytest.approx(176, abs=0.5)


def test_ink_at_the_border_is_closed_along_it():
    path = trace(np.full((N, N), 255, np.uint8))
    assert letters(path) in ("HHVV", "HVV", "HHV")
    assert abs(outline(path).real - 128).max() == pytest.approx(128, abs=0.1)
    half = np.zeros((N, N), np.uint8)
    half[:, : N // 2] = 255
    assert np.array_equal(again(trace(half)) > 127, half > 127)


def test_nothing_traces_to_nothing_and_specks_are_left_out():
    blank = np.zeros((N, N), np.uint8)
    assert not trace(blank)
    side = int(SPECK**0.5 * SCALE)
    blank[100 : 100 + side - 1, 100 : 100 + side - 1] = 255
    assert not trace(blank)
    blank[500 : 500 + side + 2, 100 : 100 + side + 2] = 255
    assert len(trace(blank).contours) == 1


@pytest.mark.parametrize("size", [64, 300, 512])
def test_other_resolutions(size):
    coverage = drawn('<circle cx="128" cy="128" r="90"/>', size)
    assert abs(abs(outline(trace(coverage)) - (128 + 128j)) - 90).max() < 0.2 * CANVAS / size


def test_a_seam_stays_smooth():
    """Two bars half a canvas unit apart, with the shades a little off, as cross-fading leaves."""
    labels = np.zeros((CANVAS, CANVAS), np.uint8)
    labels[:, 128:] = 1
    bars = [drawn(f'<path d="M-9 {top}H300V{top + 60}H-9Z"/>') for top in (100.1, 100.6)]
    joined = redraw(labels, dict(enumerate(bars)))
    noise = np.random.default_rng(1).integers(-12, 13, joined.shape)
    edge = (joined > 0) & (joined < 255)
    joined = np.where(edge, np.clip(joined + noise, 0, 255), joined).astype(np.uint8)
    path = trace(joined)
    assert len(segments(path)) <= 16
    upper = [jump for jump in kinks(path) if jump < 60]
    assert max(upper, default=0) < 3
    top = outline(path)
    top = top[(top.imag < 130) & (top.real > 1) & (top.real < 255)]
    assert top.imag.min() > 100.1 - 0.1 and top.imag.max() < 100.6 + 0.1


def polygons():
    """Corners of polygons around the middle, sides over 3 traced pixels, and no needle."""

    def corners(seed: int) -> np.ndarray:
        rng = np.random.default_rng(seed)
        count = int(rng.integers(3, 10))
        angles = (np.arange(count) + rng.uniform(-0.2, 0.2, count)) * 2 * np.pi / count
        scale = 10 ** rng.uniform(0.8, 2)
        return 128 + 128j + scale * rng.uniform(0.7, 1.2, count) * np.exp(1j * angles)

    return st.integers(0, 10**6).map(corners)


@pytest.mark.thorough
@settings(max_examples=40, suppress_health_check=[HealthCheck.filter_too_much])
@given(polygons())
def test_polygons_come_back(corners):
    sides = np.roll(corners, -1) - corners
    turns = abs(np.angle(sides / np.roll(sides, 1), deg=True))
    assume(abs(sides).min() > 3)
    assume(turns.max() < 140)
    data = " ".join(f"{at.real},{at.imag}" for at in corners)
    path = trace(drawn(f'<polygon points="{data}"/>'))
    found = np.array([points[-1] for _, points in segments(path)])
    for corner in corners[turns > 35]:
        assert abs(found - corner).min() < 0.35
    a, b = corners[:, None], np.roll(corners, -1)[:, None]
    along = np.clip((((outline(path) - a) * (b - a).conjugate()).real / abs(b - a) ** 2), 0, 1)
    assert abs(outline(path) - a - along * (b - a)).min(axis=0).max() < 0.35


@pytest.mark.thorough
@settings(max_examples=10)
@given(st.integers(0, 1000))
def test_a_trace_drawn_again_agrees_with_the_coverage(seed):
    rough = blob(seed).astype(np.float32)
    soft = ndimage.zoom(ndimage.gaussian_filter(rough, 2), SCALE, order=1)
    coverage = np.clip(255 * ((soft - 0.5) * 4 + 0.5), 0, 255).astype(np.uint8)
    parts, count = ndimage.label(coverage > 127)
    sizes = ndimage.sum_labels(np.ones_like(parts), parts, np.arange(count + 1))
    coverage[np.isin(parts, np.flatnonzero(sizes < 10 * SPECK * SCALE**2)) & (parts > 0)] = 0
    assume((coverage > 127).any())
    assert likeness(again(trace(coverage)), coverage) > 0.995


def test_tracing_is_repeatable():
    coverage = drawn('<path d="M30 30C200 0 250 90 200 220L90 160Z"/>')
    assert trace(coverage) == trace(coverage.copy())


@pytest.mark.parametrize("free", [True, False])
def test_cubics_stay_near_their_points_and_join_smoothly(free):
    truth = np.array([10 + 10j, 60 - 40j, 140 - 20j, 190 + 60j])
    points = bezier(truth, np.linspace(0, 1, 300))
    ends = (None, None) if free else ((1 - 1j) / 2**0.5, (-5 - 8j) / 89**0.5)
    for tolerance, most in ((1.0, 1), (0.05, 4)):
        found = [np.array(cubic) for cubic in fit(points, *ends, tolerance)]
        assert len(found) <= most
        assert found[0][0] == truth[0] and found[-1][-1] == truth[-1]
        drawn_again = np.concatenate([bezier(cubic, U) for cubic in found])
        dense = bezier(truth, np.linspace(0, 1, 5000))
        assert abs(drawn_again[:, None] - dense).min(axis=1).max() < tolerance + 0.05
        for before, after in pairwise(found):
            assert before[-1] == after[0]
            turn = np.angle((after[1] - after[0]) / (before[-1] - before[-2]))
            assert abs(turn) < 1e-6


def test_directions_near_an_axis_are_on_it():
    steps = np.arange(9)
    assert direction(steps * (1 + 0.01j)) == 1
    assert direction(steps * (0.01 - 1j)) == -1j
    assert direction(steps * (3 + 4j)) == pytest.approx(0.6 + 0.8j)
