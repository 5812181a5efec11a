"""Every edit can be undone and done again: any sequence of them, without the window."""

import weakref

from hypothesis import given, settings
from hypothesis import strategies as st
from PySide6.QtGui import QImage

from iconstudio.gui import commands
from iconstudio.gui.document import Document
from iconstudio.gui.mipmap import Mipmap
from iconstudio.gui.photo import Photo
from iconstudio.model import Polygon, Sketch

coordinates = st.integers(-1000, 1000).map(float)
points = st.tuples(coordinates, coordinates)
PHOTOS = tuple(
    Photo(name, 10, 10, Mipmap.of(QImage(10, 10, QImage.Format.Format_RGB32), 4)) for name in "ab"
)

makers = st.one_of(
    st.builds(lambda p: lambda d: commands.AddVertex(d, p), points),
    st.builds(
        lambda i, p: lambda d: commands.InsertVertex(d, i % max(1, len(d.page.vertices)), p),
        st.integers(0, 9),
        points,
    ),
    st.builds(
        lambda i, p, g: (
            lambda d: (
                commands.MoveVertex(d, i % len(d.page.vertices), p, g) if d.page.vertices else None
            )
        ),
        st.integers(0, 9),
        points,
        st.integers(0, 2),
    ),
    st.builds(
        lambda i: (
            lambda d: (
                commands.DeleteVertex(d, i % len(d.page.vertices)) if d.page.vertices else None
            )
        ),
        st.integers(0, 9),
    ),
    st.just(commands.CloseOutline),
    st.just(commands.ClearOutline),
    st.builds(lambda k: lambda d: commands.SetKeyword(d, k), st.text(max_size=5)),
    st.builds(
        lambda x: lambda d: commands.ExcludeIcons(d, x),
        st.frozensets(st.sampled_from(["a:b", "c:d"])),
    ),
    st.builds(lambda p: lambda d: commands.SetPhoto(d, p), st.sampled_from([None, *PHOTOS])),
    st.builds(
        lambda v, k: lambda d: commands.LoadSketch(d, Sketch(Polygon(tuple(v)), k)),
        st.lists(points, max_size=5),
        st.text(max_size=5),
    ),
)


@settings(max_examples=60, deadline=None)
@given(st.lists(makers, max_size=25))
def test_undoing_everything_gives_back_every_page(edits):
    document = Document()
    stack = document.undo_stack
    pages = {0: document.page}
    for make in edits:
        command = make(document)
        if command is not None:
            stack.push(command)
            # Commands that merge change the page at the same place of the stack.
            pages[stack.index()] = document.page
    count = stack.count()
    for index in reversed(range(count)):
        stack.undo()
        assert document.page == pages[index]
    for index in range(1, count + 1):
        stack.redo()
        assert document.page == pages[index]


def test_only_moves_of_one_gesture_merge():
    document = Document()
    stack = document.undo_stack
    for point in ((0, 0), (10, 0), (10, 10)):
        stack.push(commands.AddVertex(document, point))
    for x in (1.0, 2.0, 3.0):
        stack.push(commands.MoveVertex(document, 0, (x, 0.0), gesture=1))
    stack.push(commands.MoveVertex(document, 0, (9.0, 9.0), gesture=2))
    assert stack.count() == 5
    stack.undo()
    assert document.page.vertices[0] == (3.0, 0.0)
    stack.undo()
    assert document.page.vertices[0] == (0, 0)


def test_letters_typed_one_after_the_other_are_one_step():
    document = Document()
    for text in ("d", "do", "dog"):
        document.undo_stack.push(commands.SetKeyword(document, text))
    assert document.undo_stack.count() == 1
    document.undo_stack.undo()
    assert document.sketch.keyword == ""
    document.undo_stack.redo()
    assert document.sketch.keyword == "dog"


def test_a_new_photo_takes_the_outline_along_and_keeps_the_name():
    document = Document()
    document.undo_stack.push(
        commands.LoadSketch(document, Sketch(Polygon(((0, 0), (5, 0), (0, 5))), "dog"))
    )
    document.undo_stack.push(commands.SetPhoto(document, PHOTOS[0]))
    assert document.page.vertices == ()
    assert document.sketch.keyword == "dog"


def test_an_edit_that_changes_nothing_says_nothing(qtbot):
    document = Document()
    with qtbot.assertNotEmitted(document.page_changed):
        document.undo_stack.push(commands.ClearOutline(document))


def test_commands_do_not_keep_their_document(qapp):
    """A document that nothing else holds goes at once; no cycle is left for the collector."""
    document = Document()
    document.undo_stack.push(commands.AddVertex(document, (1.0, 2.0)))
    document.undo_stack.push(commands.SetKeyword(document, "fish"))
    gone = weakref.ref(document)
    del document
    assert gone() is None
