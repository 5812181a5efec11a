"""A line of text that ends in an ellipsis where it finds no room."""

from html import escape

from PySide6.QtCore import QEvent, Qt
from PySide6.QtGui import QResizeEvent
from PySide6.QtWidgets import QLabel, QSizePolicy

from iconstudio.gui.theme import theme


class ElidedLabel(QLabel):
    """A label as wide as its layout lets it be; with ``url``, it is a link.

    What is cut is the text before ``tail``, as long as there is room for that.
    """

    def __init__(self, text: str, url: str = "", tail: str = "") -> None:
        super().__init__()
        self._head, self._tail = text, tail
        self._url = url
        self.setTextFormat(Qt.TextFormat.RichText if url else Qt.TextFormat.PlainText)
        self.setOpenExternalLinks(bool(url))
        self.setSizePolicy(QSizePolicy.Policy.Ignored, QSizePolicy.Policy.Preferred)
        self.setAccessibleName(text + tail)
        self._show(text + tail)

    def set_words(self, text: str) -> None:
        """Show another text; the tool tip has all of it."""
        self._head = text
        self.setAccessibleName(text + self._tail)
        self.setToolTip(text + self._tail)
        self._fit()

    def resizeEvent(self, event: QResizeEvent) -> None:
        """Fit the text to the new width."""
        super().resizeEvent(event)
        self._fit()

    def changeEvent(self, event: QEvent) -> None:
        """Draw a link in the new colours."""
        super().changeEvent(event)
        if event.type() == QEvent.Type.PaletteChange:
            self._fit()

    def _fit(self) -> None:
        metrics, end = self.fontMetrics(), Qt.TextElideMode.ElideRight
        tail = metrics.elidedText(self._tail, end, self.width())
        room = self.width() - metrics.horizontalAdvance(tail)
        self._show(metrics.elidedText(self._head, end, room) + tail)

    def _show(self, text: str) -> None:
        if self._url:
            style = f"color:{theme.current().accent}; text-decoration:none"
            text = f"<a href='{escape(self._url, quote=True)}' style='{style}'>{escape(text)}</a>"
        if text != self.text():
            self.setText(text)
