import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from iconstudio.model import CANVAS, MARGIN, IconstudioError
from iconstudio.svg import rasterise as module
from iconstudio.svg.rasterise import ink_bounds, rasterise
from iconstudio.svg.resvg import render_coverage


def svg(body, attributes='viewBox="0 0 24 24"'):
    return f'<svg xmlns="http://www.w3.org/2000/svg" {attributes}>{body}</svg>'


def tight(document, frame, finer):
    """Left, top, right, bottom of the ink in canvas pixels, measured on a large picture."""
    big = render_coverage(document, frame, finer * CANVAS) > 127
    xs, ys = np.flatnonzero(big.any(axis=0)), np.flatnonzero(big.any(axis=1))
    return xs[0] / finer, ys[0] / finer, (xs[-1] + 1) / finer, (ys[-1] + 1) / finer


def assert_fits(document, tolerance=0.25, finer=4):
    """The longer side reaches from margin to margin, the shorter one is centred."""
    frame, coverage = rasterise(document)
    left, top, right, bottom = tight(document, frame, finer)
    long, short = ((left, right), (top, bottom))[:: 1 if right - left > bottom - top else -1]
    assert long == pytest.approx((MARGIN, CANVAS - MARGIN), abs=tolerance)
    assert sum(short) / 2 == pytest.approx(CANVAS / 2, abs=tolerance)
    assert coverage.shape == (CANVAS, CANVAS)
    assert coverage.dtype == np.uint8
    return frame, coverage


SHAPES = {
    "a dot in a corner": '<circle cx="23" cy="23" r=".2"/>',
    "a long bar": '<path d="M1 1h22v.4H1z"/>',
    "a ring": '<circle cx="9" cy="9" r="5" fill="none" stroke="currentColor"/>',
    "two far dots": '<circle cx="2" cy="3" r=".3"/><circle cx="20" cy="21" r=".3"/>',
    "a slanted line": '<path d="M3 3L20 9" stroke="#000" stroke-width=".5"/>',
    "more than the canvas": '<circle cx="12" cy="12" r="14"/>',
    "beyond the canvas": '<path d="M6 8h99v5H6z"/>',
    "masked": '<mask id="m"><circle cx="9" cy="9" r="3" fill="#fff"/></mask>'
    '<path d="M0 0h24v24H0z" mask="url(#m)"/>',
    "clipped": '<clipPath id="c"><circle cx="9" cy="9" r="3"/></clipPath>'
    '<path d="M0 0h24v24H0z" clip-path="url(#c)"/>',
    "covered by white": '<path d="M2 2h20v20H2z"/><path fill="#fff" d="M8 0h16v24H8z"/>',
    "a shaft that is thin for its head": '<path d="M0 11.9h23v.17H0zM22.6 11.6l1.4.4-1.4.4z"/>',
    "a pale layer": '<path opacity=".3" d="M1 1h22v22H1z"/><circle cx="8" cy="9" r="4"/>',
}


@pytest.mark.parametrize("kind", SHAPES)
def test_the_ink_fills_the_canvas_but_for_its_margin(kind):
    assert_fits(svg(SHAPES[kind]))


@pytest.mark.parametrize("width", [0.05, 0.06, 0.08, 0.1, 0.14])
@pytest.mark.parametrize("y", [12, 12.1])
def test_thin_rules_beside_a_dot_are_on_the_canvas(width, y):
    rules = f'<path d="M0 {y}H10.8M13.2 {y}H24" stroke="#000" stroke-width="{width}"/>'
    frame, _ = rasterise(svg(f'{rules}<circle cx="12" cy="{y}" r=".5"/>'))
    assert frame.size == pytest.approx(24 * CANVAS / (CANVAS - 2 * MARGIN), rel=0.005)


@given(
    st.floats(0.01, 1000),
    st.tuples(*[st.floats(-1000, 1000)] * 2),
    st.tuples(*[st.floats(0.05, 0.45)] * 2),
    st.floats(0, 180),
)
@settings(max_examples=10)
def test_it_fits_at_any_scale_and_anywhere(scale, origin, radii, angle):
    x, y = origin
    rx, ry = (scale * radius for radius in radii)
    body = (
        f'<g transform="translate({x + scale / 2} {y + scale / 2}) rotate({angle})">'
        f'<ellipse rx="{rx}" ry="{ry}"/></g>'
    )
    # resvg computes in single precision: far from the origin, a small drawing has few digits.
    tolerance = 0.3 + 1e-4 * max(map(abs, origin)) / (scale * max(radii))
    assert_fits(svg(body, f'viewBox="{x} {y} {scale} {scale}"'), tolerance)


def test_a_pale_layer_is_no_ink():
    dark, pale = '<circle cx="8" cy="9" r="4"/>', '<path opacity=".3" d="M1 1h22v22H1z"/>'
    _, alone = rasterise(svg(dark))
    _, both = rasterise(svg(pale + dark))
    assert 0 < (alone > 127).sum() == pytest.approx((both > 127).sum(), rel=0.01)
    assert both[MARGIN // 2, MARGIN // 2] == 77


@pytest.mark.parametrize(
    "body",
    [
        "",
        '<path fill="#fff" d="M1 1h9v9z"/>',
        '<path opacity=".4" d="M1 1h9v9z"/>',
        '<path fill="none" d="M1 1h9v9z"/>',
        '<path d="M99 99h9v9z"/>',
        '<path d="M1 1h9v9z"/><path fill="#fff" d="M0 0h24v24H0z"/>',
        "<text>letters need a font</text>",
    ],
)
def test_without_ink_there_is_no_exemplar(body):
    with pytest.raises(IconstudioError, match="no dark ink"):
        rasterise(svg(body))


def test_what_is_hostile_is_not_drawn(monkeypatch):
    monkeypatch.setattr(module, "render_coverage", None)
    with pytest.raises(IconstudioError, match="deep"):
        rasterise(svg("<g>" * 300 + "</g>" * 300))


def test_5000_elements_are_drawn():
    bars = "".join(f'<path d="M{i % 71 / 3} {i // 71 / 3}h.2v.2h-.2z"/>' for i in range(5000))
    assert_fits(svg(bars), finer=2)


@pytest.mark.parametrize("kind", ["a ring", "a pale layer"])
def test_the_picture_is_that_of_the_frame_even_if_it_never_fits(kind, monkeypatch):
    monkeypatch.setattr(module, "_fits", lambda bounds: False)
    document = svg(SHAPES[kind])
    frame, coverage = rasterise(document)
    np.testing.assert_array_equal(coverage, render_coverage(document, frame, CANVAS))


def test_bounds_are_fractions_of_pixels():
    picture = np.zeros((10, 10), np.uint8)
    assert ink_bounds(picture) is None
    picture[3:6, 2:8] = 255
    assert ink_bounds(picture) == (2, 3, 8, 6)
    picture[2, 2:8] = 51
    picture[6, 2:8] = 204
    assert ink_bounds(picture) == pytest.approx((2, 2.8, 8, 6.8))
