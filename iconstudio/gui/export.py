"""A picked result as a file: SVG with credits, or PNG."""

from pathlib import Path

from PySide6.QtCore import QBuffer, QIODevice, QRectF, Qt
from PySide6.QtGui import QColor, QImage, QPainter

from iconstudio.files import write_atomically
from iconstudio.gui.pictures import Picture
from iconstudio.model import IconstudioError

PNG_SIZE = 1024
"""Side of a saved PNG in pixels."""


def svg_text(picture: Picture, title: str) -> str:
    """Return a result as an SVG document with the credits of its sources."""
    from iconstudio.output.svg import svg_document

    return svg_document(picture.result.drawing, picture.result.composite, title)


def write_svg(path: Path, picture: Picture, title: str) -> None:
    """Save a result as SVG."""
    _write(path, svg_text(picture, title).encode())


def write_png(path: Path, picture: Picture, coded: bool) -> None:
    """Save a result as PNG, black on transparent ground, or coded by source."""
    image = QImage(PNG_SIZE, PNG_SIZE, QImage.Format.Format_ARGB32_Premultiplied)
    image.fill(Qt.GlobalColor.transparent)
    with QPainter(image) as painter:
        picture.paint(painter, QRectF(image.rect()), QColor("black"), coded)
    buffer = QBuffer()
    buffer.open(QIODevice.OpenModeFlag.WriteOnly)
    image.save(buffer, "PNG")
    _write(path, buffer.data().data())


def _write(path: Path, content: bytes) -> None:
    try:
        write_atomically(path, content)
    except OSError as error:
        raise IconstudioError(
            f"“{path}” cannot be written: {error.strerror}. Choose another place."
        ) from None
