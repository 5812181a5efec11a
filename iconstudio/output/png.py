"""Pictures as PNG files."""

import io
from pathlib import Path

import numpy as np
from numpy.typing import NDArray
from PIL import Image

from iconstudio.files import write_atomically
from iconstudio.model import Drawing, IconstudioError

SIZE = 1024
"""Side in pixels of a result's picture."""


def ink_picture(drawing: Drawing, size: int = SIZE) -> Image.Image:
    """Return a drawing in black on transparent ground."""
    coverage = Image.fromarray(drawing.coverage).resize((size, size), Image.Resampling.BOX)
    picture = Image.new("RGBA", (size, size), (0, 0, 0, 0))
    picture.putalpha(coverage)
    return picture


def encoded(picture: Image.Image | NDArray[np.uint8]) -> bytes:
    """Return a picture, or an array of grey or RGBA values, as PNG."""
    if not isinstance(picture, Image.Image):
        picture = Image.fromarray(picture)
    buffer = io.BytesIO()
    picture.save(buffer, "PNG")
    return buffer.getvalue()


def write(path: Path, data: bytes) -> None:
    """Write a file in one step.

    Raises
    ------
    IconstudioError
        If it cannot be written.
    """
    try:
        write_atomically(path, data)
    except OSError as error:
        raise IconstudioError(
            f"“{path}” cannot be written: {error.strerror or error}. Choose another place."
        ) from None
