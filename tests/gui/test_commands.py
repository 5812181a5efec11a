"""Every edit can be undone and done again: any sequence of them, without the window."""

import weakref

import numpy as np
from hypothesis import given, settings
from hypothesis import strategies as st

from iconstudio.gui.document.document import Document
from iconstudio.model import Axis, Photo, Polygon, Sketch
from iconstudio.workflows import criteria
from iconstudio.workflows.modelling import page as edits
from iconstudio.workflows.modelling.page import SketchPage
from iconstudio.workflows.outline import Outline

coordinates = st.integers(-1000, 1000).map(float)
points = st.tuples(coordinates, coordinates)
PHOTOS = tuple(Photo(name, 10, 10, (np.zeros((10, 10), np.uint32),)) for name in "ab")


def on_a_vertex(edit):
    """Return the edit of a vertex, whichever of those that there are; none does nothing."""

    def do(document, index, *values):
        count = len(document.page.vertices)
        if count:
            edit(Outline(document), index % count, *values)

    return do


makers = st.one_of(
    st.builds(lambda p: lambda d: Outline(d).add(p), points),
    st.builds(
        lambda i, p: lambda d: on_a_vertex(Outline.insert)(d, i, p),
        st.integers(0, 9),
        points,
    ),
    st.builds(
        lambda i, p, g: lambda d: on_a_vertex(Outline.move)(d, i, p, g),
        st.integers(0, 9),
        points,
        st.integers(0, 2),
    ),
    st.builds(lambda i: lambda d: on_a_vertex(Outline.delete)(d, i), st.integers(0, 9)),
    st.just(lambda d: Outline(d).close()),
    st.just(lambda d: Outline(d).clear()),
    st.builds(lambda k: lambda d: criteria.set_keyword(d, k), st.text(max_size=5)),
    st.builds(
        lambda x: lambda d: criteria.exclude_icons(d, x),
        st.frozensets(st.sampled_from(["a:b", "c:d"])),
    ),
    st.builds(lambda k: lambda d: criteria.toggle_stranger(d, k), st.sampled_from("ab")),
    st.builds(lambda a: lambda d: criteria.set_symmetry(d, a), st.sampled_from([None, *Axis])),
    st.builds(lambda p: lambda d: edits.set_photo(d, p), st.sampled_from([None, *PHOTOS])),
    st.builds(
        lambda v, k: lambda d: edits.load_sketch(d, Sketch(Polygon(tuple(v)), k)),
        st.lists(points, max_size=5),
        st.text(max_size=5),
    ),
)


@settings(max_examples=60)
@given(st.lists(makers, max_size=25))
def test_undoing_everything_gives_back_every_page(steps):
    document = Document(SketchPage())
    stack = document.undo_stack
    pages = {0: document.page}
    for do in steps:
        do(document)
        # Changes that merge change the page at the same place of the stack.
        pages[stack.index()] = document.page
    count = stack.count()
    for index in reversed(range(count)):
        stack.undo()
        assert document.page == pages[index]
    for index in range(1, count + 1):
        stack.redo()
        assert document.page == pages[index]


def test_only_moves_of_one_gesture_merge():
    document = Document(SketchPage())
    stack = document.undo_stack
    for point in ((0, 0), (10, 0), (10, 10)):
        Outline(document).add(point)
    for x in (1.0, 2.0, 3.0):
        Outline(document).move(0, (x, 0.0), gesture=1)
    Outline(document).move(0, (9.0, 9.0), gesture=2)
    assert stack.count() == 5
    stack.undo()
    assert document.page.vertices[0] == (3.0, 0.0)
    stack.undo()
    assert document.page.vertices[0] == (0, 0)


def test_letters_typed_one_after_the_other_are_one_step():
    document = Document(SketchPage())
    for text in ("d", "do", "dog"):
        criteria.set_keyword(document, text, gesture=1)
    assert document.undo_stack.count() == 1
    document.undo_stack.undo()
    assert document.page.sketch.keyword == ""
    document.undo_stack.redo()
    assert document.page.sketch.keyword == "dog"


def test_a_new_photo_takes_the_outline_along_and_keeps_the_name():
    document = Document(SketchPage())
    edits.load_sketch(document, Sketch(Polygon(((0, 0), (5, 0), (0, 5))), "dog"))
    edits.set_photo(document, PHOTOS[0])
    assert document.page.vertices == ()
    assert document.page.sketch.keyword == "dog"


def test_an_edit_that_changes_nothing_says_nothing(qtbot):
    document = Document(SketchPage())
    with qtbot.assertNotEmitted(document.page_changed):
        Outline(document).clear()


def test_the_view_is_asked_to_fit_only_what_lies_elsewhere(qtbot):
    document = Document(SketchPage())
    with qtbot.assertNotEmitted(document.opened):
        Outline(document).add((1.0, 2.0))
        criteria.set_keyword(document, "dog")
    with qtbot.waitSignal(document.opened):
        edits.set_photo(document, PHOTOS[0])
    with qtbot.waitSignal(document.opened):
        document.undo_stack.undo()


def test_changes_do_not_keep_their_document(qapp):
    """A document that nothing else holds goes at once; no cycle is left for the collector."""
    document = Document(SketchPage())
    Outline(document).add((1.0, 2.0))
    criteria.set_keyword(document, "fish")
    gone = weakref.ref(document)
    del document
    assert gone() is None
