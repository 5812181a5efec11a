"""What an edit keeps of an icon."""

import numpy as np

from iconstudio.algorithms.iconification.guidance import HELD
from iconstudio.algorithms.iconification.keeping import JOIN, kept
from iconstudio.algorithms.raster import solid
from iconstudio.model import CANVAS

YS, XS = np.mgrid[:CANVAS, :CANVAS] + 0.5
NOTHING = np.zeros((CANVAS, CANVAS), bool)


def box(left, top, right, bottom):
    return (left < XS) & (right > XS) & (top < YS) & (bottom > YS)


FRAME = box(40, 60, 216, 216) & ~box(56, 76, 200, 200)


def test_what_is_not_marked_keeps_its_looks():
    added = box(100, 20, 150, 90)
    found = kept(FRAME, NOTHING, added, NOTHING, solid(FRAME | added))
    assert np.array_equal(found.ink, FRAME)
    assert found.paper[10, 10] and found.paper[128, 128]
    assert not found.paper[40, 100 - JOIN : 150 + JOIN].any()
    assert found.paper[40, : 99 - JOIN].all()


def test_a_body_is_the_ground_of_what_is_added():
    body, added = box(40, 60, 216, 216), box(100, 20, 150, 90)
    found = kept(body, NOTHING, added, NOTHING, body | added)
    assert np.array_equal(found.ink, body & ~added)
    found = kept(body, added, NOTHING, NOTHING, body & ~added)
    assert np.array_equal(found.ink, body & ~added)
    assert not found.paper[added & body].any() and found.paper[added & ~body].all()


def test_what_is_taken_off_is_paper_and_a_line_may_close_the_outline():
    corner = box(160, 40, 240, 130)
    wanted = solid(FRAME) & ~corner
    found = kept(FRAME, corner, NOTHING, NOTHING, wanted)
    assert not (found.ink & corner).any()
    assert found.paper[corner].all()
    assert not found.paper[100, 140:160].any(), "inside, along the gap"
    assert found.paper[160, 70:120].all()
    whole = kept(FRAME, box(100, 100, 150, 150), NOTHING, NOTHING, solid(FRAME))
    assert np.array_equal(whole.paper, ~FRAME), "inside the outline nothing is open"


def test_labels_cost_where_they_show_anything_else():
    found = kept(FRAME, NOTHING, box(100, 20, 150, 60), NOTHING, solid(FRAME))
    own, none = found.cost(np.stack([FRAME, NOTHING]), np.array([False, False]))
    assert not own.any()
    assert np.array_equal(none > 0, FRAME)
    assert none.max() == HELD
