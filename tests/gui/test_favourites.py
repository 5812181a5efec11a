"""Favourites: added, picked, removed, dragged away."""

import pytest
from fake_session import FakeSession
from PySide6.QtCore import QPoint, QPointF, Qt
from PySide6.QtGui import QContextMenuEvent, QWheelEvent
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QMenu

from iconstudio.gui.exchange.dragging import unpacked
from iconstudio.gui.gallery.favourites import FavouritesPanel
from iconstudio.gui.pictures.picture import Picture, pictured
from iconstudio.model import Polygon, Sketch

LEFT = Qt.MouseButton.LeftButton
SQUARE = Polygon.of([(0, 0), (200, 0), (200, 200), (0, 200)])


@pytest.fixture(scope="module")
def pictures():
    """Different results."""
    events = pictured(FakeSession(skip="").model(Sketch(SQUARE, "dog")), "dog")
    return [event for event in events if isinstance(event, Picture)][:12]


@pytest.fixture
def tray(qtbot):
    tray = FavouritesPanel("Press F to keep a result.")
    qtbot.addWidget(tray)
    tray.heard = []
    tray.icon_list.chosen.connect(lambda picture: tray.heard.append(picture))
    tray.icon_list.changed.connect(lambda: tray.heard.append("changed"))
    tray.button.clicked.connect(lambda: tray.heard.append("save all"))
    tray.resize(480, 72)
    tray.show()
    qtbot.waitExposed(tray)
    return tray


@pytest.fixture
def full(tray, pictures):
    for picture in pictures[:3]:
        add(tray, picture)
    tray.heard.clear()
    return tray


def add(tray, picture):
    tray.icon_list.show_entries([*tray.pictures, picture])
    tray.icon_list.reveal(picture)


def place(tray, number):
    return tray.icon_list.visualRect(tray.icon_list.model().index(number, 0)).center()


def click(tray, number):
    QTest.mouseClick(tray.icon_list.viewport(), LEFT, pos=place(tray, number))


def ink(tray):
    """Return how many different colours the strip shows."""
    image = tray.icon_list.grab().toImage()
    size = image.size()
    return len({image.pixel(x, y) for x in range(size.width()) for y in range(size.height())})


def test_an_empty_tray_says_how_to_fill_it(tray, pictures):
    assert ink(tray) > 5
    assert tray.icon_list.accessibleDescription() == "Press F to keep a result."
    assert not tray.button.isEnabled()
    add(tray, pictures[0])
    assert tray.button.isEnabled()


def test_results_are_kept_in_their_order(full, pictures):
    assert full.pictures == tuple(pictures[:3])
    add(full, pictures[7])
    assert full.pictures == (*pictures[:3], pictures[7])
    assert full.heard == ["changed"]


def test_a_click_picks(full, pictures):
    click(full, 1)
    assert full.heard == [pictures[1]]


def test_the_keyboard_picks_and_removes(full, pictures):
    full.icon_list.setFocus()
    full.icon_list.setCurrentIndex(full.icon_list.model().index(0, 0))
    QTest.keyClick(full.icon_list, Qt.Key.Key_Right)
    QTest.keyClick(full.icon_list, Qt.Key.Key_Return)
    QTest.keyClick(full.icon_list, Qt.Key.Key_Delete)
    assert full.pictures == (pictures[0], pictures[2])
    QTest.keyClick(full.icon_list, Qt.Key.Key_Space)
    assert full.heard == [pictures[1], "changed", pictures[2]]
    for _ in range(3):
        QTest.keyClick(full.icon_list, Qt.Key.Key_Delete)
    assert full.pictures == ()
    assert not full.button.isEnabled()


def test_the_context_menu_removes(full, pictures, monkeypatch):
    monkeypatch.setattr(QMenu, "popup", lambda *_: None)  # nor can it be seen offscreen
    pos = place(full, 2)
    event = QContextMenuEvent(QContextMenuEvent.Reason.Mouse, pos, full.icon_list.mapToGlobal(pos))
    QApplication.sendEvent(full.icon_list.viewport(), event)
    (action,) = full.menu.actions()
    assert action.text() == "Remove from the favourites"
    action.trigger()
    assert full.pictures == tuple(pictures[:2])


def test_nothing_beside_the_favourites_reacts(full):
    beside = QPoint(full.icon_list.width() - 5, 20)
    QTest.mouseClick(full.icon_list.viewport(), LEFT, pos=beside)
    QApplication.sendEvent(
        full.icon_list.viewport(),
        QContextMenuEvent(
            QContextMenuEvent.Reason.Mouse, beside, full.icon_list.mapToGlobal(beside)
        ),
    )
    assert full.heard == []
    assert full.menu is None


def test_many_favourites_are_scrolled(tray, pictures):
    for picture in pictures:
        add(tray, picture)
    bar = tray.icon_list.horizontalScrollBar()
    assert bar.maximum() - 2 <= bar.value() > 0, "the newest is in sight"
    wheel = QWheelEvent(
        QPointF(20, 20),
        QPointF(tray.icon_list.mapToGlobal(QPoint(20, 20))),
        QPoint(),
        QPoint(0, 120),
        Qt.MouseButton.NoButton,
        Qt.KeyboardModifier.NoModifier,
        Qt.ScrollPhase.NoScrollPhase,
        False,
    )
    QApplication.sendEvent(tray.icon_list.viewport(), wheel)
    assert bar.value() < bar.maximum()


def test_a_favourite_is_dragged_away_as_an_icon(full, pictures):
    index = full.icon_list.model().index(1, 0)
    assert full.icon_list.dragEnabled()
    assert index.flags() & Qt.ItemFlag.ItemIsDragEnabled
    data = full.icon_list.model().mimeData([index])
    icon = unpacked(data)
    assert icon == pictures[1].pictogram()
    assert icon.svg.encode() == data.data("image/svg+xml").data()
    assert icon.made_of
    assert not data.hasText(), "or else it would be typed into text fields"


def test_save_all(full):
    QTest.mouseClick(full.button, LEFT)
    assert full.heard == ["save all"]


def test_screen_readers_know_them(full, pictures):
    role = Qt.ItemDataRole
    model = full.icon_list.model()
    assert model.data(model.index(0, 0), role.AccessibleTextRole) == pictures[0].name
    assert pictures[0].name in model.data(model.index(0, 0), role.ToolTipRole)
    assert full.icon_list.accessibleName() == "Favourites"
