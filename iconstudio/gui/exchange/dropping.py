"""What can be dropped on a widget."""

from collections.abc import Callable

from PySide6.QtCore import QEvent, QMimeData, QObject
from PySide6.QtWidgets import QWidget

from iconstudio.gui.exchange.dragging import take_copy
from iconstudio.gui.exchange.mime import holds_something


class DropTarget(QObject):
    """Calls ``take`` with what is dropped on a widget.

    By default that may be anything, so that what cannot be used is told; what does not ``fit`` is
    for the widget around it.
    """

    def __init__(
        self,
        widget: QWidget,
        take: Callable[[QMimeData], object],
        fits: Callable[[QMimeData], bool] = holds_something,
    ) -> None:
        super().__init__(widget)
        self._take, self._fits = take, fits
        widget.setAcceptDrops(True)
        widget.installEventFilter(self)

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        """Look out for what is dragged here."""
        kinds = QEvent.Type.DragEnter, QEvent.Type.Drop
        if event.type() not in kinds or not self._fits(event.mimeData()):
            return False
        take_copy(event)
        if event.type() == QEvent.Type.Drop:
            self._take(event.mimeData())
        return True
