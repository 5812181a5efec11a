"""Messages stand over the status line, whatever the window does, and cover nothing to click."""

import json

import pytest
from hands import go_to
from PySide6.QtCore import QPoint, QRect
from PySide6.QtWidgets import QAbstractButton, QApplication, QLabel, QLineEdit

LONG = (
    "“a file.svg” cannot be used. A part that nobody has heard of is not understood. Leave it out."
)


def bottom_of(pane):
    return pane.status.geometry().bottom()


def seen(widget, pane):
    """Return where a widget is on a pane."""
    return QRect(widget.mapTo(pane, QPoint()), widget.size())


def test_a_message_follows_the_height_of_the_window(window, qtbot):
    pane = window.pane
    pane.notice.say("Something went wrong.")
    for height in (640, 720, 800):
        window.resize(1280, height)
        qtbot.waitUntil(lambda: pane.notice.geometry().bottom() == bottom_of(pane))
    bar = QLabel("Something was found.")
    window.centralWidget().layout().insertWidget(1, bar)
    QApplication.processEvents()
    bar.hide()
    qtbot.waitUntil(lambda: pane.notice.geometry().bottom() == bottom_of(pane))


@pytest.mark.parametrize("title", ["Sketch", "Hybrids", "Montage"])
def test_many_messages_cover_nothing_to_click_and_show_whole_lines(window, qtbot, title):
    place = go_to(window, title)
    pane = window.pane
    notice, scroll = pane.notice, pane.notice._scroll
    for number in range(6):
        notice.say(f"{number}: {LONG}")
    bar = scroll.verticalScrollBar()
    qtbot.waitUntil(lambda: bar.maximum() > 0)
    qtbot.waitUntil(lambda: notice.geometry().bottom() == bottom_of(pane))
    things = [*place.findChildren(QAbstractButton), *place.findChildren(QLineEdit)]
    shown = [one for one in things if one.isVisible()]
    assert shown
    assert not [one for one in shown if seen(one, pane).intersects(notice.geometry())]
    line = notice.label.fontMetrics().lineSpacing()
    assert scroll.viewport().height() % line == 0
    assert bar.maximum() % bar.singleStep() == 0 == bar.singleStep() % line
    assert scroll.toolTip().count(LONG) == 6
    bar.setValue(bar.maximum())
    last = notice.label.visibleRegion().boundingRect().bottom()
    assert last == notice.label.rect().bottom(), "the last message can be read"


@pytest.mark.parametrize(
    ("title", "work", "said"),
    [
        ("Sketch", {"polygon": [[0, 0], [9, 0], [9, 9]]}, '"exclude" leaves out nothing by “a:b”'),
        ("Edit", {"icon": "shapes:ring-0"}, '"exclude" leaves out nothing by “a:b”'),
        ("Montage", {"layers": [{"icon": "shapes:ring-0", "dx": 5000}]}, "outside the canvas"),
    ],
)
def test_what_a_file_says_in_vain_is_told(window, qtbot, tmp_path, title, work, said):
    place = go_to(window, title)
    path = tmp_path / "work.json"
    one = {"exclude": ["a:b", "shapes:cross-2"], "include": ["c:d", "shapes:frame-1"]}
    path.write_text(json.dumps(work | ({} if title == "Montage" else one)))
    place.opener.open_work(str(path))
    qtbot.waitUntil(lambda: place.page != place.blank)
    told = window.pane.status.label.text()
    assert said in told
    assert ('"include" brings in nothing by “c:d”' in told) == (title != "Montage")
    assert "cross" not in told
    assert "frame" not in told


@pytest.mark.parametrize(
    ("title", "work"),
    [("Sketch", {"polygon": [[0, 0], [9, 0], [9, 9]]}), ("Edit", {"icon": "shapes:ring-0"})],
)
def test_an_icon_that_a_file_leaves_out_and_brings_in_is_told(window, qtbot, tmp_path, title, work):
    place = go_to(window, title)
    path = tmp_path / "work.json"
    both = {"exclude": ["shapes:cross-2"], "include": ["shapes:cross-2", "shapes:frame-1"]}
    path.write_text(json.dumps(work | both))
    place.opener.open_work(str(path))
    qtbot.waitUntil(lambda: place.page != place.blank)
    said = '“shapes:cross-2” is in "exclude" and in "include": it is left out.'
    assert window.pane.status.label.text().endswith(said)
