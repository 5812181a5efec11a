"""Drawings at any scale and place, as their own coordinates and their transforms have them."""

import numpy as np
import pytest

from iconstudio.svg.monochrome import OFF_PAGE
from iconstudio.svg.reading import own_artwork
from tests.svg.pictures import ink, overlap, read, svg


def drawing(unit=1.0, left=0.0, top=0.0, inner=1.0):
    """A drawing of 100 units as large as that; within a transform, they are ``inner`` as large."""

    def n(value):
        return f"{value * unit * inner:.12g}"

    def x(value):
        return f"{(value * unit + left) * inner:.12g}"

    def y(value):
        return f"{(value * unit + top) * inner:.12g}"

    body = f"""
    <defs>
    <linearGradient id="g" gradientUnits="userSpaceOnUse" x1="{x(55)}" x2="{x(90)}"
     y1="{y(0)}" y2="{y(0)}"><stop stop-color="blue"/><stop offset="1" stop-color="red"/>
    </linearGradient>
    <clipPath id="c"><circle cx="{x(30)}" cy="{y(70)}" r="{n(15)}"/></clipPath>
    <mask id="m" maskUnits="userSpaceOnUse" x="{x(50)}" y="{y(50)}" width="{n(50)}"
     height="{n(50)}"><rect x="{x(55)}" y="{y(55)}" width="{n(40)}" height="{n(40)}" fill="#fff"/>
     <circle cx="{x(75)}" cy="{y(75)}" r="{n(10)}" stroke="#000" stroke-width="{n(4)}"/></mask>
    <pattern id="p" patternUnits="userSpaceOnUse" x="{x(1)}" y="{y(1)}" width="{n(8)}"
     height="{n(8)}"><circle cx="{n(4)}" cy="{n(4)}" r="{n(3)}"/></pattern>
    <filter id="f"><feGaussianBlur stdDeviation="{n(2)}"/></filter>
    <marker id="a" markerWidth="4" markerHeight="4" refX="2" refY="2">
     <path d="M0 0h4L2 4z"/></marker>
    <path id="u" d="M{x(5)} {y(5)}h{n(10)}v{n(5)}a{n(5)} {n(5)} 0 0 1 {n(-10)} 0z"/>
    <symbol id="s" viewBox="{n(3)} {n(3)} {n(6)} {n(6)}">
     <rect x="{n(4)}" y="{n(4)}" width="{n(4)}" height="{n(4)}"/></symbol>
    </defs>
    <g stroke="green" stroke-width="{n(4)}" stroke-dasharray="{n(12)} {n(6)}">
    <circle cx="{x(30)}" cy="{y(30)}" r="{n(18)}" fill="none"/></g>
    <rect x="{x(55)}" y="{y(10)}" width="{n(35)}" height="{n(35)}" rx="{n(8)}" fill="url(#g)"/>
    <g clip-path="url(#c)"><rect x="{x(10)}" y="{y(60)}" width="{n(40)}" height="{n(30)}"/></g>
    <g mask="url(#m)"><rect x="{x(50)}" y="{y(50)}" width="{n(50)}" height="{n(50)}"/></g>
    <use href="#u" x="{n(40)}" y="{n(2)}" fill="orange"/>
    <use href="#u" transform="translate({n(2)} {n(80)})"/>
    <use href="#s" x="{x(20)}" y="{y(20)}" width="{n(20)}" height="{n(20)}"/>
    <rect x="{x(40)}" y="{y(40)}" width="{n(16)}" height="{n(16)}" fill="url(#p)"/>
    <rect x="{x(2)}" y="{y(50)}" width="{n(8)}" height="{n(8)}" filter="url(#f)"/>
    <path d="M{x(60)} {y(50)}h{n(20)}" stroke="#000" stroke-width="{n(1.5)}" marker-end="url(#a)"/>
    <text x="{x(3)}" y="{y(40)}" font-size="{n(14)}">R</text>"""
    if inner != 1:
        body = f'<g transform="scale({1 / inner:.12g})">{body}</g>'
    return svg(body, f'viewBox="{left:.12g} {top:.12g} {100 * unit:.12g} {100 * unit:.12g}"')


def colours(document):
    """(512, 512, 4): its colours, multiplied by their alpha."""
    pixels, _ = own_artwork(document.encode(), "drawing.svg")
    pixels = pixels.astype(float)
    pixels[..., :3] *= pixels[..., 3:] / 255
    return pixels


@pytest.fixture(scope="module")
def usual():
    return colours(drawing())


@pytest.mark.parametrize(
    "placed",
    [
        (1e-11,), (1e-7,), (1e-4,), (1e3,), (1e7,),
        (1, 1e5, 1e5), (1e-5, 1, -1), (1, 8e6, -4e6), (1e5, -1e9, 1e9),
        (1, 0, 0, 1e6), (1, 0, 0, 1e-9), (1e3, 1e6, 0, 1e-6), (1, 4e6, 5e6, 1e3),
    ],
)  # fmt: skip
def test_it_looks_the_same_at_every_scale_and_place(placed, usual):
    apart = abs(colours(drawing(*placed)) - usual).max(axis=2)
    assert (apart > 60).mean() < 0.001


@pytest.mark.parametrize(
    ("first", "then"),
    [
        ("scale(1e-12)", "scale(1e12)"),
        ("scale(1e9)", "scale(1e-9)"),
        ("translate(1e9 -1e9)", "translate(-1e9 1e9)"),
        ("scale(1e-5) translate(3e12)", "translate(-3e12) scale(1e5)"),
    ],
)
def test_transforms_that_undo_each_other_change_nothing(first, then, usual):
    start, end = drawing().index(">") + 1, drawing().rindex("</svg>")
    body = f'<g transform="{first}"><g transform="{then}">{drawing()[start:end]}</g></g>'
    apart = abs(colours(drawing()[:start] + body + "</svg>") - usual).max(axis=2)
    assert (apart > 60).mean() < 0.001


def test_a_circle_of_a_hundred_thousandth_is_round():
    tiny = '<path d="M1e-6 1e-6h8e-6v8e-6h-8e-6z" fill="#f80"/><circle {} fill="#048"/>'
    tiny = svg(tiny.format('cx="5e-6" cy="5e-6" r="2e-6"'), 'viewBox="0 0 1e-5 1e-5"')
    usual = svg('<path fill-rule="evenodd" d="M1 1h8v8h-8zM3 5a2 2 0 1 0 4 0a2 2 0 1 0-4 0z"/>')
    assert overlap(ink(tiny), ink(usual)) > 0.98


def test_a_drawing_far_off_its_page_is_as_fine():
    far = svg('<circle cx="9000003" cy="-8000002" r="1.5"/>')
    assert read(far).remarks == (OFF_PAGE,)
    assert overlap(ink(far), ink(svg('<circle cx="3" cy="3" r="2"/>'))) > 0.98


def test_strokes_that_a_transform_flattens_stay_flat():
    ring = '<circle cx="{0}" cy="{0}" r="{1}" fill="none" stroke="#000" stroke-width="{2}"/>'
    flat = '<g transform="scale(1 .4)">' + ring + "</g>"
    near, tiny = flat.format(12, 8, 3), flat.format(*(f"{one}e-6" for one in (12, 8, 3)))
    tiny = svg(tiny, 'viewBox="0 0 24e-6 24e-6"')
    assert overlap(ink(tiny), ink(svg(near))) > 0.98


def test_what_is_flat_does_not_show():
    document = drawing(1e-7).replace(
        "</svg>", '<g transform="scale(0 1)"><circle r="9"/></g></svg>'
    )
    assert np.abs(colours(document) - colours(drawing())).mean() < 1
