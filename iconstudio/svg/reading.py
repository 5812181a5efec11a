"""Reads an icon of the user's own from an SVG document, with the credits that it carries."""

import hashlib
import logging
from pathlib import Path

from iconstudio.files import read_bytes
from iconstudio.model import IconstudioError, Pictogram
from iconstudio.svg import credits
from iconstudio.svg.decode import MAX_BYTES, decode
from iconstudio.svg.markup import markup_of
from iconstudio.svg.parse import parse

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


def own_svg(data: bytes, name: str) -> Pictogram:
    """Return an SVG document as a pictogram: ``own:`` with its name and a digest of the contents.

    Its drawing is plain and black. If its Dublin Core metadata name author and licence, they are
    credited. If they list the sources that it was made of, as those of a saved result do
    (``output.svg``), the pictogram is ``made_of`` them. Its remarks say what could not be read.

    The document is hostile: call this in a worker process with limits of time and memory.

    Parameters
    ----------
    name
        The path of its file, or what to call it.

    Raises
    ------
    IconstudioError
        If it is no SVG, shows nothing, or is not safe to draw.
    """
    # They load libraries, which the window's own process can do without.
    from iconstudio.svg.monochrome import in_black
    from iconstudio.svg.plain import plain

    try:
        markup, said = markup_of(decode(data))
        root, left_out = parse(markup)
        rdf = credits.metadata(root)
        credit, made_of = credits.credit(rdf, Path(name).name), credits.sources(rdf)
        svg, remarks = in_black(plain(root, said + left_out), rdf)
    except IconstudioError as error:
        raise IconstudioError(f"“{name}” cannot be used. {error}") from None
    except (ArithmeticError, LookupError, RecursionError, TypeError, ValueError) as error:
        # What libraries make of input that nobody thought of.
        _log.warning("Reading %r failed", name, exc_info=error)
        raise IconstudioError(
            f"“{name}” cannot be used. A part of it is not understood. Save it as plain SVG."
        ) from None
    digest = hashlib.sha256(data).hexdigest()[:8]
    return Pictogram(f"own:{Path(name).stem}-{digest}", svg, credit, made_of, remarks)
