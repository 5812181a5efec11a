"""A drawing is the same in whatever space its parts are drawn."""

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from iconstudio.svg.rasterise import rasterise
from tests.svg.pictures import ink, overlap, read, svg

DRAWINGS = {
    "lines": '<g fill="none" stroke="#000" stroke-width="2"><path d="M3 21V10l9-7 9 7v11z"/>'
    '<path d="M10 21v-7h4v7"/></g>',
    "dashes": '<g fill="none" stroke="#000" stroke-width="2" stroke-dasharray="4 3">'
    '<circle cx="12" cy="12" r="9"/></g>',
    "shapes": '<path d="M3 21V10l9-7 9 7v11h-7v-6h-4v6z"/>',
    "an arrow": '<marker id="m" viewBox="0 0 10 10" refX="5" refY="5" markerWidth="4"'
    ' markerHeight="4"><path d="M1 1l7 4-7 4" fill="none" stroke="#000" stroke-width="2"/></marker>'
    '<path d="M3 12H16" stroke="#000" stroke-width="2" marker-end="url(#m)"/>',
    "a mask": '<mask id="m" maskContentUnits="objectBoundingBox"><path fill="#fff"'
    ' d="M0 0h1v1H0z"/><path d="M.2 .2L.8 .8" stroke="#000" stroke-width=".1"/></mask>'
    '<circle cx="12" cy="12" r="10" mask="url(#m)"/>',
    "a pattern": '<pattern id="m" width=".2" height=".2" viewBox="0 0 10 10"><path d="M0 5H10"'
    ' stroke="#000" stroke-width="4"/></pattern><circle cx="12" cy="12" r="10" fill="url(#m)"'
    ' stroke="#000" stroke-width="1"/>',
    "a clip path": '<clipPath id="m"><use href="#n"/></clipPath><defs>'
    '<path id="n" d="M0 0H24V12H0z"/></defs><circle cx="12" cy="12" r="10" clip-path="url(#m)"/>',
}  # fmt: skip


def group(content, inner, outer, number):
    return f'<g transform="scale({outer / inner:.9g})">{content}</g>'


def viewport(content, inner, outer, number):
    box = f'viewBox="0 0 {inner:g} {inner:g}"'
    return f'<svg width="{outer:g}" height="{outer:g}" {box}>{content}</svg>'


def symbol(content, inner, outer, number):
    return (
        f'<symbol id="s{number}" viewBox="0 0 {inner:g} {inner:g}">{content}</symbol>'
        f'<use href="#s{number}" width="{outer:g}" height="{outer:g}"/>'
    )


def repeated(content, inner, outer, number):
    return (
        f'<defs><g id="s{number}">{content}</g></defs><use href="#s{number}" x="{inner:g}"'
        f' transform="scale({outer / inner:.9g}) translate({-inner:g})"/>'
    )


def in_parts(content, inner, outer, number):
    """A viewport whose size is a part of that around it."""
    return (
        f'<svg width="{2 * outer:g}" height="{2 * outer:g}"><svg width="50%" height="50%"'
        f' viewBox="0 0 {inner:g} {inner:g}">{content}</svg></svg>'
    )


SPACES = (group, viewport, symbol, repeated, in_parts)


@pytest.mark.thorough
@given(
    st.sampled_from(sorted(DRAWINGS)),
    st.lists(st.tuples(st.sampled_from(SPACES), st.integers(-2, 4)), min_size=1, max_size=3),
)
@settings(max_examples=25)
def test_a_drawing_is_the_same_at_any_scale(name, spaces):
    content, inner = DRAWINGS[name], 24.0
    for number, (space, power) in enumerate(spaces):
        outer = 24 * 10.0**power
        content = space(content, inner, outer, number)
        inner = outer
    pictogram = read(svg(content, f'viewBox="0 0 {inner:g} {inner:g}"'))
    _, coverage = rasterise(pictogram.svg)
    assert pictogram.remarks == ()
    assert overlap(coverage > 127, ink(svg(DRAWINGS[name]))) > 0.98
