import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from iconstudio.model import CANVAS, Frame, IconstudioError, Placement
from iconstudio.svg.placed import render_placed
from iconstudio.svg.resvg import render_coverage, view_box

WHOLE = Frame(0, 0, 16)
F = "M3 2h9v3H7v3h4v3H7v5H3z"
"""The letter F, which no mirroring or turning maps to itself."""


def svg(body, attributes='viewBox="0 0 16 16"'):
    return f'<svg xmlns="http://www.w3.org/2000/svg" {attributes}>{body}</svg>'


def draw(body, attributes='viewBox="0 0 16 16"', frame=WHOLE, size=16):
    return render_coverage(svg(body, attributes), frame, size)


def box(left, top, right, bottom, value=255, size=16):
    """The picture of a rectangle on whole pixels."""
    picture = np.zeros((size, size), np.uint8)
    picture[top:bottom, left:right] = value
    return picture


def same(a, b, tolerance=1):
    assert a.dtype == b.dtype == np.uint8
    np.testing.assert_allclose(a.astype(int), b.astype(int), atol=tolerance)


@pytest.mark.parametrize(
    "body",
    [
        '<rect x="2" y="4" width="8" height="6" fill="currentColor"/>',
        '<g style="color:currentColor"><rect x="2" y="4" width="8" height="6"/></g>',
        '<path d="M2 7h8" stroke="currentColor" stroke-width="6"/>',
        '<mask id="m"><path fill="#fff" d="M0 0h10v10H0z"/></mask>'
        '<rect x="2" y="4" width="14" height="12" mask="url(#m)"/>',
        '<clipPath id="c"><path d="M0 0h10v10H0z"/></clipPath>'
        '<rect x="2" y="4" width="14" height="12" clip-path="url(#c)"/>',
        '<defs><rect id="r" width="8" height="6"/></defs><use href="#r" x="2" y="4"/>',
        '<defs><rect id="r" width="8" height="6"/></defs>'
        '<use xmlns:xlink="http://www.w3.org/1999/xlink" xlink:href="#r" x="2" y="4"/>',
        '<style>.a{fill:#000}</style><rect class="a" fill="red" x="2" y="4" width="8" height="6"/>',
        '<script>alert(1)</script><rect x="2" y="4" width="8" height="6" onload="alert(1)"/>',
    ],
)
def test_one_rectangle_drawn_in_many_ways(body):
    same(draw(body), box(2, 4, 10, 10))


def test_the_fill_rule_makes_holes():
    rings = "M1 1h12v12H1z M4 4h6v6H4z"
    same(draw(f'<path d="{rings}"/>'), box(1, 1, 13, 13))
    hole = box(1, 1, 13, 13)
    hole[4:10, 4:10] = 0
    same(draw(f'<path fill-rule="evenodd" d="{rings}"/>'), hole)


@pytest.mark.parametrize(
    ("paint", "value"),
    [
        ('opacity=".3"', 77),
        ('fill="#fff"', 0),
        ('fill="#808080"', 127),
        ('fill="none"', 0),
        ('fill="#fff" fill-opacity=".2"', 0),
    ],
)
def test_coverage_is_alpha_times_darkness(paint, value):
    same(draw(f'<rect x="2" y="4" width="8" height="6" {paint}/>'), box(2, 4, 10, 10, value))


@pytest.mark.parametrize(
    ("attributes", "expected"),
    [
        ('viewBox="0 0 24 24"', (0, 0, 24, 24)),
        ('viewBox="-4,8 , 24 32.5"', (-4, 8, 24, 32.5)),
        ('viewBox="0 0 1e1 .5e1"', (0, 0, 10, 5)),
        ('width="24" height="12"', (0, 0, 24, 12)),
        ('width="72pt" height="1in"', (0, 0, 96, 96)),
        ('width=" 25.4mm " height="2.54 cm"', (0, 0, 96, 96)),
        ('width="1em" height="1em" viewBox="0 0 512 512"', (0, 0, 512, 512)),
        ('width="100%" height="100%" viewBox="0 0 9 8"', (0, 0, 9, 8)),
        ('width="20" height="40" viewBox="0 0 10 10"', (0, 0, 10, 20)),
    ],
)
def test_the_view_box(attributes, expected):
    assert view_box(svg("", attributes)) == pytest.approx(expected)


@pytest.mark.parametrize(
    "attributes",
    [
        "",
        'width="24"',
        'width="100%" height="100%"',
        'viewBox="0 0 0 24"',
        'viewBox="0 0 24 -1"',
        'viewBox="1 2 3"',
        'viewBox="0 0 1e400 1e400"',
        'viewBox="1e300 0 24 24"',
        'width="1e-300" height="1e-300"',
        f'width="{"1" * 1_000_000}!"',
        f'width="1{" " * 1_000_000}!"',
    ],
)
def test_a_document_without_a_usable_size(attributes):
    with pytest.raises(IconstudioError):
        view_box(svg("", attributes))


@pytest.mark.parametrize(
    "attributes",
    [
        'viewBox="100 -50 16 16"',
        'viewBox="100 -50 16 16" width="1em" height="1em"',
        'viewBox="100 -50 16 16" width="37pt" height="37pt"',
        'viewBox="100 -50 16 16" x="7" y="9"',
    ],
)
def test_the_frame_is_in_user_space_whatever_the_document_measures(attributes):
    body = '<rect x="102" y="-46" width="8" height="6"/>'
    same(draw(body, attributes, Frame(100, -50, 16)), box(2, 4, 10, 10))
    same(draw(body, attributes, Frame(102, -46, 8), 8), box(0, 0, 8, 6, size=8))


@pytest.mark.parametrize("attributes", ['width="16" height="16"', 'width="12pt" height="12pt"'])
def test_without_view_box_user_space_is_in_css_pixels(attributes):
    same(draw('<rect x="2" y="4" width="8" height="6"/>', attributes), box(2, 4, 10, 10))


@given(
    st.tuples(*[st.floats(-8, 20)] * 2),
    st.floats(4, 40),
    st.tuples(*[st.floats(1, 16)] * 2),
)
@settings(max_examples=30)
def test_nothing_shows_outside_the_documents_own_canvas(corner, side, size):
    """What shows of a drawing larger than its canvas is the area of the canvas in each pixel."""
    drawn = draw(
        '<path d="M-99-99h999v999h-999z"/>',
        f'viewBox="1 2 {size[0]} {size[1]}"',
        Frame(*corner, side),
        32,
    )
    across, down = (
        np.clip(
            np.minimum(np.arange(1, 33), (low + extent - start) / side * 32)
            - np.maximum(np.arange(32), (low - start) / side * 32),
            0,
            1,
        )
        for low, extent, start in zip((1, 2), size, corner, strict=True)
    )
    same(drawn, (255 * np.outer(down, across)).astype(np.uint8), 2)


@pytest.mark.parametrize("bad", ["", "no XML", "<svg", "<svg xmlns='http://www.w3.org/2000/svg'/>"])
def test_what_cannot_be_drawn_is_said_in_a_sentence(bad):
    with pytest.raises(IconstudioError, match=r"^The SVG .*\.$"):
        render_coverage(bad, WHOLE, 16)


def test_a_panic_of_the_renderer_is_an_error_like_others(capfd):
    inner = '<svg viewBox="0 0 1e-20 1e-20"><path d="M0 0h50v50z" stroke="#000"/></svg>'
    with pytest.raises(IconstudioError, match="cannot be drawn"):
        draw(inner)
    capfd.readouterr()


placements = st.builds(
    Placement,
    scale=st.sampled_from([0.8, 0.9, 1.0, 1.1, 1.25]),
    flip=st.booleans(),
    dx=st.integers(-60, 60),
    dy=st.integers(-60, 60),
)
frames = st.builds(Frame, st.floats(-6, 4), st.floats(-6, 4), st.floats(9, 30))


@given(placements, frames)
@settings(max_examples=30)
def test_a_placement_is_what_its_definition_says(placement, frame):
    """The same transformation of the canvas, written as an SVG transform."""
    c, unit = CANVAS / 2, CANVAS / frame.size
    sign = -1 if placement.flip else 1
    by_hand = (
        f'<g transform="translate({placement.dx} {placement.dy}) translate({c} {c})'
        f" scale({placement.scale * sign} {placement.scale}) translate({-c} {-c})"
        f' scale({unit}) translate({-frame.x} {-frame.y})"><path d="{F}"/></g>'
    )
    expected = draw(by_hand, f'viewBox="0 0 {CANVAS} {CANVAS}"', Frame(0, 0, CANVAS), 128)
    document = svg(f'<path d="{F}"/>', 'viewBox="-50 -50 100 100"')
    drawn = render_placed(document, frame, placement, 128)
    same(drawn, expected, 6)
    assert drawn.flags.c_contiguous
