"""Files from outside, read in a process of their own, with limits of time and memory."""

import os
from collections.abc import Generator
from pathlib import Path
from typing import TypeVar

from iconstudio.algorithms.scanning.binarisation import Scan
from iconstudio.files import is_address
from iconstudio.images import scans
from iconstudio.images.photo import photo_from, photo_of
from iconstudio.images.reading import Image, awaited, is_image_file, read_image
from iconstudio.model import BitmapError, IconstudioError, Pictogram, Separation
from iconstudio.svg.reading import file_and_symbol, own_artwork, own_svg, read_file
from iconstudio.workers import Workers, answer
from iconstudio.workflows.events import Event, staged
from iconstudio.workflows.registry import taking_icons

SECONDS, MEMORY = 20.0, 1 << 30
"""How many seconds of a processor reading a file may take, and how many bytes."""
SIMPLER = "Simplify the drawing, or save it as a PNG and open that."
"""What to do about a drawing that reaches the limits."""
_SHOWN = 200
"""Most characters of a reference that a message repeats."""

T = TypeVar("T")


class FileReader:
    """Reads icons and images from files, or from bytes that are in none."""

    def __init__(self) -> None:
        self._readers = Workers(1)  # files need not wait for cuts, nor for their compiling

    def icon_in(self, reference: str) -> Pictogram | None:
        """Return the icon in a file: an SVG, ``FILE.svg#id``, a scan; None if it names no file.

        Raises
        ------
        IconstudioError
            If the file is no good, or it is an address.
        """
        if is_address(reference):
            raise IconstudioError(
                f"“{reference[:_SHOWN]}” is an address, and nothing is downloaded. "
                "Save the drawing as a file, and give its path."
            )
        if is_image_file(Path(reference)):
            return returned(scans.read_scan(Path(reference), self._readers))
        if not is_path(reference):
            return None
        path, symbol = file_and_symbol(reference)
        return self.icon_from(read_file(Path(path)), path, symbol)

    def icon_from(self, data: bytes, name: str, symbol: str | None = None) -> Pictogram:
        """Return an icon of SVG markup that is in no file, but pasted, say; ``name`` it.

        Raises
        ------
        IconstudioError
            If it is no good.
        """
        task = own_svg, data, name, symbol
        reading = self._readers.submit(*task, timeout=SECONDS, memory=MEMORY)
        try:
            return answer(reading, f"Reading “{name}”", SIMPLER)
        except BitmapError as error:
            bitmap = scans.read_bitmap(error.bitmap, name, self._readers, error.remark)
            return returned(bitmap)

    def image(self, source: Path | bytes) -> Generator[None, None, Image]:
        """Return the image in a file, or in bytes; yield now and then, where it can be closed.

        Raises
        ------
        IconstudioError
            If it cannot be read, or is none.
        """
        elsewhere = f"To use it as an icon, open it in {taking_icons()}."
        return (yield from read_image(source, self._readers, elsewhere))

    def artwork(self, path: Path) -> Generator[Event, None, Separation]:
        """Return the image in a file, or an SVG drawing in its colours, with its credits.

        Of a sprite sheet, ``FILE.svg#id`` is one symbol.

        Raises
        ------
        IconstudioError
            If it cannot be read, or shows nothing.
        """
        if is_image_file(path):
            image = yield from staged("prepare", "Reading the image", _started(self.image(path)))
            return Separation(photo_from(path, image))
        name, symbol = file_and_symbol(str(path))
        task = own_artwork, read_file(Path(name)), name, symbol
        reading = self._readers.submit(*task, timeout=SECONDS, memory=MEMORY)
        waiting = _started(awaited(reading, f"Reading “{name}”", SIMPLER))
        try:
            pixels, pictogram = yield from staged("prepare", "Reading the drawing", waiting)
        except BitmapError as error:
            steps = _started(self.image(error.bitmap))
            image = yield from staged("prepare", "Reading the image", steps)
            return Separation(photo_of(image, str(path)))
        image = Image(pixels, pixels.shape[1], pixels.shape[0])
        return Separation(photo_of(image, str(path)), credits=(pictogram,))

    def scan(self, image: Image, inverted: bool | None = None) -> Generator[None, None, Scan]:
        """Return the drawing on an image; see ``images.scans.scan``."""
        return (yield from scans.scan(image, inverted, self._readers))

    def trace(
        self, scan: Scan, threshold: int | None, name: str, remark: str = ""
    ) -> Generator[None, None, scans.Tracing]:
        """Return the drawing on a scan as an icon; see ``images.scans.trace``."""
        return (yield from scans.trace(scan, threshold, name, self._readers, remark))


def is_path(reference: str) -> bool:
    """Whether a reference names a file, which need not be there."""
    named = reference.startswith(("/", ".", "~")) or "\\" in reference or Path(reference).suffix
    return bool(named) or os.path.isfile(file_and_symbol(reference)[0])


def _started(steps: Generator[None, None, T]) -> Generator[float, None, T]:
    """Yield 0 for each step: how many there are is not known."""
    try:
        while True:
            next(steps)
            yield 0.0
    except StopIteration as end:
        value: T = end.value
        return value


def returned(steps: Generator[object, None, T]) -> T:
    """Return what a generator returns, whatever it yields."""
    try:
        while True:
            next(steps)
    except StopIteration as end:
        value: T = end.value
        return value
