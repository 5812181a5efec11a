"""Offers work that a window left behind, above the page: to restore it, or to let it go."""

import time
from collections.abc import Mapping
from pathlib import Path

from PySide6.QtCore import Qt, Signal
from PySide6.QtWidgets import QFrame, QLabel

from iconstudio.gui.theme.layout import push_button, row, with_role
from iconstudio.gui.theme.theme import UNIT
from iconstudio.project.journal import LeftBehind
from iconstudio.workflows.workflow import Workflow


class RecoveryBar(QFrame):
    """Shows one offer at a time; hidden while there is none.

    Signals
    -------
    restore(LeftBehind), dismiss(LeftBehind)
        What the user wants to become of the work in sight.
    """

    restore = Signal(object)
    dismiss = Signal(object)

    def __init__(self, workflows: Mapping[str, Workflow]) -> None:
        super().__init__()
        with_role(with_role(self, "notice"), "hint")
        self._workflows = workflows
        self._offers: list[LeftBehind] = []
        self._restoring = False
        self.label = QLabel(wordWrap=True)
        self.label.setTextFormat(Qt.TextFormat.PlainText)
        self.restore_button = push_button(
            "&Restore", "Open it here, still unsaved", lambda: self.restore.emit(self._offers[0])
        )
        self.dismiss_button = push_button(
            "&Dismiss", "Remove it for good", lambda: self.dismiss.emit(self._offers[0])
        )
        margins = UNIT * 3 // 2, UNIT // 4, UNIT // 2, UNIT // 4
        row((self.label, 1), self.restore_button, self.dismiss_button, of=self, margins=margins)
        self.hide()

    def offer(self, found: LeftBehind) -> None:
        """Offer one more."""
        self._offers.append(found)
        self._show()

    def withdraw(self, found: LeftBehind) -> None:
        """Offer one no longer."""
        if found in self._offers:
            self._offers.remove(found)
        self._show()

    def set_restoring(self, restoring: bool) -> None:
        """Say whether the work in sight is being restored; until then it can be asked for."""
        for button in (self.restore_button, self.dismiss_button):
            button.setEnabled(not restoring)
        self._restoring = restoring
        self._show()

    def _show(self) -> None:
        self.setVisible(bool(self._offers))
        if self._offers:
            words = "Restoring the work…" if self._restoring else self._words(self._offers[0])
            self.label.setText(words)
            self.setAccessibleName(self.label.text())

    def _words(self, found: LeftBehind) -> str:
        when = time.localtime(found.when)
        day = "today" if when[:3] == time.localtime()[:3] else f"on {time.strftime('%d %B', when)}"
        clock = time.strftime("%H:%M", when)
        known = self._workflows.get(found.current)
        what = f"on “{Path(found.file).name}”" if found.file else ""
        where = f"in {known.title}" if known is not None else ""
        others = len(self._offers) - 1
        more = f" ({others} more)" if others else ""
        work = " ".join(filter(None, ("Unsaved work", what, where)))
        return f"{work} was left when Iconstudio ended {day} at {clock}{more}."
