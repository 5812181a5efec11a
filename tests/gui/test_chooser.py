"""Choosing icons: looked up, opened, dropped, taken and given back, dragged away."""

import threading

import pytest
from fake_session import read_simply
from hands import search
from images import pixels
from PySide6.QtCore import QMimeData, QPoint, QPointF, Qt, QUrl
from PySide6.QtGui import QDrag, QDragEnterEvent, QDropEvent
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QFileDialog, QWidget

from iconstudio.gui.exchange.dragging import unpacked
from iconstudio.gui.jobs.worker import Worker
from iconstudio.gui.panels.chooser import IconChooser

LEFT = Qt.MouseButton.LeftButton
SVG = '<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 9 9"><path d="M1 1h7v7z"/></svg>'


@pytest.fixture
def worker(qtbot):
    one = Worker()
    yield one
    one.close()
    assert not one.alive


@pytest.fixture
def make(qtbot, session, worker):
    """Return a function that shows a chooser; ``heard`` lists what it says."""

    def make(multiple=False):
        chooser = IconChooser(session, worker, multiple)
        qtbot.addWidget(chooser)
        chooser.heard = []
        for name in ("chosen", "released", "failed"):
            signal = getattr(chooser, name)
            signal.connect(lambda said, name=name: chooser.heard.append((name, said)))
        chooser.resize(360, 420)
        chooser.show()
        qtbot.waitExposed(chooser)
        return chooser

    return make


@pytest.fixture
def chooser(make):
    return make()


@pytest.fixture
def own(tmp_path):
    path = tmp_path / "logo.svg"
    path.write_text(SVG)
    return path


def count(chooser):
    return chooser.sheet.model().rowCount()


def found(chooser, qtbot, keyword="dog"):
    search(chooser, keyword)
    qtbot.waitUntil(lambda: count(chooser) >= 60)
    return [chooser.sheet.model().entry(chooser.sheet.model().index(i)) for i in range(60)]


def place(chooser, number):
    """Return the middle of an icon on the sheet."""
    return chooser.sheet.visualRect(chooser.sheet.model().index(number)).center()


def click(chooser, number):
    QTest.mouseClick(chooser.sheet.viewport(), LEFT, pos=place(chooser, number))


def opened(chooser, qtbot, path):
    chooser.open_file(str(path))
    qtbot.waitUntil(lambda: not chooser.caption.text().startswith("Opening"))


def test_it_says_what_to_do(chooser):
    assert "Look icons up" in chooser.caption.text()
    assert count(chooser) == 0


def test_typing_looks_icons_up_once_and_not_in_the_windows_thread(chooser, qtbot, session):
    QTest.keyClicks(chooser.field, "dog")
    assert not session.calls
    qtbot.waitUntil(lambda: count(chooser) == 60)
    assert [call[1] for call in session.calls] == ["dog"]
    assert threading.get_ident() not in session.thread_ids
    assert "60 icons found" in chooser.caption.text()


def test_return_does_not_wait(chooser, qtbot, session):
    session.search_gate = threading.Semaphore(0)
    QTest.keyClicks(chooser.field, "dog")
    QTest.keyClick(chooser.field, Qt.Key.Key_Return)
    assert chooser.caption.text() == "Looking for “dog”…"
    session.search_gate.release(9)
    qtbot.waitUntil(lambda: count(chooser) == 60)


def test_a_word_that_was_changed_meanwhile_is_forgotten(chooser, qtbot, session):
    session.search_gate = threading.Semaphore(0)
    search(chooser, "cat")
    qtbot.waitUntil(lambda: len(session.calls) == 1)
    search(chooser, "dog")
    qtbot.waitUntil(lambda: len(session.calls) == 2)
    assert chooser.caption.text() == "Looking for “dog”…"
    session.search_gate.release(9)
    qtbot.waitUntil(lambda: "60 icons" in chooser.caption.text())
    assert [call[1] for call in session.calls] == ["cat", "dog"]


def test_how_the_word_was_read_is_said(chooser, qtbot):
    found(chooser, qtbot, "red doog")
    qtbot.waitUntil(lambda: "found" in chooser.caption.text())
    assert chooser.caption.text().startswith("“doog” was read as “dog”. 60 icons found")
    found(chooser, qtbot, "dog")
    qtbot.waitUntil(lambda: "found" in chooser.caption.text())
    assert chooser.caption.text().startswith("60 icons found")


def test_an_emptied_field_forgets_what_was_found(chooser, qtbot):
    found(chooser, qtbot)
    chooser.field.selectAll()
    QTest.keyClick(chooser.field, Qt.Key.Key_Delete)
    qtbot.waitUntil(lambda: count(chooser) == 0)
    assert "Look icons up" in chooser.caption.text()


def test_nothing_found_is_said_in_place(chooser, qtbot):
    found(chooser, qtbot)
    search(chooser, "zzebra")
    qtbot.waitUntil(lambda: "No icon is found" in chooser.caption.text())
    assert chooser.caption.property("error")
    assert count(chooser) == 0
    assert chooser.heard == [("failed", chooser.caption.text())]
    found(chooser, qtbot)
    assert not chooser.caption.property("error")


def test_what_is_typed_is_no_markup(chooser, qtbot, session):
    session.search_gate = threading.Semaphore(0)
    search(chooser, "<a href='x'>y</a>")
    assert chooser.caption.textFormat() == Qt.TextFormat.PlainText


def test_a_click_chooses(chooser, qtbot):
    icons = found(chooser, qtbot)
    click(chooser, 3)
    assert chooser.heard == [("chosen", icons[3])]


def test_the_keyboard_does_it_all(chooser, qtbot):
    icons = found(chooser, qtbot)
    chooser.setFocus()
    assert chooser.field.hasFocus()
    QTest.keyClick(chooser.field, Qt.Key.Key_Down)
    assert chooser.sheet.hasFocus()
    QTest.keyClick(chooser.sheet, Qt.Key.Key_Return)
    QTest.keyClick(chooser.sheet, Qt.Key.Key_Right)
    QTest.keyClick(chooser.sheet, Qt.Key.Key_Space)
    assert chooser.heard == [("chosen", icons[0]), ("chosen", icons[1])]


def test_down_stays_where_there_is_nothing(chooser):
    chooser.setFocus()
    QTest.keyClick(chooser.field, Qt.Key.Key_Down)
    assert chooser.field.hasFocus()


def test_only_where_several_are_chosen_a_taken_icon_is_given_back(make, qtbot):
    for multiple, second in ((True, "released"), (False, "chosen")):
        chooser = make(multiple)
        icons = found(chooser, qtbot)
        click(chooser, 2)
        chooser.set_taken(frozenset({icons[2].id}))
        click(chooser, 2)
        assert chooser.heard == [("chosen", icons[2]), (second, icons[2])]


def test_a_taken_icon_is_ticked(make, qtbot):
    chooser = make(multiple=True)
    icons = found(chooser, qtbot)
    sheet = chooser.sheet.model()
    before = pixels(chooser.sheet.viewport().grab().toImage())
    chooser.set_taken(frozenset({icons[1].id}))
    after = pixels(chooser.sheet.viewport().grab().toImage())
    ys, xs = (before != after).any(axis=2).nonzero()
    box = chooser.sheet.visualRect(sheet.index(1))
    assert len(ys) > 200
    assert all(box.contains(QPoint(int(x), int(y))) for y, x in zip(ys, xs, strict=True))
    role = Qt.ItemDataRole
    assert sheet.data(sheet.index(1)) == f"{icons[1].id}, taken"
    assert "take it away" in sheet.data(sheet.index(1), role.ToolTipRole)
    assert "add it" in sheet.data(sheet.index(2), role.ToolTipRole)


def test_a_file_is_opened_and_chosen(chooser, qtbot, own, monkeypatch):
    found(chooser, qtbot)
    monkeypatch.setattr(QFileDialog, "getOpenFileName", lambda *_: (str(own), ""))
    QTest.mouseClick(chooser.button, LEFT)
    qtbot.waitUntil(lambda: len(chooser.heard) == 1)
    ((signal, exemplar),) = chooser.heard
    assert signal == "chosen"
    assert exemplar.pictogram.credit.title == "logo.svg"
    assert count(chooser) == 61
    assert "Opened “logo.svg”" in chooser.caption.text()
    click(chooser, 0)
    assert chooser.heard[1] == ("chosen", exemplar)


def test_a_file_dialog_that_is_cancelled_changes_nothing(chooser, qtbot, monkeypatch):
    monkeypatch.setattr(QFileDialog, "getOpenFileName", lambda *_: ("", ""))
    said = chooser.caption.text()
    QTest.mouseClick(chooser.button, LEFT)
    assert chooser.caption.text() == said


def test_an_opened_file_stays_while_others_are_looked_up(chooser, qtbot, own):
    opened(chooser, qtbot, own)
    first = chooser.sheet.model().entry(chooser.sheet.model().index(0))
    opened(chooser, qtbot, own)
    assert count(chooser) == 1, "it is the same file"
    found(chooser, qtbot)
    assert chooser.sheet.model().entry(chooser.sheet.model().index(0)).id == first.id
    assert count(chooser) == 61


def test_opening_what_is_taken_does_not_give_it_back(make, qtbot, own):
    chooser = make(multiple=True)
    opened(chooser, qtbot, own)
    chooser.set_taken(frozenset({chooser.heard[0][1].id}))
    opened(chooser, qtbot, own)
    assert [signal for signal, _ in chooser.heard] == ["chosen"]


def drop(chooser, *urls):
    data = QMimeData()
    data.setUrls([QUrl(url) if isinstance(url, str) else url for url in urls])
    place, copy = QPoint(50, 200), Qt.DropAction.CopyAction
    none = Qt.KeyboardModifier.NoModifier
    enter = QDragEnterEvent(place, copy, data, LEFT, none)
    enter.ignore()
    QApplication.sendEvent(chooser, enter)
    if enter.isAccepted():
        QApplication.sendEvent(chooser, QDropEvent(QPointF(place), copy, data, LEFT, none))
    return enter.isAccepted()


def test_a_dropped_file_is_opened(chooser, qtbot, own):
    assert drop(chooser, QUrl.fromLocalFile(str(own)))
    qtbot.waitUntil(lambda: len(chooser.heard) == 1)
    assert chooser.heard[0][1].pictogram.svg == read_simply(SVG.encode(), "logo.svg").svg


def test_no_part_of_the_chooser_keeps_a_drop_from_it(chooser):
    assert chooser.acceptDrops()
    assert not [part for part in chooser.findChildren(QWidget) if part.acceptDrops()]


def test_what_is_no_file_cannot_be_dropped(chooser):
    assert not drop(chooser, "https://example.org/a.svg")
    assert not drop(chooser)


@pytest.mark.parametrize(
    ("name", "content", "words"),
    [
        ("gone.svg", None, "no such file"),
        ("empty.svg", "", "is empty"),
        ("letter.svg", "Dear dog", "a text, not a drawing"),
        ("pale.svg", SVG.replace("path", "g"), "nothing to be seen"),
    ],
)
def test_a_bad_file_is_told_and_nothing_is_lost(chooser, qtbot, tmp_path, name, content, words):
    found(chooser, qtbot)
    if content is not None:
        (tmp_path / name).write_text(content)
    opened(chooser, qtbot, tmp_path / name)
    assert words in chooser.caption.text()
    assert chooser.caption.property("error")
    assert chooser.heard == [("failed", chooser.caption.toolTip())]
    assert count(chooser) == 60


def test_an_icon_is_dragged_away_and_not_chosen(chooser, qtbot, monkeypatch):
    icons = found(chooser, qtbot)
    dragged = []
    monkeypatch.setattr(QDrag, "exec", lambda drag, _: dragged.append(unpacked(drag.mimeData())))
    view, start = chooser.sheet.viewport(), place(chooser, 4)
    QTest.mousePress(view, LEFT, pos=start)
    for step in range(1, 6):
        QTest.mouseMove(view, start + QPoint(0, 20 * step))
    QTest.mouseRelease(view, LEFT, pos=start + QPoint(0, 100))
    assert dragged == [icons[4].pictogram]
    assert chooser.heard == []


def test_a_drag_from_elsewhere_is_no_icon():
    data = QMimeData()
    assert unpacked(data) is None
    data.setData("application/x-iconstudio-icon", b"no:such")
    assert unpacked(data) is None


def test_everything_has_a_name_for_screen_readers(chooser, qtbot):
    icons = found(chooser, qtbot)
    assert chooser.field.accessibleName()
    assert chooser.sheet.accessibleName()
    sheet = chooser.sheet.model()
    role = Qt.ItemDataRole.AccessibleTextRole
    assert sheet.data(sheet.index(5), role) == icons[5].id
    assert sheet.data(sheet.index(99), role) is None
