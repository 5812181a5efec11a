"""Icons and files that are dragged onto a part of the window."""

from PySide6.QtCore import QMimeData, QPoint, QRect, Qt
from PySide6.QtGui import QDrag, QDropEvent, QPixmap
from PySide6.QtWidgets import QWidget

from iconstudio.model import Pictogram

ICON = "application/x-iconstudio-icon"
"""MIME type of an icon of this window; its data are the pictogram's identifier."""

_carried: dict[str, Pictogram] = {}
"""What is dragged now: there is but one pointer."""


def packed(pictogram: Pictogram) -> QMimeData:
    """Return what a drag of ``pictogram`` carries; for other programs, that is its SVG."""
    _carried.clear()
    _carried[pictogram.id] = pictogram
    data = QMimeData()
    data.setData(ICON, pictogram.id.encode())
    data.setData("image/svg+xml", pictogram.svg.encode())
    return data


def unpacked(data: QMimeData) -> Pictogram | None:
    """Return the icon that is dragged, if it is one of this window."""
    return _carried.get(data.data(ICON).data().decode(errors="replace"))


def take_copy(event: QDropEvent) -> None:
    """Accept a drop, and leave what was dragged where it came from."""
    event.setDropAction(Qt.DropAction.CopyAction)
    event.accept()


def drag(pictogram: Pictogram, picture: QPixmap, source: QWidget) -> None:
    """Let the user drag an icon, whose ``picture`` hangs on the pointer, and drop it."""
    carrier = QDrag(source)
    carrier.setMimeData(packed(pictogram))
    carrier.setPixmap(picture)
    carrier.setHotSpot(QRect(QPoint(), picture.deviceIndependentSize().toSize()).center())
    carrier.exec(Qt.DropAction.CopyAction)
