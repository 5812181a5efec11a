"""A canvas with its tool bar."""

from collections.abc import Sequence

from PySide6.QtCore import QSize
from PySide6.QtGui import QAction
from PySide6.QtWidgets import QFrame, QHBoxLayout, QToolButton, QVBoxLayout, QWidget

from iconstudio.gui.canvas.view import CanvasView
from iconstudio.gui.theme.theme import UNIT


class CanvasPanel(QFrame):
    """Tool bar above, canvas below.

    Parameters
    ----------
    groups
        Actions, and widgets, of the tool bar; a little space parts the groups.
    trailing
        Widgets at its right end.
    """

    def __init__(
        self,
        view: CanvasView,
        groups: Sequence[Sequence[QAction | QWidget]],
        trailing: Sequence[QWidget] = (),
        parent: QWidget | None = None,
    ) -> None:
        super().__init__(parent)
        self.setProperty("card", True)
        bar = QHBoxLayout()
        bar.setContentsMargins(UNIT // 2, UNIT // 2, UNIT, UNIT // 2)
        bar.setSpacing(2)
        for number, group in enumerate(groups):
            if number:
                bar.addSpacing(UNIT)
            for item in group:
                bar.addWidget(_button(item) if isinstance(item, QAction) else item)
        bar.addStretch()
        for widget in trailing:
            bar.addWidget(widget)
        layout = QVBoxLayout(self)
        layout.setContentsMargins(1, 1, 1, 1)
        layout.setSpacing(0)
        layout.addLayout(bar)
        layout.addWidget(view, 1)


def _button(action: QAction) -> QToolButton:
    button = QToolButton()
    button.setDefaultAction(action)
    button.setIconSize(QSize(20, 20))
    button.setAccessibleName(action.iconText())
    if action.menu() is not None:
        button.setPopupMode(QToolButton.ToolButtonPopupMode.InstantPopup)
    return button
