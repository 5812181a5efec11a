"""What only the session can say of an icon: how it is drawn large, and what it is called."""

import numpy as np
import pytest

from iconstudio.model import CANVAS
from iconstudio.session import Session


@pytest.fixture(scope="module")
def session():
    with Session() as one:
        yield one


def test_an_icon_is_drawn_as_on_the_canvas_but_finer(session):
    icon = session.exemplar(session.icon("heroicons:camera"))
    drawing = session.drawing(icon)
    finer = drawing.coverage.shape[0] // CANVAS
    assert finer > 1
    coarse = drawing.coverage.reshape(CANVAS, finer, CANVAS, finer).mean(axis=(1, 3)) > 127
    assert (coarse == icon.ink).mean() > 0.99
    assert np.array_equal(session.drawing(icon).coverage, drawing.coverage)
    assert drawing.path.startswith("M")
    assert drawing.path.endswith("Z")


@pytest.mark.parametrize(
    ("reference", "keyword"),
    [("heroicons:camera", "camera"), ("mdi:beer-outline", "beer"), ("bxs:castle", "castle")],
)
def test_an_icon_is_named_after_what_it_shows(session, reference, keyword):
    assert session.keyword(session.icon(reference)) == keyword
