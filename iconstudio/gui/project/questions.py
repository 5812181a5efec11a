"""What the user is asked about projects."""

import os
from enum import Enum
from pathlib import Path

from PySide6.QtWidgets import QFileDialog, QMessageBox, QWidget

from iconstudio.model import IconstudioError
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


def ask_where(window: QWidget, suggested: str) -> Path | None:
    """Ask where to save a project; None if the user thinks better of it.

    Raises
    ------
    IconstudioError
        If that would replace a file that the dialog did not ask about.
    """
    dialog = QFileDialog(window, "Save the project as")
    dialog.setAcceptMode(QFileDialog.AcceptMode.AcceptSave)
    dialog.setNameFilter(f"Projects (*{SUFFIX})")
    dialog.setDefaultSuffix(SUFFIX[1:])
    dialog.selectFile(suggested)
    chosen = dialog.selectedFiles() if dialog.exec() else []
    dialog.deleteLater()
    return named_as_project(Path(chosen[0])) if chosen else None


def named_as_project(path: Path) -> Path:
    """Return a path whose name ends as those of projects do.

    Raises
    ------
    IconstudioError
        If there is a file of that name, which is not the one that was chosen.
    """
    if path.suffix.lower() == SUFFIX:
        return path
    path = path.with_name(f"{path.name}{SUFFIX}")
    if os.path.lexists(path):
        raise IconstudioError(f"“{path}” is there already. Save under another name.")
    return path


def ask_which(window: QWidget) -> Path | None:
    """Ask which file to open; None if the user thinks better of it."""
    kinds = f"Projects and work (*{SUFFIX} *.json);;All files (*)"
    path, _ = QFileDialog.getOpenFileName(window, "Open a project", "", kinds)
    return Path(path) if path else None
