"""Parts taken off an outline: it closes as if they had never been there."""

import numpy as np
import pytest

from iconstudio.algorithms.iconification.detaching import detached
from iconstudio.model import CANVAS, Frame, Placement, Polygon
from iconstudio.svg.placed import render_placed
from iconstudio.workflows.drawing import svg_of

WHOLE = Frame(0, 0, CANVAS)
DISC = '<circle cx="128" cy="150" r="70"/>'
ARM = '<path d="M40 80 100 134" stroke="#000" stroke-width="16"/>'
BOX = '<rect x="40" y="90" width="176" height="120" rx="30"/>'
ANTENNA = '<path d="M122 40h12v60h-12z"/><circle cx="128" cy="36" r="16"/>'
ROOF = '<path d="M20 150 128 40 236 150z"/>'
CHIMNEY = '<path d="M176 50h24v80h-24z"/>'
MUG = '<path d="M50 60H150V190H50z" fill="none" stroke="#000" stroke-width="16"/>'
HANDLE = '<path d="M150 95H190V155H150" fill="none" stroke="#000" stroke-width="16"/>'
RIM = '<path d="M50 90H200L180 220H70z" fill="none" stroke="#000" stroke-width="16"/>'
STRAW = '<path d="M120 90 130 30H160" fill="none" stroke="#000" stroke-width="14"/>'
RING = '<circle cx="128" cy="128" r="80" fill="none" stroke="#000" stroke-width="20"/>'
PEN = 'fill="none" stroke="#000" stroke-width="16" stroke-linejoin="round"'
HEAD = f'<path d="M72 108A70 70 0 1 0 184 108L216 30 152 76H104L40 30z" {PEN}/>'


def drawing(*shapes):
    return f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 256 256">{"".join(shapes)}</svg>'


def outline(*shapes):
    return render_placed.outline(drawing(*shapes), WHOLE)


def ink(svg):
    return render_placed(svg, WHOLE, Placement(), CANVAS) > 127


def box(left, top, right, bottom):
    return Polygon.of([(left, top), (right, top), (right, bottom), (left, bottom)])


ROUGHLY = [
    ((BOX,), (ANTENNA,), box(100, 10, 156, 90)),
    ((BOX,), (ANTENNA,), box(90, 5, 170, 96)),
    ((BOX,), (ANTENNA,), box(108, 15, 150, 82)),
    ((ROOF,), (CHIMNEY,), Polygon.of([(170, 40), (206, 40), (206, 122), (170, 86)])),
    ((ROOF,), (CHIMNEY,), box(168, 40, 214, 110)),
    ((DISC,), (ARM,), Polygon.of([(20, 60), (60, 60), (96, 110), (80, 130), (20, 100)])),
    ((DISC,), (ARM,), Polygon.of([(20, 60), (60, 60), (80, 85), (62, 110), (20, 100)])),
    ((MUG,), (HANDLE,), box(150, 80, 220, 170)),
    ((MUG,), (HANDLE,), box(166, 80, 220, 170)),
    ((RIM,), (STRAW,), box(100, 10, 180, 82)),
    ((RIM,), (STRAW,), box(100, 10, 180, 88)),
]


@pytest.mark.parametrize(("body", "part", "mark"), ROUGHLY)
def test_a_part_goes_and_nothing_tells_where_it_was_however_roughly_it_is_marked(body, part, mark):
    found = detached(outline(*body, *part), mark)
    off = ink(svg_of(found)) ^ ink(drawing(*body))
    assert off.sum() < 0.002 * ink(drawing(*body)).sum()


def test_the_rest_is_the_outline_itself():
    whole, found = outline(BOX, ANTENNA), detached(outline(BOX, ANTENNA), box(100, 10, 156, 90))
    below = {point for point in whole.contours[0].points if point[1] > 95}
    assert len(below) > 8
    np.testing.assert_allclose(
        sorted(below), sorted({p for p in found.contours[0].points if p[1] > 95}), atol=1e-9
    )


def test_without_an_ear_the_line_of_a_head_goes_on():
    found = ink(svg_of(detached(outline(HEAD), box(20, 15, 92, 105))))
    assert not found[:60, :60].any()
    before = ink(svg_of(outline(HEAD)))
    assert (found == before)[140:].all()
    assert (found == before)[:, 140:].all()
    across = found[np.arange(60, 110), np.arange(60, 110)]  # from the corner to the middle
    edges = np.flatnonzero(np.diff(across.astype(int)))
    assert len(edges) == 2, "one line crosses the gap"
    assert 8 < (edges[1] - edges[0]) * np.sqrt(2) < 32


@pytest.mark.parametrize(
    ("shapes", "mark"),
    [
        ((DISC,), Polygon.of([(170, 90), (230, 90), (230, 150), (200, 160), (170, 130)])),  # a bite
        ((RING,), box(100, 20, 156, 80)),  # a gap
        ((BOX,), box(120, 60, 240, 150)),  # a quarter
    ],
)
def test_what_is_no_part_that_sticks_out_is_not_closed_over(shapes, mark):
    found = detached(outline(*shapes), mark)
    if found is not None:
        marked = ink(drawing(*shapes)) & (ink(svg_of(outline(polygon_shape(mark)))))
        assert (ink(svg_of(found)) & marked).sum() > 0.9 * marked.sum(), "else it is as it was"


def polygon_shape(mark):
    points = " ".join(f"{x},{y}" for x, y in mark.vertices)
    return f'<polygon points="{points}"/>'


def test_what_is_marked_whole_goes_whole():
    dot = '<circle cx="30" cy="30" r="12"/>'
    found = detached(outline(BOX, dot), box(10, 10, 50, 36))
    assert found.contours == outline(BOX).contours


def test_a_hole_that_is_nearly_all_marked_goes_with_its_part():
    found = detached(outline(MUG, HANDLE), box(166, 80, 220, 170))
    assert len(found.contours) == len(outline(MUG).contours)
