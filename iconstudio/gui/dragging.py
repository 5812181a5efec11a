"""Icons and files that are dragged onto a part of the window."""

from PySide6.QtCore import QMimeData, QPoint, QRect, Qt
from PySide6.QtGui import QDrag, QPixmap
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


def dropped_file(data: QMimeData) -> str | None:
    """Return the path of the first file on this computer among what is dragged."""
    return next((url.toLocalFile() for url in data.urls() if url.isLocalFile()), None)


def droppable(data: QMimeData) -> bool:
    """Whether an icon of this window or a file is dragged."""
    return unpacked(data) is not None or dropped_file(data) is not None


def drag(pictogram: Pictogram, picture: QPixmap, source: QWidget) -> None:
    """Let the user drag an icon, whose ``picture`` hangs on the pointer, and drop it."""
    carrier = QDrag(source)
    carrier.setMimeData(packed(pictogram))
    carrier.setPixmap(picture)
    carrier.setHotSpot(QRect(QPoint(), picture.deviceIndependentSize().toSize()).center())
    carrier.exec(Qt.DropAction.CopyAction)
