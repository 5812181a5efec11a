"""What an empty canvas offers to begin with."""

from PySide6.QtGui import QAction
from PySide6.QtWidgets import QMenu, QWidget

from iconstudio.gui.canvas.view import CanvasView
from iconstudio.gui.theme.layout import OnGeometry, push_button, row
from iconstudio.gui.theme.theme import UNIT


class StartButtons(QWidget):
    """A button for an action and “Try an example” below the welcome on an empty canvas.

    The latter only if there are ``examples``.
    """

    def __init__(self, canvas: CanvasView, action: QAction, examples: QMenu | None) -> None:
        super().__init__(canvas)
        self._canvas = canvas
        buttons = [push_button(action.text().replace("&", ""), do=action.trigger)]
        if examples is not None:
            buttons.append(push_button("Try an example"))
            buttons[-1].setMenu(examples)
        row(*buttons, of=self)
        OnGeometry(canvas, self._place)
        canvas.scene.document.page_changed.connect(self._show)
        self._show()

    def _show(self) -> None:
        self.setVisible(self._canvas.scene.empty)

    def _place(self) -> None:
        """Stay below the middle of the canvas."""
        self.adjustSize()
        canvas = self._canvas
        self.move((canvas.width() - self.width()) // 2, canvas.height() // 2 + 2 * UNIT)
