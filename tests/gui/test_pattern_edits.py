"""Every edit of a pattern's page can be undone and done again, without the window."""

import numpy as np
import pytest
from fake_session import exemplar
from hypothesis import given, settings
from hypothesis import strategies as st

from iconstudio.gui.document.document import Document
from iconstudio.model import CANVAS, IconstudioError, Photo, Stroke
from iconstudio.workflows.pattern import page as edits
from iconstudio.workflows.pattern.bounds import MOST_MOTIFS
from iconstudio.workflows.pattern.page import PatternPage

ICONS = tuple(exemplar(number).pictogram for number in range(3))
PHOTO = Photo("a.png", 10, 10, (np.zeros((10, 10), np.uint32),))

numbers = st.floats(-400, 400, allow_subnormal=False)
gestures = st.sampled_from([None, 1, 2])


def choosing(numbers):
    """Choose those of the motifs that there are."""

    def do(document):
        count = len(document.page.work.motifs)
        edits.choose(document, frozenset(number for number in numbers if number < count))

    return do


def an(edit, *values):
    return st.builds(lambda *given: lambda document: edit(document, *given), *values)


makers = st.one_of(
    an(edits.add_icons, st.lists(st.sampled_from(ICONS), min_size=1, max_size=2)),
    st.builds(choosing, st.frozensets(st.integers(0, 12))),
    an(edits.scatter, st.integers(0, 3)),
    an(edits.move_chosen, numbers, numbers, gestures),
    an(edits.resize_chosen, st.floats(0.1, 10), gestures),
    an(edits.turn_chosen, numbers, gestures),
    an(edits.colour_chosen, st.sampled_from(["#ff0000", "#00ff00"]), gestures),
    *(
        st.just(edit)
        for edit in (
            edits.flip_chosen, edits.duplicate_chosen, edits.raise_chosen, edits.lower_chosen,
            edits.remove_chosen, edits.clear, edits.clear_corrections,
        )
    ),
    an(edits.take_image, st.just(PHOTO)),
    an(edits.set_colours, st.sampled_from([None, 2, 3])),
    an(edits.correct, st.integers(0, 2), st.just(Stroke(3.0, ((1.0, 2.0), (5.0, 5.0))))),
    an(edits.set_ground, st.sampled_from(["#ff0000", "#ffffff"]), gestures),
    an(edits.set_size, st.integers(0, 20_000), st.integers(0, 20_000), gestures),
    an(edits.set_tile, st.booleans()),
    an(edits.set_seed, st.integers(0, 9), gestures),
    an(edits.set_scale, st.floats(0.01, 9), gestures),
    an(edits.set_density, st.floats(0.01, 9), gestures),
    an(edits.set_turn, numbers, gestures),
    an(edits.set_fill, st.sampled_from([None, *ICONS])),
)  # fmt: skip


@settings(max_examples=40)
@given(st.lists(makers, max_size=20))
def test_undoing_everything_gives_back_all_work(steps):
    document = Document(PatternPage())
    stack = document.undo_stack
    works = {0: document.page.work}
    for do in steps:
        do(document)
        works[stack.index()] = document.page.work
        page = document.page
        assert all(number < len(page.work.motifs) for number in page.chosen)
        assert all(0 <= one.x <= CANVAS and 0 <= one.y <= CANVAS for one in page.work.motifs)
        assert not (page.work.motifs and page.work.image)
    count = stack.count()
    for index in reversed(range(count)):
        stack.undo()
        assert document.page.work == works[index]
    for index in range(1, count + 1):
        stack.redo()
        assert document.page.work == works[index]


def test_icons_are_scattered_together_until_somebody_arranges_them():
    document = Document(PatternPage())
    for icon in ICONS:
        edits.add_icons(document, [icon])
    motifs = document.page.work.motifs
    assert [sum(one.icon == icon for one in motifs) for icon in ICONS] == [3, 3, 3]
    assert len({one.colour for one in motifs}) == 3
    edits.add_icons(document, ICONS[:1])
    assert len(document.page.work.motifs) == 10, "one more of what is there"
    edits.choose(document, frozenset({0}))
    edits.move_chosen(document, 5, 5)
    edits.add_icons(document, [exemplar(7).pictogram])
    assert document.page.work.motifs[1:10] == (*motifs[1:], document.page.work.motifs[9])
    assert document.page.chosen == {10}


def test_there_may_be_no_more_icons_than_a_canvas_takes():
    document = Document(PatternPage())
    edits.add_icons(document, ICONS)
    edits.choose(document, frozenset(range(9)))
    with pytest.raises(IconstudioError, match="at most 200 icons"):
        for _ in range(MOST_MOTIFS):
            edits.duplicate_chosen(document)
    assert len(document.page.work.motifs) <= MOST_MOTIFS
