"""Compares what is drawn with what should be drawn."""

import numpy as np
from PySide6.QtCore import Qt
from PySide6.QtGui import QImage


def pixels(image: QImage) -> np.ndarray:
    """Return (h, w, 4) float in 0 to 1: RGBA, alpha multiplied in."""
    image = image.convertToFormat(QImage.Format.Format_RGBA8888_Premultiplied)
    row = image.bytesPerLine()
    flat = np.frombuffer(image.constBits(), np.uint8, row * image.height())
    return (
        flat.reshape(image.height(), row)[:, : 4 * image.width()].reshape(
            image.height(), image.width(), 4
        )
        / 255
    )


def difference(first: QImage, second: QImage) -> float:
    """Return the largest mean difference of any 8 x 8 block, from 0 (equal) to 1.

    Blocks, so that another antialiasing is nothing and a missing line is much.
    """
    assert first.size() == second.size(), f"{first.size()} is not {second.size()}"
    gap = np.abs(pixels(first) - pixels(second)).max(axis=2)
    height, width = (side - side % 8 for side in gap.shape)
    blocks = gap[:height, :width].reshape(height // 8, 8, width // 8, 8)
    return float(blocks.mean(axis=(1, 3)).max(initial=0.0))


def assert_alike(first: QImage, second: QImage, tolerance: float = 0.1) -> None:
    """Fail unless the images show the same."""
    found = difference(first, second)
    assert found <= tolerance, f"the images differ by {found:.2f}, more than {tolerance}"


def blank(width: int, height: int) -> QImage:
    """Return a white image."""
    image = QImage(width, height, QImage.Format.Format_ARGB32_Premultiplied)
    image.fill(Qt.GlobalColor.white)
    return image
