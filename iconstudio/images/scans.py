"""A scan, a photo of a drawing or a picture of an icon becomes an icon of one's own."""

import hashlib
from collections.abc import Generator
from dataclasses import dataclass
from pathlib import Path

from iconstudio.algorithms.scanning.binarisation import Scan, ink_of, recognised
from iconstudio.algorithms.scanning.doubts import dots, writing
from iconstudio.algorithms.scanning.thickening import thickened
from iconstudio.algorithms.tracing.potrace import traced
from iconstudio.images.pillow import CUT_SHORT, DAMAGED
from iconstudio.images.reading import Image, awaited, read_image
from iconstudio.model import CANVAS, MARGIN, Credit, IconstudioError, Pictogram
from iconstudio.model import Path as Outline
from iconstudio.model.pictogram import OWN
from iconstudio.svg.credits import UNLICENSED, UNNAMED
from iconstudio.svg.lengths import written
from iconstudio.svg.mark import IN_MARKUP
from iconstudio.svg.omitted import THIN, said_of
from iconstudio.workers import Workers

_SECONDS = 30.0
_MEMORY = 1 << 30
"""Bytes that scanning or tracing may take."""
_NOT_FOUND = "No drawing can be made out on it."
_DARKER = (
    "If there is one, draw it with a darker pen or in stronger colours, or scan it with more "
    "contrast; in the window, the threshold can also be chosen by hand."
)
_FAINT = (
    "The drawing is faint, and parts of it may be missing. Draw with a darker pen, scan with more "
    "contrast, or choose the threshold in the window."
)
_FAINTER = (
    "Lines that are much fainter than the rest were left out. Draw them with a darker pen, or "
    "choose the threshold in the window."
)
_DOTS = (
    "Small parts, such as specks or small writing, were left out. If they belong to the drawing, "
    "draw them larger, or crop the picture to it."
)
_THIN = 1.5
"""Canvas units that the thickest lines must measure."""
_FAINTEST = 32
"""A threshold below which ink is hardly darker than paper: by less than a quarter."""
_PHOTO = "This looks like a photo rather than a drawing."


@dataclass(frozen=True, slots=True)
class Tracing:
    """The drawing on a scan as an icon, and its outline."""

    pictogram: Pictogram
    path: Outline
    """In pixels of the scan, to be filled with the even-odd rule."""
    width: int
    height: int


def scan(image: Image, inverted: bool | None, workers: Workers) -> Generator[None, None, Scan]:
    """Return the drawing on an image, see ``algorithms.scanning``; yield now and then.

    Raises
    ------
    IconstudioError
        If there is nothing to be seen.
    """
    future = workers.submit(_scan, image, inverted, timeout=_SECONDS, memory=_MEMORY)
    return (yield from awaited(future))


def doubts(scan: Scan) -> str:
    """Return why a scan may hold no drawing, for the user; empty if it does."""
    said = ("" if scan.found else _NOT_FOUND, _PHOTO if scan.shaded else "")
    return " ".join(filter(None, said))


def trace(
    scan: Scan, threshold: int | None, name: str, workers: Workers, remark: str = ""
) -> Generator[None, None, Tracing]:
    """Return the drawing on a scan as an icon, ``own:name-digest``; yield now and then.

    Raises
    ------
    IconstudioError
        If nothing is darker than the threshold, or none was chosen and no drawing made out.
    """
    if threshold is None and not scan.found:
        raise IconstudioError(f"{doubts(scan)} {_DARKER}")
    future = workers.submit(_trace, scan, threshold, timeout=_SECONDS, memory=_MEMORY)
    path, (height, width), thin, dotted = yield from awaited(future)
    svg = _document(path, width, height)
    digest = hashlib.sha256(svg.encode()).hexdigest()[:8]
    credit = Credit(name, UNNAMED, UNLICENSED, "", "")
    said = [remark, _PHOTO if scan.shaded else "", THIN if thin else "", _DOTS if dotted else ""]
    said += said_of(scan.omissions)
    if scan.coloured is not None and threshold in (None, scan.threshold):
        pass  # its colours were told apart, however pale
    elif threshold is None and scan.threshold < _FAINTEST:
        said.append(_FAINT)
    elif threshold is None and scan.faint and not scan.shaded:
        said.append(_FAINTER)
    remarks = tuple(filter(None, said))
    pictogram = Pictogram(f"{OWN}{Path(name).stem}-{digest}", svg, credit, remarks=remarks)
    return Tracing(pictogram, path, width, height)


def read_scan(path: Path, workers: Workers) -> Generator[None, None, Pictogram]:
    """Return the icon in a file of an image; see ``read_bitmap``."""
    return (yield from read_bitmap(path, str(path), workers))


def read_bitmap(
    source: Path | bytes, name: str, workers: Workers, said: str = ""
) -> Generator[None, None, Pictogram]:
    """Return the icon in an image, of a file or in bytes; yield now and then.

    What is ``said`` of it is the first of its remarks.

    Raises
    ------
    IconstudioError
        If it cannot be read, or no drawing can be made out.
    """
    try:
        image = yield from read_image(source, workers)
    except IconstudioError as error:
        if isinstance(source, Path):
            raise
        raise IconstudioError(f"“{name}” cannot be used. {error}") from None
    try:
        found = yield from scan(image, None, workers)
        remark = " ".join(filter(None, [said, image.remark]))
        tracing = yield from trace(found, None, Path(name).name, workers, remark)
        return tracing.pictogram
    except IconstudioError as error:
        # Nothing of it is shown.
        remark = DAMAGED if image.remark == CUT_SHORT else image.remark
        why = " ".join(filter(None, [remark, str(error)]))
        raise IconstudioError(f"“{name}” cannot be used. {why}") from None


def _scan(image: Image, inverted: bool | None) -> Scan:
    return recognised(image.was_read, inverted)


def _trace(scan: Scan, threshold: int | None) -> tuple[Outline, tuple[int, int], bool, bool]:
    """Return the outline, height and width, and whether lines were too thin, and dots too small."""
    ink = ink_of(scan, threshold)
    seen = scan.at(scan.threshold if threshold is None else threshold)
    small = seen & ~ink
    dotted = bool(dots(small).any() or writing(small).any())
    thick = thickened(ink, round(_THIN * max(ink.shape) / CANVAS))
    height, width = thick.shape
    return traced(thick), (height, width), thick is not ink, dotted


def _document(path: Outline, width: int, height: int) -> str:
    """Return the drawing on a sheet; to be restyled it fills the canvas, wherever it is there."""
    left, top, right, bottom = path.bounds
    size = max(right - left, bottom - top) * CANVAS / (CANVAS - 2 * MARGIN)
    page = written(((left + right - size) / 2, (top + bottom - size) / 2, size, size))
    return (
        f'<svg xmlns="http://www.w3.org/2000/svg" {IN_MARKUP} iconstudio:page="{page}"'
        f' width="{width}" height="{height}"'
        f' viewBox="0 0 {width} {height}" fill="currentColor">\n'
        f'<path fill-rule="evenodd" d="{path.svg()}"/>\n</svg>\n'
    )
