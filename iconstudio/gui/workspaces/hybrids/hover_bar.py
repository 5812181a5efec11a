"""The buttons that hover over a hybrid on the sheet."""

from PySide6.QtCore import QEvent, QObject, QPersistentModelIndex, Qt, Signal, SignalInstance
from PySide6.QtWidgets import QToolButton, QWidget

from iconstudio.gui.gallery.sheet import Sheet
from iconstudio.gui.gallery.sheet_model import Index
from iconstudio.gui.pictures.picture import Picture
from iconstudio.gui.theme import icons
from iconstudio.gui.theme.layout import row, tool_button, with_role


class HoverBar(QWidget):
    """The buttons over the hybrid at which the pointer is.

    Signals
    -------
    favourite(Picture), like(Picture)
        The user wants to keep it, or others that resemble it.
    left()
        The pointer is nowhere on the sheet any more.
    """

    favourite = Signal(object)
    like = Signal(object)
    left = Signal()

    def __init__(self, sheet: Sheet) -> None:
        super().__init__(sheet.viewport())
        self._sheet, self._model = sheet, sheet.model()
        self._hovered = QPersistentModelIndex()
        more = self._button("like", "More like this (L)", self.like)
        self._star = self._button("star", "Keep as a favourite (F)", self.favourite)
        row(more, self._star, of=self, spacing=0)
        self.adjustSize()
        self.hide()
        sheet.entered.connect(self._hover)
        sheet.viewportEntered.connect(self._leave)
        sheet.verticalScrollBar().valueChanged.connect(self._leave)
        for changed in (self._model.modelReset, self._model.dataChanged):
            changed.connect(self._place)
        sheet.viewport().installEventFilter(self)

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        """Go away when the pointer leaves."""
        if event.type() == QEvent.Type.Leave:
            self._leave()
            self.left.emit()
        return False

    @property
    def row(self) -> int:
        """The row at which the pointer is; -1 if it is at no hybrid."""
        return self._hovered.row() if self._picture is not None else -1

    @property
    def _picture(self) -> Picture | None:
        entry = self._model.entry(self._hovered)
        return entry if isinstance(entry, Picture) else None

    def _leave(self) -> None:
        self._hover(QPersistentModelIndex())

    def _hover(self, index: Index) -> None:
        self._hovered = QPersistentModelIndex(index)
        self._place()

    def _place(self) -> None:
        """Stand at the top of the hybrid, if there is one; say whether it is a favourite."""
        picture = self._picture
        if picture is None:
            self.hide()
            return
        kept = self._model.is_marked(picture)
        self._star.setIcon(icons.icon("star-full" if kept else "star", "accent"))
        self._star.setToolTip("No favourite any more (F)" if kept else "Keep as a favourite (F)")
        box = self._sheet.visualRect(self._model.index(self._hovered.row()))
        self.move(box.right() - self.width() - 2, box.top() + 2)
        self.show()

    def _button(self, icon: str, words: str, signal: SignalInstance) -> QToolButton:
        button = tool_button(icon, words, lambda: signal.emit(self._picture), token="accent")
        button.setCursor(Qt.CursorShape.ArrowCursor)
        return with_role(button, "floating")
