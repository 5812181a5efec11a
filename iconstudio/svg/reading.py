"""Reads an icon of the user's own from an SVG document, with the credits that it carries."""

import hashlib
import logging
import os
import re
import xml.etree.ElementTree as ET
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from iconstudio.files import read_bytes
from iconstudio.model import BitmapError, Credit, IconstudioError, Pictogram, SpriteError
from iconstudio.model.pictogram import OWN
from iconstudio.svg import credits
from iconstudio.svg.animation import moves
from iconstudio.svg.decode import MAX_BYTES, decode
from iconstudio.svg.markup import markup_of
from iconstudio.svg.parse import parse

UNSTYLED = (
    "How it is painted lies elsewhere, and was not read; its outlines were drawn as lines. "
    "Save the drawing with its styles embedded."
)
_STYLED = re.compile(r"\bclass(?:Name|List)?\s*=|\bstyled\b|\bcss\s*=|\bsx\s*=|:class\s*=")
"""What refers to styles elsewhere."""
_STROKED = re.compile(r"\bstroke(?:-?[wW]idth)?\s*[=:]|<style\b", re.IGNORECASE)
_UNFORESEEN = (ArithmeticError, LookupError, RecursionError, TypeError, ValueError)
"""What libraries make of input that nobody thought of."""
_log = logging.getLogger(__name__)


def read_file(path: Path) -> bytes:
    """Return what is in the file of a drawing.

    Raises
    ------
    IconstudioError
        If it cannot be read, or is too large.
    """
    try:
        return read_bytes(path, MAX_BYTES)
    except IconstudioError as error:
        raise IconstudioError(f"“{path}” cannot be used. {error}") from None


def file_and_symbol(reference: str) -> tuple[str, str | None]:
    """Split ``FILE.svg#id`` into the path of a file that is there and the id of a symbol in it."""
    end = len(reference)
    while not os.path.exists(reference[:end]) and "#" in reference[:end]:
        end = reference.rindex("#", 0, end)
    if end == len(reference) or not os.path.isfile(reference[:end]):
        return reference, None
    return reference[:end], reference[end + 1 :]


def own_svg(data: bytes, name: str, symbol: str | None = None) -> Pictogram:
    """Return an SVG document as a pictogram: ``own:`` with its name and a digest of the contents.

    Its drawing is plain and black. If its Dublin Core metadata name author and licence, they are
    credited. If they list the sources that it was made of, as those of a saved result do
    (``output.svg``), the pictogram is ``made_of`` them. Its remarks say what could not be read.

    The document is hostile: call this in a worker process with limits of time and memory.

    Parameters
    ----------
    name
        The path of its file, or what to call it.
    symbol
        The id of what is wanted of it, if that is not all.

    Raises
    ------
    SpriteError
        If it is a sprite sheet, and ``symbol`` does not say what of it is wanted.
    BitmapError
        If all that it shows is a bitmap.
    IconstudioError
        If it is no SVG, shows nothing, or is not safe to draw.
    """
    with told(data, name, symbol):
        svg, credit, made_of, remarks = _read(data, Path(name).name, symbol)
    return Pictogram(identifier(data, name, symbol)[0], svg, credit, made_of, remarks)


def own_artwork(
    data: bytes, name: str, symbol: str | None = None
) -> tuple[NDArray[np.uint8], Pictogram]:
    """Return an SVG document in its colours (h, w, 4), and whom to thank, without a drawing.

    As with ``own_svg``, its remarks say what could not be read, and the document is hostile.

    Raises
    ------
    SpriteError
        If it is a sprite sheet, and ``symbol`` does not say what of it is wanted.
    BitmapError
        If all that it shows is a bitmap.
    IconstudioError
        If it is no SVG, shows nothing on its canvas, or is not safe to draw.
    """
    from iconstudio.svg.artwork import artwork

    with told(data, name, symbol):
        pixels, rdf, remarks = artwork(data, symbol)
    called, title = identifier(data, name, symbol)
    credit, made_of = credits.credit(rdf, title), credits.sources(rdf)
    return pixels, Pictogram(called, "", credit, made_of, tuple(remarks))


def identifier(data: bytes, name: str, symbol: str | None = None) -> tuple[str, str]:
    """Return the identifier of a drawing of the user's own, and its title if it has none."""
    digest = hashlib.sha256(data).hexdigest()[:8]
    called = "-".join(filter(None, (Path(name).stem, symbol, digest)))
    title = Path(name).name
    return f"{OWN}{called}", title if symbol is None else f"{title}#{symbol}"


@contextmanager
def told(data: bytes, name: str, symbol: str | None = None) -> Iterator[None]:
    """Say of which drawing it is that it cannot be used, and which part of it, within.

    Raises
    ------
    SpriteError, BitmapError, IconstudioError
        With whatever is raised there.
    """
    try:
        yield
    except SpriteError as error:
        raise SpriteError(
            f"“{name}” cannot be used. {error.what}",
            error.names,
            f"To use one, write its name behind the file's: “{Path(name).name}#{error.names[0]}”.",
        ) from None
    except BitmapError as error:
        raise BitmapError(f"“{name}” cannot be used. {error}", error.bitmap, error.remark) from None
    except IconstudioError as error:
        raise IconstudioError(f"“{name}” cannot be used. {error}") from None
    except _UNFORESEEN as error:
        _log.warning("Reading %r failed", name, exc_info=error)
        part = _part_not_understood(data, symbol)
        raise IconstudioError(
            f"“{name}” cannot be used. {part} is not understood. Leave it out, or save the drawing "
            "as plain SVG."
        ) from None


def _part_not_understood(data: bytes, symbol: str | None) -> str:
    """Return which part of a document cannot be read, as the beginning of a sentence."""
    from iconstudio.svg.culprit import culprit
    from iconstudio.svg.monochrome import in_black
    from iconstudio.svg.plain import plain

    try:
        root, _ = parse(markup_of(decode(data))[0])
    except _UNFORESEEN:
        return "The code around the drawing"

    def is_readable(part: ET.Element) -> bool:
        try:
            in_black(plain(part, (), symbol), credits.metadata(part))
        except _UNFORESEEN:
            return False
        except IconstudioError:  # what is left may show nothing
            pass
        return True

    found = culprit(root, is_readable)
    return f"The part {found} of it" if found else "More than one part of it"


def _read(
    data: bytes, title: str, symbol: str | None
) -> tuple[str, Credit, tuple[Pictogram, ...], tuple[str, ...]]:
    """Return a drawing in black, whose it is, what it is made of, and what to say of it."""
    # They load libraries, which the window's own process can do without.
    from iconstudio.svg.monochrome import EmptyError, in_black
    from iconstudio.svg.omitted import THIN
    from iconstudio.svg.pictured import bitmap_error
    from iconstudio.svg.plain import plain

    text = decode(data)
    markup, unread = markup_of(text)
    root, left_out = parse(markup)
    said = [*unread, *left_out]
    rdf = credits.metadata(root)
    title = title if symbol is None else f"{title}#{symbol}"
    drawing = plain(root, said, symbol)
    rdf = credits.attributed(rdf, drawing.author, title)
    try:
        svg, remarks = in_black(drawing, rdf)
    except EmptyError as error:
        if shown := bitmap_error(str(error), drawing, parse(markup)[0], symbol):
            raise shown from None
        if not moves(markup):
            raise
        svg, remarks = in_black(plain(parse(markup)[0], said, symbol, midway=True), rdf)
    if THIN in remarks and _STYLED.search(text) and not _STROKED.search(markup):
        remarks = tuple(UNSTYLED if one == THIN else one for one in remarks)
    return svg, credits.credit(rdf, title), credits.sources(rdf), remarks
