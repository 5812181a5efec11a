"""The exact outline of a drawing gives its picture, and its own curves."""

import numpy as np
import pytest

from iconstudio.algorithms.iconification.redraw import binarised
from iconstudio.model import CANVAS, Exemplar, Frame, Placement, Source
from iconstudio.svg.outline import outline_of
from iconstudio.svg.placed import render_placed
from iconstudio.svg.rasterise import rasterise
from iconstudio.svg.resvg import render_coverage
from iconstudio.workflows.drawing import draw
from tests.paths import segments
from tests.shapes import pictogram

pytestmark = pytest.mark.thorough(but=1)


def document(body):
    return f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 256 256">{body}</svg>'


def picture(path, side=512):
    return render_coverage(document(f'<path d="{path.svg()}"/>'), Frame(0, 0, CANVAS), side)


def unlike(one, other):
    """Return the pixels that are ink in one and paper in the other, as a part of the ink."""
    return (abs(one.astype(int) - other) > 100).sum() / (other > 127).sum()


def picture_of_rule(data, rule):
    svg = document(f'<path d="{data}" fill-rule="{rule}"/>')
    return render_coverage(svg, Frame(0, 0, CANVAS), CANVAS)


@pytest.mark.parametrize("word", ["cat", "bicycle", "key", "camera", "lamp"])
def test_the_outline_of_a_real_icon_gives_its_picture(session, word):
    known = 0
    for icon in session.search(word)[:12]:
        frame, _ = rasterise(icon.svg)
        outline = outline_of(icon.svg, frame)
        if not outline or "opacity" in icon.svg:  # a pale layer blurs the edges of the dark one
            continue
        known += 1
        drawn = binarised(render_coverage(icon.svg, frame, 512))
        assert unlike(picture(outline), drawn) <= 0.002, icon.id
        data = outline.svg()
        rules = [picture_of_rule(data, rule) for rule in ("nonzero", "evenodd")]
        assert np.array_equal(*rules), icon.id
    assert known >= 10


@pytest.mark.parametrize(
    "body",
    [
        '<g clip-path="url(#c)"><circle cx="128" cy="128" r="90"/></g>'
        '<clipPath id="c"><rect x="20" y="20" width="120" height="200"/></clipPath>',
        '<path d="M30 30H210V210H30z"/><circle r="40" fill="#fff" cx="90" cy="99"/>',
        '<path d="M40 40L200 90L60 200" fill="none" stroke="#000" stroke-width="20"/>',
        '<path d="M40 40H200V200H40Z" fill="none" stroke="#000" stroke-width="14"'
        ' stroke-dasharray="30 20" transform="rotate(20 128 128)"/>',
        '<path d="M40 128H216" stroke="#000" stroke-width="40" transform="skewX(20)"/>',
        '<circle cx="10" cy="128" r="90"/>',
    ],
    ids=["clip", "paper", "stroke", "dashes", "skewed", "page"],
)
def test_what_is_painted_over_cut_and_stroked(body):
    svg = document(body)
    drawn = render_coverage(svg, Frame(0, 0, CANVAS), 512)
    assert unlike(picture(outline_of(svg, Frame(0, 0, CANVAS))), drawn) <= 0.002


@pytest.mark.parametrize(
    "body",
    [
        '<mask id="m"><circle cx="128" cy="128" r="90" fill="#fff"/></mask>'
        '<rect width="256" height="256" mask="url(#m)"/>',
        "<path d='M1 1H9' fill='url(#nothing)' filter='url(#f)'/>",
    ],
)
def test_what_is_more_than_fills_and_strokes_has_none(body):
    assert not outline_of(document(body), Frame(0, 0, CANVAS))


PLACED = Placement(0.9, True, 6, -4)


@pytest.mark.parametrize("flip", [False, True])
def test_a_result_with_one_source_has_the_path_data_of_that_source(flip):
    body = '<path d="M28 28H228V228H28ZM78 78V178H178V78ZM100 128L128 100L156 128L128 156Z"/>'
    icon = pictogram("frame", body)
    one = Source(Exemplar(icon, *rasterise(icon.svg)), Placement(1.0, flip, 6, -4))
    ink = np.zeros((1, CANVAS, CANVAS), dtype=bool)
    ink[0, 2:-2, 2:-2] = True
    path = draw(np.zeros((CANVAS, CANVAS), np.uint8), ink, [one], render_placed).path
    own = outline_of(icon.svg, one.exemplar.frame).transformed(one.placement.transform)
    assert segments(path) == segments(own)
