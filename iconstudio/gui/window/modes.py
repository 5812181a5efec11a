"""The switch between workspaces."""

from collections.abc import Sequence

from PySide6.QtCore import Signal
from PySide6.QtGui import QAction, QActionGroup
from PySide6.QtWidgets import QFrame, QToolButton

from iconstudio.gui.theme.layout import segments


class ModeSwitch(QFrame):
    """A segment for each workspace; Ctrl and its number switch to it, too.

    Signals
    -------
    chosen(int)
        Number of the workspace that the user wants.
    """

    chosen = Signal(int)

    def __init__(self, titles: Sequence[str]) -> None:
        super().__init__()
        group = QActionGroup(self)
        self.actions_in_order: list[QAction] = []
        buttons: list[QToolButton] = []
        for number, title in enumerate(titles):
            action = QAction(title, self, checkable=True, shortcut=f"Ctrl+{number + 1}")
            keys = action.shortcut().toString(action.shortcut().SequenceFormat.NativeText)
            action.setToolTip(f"{title} ({keys})")
            action.triggered.connect(lambda _=False, number=number: self.chosen.emit(number))
            group.addAction(action)
            button = QToolButton()
            button.setDefaultAction(action)
            button.setAccessibleName(title)
            buttons.append(button)
            self.actions_in_order.append(action)
        segments(self, *buttons)

    def show_current(self, number: int) -> None:
        """Mark the workspace in use."""
        self.actions_in_order[number].setChecked(True)
