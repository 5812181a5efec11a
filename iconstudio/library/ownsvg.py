"""Reads an SVG file of the user's own, with the credits that it carries."""

import hashlib
import re
import xml.etree.ElementTree as ET
from pathlib import Path

from iconstudio.library.svgcheck import MAX_BYTES, check
from iconstudio.model import Credit, IconstudioError, Pictogram

UNNAMED = "an unnamed author"
UNLICENSED = "licence not stated"

_SVG = "{http://www.w3.org/2000/svg}"
_RDF = "{http://www.w3.org/1999/02/22-rdf-syntax-ns#}"
_DC = "{http://purl.org/dc/elements/1.1/}"
_CC = "{http://creativecommons.org/ns#}"
_WORK = f"{_SVG}metadata/{_RDF}RDF/{_CC}Work"
_SOURCES = f"{_DC}source/{_RDF}Bag/{_RDF}li/{_CC}Work"

_DECLARED = re.compile(rb"""<\?xml[^>]{0,99}?encoding\s*=\s*["'](iso-8859-1|windows-1252)""", re.I)
_UTF_16 = b"\xff\xfe", b"\xfe\xff"
_GZIP = b"\x1f\x8b"
_LONGEST = 500
"""Most characters that are taken over of a title, a name or an address."""


def read_own_svg(path: Path) -> Pictogram:
    """Read an SVG file as a pictogram, ``own:`` with the file's name and a digest of its contents.

    Raises
    ------
    IconstudioError
        If the file cannot be read, is no SVG, or is refused by ``svgcheck.check``.
    """
    try:
        data = _contents(path)
    except IconstudioError as error:
        raise IconstudioError(f"“{path}” cannot be used. {error}") from None
    return own_svg(data, str(path))


def own_svg(data: bytes, name: str) -> Pictogram:
    """Return an SVG document as a pictogram; ``name`` is the path of its file, or what to call it.

    If its Dublin Core metadata name its author and licence, they are credited. If they list
    the sources that it was made of, as those of a saved result do (``output.svg``), the
    pictogram is ``made_of`` them. Whether there is anything to see shows only once it is drawn.

    Raises
    ------
    IconstudioError
        If it is no SVG, or is refused by ``svgcheck.check``.
    """
    try:
        svg = _text(data)
        check(svg)
        root = ET.fromstring(svg)  # without entities and within bounds, says the check
        if root.tag != f"{_SVG}svg":
            raise IconstudioError(
                'Its root lacks the SVG namespace. Add xmlns="http://www.w3.org/2000/svg" to it.'
            )
    except IconstudioError as error:
        raise IconstudioError(f"“{name}” cannot be used. {error}") from None
    work = root.find(_WORK)
    path = Path(name)
    return Pictogram(
        id=f"own:{path.stem}-{hashlib.sha256(data).hexdigest()[:8]}",
        svg=svg,
        credit=_credit(work, path.name),
        made_of=() if work is None else _sources(work),
    )


def _contents(path: Path) -> bytes:
    try:
        if path.is_dir():
            raise IconstudioError("It is a folder. Choose an SVG file in it.")
        if path.exists() and not path.is_file():  # reading a pipe or a device might never end
            raise IconstudioError("It is no file on a disk. Choose an SVG file.")
        with path.open("rb") as file:
            data = file.read(MAX_BYTES + 1)
    except FileNotFoundError:
        raise IconstudioError("There is no such file. Check its name and folder.") from None
    except (OSError, ValueError) as error:
        reason = getattr(error, "strerror", None) or error
        raise IconstudioError(f"It cannot be read: {reason}.") from None
    if len(data) > MAX_BYTES:
        raise IconstudioError(f"It has more than {MAX_BYTES:,} bytes. Simplify the drawing.")
    if not data.strip():
        raise IconstudioError("The file is empty. Save the drawing again.")
    return data


def _text(data: bytes) -> str:
    if data.startswith(_GZIP):
        raise IconstudioError("It is compressed (SVGZ). Save it as plain SVG.")
    declared = _DECLARED.match(data)
    encoding = "utf-8-sig"
    if data.startswith(_UTF_16):
        encoding = "utf-16"
    elif declared:
        encoding = declared[1].decode().lower()
    try:
        return data.decode(encoding)
    except UnicodeDecodeError:
        raise IconstudioError(
            "It is no SVG drawing, or not in UTF-8. Choose another file, or save it again as SVG."
        ) from None


def _sources(work: ET.Element) -> tuple[Pictogram, ...]:
    """Return the sources that a work lists, each once, without their drawings."""
    found: dict[str, Pictogram] = {}
    for source in work.iterfind(_SOURCES):
        name = _said(source, f"{_DC}identifier")
        if name:
            found.setdefault(name, Pictogram(name, "", _credit(source, name)))
    return tuple(found.values())


def _credit(work: ET.Element | None, title: str) -> Credit:
    """Return what a work says of itself, as ``output.svg`` writes it or Inkscape does."""
    if work is None:
        return Credit(title, UNNAMED, UNLICENSED, "", "")
    licence, address = _said(work, f"{_DC}rights"), _address(work, f"{_CC}license")
    return Credit(
        title=_said(work, f"{_DC}title") or title,
        author=_said(work, f"{_DC}creator") or UNNAMED,
        license=licence or address or UNLICENSED,
        license_url=address if licence else "",
        url=_address(work, f"{_DC}source"),
    )


def _said(work: ET.Element, name: str) -> str:
    """Return the text of a property on one line; empty if it has none."""
    node = work.find(name)
    return "" if node is None else " ".join("".join(node.itertext()).split())[:_LONGEST]


def _address(work: ET.Element, name: str) -> str:
    """Return the web address of a property; empty if it is none that a click may open."""
    node = work.find(name)
    address = "" if node is None else node.get(f"{_RDF}resource", "")[:_LONGEST]
    return address if address.startswith(("https://", "http://")) else ""
