"""A scan that is opened, dropped or pasted becomes an icon while the user looks on."""

import numpy as np
import pytest
from images import pixels
from PIL import Image
from PySide6.QtCore import QMimeData, Qt, QUrl
from PySide6.QtGui import QImage
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QDialog, QFileDialog

from iconstudio.gui.exchange.scanning import DARKEST, ScanDialog, ScanView
from iconstudio.images.scans import Tracing
from iconstudio.model import IconstudioError
from tests.shapes import outline

pytestmark = pytest.mark.thorough(but=1)

EDIT, HYBRIDS, MONTAGE = 1, 2, 3


@pytest.fixture
def scan_file(tmp_path):
    """A dark bar with a fainter one on white."""
    picture = np.full((120, 160, 3), 255, np.uint8)
    picture[30:60, 30:130] = 20
    picture[70:90, 30:130] = 170
    path = tmp_path / "scan.png"
    Image.fromarray(picture).save(path)
    return path


@pytest.fixture(params=[EDIT, HYBRIDS, MONTAGE], ids=["Edit", "Hybrids", "Montage"])
def place(request, window):
    window.show_workspace(request.param)
    return window.workspace


def opener(place):
    return getattr(place, "opener", None) or place.opener


def dialogs(place):
    return [one for one in place.window().findChildren(ScanDialog) if one.isVisible()]


def shown(place, qtbot) -> ScanDialog:
    """Return the dialog, as soon as it shows an icon."""
    qtbot.waitUntil(lambda: bool(dialogs(place)))
    (dialog,) = dialogs(place)
    qtbot.waitUntil(lambda: dialog.icon is not None)
    return dialog


def dropped(path) -> QMimeData:
    data = QMimeData()
    data.setUrls([QUrl.fromLocalFile(str(path))])
    return data


def test_a_dropped_scan_is_shown_and_becomes_an_icon(place, qtbot, scan_file, session):
    opener(place).open_mime(dropped(scan_file))
    dialog = shown(place, qtbot)
    assert place.document.page == type(place.document.page)()
    assert dialog.accept_button.isEnabled()
    QTest.mouseClick(dialog.accept_button, Qt.MouseButton.LeftButton)
    qtbot.waitUntil(lambda: place.document.page != type(place.document.page)())
    assert "own:scan.png" in str(place.document.page)
    assert not dialogs(place)
    place.document.undo_stack.undo()
    assert place.document.page == type(place.document.page)()


def test_cancel_leaves_everything_as_it_was(place, qtbot, scan_file):
    before = place.document.page
    opener(place).open_mime(dropped(scan_file))
    QTest.keyClick(shown(place, qtbot), Qt.Key.Key_Escape)
    qtbot.waitUntil(lambda: not dialogs(place))
    qtbot.wait(50)
    assert place.document.page == before


@pytest.mark.parametrize("way", ["bytes", "Qt"])
def test_a_pasted_image_is_shown(place, qtbot, scan_file, way):
    data = QMimeData()
    if way == "bytes":
        data.setData("image/png", scan_file.read_bytes())
    else:
        data.setImageData(QImage(str(scan_file)))
    QApplication.clipboard().setMimeData(data)
    place.actions_by_name["paste"].trigger()
    assert shown(place, qtbot).icon.credit.title == "image"


@pytest.mark.parametrize("number", [HYBRIDS, MONTAGE])
def test_a_scan_is_opened_from_the_menu(window, qtbot, scan_file, monkeypatch, number):
    window.show_workspace(number)
    place = window.workspace
    monkeypatch.setattr(QFileDialog, "getOpenFileName", lambda *_: (str(scan_file), ""))
    place.actions_by_name["svg_in"].trigger()
    shown(place, qtbot).accept()
    qtbot.waitUntil(lambda: "own:scan.png" in str(place.document.page))


def test_the_slider_says_what_is_ink(window, qtbot, scan_file, session):
    window.show_workspace(EDIT)
    opener(window.workspace).open_mime(dropped(scan_file))
    dialog = shown(window.workspace, qtbot)
    automatic = dialog.slider.value()
    first = dialog.icon
    dialog.slider.setValue(DARKEST - 30)
    assert dialog.icon is None and not dialog.accept_button.isEnabled()
    qtbot.waitUntil(lambda: dialog.icon is not None)
    assert dialog.icon.svg != first.svg  # the fainter bar counts, too
    assert ("trace", 30, "scan.png") in session.calls
    dialog.automatic.click()
    qtbot.waitUntil(lambda: dialog.icon is not None)
    assert dialog.slider.value() == automatic and dialog.icon.svg == first.svg
    dialog.slider.setValue(1)
    qtbot.waitUntil(lambda: "Lower the threshold" in dialog.caption.text())
    assert not dialog.accept_button.isEnabled()
    dialog.slider.setValue(automatic)
    qtbot.waitUntil(lambda: dialog.icon is not None)


def test_light_on_dark_can_be_chosen(window, qtbot, scan_file, session):
    window.show_workspace(EDIT)
    opener(window.workspace).open_mime(dropped(scan_file))
    dialog = shown(window.workspace, qtbot)
    assert not dialog.inverted.isChecked()
    dialog.inverted.click()
    qtbot.waitUntil(lambda: ("scan", True) in session.calls and dialog.inverted.isEnabled())
    dialog.inverted.click()
    qtbot.waitUntil(lambda: ("scan", False) in session.calls and dialog.icon is not None)


def test_while_the_slider_moves_the_ink_is_shown_at_once(window, qtbot, scan_file):
    window.show_workspace(EDIT)
    opener(window.workspace).open_mime(dropped(scan_file))
    dialog = shown(window.workspace, qtbot)

    def dark() -> float:
        return float((pixels(dialog.preview.grab().toImage())[..., 0] < 0.5).mean())

    dialog.slider.setValue(60)
    less = dark()
    dialog.slider.setValue(DARKEST - 30)
    assert dark() > 1.2 * less > 0


def test_a_file_that_only_looks_like_an_image_is_opened_as_what_it_is(window, qtbot, tmp_path):
    window.show_workspace(EDIT)
    place = window.workspace
    path = tmp_path / "letter.png"
    path.write_text("Dear dog")
    opener(place).open_mime(dropped(path))
    qtbot.waitUntil(window.pane.notice.isVisible)
    assert not dialogs(place)


def test_a_broken_image_is_told(window, qtbot, tmp_path, scan_file):
    window.show_workspace(MONTAGE)
    path = tmp_path / "broken.png"
    path.write_bytes(scan_file.read_bytes()[:50])
    opener(window.workspace).open_mime(dropped(path))
    qtbot.waitUntil(window.pane.notice.isVisible)
    assert "“broken.png” cannot be opened" in window.pane.notice.label.text()
    assert not dialogs(window.workspace)


def test_a_page_without_a_drawing_is_told_in_the_dialog(window, qtbot, tmp_path):
    window.show_workspace(EDIT)
    path = tmp_path / "blank.png"
    Image.new("RGB", (50, 50), "white").save(path)
    opener(window.workspace).open_mime(dropped(path))
    qtbot.waitUntil(lambda: bool(dialogs(window.workspace)))
    (dialog,) = dialogs(window.workspace)
    qtbot.waitUntil(lambda: "No drawing" in dialog.caption.text())
    assert not dialog.accept_button.isEnabled() and dialog.inverted.isEnabled()
    dialog.reject()


def test_where_no_drawing_is_made_out_the_user_may_choose_what_is_ink(window, qtbot, tmp_path):
    window.show_workspace(EDIT)
    path = tmp_path / "faint.png"
    picture = np.full((60, 80, 3), 250, np.uint8)
    picture[20:40, 20:60] = 235
    Image.fromarray(picture).save(path)
    opener(window.workspace).open_mime(dropped(path))
    qtbot.waitUntil(lambda: bool(dialogs(window.workspace)))
    (dialog,) = dialogs(window.workspace)
    qtbot.waitUntil(lambda: "No drawing" in dialog.caption.text())
    assert "move the slider" in dialog.caption.text()
    assert dialog.slider.isEnabled() and not dialog.automatic.isEnabled()
    dialog.slider.setValue(dialog.slider.value() + 10)
    qtbot.waitUntil(lambda: dialog.icon is not None)
    dialog.accept()
    qtbot.waitUntil(lambda: "own:faint.png" in str(window.workspace.document.page))


def test_several_images_are_taken_together_without_asking(window, qtbot, scan_file, tmp_path):
    window.show_workspace(MONTAGE)
    place = window.workspace
    data = QMimeData()
    paths = [scan_file, tmp_path / "gone.png"]
    data.setUrls([QUrl.fromLocalFile(str(path)) for path in paths])
    opener(place).open_mime(data)
    qtbot.waitUntil(lambda: len(place.document.page.layers) == 1)
    assert not dialogs(place)
    assert "gone.png" in window.pane.notice.label.text()


def test_closing_the_window_ends_a_dialog(window, qtbot, scan_file):
    window.show_workspace(EDIT)
    opener(window.workspace).open_mime(dropped(scan_file))
    qtbot.waitUntil(lambda: bool(dialogs(window.workspace)))


def test_all_is_read_in_another_thread(window, qtbot, scan_file, session):
    import threading

    window.show_workspace(EDIT)
    opener(window.workspace).open_mime(dropped(scan_file))
    assert shown(window.workspace, qtbot).result() == QDialog.DialogCode.Rejected
    assert threading.get_ident() not in session.thread_ids


def test_a_traced_icon_is_drawn_with_its_holes(qtbot):
    from iconstudio.model import Credit, Pictogram

    path = outline([(0, 0), (90, 0), (90, 90), (0, 90)], [(30, 30), (60, 30), (60, 60), (30, 60)])
    pictogram = Pictogram("own:a", "", Credit("a", "", "", "", ""))
    view = ScanView("icon")
    qtbot.addWidget(view)
    view.resize(300, 300)
    view.show_tracing(Tracing(pictogram, path, 90, 90))
    seen = pixels(view.grab().toImage())[..., 0]
    middle, beside = seen[150, 150], seen[150, 60]
    assert abs(middle - beside) > 0.5
    view.clear()
    assert np.ptp(pixels(view.grab().toImage())[20:-20, 20:-20, 0]) == 0


def test_an_image_that_cannot_be_read_raises_for_the_session_too(session, tmp_path):
    with pytest.raises(IconstudioError):
        list(session.image(tmp_path / "gone.png"))
