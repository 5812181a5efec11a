"""Photos to trace over: decoded away from the window's thread, scaled down when gigantic."""

from dataclasses import dataclass
from pathlib import Path

from PySide6.QtCore import QSize, Qt
from PySide6.QtGui import QImage, QImageIOHandler, QImageReader

from iconstudio.gui.mipmap import Mipmap
from iconstudio.model import IconstudioError

LONGEST = 4096
"""A photo is kept with at most this many pixels on its longer side; it is only a guide."""

_ALLOCATION_LIMIT = 512
"""Megabytes that decoding a photo may take, before scaling."""


@dataclass(frozen=True, slots=True, eq=False)
class Photo:
    """A photo under the drawing.

    ``width`` and ``height`` are the original's pixels, the unit of the outline.
    """

    path: str
    width: int
    height: int
    picture: Mipmap

    @property
    def scaled_down(self) -> bool:
        """Whether the photo was too large to be kept whole."""
        return self.picture.width < self.width


def read_photo(path: str) -> Photo:
    """Decode the photo in the file ``path``.

    Raises
    ------
    IconstudioError
        If the file cannot be read, is no image, or is too large to decode.
    """
    name = Path(path).name
    if not Path(path).is_file():
        raise IconstudioError(f"There is no file “{path}”. Choose another photo.")
    QImageReader.setAllocationLimit(_ALLOCATION_LIMIT)
    reader = QImageReader(path)
    reader.setAutoTransform(True)
    reader.setDecideFormatFromContent(True)
    size = reader.size()
    if size.isValid() and max(size.width(), size.height()) > LONGEST:
        reader.setScaledSize(size.scaled(LONGEST, LONGEST, Qt.AspectRatioMode.KeepAspectRatio))
    image = reader.read()
    if image.isNull():
        if size.isValid() and size.width() * size.height() > 50_000_000:
            raise IconstudioError(
                f"“{name}” is too large to open ({size.width():,} × {size.height():,} pixels). "
                f"Scale it down to {LONGEST:,} pixels or fewer and open it again."
            )
        raise IconstudioError(
            f"“{name}” is not a photo that can be opened ({reader.errorString().rstrip('.')}). "
            "Choose a PNG, JPEG, WebP, TIFF, GIF or BMP file."
        )
    if reader.transformation() & QImageIOHandler.Transformation.TransformationRotate90:
        size.transpose()
    return _photo(image, size if size.isValid() else image.size(), path)


def photo_from_image(image: QImage) -> Photo:
    """Return a pasted or dropped ``image`` as a photo."""
    if image.isNull():
        raise IconstudioError("The clipboard holds no image. Copy a photo and paste it again.")
    return _photo(image, image.size(), "")


def _photo(image: QImage, size: QSize, path: str) -> Photo:
    smooth = Qt.TransformationMode.SmoothTransformation
    keep = Qt.AspectRatioMode.KeepAspectRatio
    if max(image.width(), image.height()) > LONGEST:
        image = image.scaled(LONGEST, LONGEST, keep, smooth)
    return Photo(path, size.width(), size.height(), Mipmap.of(image, 256))
