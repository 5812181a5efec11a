"""A light figure to draw sheets on: text in the bundled font, thumbnails of ink."""

import io
from collections.abc import Sequence
from functools import cache
from itertools import groupby
from unicodedata import category, name

import numpy as np
from numpy.typing import NDArray
from PIL import Image, ImageDraw, ImageFont

from iconstudio.library.words.symbols import spoken
from iconstudio.resources import resource
from iconstudio.svg.geometry import advances

INK = (28, 30, 34)
MUTED = (118, 122, 130)
WARNING = (176, 58, 46)
ACCENT = (94, 138, 214)
PAPER = (255, 255, 255)
RULE = (228, 230, 234)
PALE = (222, 224, 228)
"""Ink of a source that is not used."""

RGB = tuple[int, int, int]


@cache
def font(size: int, bold: bool = False) -> ImageFont.FreeTypeFont:
    """Return Inter at ``size`` pixels."""
    name = f"fonts/Inter-{'SemiBold' if bold else 'Regular'}.otf"
    # From memory: Pillow would keep the file open.
    data = io.BytesIO(resource(name).read_bytes())
    return ImageFont.truetype(data, size, layout_engine=ImageFont.Layout.BASIC)


@cache
def _letters() -> frozenset[int]:
    """Return the characters that Inter has."""
    return frozenset(advances(resource("fonts/Inter-Regular.otf")))


def legible(text: str) -> str:
    """Return a text with names for what Inter lacks: of symbols, or of a word's script."""
    known = _letters()

    def written(word: str) -> str:
        unknown = [one for one in word if ord(one) not in known]
        script = name(unknown[0], "?").split()[0] if unknown else ""
        return f"[{script if script == 'CJK' else script.capitalize()}]" if script else word

    if all(ord(one) in known or one.isspace() for one in text):
        return text
    seen = "".join(
        one for one in spoken(text) if category(one) not in ("Cc", "Cf") or one.isspace()
    )
    return " ".join(word for word, _ in groupby(map(written, seen.split())))


class Figure:
    """A white picture of a fixed size."""

    def __init__(self, width: int, height: int) -> None:
        self.picture = Image.new("RGB", (width, height), PAPER)
        self._draw = ImageDraw.Draw(self.picture)

    def text(
        self,
        x: float,
        y: float,
        text: str,
        size: int,
        *,
        bold: bool = False,
        colour: RGB = INK,
        width: float = float("inf"),
        anchor: str = "la",
    ) -> float:
        """Write a line, shortened with an ellipsis to ``width``, and return how long it is.

        ``anchor`` is Pillow's.
        """
        face = font(size, bold)
        text = shortened(legible(text), face, width)
        self._draw.text((x, y), text, colour, face, anchor)
        return face.getlength(text)

    def paragraph(
        self, x: float, y: float, text: str, size: int, width: float, colour: RGB
    ) -> None:
        """Write lines broken at words."""
        face, line = font(size), ""
        for word in [*legible(text).split(), ""]:
            if line and (not word or face.getlength(f"{line} {word}") > width):
                self._draw.text((x, y), line, colour, face)
                y, line = y + size * 1.4, word
            else:
                line = f"{line} {word}".strip()

    def rule(self, y: float, left: float, right: float) -> None:
        """Draw a thin horizontal line."""
        self._draw.line((left, y, right, y), RULE, 2)

    def arrow(self, left: float, right: float, y: float) -> None:
        """Draw a thin arrow to the right."""
        self._draw.line((left, y, right, y), MUTED, 2)
        self._draw.line((right - 8, y - 6, right, y, right - 8, y + 6), MUTED, 2, joint="curve")

    def frame(self, x: float, y: float, width: float, height: float, colour: RGB) -> None:
        """Draw the outline of a rectangle with round corners."""
        radius = min(8, height / 4)
        box = (x, y, x + width, y + height)
        self._draw.rounded_rectangle(box, radius, outline=colour, width=2)

    def polygon(
        self, x: float, y: float, points: Sequence[tuple[float, float]], scale: float
    ) -> None:
        """Fill a polygon given in canvas units."""
        mask = Image.new("L", [4 * round(256 * scale)] * 2)
        corners = [(4 * scale * px, 4 * scale * py) for px, py in points]
        ImageDraw.Draw(mask).polygon(corners, 255)
        side = round(256 * scale)
        small = mask.resize((side, side), Image.Resampling.BICUBIC)
        self.picture.paste(MUTED, (round(x), round(y)), small)

    def stencil(
        self, x: float, y: float, side: int, coverage: NDArray[np.uint8], colour: RGB = INK
    ) -> None:
        """Draw ink, (n, n) uint8, in one colour."""
        # Smoothly: 512 pixels made 480 by means of whole pixels would be jagged.
        mask = Image.fromarray(coverage).resize((side, side), Image.Resampling.BICUBIC)
        self.picture.paste(colour, (round(x), round(y)), mask)

    def image(self, x: float, y: float, rgba: NDArray[np.uint8]) -> None:
        """Draw a picture, (h, w, 4) uint8."""
        image = Image.fromarray(rgba)
        self.picture.paste(image, (round(x), round(y)), image)


def shortened(text: str, face: ImageFont.FreeTypeFont, width: float) -> str:
    """Return ``text``, or as much of it as fits ``width`` with an ellipsis."""
    if face.getlength(text) <= width:
        return text
    while text and face.getlength(text + "…") > width:
        text = text[:-1]
    return text + "…"
