"""A finished result depends on the page alone: not on what was run before, nor on the focus."""

from dataclasses import replace

import pytest

from iconstudio.model import Polygon
from iconstudio.output.svg import svg_document
from iconstudio.session import Session
from iconstudio.workflows.events import Result
from iconstudio.workflows.grid import LAMBDAS, GridSettings
from iconstudio.workflows.modelling.file import example
from iconstudio.workflows.modelling.spec import MODELLING

STYLE = "medium"
FEW = LAMBDAS[2:6]


def finished(session, sketch, settings, enough=None):
    """The files of all finished results, by lambda_S; ends after ``enough`` results of any kind."""
    found = {}
    events = session.run(MODELLING, sketch, settings)
    for event in events:
        if isinstance(event, Result):
            if not event.preview:
                icon, one = event.icon, event.icon.composite
                said = svg_document(icon), one.energy, one.iou, one.shares
                found[one.lambda_s] = said, one.labels.tobytes(), icon.drawing.coverage.tobytes()
            if enough is not None and (enough := enough - 1) <= 0:
                break
    events.close()
    return found


SKETCH = example("shuttle").sketch
PLAIN = GridSettings(styles=(STYLE,), lambdas=FEW)


@pytest.fixture(scope="module")
def fresh():
    """A session that has run but once, and the results of that."""
    with Session() as session:
        yield session, finished(session, SKETCH, PLAIN)


@pytest.mark.thorough
def test_a_run_after_many_edits_equals_a_fresh_one_to_the_byte(fresh):
    _, expected = fresh
    assert len(expected) == len(FEW)
    fitted = SKETCH.polygon.fitted().vertices
    with Session() as used:
        for step in range(2):  # a vertex is dragged, another result in focus each time
            moved = [(x + 9 * (step + 1) * (n == 3), y) for n, (x, y) in enumerate(fitted)]
            live = replace(PLAIN, previews=True, focus=(STYLE, FEW[step]))
            edited = replace(SKETCH, polygon=Polygon.of(moved))
            assert finished(used, edited, live, enough=1 + step % 2) is not None
        for focus in (FEW[0], FEW[3]):
            live = replace(PLAIN, previews=True, focus=(STYLE, focus))
            assert finished(used, SKETCH, live) == expected


@pytest.mark.thorough
def test_what_else_is_asked_for_does_not_matter(fresh):
    """All lambda_S of the paper's row are explored, whichever are asked for."""
    (session, every), asked = fresh, FEW[1::2]
    some = finished(session, SKETCH, replace(PLAIN, lambdas=asked))
    assert some == {value: every[value] for value in asked}
