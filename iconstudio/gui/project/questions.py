"""What the user is asked about projects."""

from enum import Enum
from pathlib import Path

from PySide6.QtWidgets import QFileDialog, QMessageBox, QWidget

from iconstudio.gui.exchange.saving import ask_path
from iconstudio.output.filenames import suffixed
from iconstudio.project.archive import SUFFIX


class Answer(Enum):
    """What becomes of work that is not saved."""

    SAVE = "save"
    DISCARD = "discard"
    CANCEL = "cancel"


def ask_about_unsaved(window: QWidget, name: str) -> Answer:
    """Ask what becomes of the work in the project of that name before it goes from sight."""
    box = unsaved_box(window, name)
    box.exec()
    answers = {
        QMessageBox.ButtonRole.AcceptRole: Answer.SAVE,
        QMessageBox.ButtonRole.DestructiveRole: Answer.DISCARD,
    }
    pressed = box.clickedButton()
    answer = answers.get(box.buttonRole(pressed), Answer.CANCEL) if pressed else Answer.CANCEL
    box.deleteLater()
    return answer


def unsaved_box(window: QWidget, name: str) -> QMessageBox:
    """Return the question."""
    box = QMessageBox(window)
    box.setIcon(QMessageBox.Icon.Question)
    box.setWindowTitle("Unsaved work")
    box.setText(f"Save the changes to “{name}”?" if name else "Save your work?")
    box.setInformativeText("If you do not save, what you did since it was last saved is lost.")
    if not name:
        box.setInformativeText("If you do not save it, it is lost.")
    save = box.addButton("&Save" if name else "&Save…", QMessageBox.ButtonRole.AcceptRole)
    box.addButton("&Don’t save", QMessageBox.ButtonRole.DestructiveRole)
    cancel = box.addButton("&Cancel", QMessageBox.ButtonRole.RejectRole)
    box.setDefaultButton(save)
    box.setEscapeButton(cancel)
    return box


def ask_about_opening(window: QWidget) -> bool:
    """Ask whether to go on although something is still being opened, which is lost then."""
    box = opening_box(window)
    box.exec()
    pressed = box.clickedButton()
    going = pressed and box.buttonRole(pressed) == QMessageBox.ButtonRole.DestructiveRole
    box.deleteLater()
    return bool(going)


def opening_box(window: QWidget) -> QMessageBox:
    """Return the question."""
    box = QMessageBox(window)
    box.setIcon(QMessageBox.Icon.Question)
    box.setWindowTitle("Still opening")
    box.setText("Something that you opened is still being read.")
    box.setInformativeText("It is in no file of yours yet. Wait until it is there to save it.")
    wait = box.addButton("&Wait", QMessageBox.ButtonRole.RejectRole)
    box.addButton("&Leave it out", QMessageBox.ButtonRole.DestructiveRole)
    box.setDefaultButton(wait)
    box.setEscapeButton(wait)
    return box


def ask_where(window: QWidget, suggested: str) -> Path | None:
    """Ask where to save a project; None if the user thinks better of it.

    Raises
    ------
    IconstudioError
        If that would replace a file that the dialog did not ask about.
    """
    path = ask_path(window, "Save the project as", "Projects", SUFFIX, suggested)
    return None if path is None else suffixed(path, SUFFIX)


def ask_which(window: QWidget) -> Path | None:
    """Ask which file to open; None if the user thinks better of it."""
    kinds = f"Projects and work (*{SUFFIX} *.json);;All files (*)"
    path, _ = QFileDialog.getOpenFileName(window, "Open a project", "", kinds)
    return Path(path) if path else None
