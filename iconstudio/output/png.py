"""Pictures as PNG files."""

import io
from dataclasses import replace
from pathlib import Path

import numpy as np
from numpy.typing import NDArray
from PIL import Image

from iconstudio.files import check_writable
from iconstudio.model import CANVAS, Frame, Icon, IconstudioError, Remix
from iconstudio.model import Path as Outline
from iconstudio.svg.resvg import render_colours, render_coverage

SIZE = 1024
"""Side in pixels of a result's picture."""


def coverage(path: Outline, size: int) -> NDArray[np.uint8]:
    """Draw a path at any size, (size, size) uint8, 255 = ink."""
    svg = (
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {CANVAS} {CANVAS}">'
        f'<path d="{path.svg()}"/></svg>'
    )
    return render_coverage(svg, Frame(0, 0, CANVAS), size)


def untidied(icon: Icon) -> Icon:
    """Return an icon as it was before what seams brought about was put right."""
    if not isinstance(icon, Remix) or icon.drawing.untidied is None:
        return icon
    path, drawing = icon.drawing.untidied, icon.drawing
    drawn = coverage(path, len(drawing.coverage))
    return icon.drawn(replace(drawing, path=path, coverage=drawn, untidied=None))


def icon_pixels(icon: Icon, size: int, white: bool = False) -> NDArray[np.uint8]:
    """Return an icon on transparent ground, (h, w, 4) uint8 RGBA, the longer side ``size``.

    What has no colour of its own is black, or white.
    """
    from iconstudio.output.svg import svg_document

    if any(fill.colour for fill in icon.fills):
        width, height = icon.size
        longer = max(width, height)
        pixels = render_colours(svg_document(icon), Frame(0, 0, longer), size)
        return pixels[: round(size * height / longer), : round(size * width / longer)]
    picture = np.full((size, size, 4), 255 if white else 0, np.uint8)
    picture[..., 3] = coverage(icon.path, size)
    return picture


def encoded(pixels: NDArray[np.uint8] | Image.Image) -> bytes:
    """Encode a picture, or (h, w, 4) uint8 RGBA with alpha not multiplied in."""
    image = pixels if isinstance(pixels, Image.Image) else Image.fromarray(pixels)
    file = io.BytesIO()
    image.save(file, "PNG")
    return file.getvalue()


def check_name(path: Path, *read: str | Path) -> Path:
    """Return the path of a picture that is to be written, and is none of those that are ``read``.

    Raises
    ------
    IconstudioError
        If its name does not end in .png, or it cannot be written, or is read.
    """
    if path.suffix.lower() != ".png":
        raise IconstudioError(
            f"Pictures are written as PNG, and “{path.name}” does not say so. "
            f"Call it “{path.stem or 'picture'}.png”."
        )
    check_writable(path, read)
    return path
