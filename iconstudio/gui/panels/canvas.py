"""A canvas with its tool bar."""

from collections.abc import Sequence

from PySide6.QtCore import QSize
from PySide6.QtGui import QAction
from PySide6.QtWidgets import QFrame, QToolButton, QWidget

from iconstudio.gui.canvas.view import CanvasView
from iconstudio.gui.theme.layout import column, row, with_role
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
    ) -> None:
        super().__init__()
        parts: list[QWidget | int] = []
        for group in groups:
            if parts:
                parts.append(UNIT)
            parts += (_button(item) if isinstance(item, QAction) else item for item in group)
        margins = UNIT // 2, UNIT // 2, UNIT, UNIT // 2
        bar = row(*parts, None, *trailing, spacing=2, margins=margins)
        column(bar, (view, 1), of=with_role(self, "card"), spacing=0, margins=(1, 1, 1, 1))


def _button(action: QAction) -> QToolButton:
    button = QToolButton()
    button.setDefaultAction(action)
    button.setIconSize(QSize(20, 20))
    button.setAccessibleName(action.iconText())
    if action.menu() is not None:
        button.setPopupMode(QToolButton.ToolButtonPopupMode.InstantPopup)
    return button
