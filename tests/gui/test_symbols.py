"""A sprite sheet that is opened, dropped or pasted: the user chooses one of its symbols."""

import pytest
from PySide6.QtCore import QMimeData, Qt, QUrl
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication

from iconstudio.gui.exchange.symbols import SymbolDialog
from iconstudio.gui.jobs.worker import Worker
from iconstudio.gui.panels.chooser import IconChooser

EDIT, HYBRIDS, MONTAGE = 1, 2, 3
SHEET = (
    '<svg xmlns="http://www.w3.org/2000/svg"><symbol id="flag" viewBox="0 0 9 9">'
    '<path d="M1 1h7v7z"/></symbol><symbol id="bar" viewBox="0 0 9 9"><path d="M1 1h7v2H1z"/>'
    "</symbol></svg>"
)


@pytest.fixture(params=["sheet.svg", "a#sheet.svg"])
def sheet(request, tmp_path):
    path = tmp_path / request.param
    path.write_text(SHEET)
    return path


def dropped(*paths):
    data = QMimeData()
    data.setUrls([QUrl.fromLocalFile(str(path)) for path in paths])
    return data


def shown(owner, qtbot) -> SymbolDialog:
    """Return the dialog, as soon as it shows a symbol."""

    def dialogs():
        return [one for one in owner.findChildren(SymbolDialog) if one.isVisible()]

    qtbot.waitUntil(lambda: bool(dialogs()))
    (dialog,) = dialogs()
    qtbot.waitUntil(lambda: dialog.icon is not None)
    return dialog


def opener(place):
    return getattr(place, "opener", None) or place.opener


@pytest.mark.parametrize("number", [EDIT, HYBRIDS, MONTAGE], ids=["Edit", "Hybrids", "Montage"])
def test_a_symbol_of_a_dropped_sheet_is_opened(window, qtbot, sheet, number):
    window.show_workspace(number)
    place = window.workspace
    empty = type(place.document.page)()
    opener(place).open_mime(dropped(sheet))
    dialog = shown(window, qtbot)
    assert [dialog.list.item(row).text() for row in range(2)] == ["flag", "bar"]
    assert place.document.page == empty
    dialog.list.setCurrentRow(1)
    assert not dialog.accept_button.isEnabled()
    qtbot.waitUntil(lambda: dialog.icon is not None)
    assert "H1" in dialog.icon.svg
    QTest.mouseClick(dialog.accept_button, Qt.MouseButton.LeftButton)
    qtbot.waitUntil(lambda: place.document.page != empty)
    place.document.undo_stack.undo()
    assert place.document.page == empty


def test_a_symbol_of_pasted_markup_is_opened(window, qtbot):
    window.show_workspace(EDIT)
    data = QMimeData()
    data.setText(SHEET)
    QApplication.clipboard().setMimeData(data)
    window.workspace.actions_by_name["paste"].trigger()
    shown(window, qtbot).accept()
    qtbot.waitUntil(lambda: window.workspace.document.page.icon is not None)


def test_names_are_searched_and_escape_leaves_all_as_it_was(window, qtbot, sheet):
    window.show_workspace(EDIT)
    place = window.workspace
    before = place.document.page
    opener(place).open_mime(dropped(sheet))
    dialog = shown(window, qtbot)
    QTest.keyClicks(dialog.field, "BA")
    assert dialog.list.currentItem().text() == "bar"
    QTest.keyClicks(dialog.field, "x")
    assert "No symbol" in dialog.caption.text() and not dialog.accept_button.isEnabled()
    dialog.field.clear()
    qtbot.waitUntil(lambda: dialog.icon is not None)
    QTest.keyClick(dialog, Qt.Key.Key_Escape)
    qtbot.wait(50)
    assert place.document.page == before


def test_among_several_files_a_sheet_is_told(window, qtbot, sheet, tmp_path):
    window.show_workspace(HYBRIDS)
    other = tmp_path / "other.svg"
    other.write_text(SHEET.replace("symbol", "g"))
    told = []
    opener(window.workspace).failed.connect(told.append)
    opener(window.workspace).open_mime(dropped(sheet, other))
    qtbot.waitUntil(lambda: bool(told))
    assert "sprite sheet of 2 symbols (flag, bar)" in told[0]
    assert told[0].endswith("Open it by itself to choose a symbol.")
    assert "#flag" not in told[0], "that is advice for the command line"


def test_the_chooser_offers_the_symbols(qtbot, session, sheet):
    worker = Worker()
    chooser = IconChooser(session, worker)
    qtbot.addWidget(chooser)
    chooser.show()
    chosen = []
    chooser.chosen.connect(chosen.append)
    chooser.open_file(str(sheet))
    shown(chooser, qtbot).accept()
    qtbot.waitUntil(lambda: bool(chosen))
    assert "Opened" in chooser.caption.text()
    worker.close()
