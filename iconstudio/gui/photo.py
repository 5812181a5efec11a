"""Photos to trace over, and images of pixels as Qt has them. Nothing is decoded here."""

from dataclasses import dataclass

import numpy as np
from PySide6.QtCore import Qt
from PySide6.QtGui import QImage

from iconstudio.gui.mipmap import Mipmap
from iconstudio.library.images import LONGEST, Image
from iconstudio.model import IconstudioError


@dataclass(frozen=True, slots=True, eq=False)
class Photo:
    """A photo under the drawing.

    ``width`` and ``height`` are the original's pixels, the unit of the outline.
    """

    path: str
    width: int
    height: int
    picture: Mipmap
    remark: str = ""
    """What of it could not be read, or is not shown."""

    @property
    def scaled_down(self) -> bool:
        """Whether the photo was too large to be kept whole."""
        return self.picture.width < self.width


def photo_of(image: Image, path: str = "") -> Photo:
    """Return an image that was read from the file ``path``, if any, as a photo."""
    return Photo(path, image.width, image.height, Mipmap.of(qt_image(image), 256), image.remark)


def qt_image(image: Image) -> QImage:
    """Return an image as Qt has it."""
    height, width, channels = image.pixels.shape
    kind = QImage.Format.Format_RGBA8888 if channels == 4 else QImage.Format.Format_RGB888
    # A copy: Qt would not keep the pixels alive.
    return QImage(image.pixels, width, height, width * channels, kind).copy()


def image_of(image: QImage) -> Image:
    """Return an image that another program, or Qt, holds in memory, as one that was read.

    Raises
    ------
    IconstudioError
        If it is empty.
    """
    if image.isNull():
        raise IconstudioError("The clipboard holds no image. Copy a photo and paste it again.")
    width, height = image.width(), image.height()
    if max(width, height) > LONGEST:
        smooth, keep = (
            Qt.TransformationMode.SmoothTransformation,
            Qt.AspectRatioMode.KeepAspectRatio,
        )
        image = image.scaled(LONGEST, LONGEST, keep, smooth)
    clear = image.hasAlphaChannel()
    image = image.convertToFormat(
        QImage.Format.Format_RGBA8888 if clear else QImage.Format.Format_RGB888
    )
    rows = np.frombuffer(image.constBits(), np.uint8).reshape(image.height(), -1)
    channels = 4 if clear else 3
    pixels = rows[:, : image.width() * channels].reshape(image.height(), image.width(), channels)
    return Image(pixels.copy(), width, height)
