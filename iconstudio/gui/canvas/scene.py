"""What lies on a canvas, under the feedback of its tool."""

from typing import ClassVar

from PySide6.QtCore import QObject, QRectF, Signal
from PySide6.QtGui import QPainter

from iconstudio.gui.canvas.camera import Camera
from iconstudio.gui.document.document import Document
from iconstudio.gui.theme.theme import Theme
from iconstudio.model import CANVAS


class Scene(QObject):
    """Paints the page of a document; each workspace has its own.

    Signals
    -------
    changed()
        Something else is to be painted though the page is the same.
    """

    changed = Signal()

    welcome: ClassVar[tuple[str, str]] = ("", "")
    """What an empty canvas says: a heading, and what to do."""

    def __init__(self, document: Document) -> None:
        super().__init__()
        self.document = document

    @property
    def empty(self) -> bool:
        """Whether there is nothing to look at yet."""
        return False

    def bounds(self) -> QRectF:
        """Return the area to show, in page units."""
        return QRectF(0, 0, CANVAS, CANVAS)

    def paint(self, painter: QPainter, camera: Camera, ratio: float, theme: Theme) -> None:
        """Draw the page in view coordinates; ``ratio`` is the pixels of the device to each."""
