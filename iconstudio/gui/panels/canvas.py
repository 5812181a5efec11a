"""A canvas with its tool bar."""

from collections.abc import Sequence

from PySide6.QtCore import QSize
from PySide6.QtGui import QAction
from PySide6.QtWidgets import QFrame, QMenu, QToolButton, QWidget

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


class ToolsButton(QToolButton):
    """One button for several tools, with a menu of them: it takes the one that was last in use."""

    def __init__(self, tools: Sequence[QAction]) -> None:
        super().__init__()
        menu = QMenu(self)
        menu.addActions(tools)
        self.setMenu(menu)
        self.setPopupMode(QToolButton.ToolButtonPopupMode.MenuButtonPopup)
        self.setIconSize(QSize(20, 20))
        for one in tools:
            one.toggled.connect(lambda on, one=one: on and self._show(one))
        self._show(tools[0])

    def _show(self, tool: QAction) -> None:
        self.setDefaultAction(tool)
        self.setAccessibleName(tool.iconText())


def together(tools: Sequence[QAction]) -> QAction | QWidget:
    """Return what stands on a bar for some tools: of several, one button is made."""
    return ToolsButton(tools) if len(tools) > 1 else tools[0]
