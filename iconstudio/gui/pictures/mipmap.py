"""A picture with ever smaller copies, so that drawing it small is quick and smooth."""

from dataclasses import dataclass

from PySide6.QtCore import Qt
from PySide6.QtGui import QImage


@dataclass(frozen=True, slots=True, eq=False)
class Mipmap:
    """``levels`` hold the picture and copies, each half as large as the one before."""

    levels: tuple[QImage, ...]

    @classmethod
    def of(cls, image: QImage, least: int) -> "Mipmap":
        """Return ``image`` with copies whose shorter side is no less than ``least``."""
        levels = [image.convertToFormat(QImage.Format.Format_ARGB32_Premultiplied)]
        while min(levels[-1].width(), levels[-1].height()) >= 2 * least:
            last = levels[-1]
            half = last.scaled(
                last.width() // 2,
                last.height() // 2,
                Qt.AspectRatioMode.IgnoreAspectRatio,
                Qt.TransformationMode.SmoothTransformation,
            )
            levels.append(half)
        return cls(tuple(levels))

    @property
    def width(self) -> int:
        """Pixels of the largest copy."""
        return self.levels[0].width()

    def at(self, width: float) -> QImage:
        """Return the smallest copy with at least ``width`` pixels, or the largest there is."""
        return next((one for one in reversed(self.levels) if one.width() >= width), self.levels[0])


def fitted(image: QImage, side: int) -> QImage:
    """Return an image scaled smoothly, its longer side ``side`` pixels."""
    keep, smooth = Qt.AspectRatioMode.KeepAspectRatio, Qt.TransformationMode.SmoothTransformation
    return image.scaled(side, side, keep, smooth)
