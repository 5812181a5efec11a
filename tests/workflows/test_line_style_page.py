"""The edits of a page of lines, and which lines are meant by a click or a box."""

from dataclasses import dataclass, field

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from shapely import LineString, Point, box

from iconstudio.inputs.line_style import check_style
from iconstudio.inputs.styles import named
from iconstudio.model import IconstudioError, Line, Restyling, StylePair
from iconstudio.workflows.line_style import page as edits
from iconstudio.workflows.line_style.page import RestylePage
from iconstudio.workflows.line_style.selecting import line_at, lines_in

WAVE = tuple((4.0 * n, 10.0 * (n % 2)) for n in range(20))
FLAT = tuple((4.0 * n, 0.0) for n in range(20))
INK, LOOPS = named("Ink"), named("Loops")

_point = st.tuples(*[st.floats(0, 256, width=32)] * 2)
_line = st.builds(
    lambda points, closed: Line(tuple(points), closed, 0.0),
    st.lists(_point, min_size=2, max_size=6, unique=True),
    st.booleans(),
)


@dataclass
class Paper:
    """A document that keeps all its pages."""

    page: RestylePage = field(default_factory=RestylePage)
    steps: list[str] = field(default_factory=list)

    def change(self, text, after, gesture=None):
        self.steps.append(text)
        self.page = after

    def show(self, page):
        self.page = page


@pytest.fixture
def paper():
    return Paper(RestylePage(Restyling(INK, strokes=(Line(WAVE), Line(FLAT), Line(WAVE)))))


def shape(line):
    return LineString((*line.points, line.points[0]) if line.closed else line.points)


@given(st.lists(_line, min_size=1, max_size=4), _point)
@settings(max_examples=60)
def test_a_click_means_the_nearest_line_within_reach(lines, point):
    gaps = [shape(line).distance(Point(point)) for line in lines]
    found = line_at(lines, point, 20.0)
    if found is None:
        assert min(gaps) > 20.0 - 1e-6
    else:
        assert gaps[found] == pytest.approx(min(gaps), abs=1e-6)
        assert gaps[found] <= 20.0 + 1e-6


@given(_line, _point, _point)
@settings(max_examples=60)
def test_a_box_means_the_lines_that_pass_through_it(line, one, other):
    (x0, y0), (x1, y1) = one, other
    area = box(min(x0, x1), min(y0, y1), max(x0, x1), max(y0, y1))
    found = lines_in([line], one, other)
    if not area.buffer(1e-6).intersects(shape(line)):
        assert not found
    if area.buffer(-1e-6).intersects(shape(line)):
        assert found == {0}


def test_the_ink_of_a_stroke_is_hit_as_its_line_is():
    wide = Line(((0.0, 0.0), (100.0, 0.0)), width=30.0)
    assert line_at([wide], (50.0, 14.0), 1.0) == 0
    assert line_at([wide], (50.0, 17.0), 1.0) is None
    assert line_at([], (50.0, 17.0), 1.0) is None


def test_a_style_goes_to_the_selected_lines(paper):
    edits.select(paper, frozenset({1}))
    assert paper.steps == []
    edits.set_style(paper, LOOPS)
    assert paper.page.work.others == ((1, LOOPS),)
    assert paper.page.style == LOOPS
    assert paper.page.styles == (INK, LOOPS)
    edits.set_style(paper, INK)
    assert paper.page.work.others == ()
    edits.set_style(paper, LOOPS)
    edits.select(paper, frozenset())
    edits.set_style(paper, LOOPS)
    assert paper.page.work == Restyling(LOOPS, strokes=paper.page.work.strokes)


def test_an_example_goes_to_the_selected_lines_too_and_can_be_cleared(paper):
    edits.select(paper, frozenset({2}))
    edits.add_example(paper, StylePair(WAVE))
    edits.add_example(paper, StylePair(WAVE))
    ((number, style),) = paper.page.work.others
    assert number == 2
    assert len(style.pairs) == 2
    assert paper.page.work.style == INK
    edits.clear_example(paper)
    assert paper.page.work.others == ()
    edits.clear_example(paper)
    assert paper.steps[-1] == "clear example"
    assert len(paper.steps) == 3


def test_an_example_of_the_other_kind_begins_another_style(paper):
    edits.add_example(paper, StylePair(WAVE))
    edits.add_example(paper, StylePair(WAVE, FLAT))
    edits.add_example(paper, StylePair(WAVE, FLAT))
    assert [bool(pair.plain) for pair in paper.page.work.style.pairs] == [True, True]


def test_what_a_mouse_draws_beside_a_pen_has_one_width(paper):
    edits.add_example(paper, StylePair(WAVE))
    edits.add_example(paper, StylePair(FLAT, widths=(2.0,) * len(FLAT)))
    first, second = paper.page.work.style.pairs
    assert set(first.widths) == {1.0}
    assert second.widths == (2.0,) * len(FLAT)
    check_style(paper.page.work.style)


@pytest.mark.parametrize(
    "pair", [StylePair(WAVE[:2]), StylePair(((0.0, 0.0),) * 5), StylePair(WAVE, FLAT[:2])]
)
def test_an_example_of_which_nothing_can_be_learned_is_refused(paper, pair):
    before = paper.page
    with pytest.raises(IconstudioError, match="needs at least"):
        edits.add_example(paper, pair)
    assert paper.page == before


def test_only_drawn_lines_are_removed_and_the_others_keep_their_styles(paper):
    edits.select(paper, frozenset({5}))
    edits.set_style(paper, LOOPS)
    edits.select(paper, frozenset({1, 3}))
    edits.remove_strokes(paper, 3)  # after three lines of an icon
    assert paper.page.work.strokes == (Line(FLAT), Line(WAVE))
    assert paper.page.work.others == ((4, LOOPS),)
    edits.select(paper, frozenset({1}))
    before = paper.page
    edits.remove_strokes(paper, 3)
    assert paper.page == before
