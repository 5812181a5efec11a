"""Photos and other images of pixels as Qt has them. Nothing is decoded here."""

from functools import lru_cache

import numpy as np
from numpy.typing import NDArray
from PySide6.QtGui import QImage

from iconstudio.gui.pictures.mipmap import Mipmap, fitted
from iconstudio.images.reading import LONGEST, Image
from iconstudio.model import IconstudioError, Photo


@lru_cache(2)
def mipmap_of(photo: Photo) -> Mipmap:
    """Return a photo as Qt draws it; the pixels are the photo's own, which must outlive it."""
    return Mipmap(tuple(map(_wrapped, photo.levels)))


def _wrapped(words: NDArray[np.uint32]) -> QImage:
    height, width = words.shape
    kind = QImage.Format.Format_ARGB32_Premultiplied
    return QImage(words.view(np.uint8), width, height, 4 * width, kind)


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
        image = fitted(image, LONGEST)
    clear = image.hasAlphaChannel()
    image = image.convertToFormat(
        QImage.Format.Format_RGBA8888 if clear else QImage.Format.Format_RGB888
    )
    rows = np.frombuffer(image.constBits(), np.uint8).reshape(image.height(), -1)
    channels = 4 if clear else 3
    pixels = rows[:, : image.width() * channels].reshape(image.height(), image.width(), channels)
    return Image(pixels.copy(), width, height)
