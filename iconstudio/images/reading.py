"""Pictures made of pixels from outside: photos to trace over, drawings to make icons of."""

import re
import zlib
from collections.abc import Generator
from concurrent.futures import Future, wait
from dataclasses import dataclass
from pathlib import Path
from typing import TypeVar

import numpy as np
from numpy.typing import NDArray

from iconstudio.files import read_bytes
from iconstudio.images.pillow import CUT_SHORT, decode, is_image
from iconstudio.images.truncated import what_was_read
from iconstudio.model import IconstudioError
from iconstudio.workers import Workers, answer

T = TypeVar("T")

LONGEST = 4096
"""An image is kept with at most this many pixels on its longer side."""
MAX_BYTES = 1 << 29
"""Most bytes of a file."""
SUFFIXES = (
    *("png", "jpg", "jpeg", "jfif", "webp", "avif", "heic", "heif", "tif", "tiff", "gif", "bmp"),
    *("jp2", "j2k", "jpx", "tga", "pbm", "pgm", "ppm", "pnm", "qoi", "ico", "icns", "psd", "pcx"),
)
"""How names of files of images usually end."""

CURE = "Scale it down, or save it in another format."
"""What to do about an image that reaches the limits."""
_SECONDS = 60.0
_MEMORY = 1 << 31
"""Bytes that decoding may take: enough for the largest image."""
_PATIENCE = 0.1
_START = 64
_HEAD = 1 << 16
"""In so many bytes the root of an SVG file begins."""

_MARKUP = re.compile(rb"(?:\xef\xbb\xbf|\xff\xfe|\xfe\xff)?[\s\0]*<|\x1f\x8b")
"""How text with tags begins, or what is compressed."""
_SVG = re.compile(rb"<(?:[\w.-]+:)?svg[\s/>]")


@dataclass(frozen=True, slots=True, eq=False)
class Image:
    """An image, upright and in sRGB."""

    pixels: NDArray[np.uint8]
    """(height, width, 3), or (height, width, 4) if some of it is transparent; C-contiguous."""
    width: int
    """Of the original, in pixels; ``pixels`` may be fewer."""
    height: int
    remark: str = ""
    """A sentence about what could not be read, or is not shown."""

    @property
    def was_read(self) -> NDArray[np.uint8]:
        """``pixels`` without the rows that a file lacks that is cut short."""
        return what_was_read(self.pixels) if self.remark == CUT_SHORT else self.pixels


def is_image_file(path: Path) -> bool:
    """Whether a file begins as that of an image does; false if it cannot be read.

    Or is called one, and is no markup: it is damaged then.
    """
    try:
        if not path.is_file():
            return False
        with path.open("rb") as file:
            start = file.read(_START)
    except (OSError, ValueError):
        return False
    called = path.suffix.lower().lstrip(".") in SUFFIXES
    return is_image(start, path.name) or (called and not _MARKUP.match(start))


def read_image(
    source: Path | bytes, workers: Workers, elsewhere: str = "Save it as PNG."
) -> Generator[None, None, Image]:
    """Return the image in a file, or in bytes; yield now and then while it is decoded.

    ``elsewhere`` says what can be done with a drawing that is none.

    Raises
    ------
    IconstudioError
        If it cannot be read, or is none.
    """
    name = f"“{source.name}”" if isinstance(source, Path) else "The image"
    try:
        data = read_bytes(source, MAX_BYTES) if isinstance(source, Path) else source
        if not data.strip():
            raise IconstudioError("It is empty. Save or copy it again.")
        if _is_svg(data):
            raise IconstudioError(f"It is an SVG drawing, not a photo. {elsewhere}")
        future = workers.submit(decode_image, data, timeout=_SECONDS, memory=_MEMORY)
        return (yield from awaited(future))
    except IconstudioError as error:
        raise IconstudioError(f"{name} cannot be opened. {error}") from None


def decode_image(data: bytes) -> Image:
    """Decode an image; runs in a worker process."""
    pixels, (width, height), remark = decode(data, LONGEST)
    return Image(pixels, width, height, remark)


def awaited(
    future: "Future[T]",
    doing: str = "Reading it",
    cure: str = CURE,
) -> Generator[None, None, T]:
    """Return what a worker process makes of an image; yield now and then until it is there.

    Closing the generator ends the work. What it was ``doing``, and a ``cure``, are said if it
    reaches its limits.

    Raises
    ------
    IconstudioError
        If it raised one, or took more time or memory than there is.
    """
    try:
        while not wait([future], _PATIENCE).done:
            yield
        return answer(future, doing, cure)
    finally:
        future.cancel()


def _is_svg(data: bytes) -> bool:
    """Whether data begin as an SVG file does, be it compressed or in UTF-16."""
    start = data[:_HEAD]
    if start.startswith(b"\x1f\x8b"):
        try:
            start = zlib.decompressobj(31).decompress(start, _HEAD)
        except zlib.error:
            return False
    start = start.replace(b"\0", b"").lstrip(b"\xef\xbb\xbf\xff\xfe \t\r\n")
    return start.startswith(b"<") and _SVG.search(start) is not None
