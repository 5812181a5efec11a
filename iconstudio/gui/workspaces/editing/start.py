"""Where an edit begins: a sheet over the canvas on which the icon is chosen."""

from PySide6.QtCore import Qt
from PySide6.QtGui import QKeyEvent
from PySide6.QtWidgets import QFrame, QMenu, QWidget

from iconstudio.gui.panels.chooser import IconChooser
from iconstudio.gui.theme.layout import (
    OnGeometry,
    column,
    label,
    push_button,
    row,
    tool_button,
    with_role,
)
from iconstudio.gui.theme.theme import UNIT
from iconstudio.workflows.editing.page import EditDocument


class StartPanel(QFrame):
    """Covers a canvas while an icon is chosen; can be closed if there is one already."""

    def __init__(
        self, document: EditDocument, canvas: QWidget, chooser: IconChooser, examples: QMenu
    ) -> None:
        super().__init__(canvas)
        self._document, self._canvas = document, canvas
        with_role(self, "sheet").setAutoFillBackground(True)
        self.chooser = chooser
        tip = "Go on with the icon that is there (Esc)"
        self.close_button = tool_button("close", tip, self._close)
        self.close_button.setAccessibleName("Close")
        try_example = push_button("Try an example")
        try_example.setMenu(examples)
        heading = label("Choose an icon to change", "title")
        words = label(
            "Then mark on it what should go and what should come: parts of other icons fill in.",
            wordWrap=True,
        )
        top = row((heading, 1), try_example, self.close_button)
        margins = 2 * UNIT, 2 * UNIT, 2 * UNIT, UNIT
        column(top, words, (self.chooser, 1), of=self, margins=margins)
        self.setFocusProxy(self.chooser)
        OnGeometry(canvas, lambda: self.resize(canvas.size()))

        document.opened.connect(lambda: self.offer(document.page.empty))

    def offer(self, shown: bool) -> None:
        """Let an icon be chosen, or go on with the one that is there."""
        self.close_button.setVisible(not self._document.page.empty)
        was = self.isVisibleTo(self._canvas)
        self.setVisible(shown)
        if was and not shown and self._canvas.isVisible():
            self._canvas.setFocus()

    def _close(self) -> None:
        self.offer(False)

    def keyPressEvent(self, event: QKeyEvent) -> None:
        """Close with Escape; keep other keys from the canvas below."""
        if event.key() == Qt.Key.Key_Escape and self.close_button.isVisible():
            self._close()
        event.accept()
