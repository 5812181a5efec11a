"""The window as a whole: words, keys, names, looks."""

import pytest
from hands import action, go_to, trace, type_keyword, workspaces
from PySide6.QtCore import QMimeData, QPoint, QRect, Qt, QTimer
from PySide6.QtGui import QImage
from PySide6.QtTest import QTest
from PySide6.QtWidgets import (
    QAbstractButton,
    QAbstractSlider,
    QApplication,
    QLineEdit,
    QMessageBox,
    QScrollBar,
    QSplitterHandle,
    QToolButton,
)

from iconstudio.gui import app
from iconstudio.gui.theme import theme
from iconstudio.gui.window.main_window import MainWindow
from iconstudio.model import IconstudioError
from iconstudio.workflows.events import Progress
from iconstudio.workflows.registry import workflows


def test_everything_that_can_be_used_has_a_name_and_is_reached_by_keys(window):
    kinds = QAbstractButton, QAbstractSlider, QLineEdit
    found = [w for kind in kinds for w in window.findChildren(kind) if w.isVisible()]
    used = [w for w in found if not isinstance(w, QScrollBar | QSplitterHandle)]
    assert len(used) > 10
    for widget in used:
        if isinstance(widget.parent(), QLineEdit):
            continue
        name = widget.accessibleName() or getattr(widget, "text", str)()
        assert name.strip(), widget
        assert widget.focusPolicy() & Qt.FocusPolicy.TabFocus, name


def test_every_button_on_the_bar_has_an_icon_and_says_what_it_does(sketching):
    buttons = [b for b in sketching.canvas_panel.findChildren(QToolButton) if b.defaultAction()]
    assert len(buttons) == 10
    for button in buttons:
        assert not button.icon().isNull()
        assert len(button.toolTip()) > 3


def test_no_two_actions_share_a_shortcut(window):
    shared = [*window.actions_by_name.values(), *window.modes.actions_in_order]
    for workspace in workspaces(window):
        actions = [*shared, *workspace.actions_by_name.values()]
        keys = [key.toString() for action in actions for key in action.shortcuts()]
        assert len(keys) == len(set(keys)), sorted(keys)


def test_letters_in_the_keyword_field_are_no_shortcuts(sketching):
    sketching.keyword_panel.field.setFocus()
    QTest.keyClicks(sketching.keyword_panel.field, "hippo r")
    assert sketching.document.page.sketch.keyword == "hippo r"
    assert sketching.actions_by_name["trace"].isChecked()
    assert not sketching.actions_by_name["regions"].isChecked()


def test_tools_are_switched_by_letters(sketching):
    sketching.view.setFocus()
    QTest.keyClick(sketching.view, Qt.Key.Key_H)
    assert sketching.view.tool is sketching.view.pan_tool
    QTest.keyClick(sketching.view, Qt.Key.Key_P)
    assert sketching.view.tool is sketching.tool


def test_about_names_licence_and_credits(window):
    action(window, "about").trigger()
    box = window.findChild(QMessageBox)
    assert "General Public License" in box.text()
    assert "CREDITS" in box.text()
    box.close()


def test_a_message_is_dismissed(sketching):
    sketching.run()
    assert sketching.window().pane.notice.isVisible()
    sketching.window().pane.notice._button.click()
    assert not sketching.window().pane.notice.isVisible()


def test_the_window_follows_the_system_into_the_dark(window, monkeypatch, request, qtbot):
    application = QApplication.instance()
    request.addfinalizer(lambda: theme.apply(application, theme.LIGHT))
    light = window.grab().toImage().pixelColor(3, 400)
    monkeypatch.setattr(theme, "current", lambda: theme.DARK)
    theme.change(application, theme.current())
    assert not window.updatesEnabled()  # nobody sees it half in the old colours
    qtbot.waitUntil(window.updatesEnabled)
    dark = window.grab().toImage().pixelColor(3, 400)
    assert light.lightness() > 220
    assert dark.lightness() < 40


def test_the_window_fits_a_small_screen(window):
    window.resize(100, 100)
    assert window.width() <= 1024
    assert window.height() <= 700


def test_the_demonstration_loads_an_example_and_remixes_it(window, qtbot, session):
    app.start(window, "motorbike")
    qtbot.waitUntil(lambda: len(window.workspace.browser.results.pictures) == 24, timeout=20000)
    assert window.workspace.document.page.sketch.keyword == "motorcycle"


def test_an_unknown_example_is_told(window):
    with pytest.raises(IconstudioError, match="motorbike"):
        app.start(window, "unicorn")


def test_run_shows_the_window_and_ends_with_it(qtbot, session):
    def look_and_close():
        shown = [one for one in QApplication.topLevelWidgets() if one.isVisible()]
        for window in shown:
            if (
                isinstance(window, MainWindow)
                and window.workspace.document.page.sketch.keyword == "motorcycle"
            ):
                timer.stop()
                window.close()

    timer = QTimer(interval=50)
    timer.timeout.connect(look_and_close)
    timer.start()
    assert app.run("motorbike", session) == 0
    assert not timer.isActive()
    assert session.closed.is_set()


def test_the_window_stays_as_wide_as_it_is_however_high_its_results_are_shown(
    window, sketching, qtbot
):
    photo, data = QImage(300, 200, QImage.Format.Format_RGB32), QMimeData()
    photo.fill(Qt.GlobalColor.gray)
    data.setImageData(photo)
    sketching.opener.open_mime(data)
    qtbot.waitUntil(sketching.dim.isVisible)
    trace(sketching)
    type_keyword(sketching, "motorcycle")
    sketching.run()
    qtbot.waitUntil(lambda: sketching.browser.results.finished == 24)
    sketching.browser.setSizes([200, 400])
    large = sketching.detail.large
    qtbot.waitUntil(lambda: large.height() > 250)
    sketching.detail.show_picture(sketching.browser.results.pictures[-1])
    for _ in range(9):  # from layout to layout
        QApplication.processEvents()
    assert (window.width(), window.height()) == (1280, 720)
    assert window.minimumSizeHint().width() <= 1200
    assert large.width() > 160, "it takes what room there is"


@pytest.mark.parametrize("title", [one.title for one in workflows()])
def test_a_message_covers_nothing_that_can_be_clicked(window, title, qtbot):
    place = go_to(window, title)
    place.failed.emit("“photo of a motorbike.png” cannot be opened. " * 3)
    place.progressed.emit(Progress("remix", 0.5, "Remixing"))
    notice = window.pane.notice
    qtbot.waitUntil(notice.isVisible)
    covered = QRect(notice.mapTo(window, QPoint()), notice.size())
    for kind in (QAbstractButton, QAbstractSlider, QLineEdit):
        for one in window.findChildren(kind):
            if one.isVisible() and not notice.isAncestorOf(one) and one.visibleRegion():
                spot = QRect(one.mapTo(window, QPoint()), one.size())
                assert not covered.intersects(spot), one.accessibleName() or one.toolTip()
