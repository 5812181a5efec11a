"""What only the session knows: how an icon is drawn large, what it is called, what is ready."""

import sys
import time
from dataclasses import replace

import numpy as np
import pytest

from iconstudio.algorithms.curves.outline import path_of
from iconstudio.model import CANVAS, Credit, IconstudioError, Pictogram
from iconstudio.session import Session
from iconstudio.workflows.events import Progress, Retrieved
from iconstudio.workflows.line_style.restyling import said_of


def test_an_icon_is_drawn_as_on_the_canvas_but_finer(session):
    icon = session.exemplar(session.icon("heroicons:camera"))
    drawing = session.drawing(icon)
    finer = drawing.coverage.shape[0] // CANVAS
    assert finer > 1
    coarse = drawing.coverage.reshape(CANVAS, finer, CANVAS, finer).mean(axis=(1, 3)) > 127
    assert (coarse == icon.ink).mean() > 0.99
    assert np.array_equal(session.drawing(icon).coverage, drawing.coverage)
    assert drawing.path.contours
    assert all(one.closed for one in drawing.path.contours)


@pytest.mark.parametrize(
    ("reference", "keyword"),
    [("heroicons:camera", "camera"), ("mdi:beer-outline", "beer"), ("bxs:castle", "castle")],
)
def test_an_icon_is_named_after_what_it_shows(session, reference, keyword):
    assert session.keyword(session.icon(reference)) == keyword


@pytest.mark.parametrize("name", ["drawing", "image", "drawing.svg", "icon", "montage"])
def test_a_name_that_nobody_gave_is_no_keyword(session, name):
    icon = session.icon("lucide:image")
    for identifier in ("own:a-1", "made:a-1"):
        own = replace(icon, id=identifier, credit=replace(icon.credit, title=name))
        assert session.keyword(own) == ""
    named = replace(icon, id="own:cat-1", credit=replace(icon.credit, title="cat.svg"))
    assert session.keyword(named) == "cat"
    assert session.keyword(icon) == "image", "an icon of the collection is called so"


def prepared(session, keyword):
    return finished(session.prepare(keyword))


def finished(steps):
    events = []
    while True:
        try:
            events.append(next(steps))
        except StopIteration as end:
            return events, end.value


def test_a_keyword_is_made_ready_once(session):
    events, matcher = prepared(session, "hedgehog")  # of which no other test asks
    (retrieved,) = (event for event in events if isinstance(event, Retrieved))
    exemplars = tuple(one.exemplar for one in matcher.exemplars)
    assert retrieved.exemplars == exemplars
    assert len(exemplars) > 1
    # The icons are shown before they are ready for matching.
    after = events[events.index(retrieved) + 1 :]
    assert [event.done for event in after if isinstance(event, Progress)][-1] == 1
    assert len(after) == len(exemplars)
    again, same = prepared(session, " Hedgehog")
    assert same is matcher
    assert [type(event) for event in again] == [Retrieved]


def test_icons_are_retrieved_without_warming_up_what_cuts(session, monkeypatch):
    begun = []
    monkeypatch.setattr(session, "get_ready", lambda: begun.append(True) or iter(()))
    events, exemplars = finished(session.retrieve("otter"))
    assert events[-1] == Retrieved("otter", exemplars)
    assert not begun
    matcher = prepared(session, "otter")[1]
    assert [one.id for one in exemplars] == [one.exemplar.id for one in matcher.exemplars]


def test_a_drawing_that_reaches_a_limit_ends_with_what_to_do(session, monkeypatch):
    monkeypatch.setattr("iconstudio.reading.SECONDS", 0.01)
    blur = '<filter id="f"><feGaussianBlur stdDeviation="900"/></filter>'
    groups = '<g filter="url(#f)">' * 40 + '<path d="M0 0h9v9z"/>' + "</g>" * 40
    svg = f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 9 9">{blur}{groups}</svg>'
    told = r"“slow\.svg” takes too long\. Simplify the drawing"
    with pytest.raises(IconstudioError, match=told):
        session.icon_from(svg.encode(), "slow.svg")


@pytest.mark.parametrize("address", ["http://example.com/a.svg", "HTTPS://example.com/a.png"])
def test_nothing_is_downloaded(session, address):
    with pytest.raises(IconstudioError, match=rf"“{address}” is an address, and nothing is down"):
        session.icon(address)


def test_the_lines_of_an_icon_are_read_once(session):
    icon = session.icon("lucide:house")
    lines = session.lines(icon)
    assert all(line.width > 0 for line in lines)
    assert session.lines(icon) is lines


def test_what_reads_lines_is_loaded_before_they_are_read(tmp_path):
    with Session(tmp_path) as session:
        session.expect_lines()
        loaded = session._readers.submit(_loaded).result()
    assert {"shapely", "iconstudio.algorithms.tracing.vectorize"} <= loaded


@pytest.mark.thorough
def test_what_reads_lines_takes_no_time_from_the_first_icon(tmp_path, monkeypatch):
    """On a busy machine loading it took too long, and a line icon came out as its outline."""
    monkeypatch.setattr("iconstudio.session._LINES_SECONDS", 0.5)
    monkeypatch.setattr("iconstudio.session.lines.warm_up", _load_slowly)
    monkeypatch.setattr("iconstudio.session.lines.lines_on_page", _read_if_loaded)
    with Session(tmp_path) as session:
        assert session.lines(session.icon("lucide:bird")) == "read"


def _load_slowly():
    time.sleep(0.6)
    _LOADED.append(True)


def _read_if_loaded(svg):
    return "read" if _LOADED else time.sleep(60)


_LOADED = []


def _loaded():
    return set(sys.modules)


def test_where_reading_the_lines_takes_too_long_the_picture_is_traced(session, monkeypatch):
    monkeypatch.setattr("iconstudio.session._LINES_SECONDS", 1e-3)
    bird = session.icon("lucide:bird")
    lines = session.lines(replace(bird, id="slow:bird"))
    assert lines
    monkeypatch.undo()
    own = session.lines(replace(bird, id="own:bird"))
    assert lines != own
    assert path_of(lines).bounds == pytest.approx(path_of(own).bounds, abs=1), "on the same page"
    assert {round(line.width) for line in lines if line.width} == {round(own[0].width)}


def test_icons_that_are_less_alike_come_last_and_none_is_lost(session):
    (*_, retrieved), exemplars = finished(session.retrieve("otter"))
    found = [one.id for one in exemplars]
    assert sorted(found) == sorted(one.id for one in session.search("otter"))
    flags = [one in retrieved.strangers for one in found]
    assert flags == sorted(flags)
    assert not all(flags)
    assert prepared(session, "otter")[1].strangers == retrieved.strangers


@pytest.mark.parametrize(
    ("page", "width", "said"), [(24, 2, False), (400, 2, True), (160, 14, False)]
)
def test_what_is_small_on_its_page_is_said_to_be(session, page, width, said):
    """Its textures would look large. A dot of a set is as small, and as thick as all else."""
    svg = (
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {page} {page}">'
        f'<path d="M8 8H20V20" fill="none" stroke="#000" stroke-width="{width}"/></svg>'
    )
    icon = Pictogram(f"small:{page}-{width}", svg, Credit("corner", "", "", "", ""))
    assert ("small on its page" in said_of(session, icon)) == said
