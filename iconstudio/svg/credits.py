"""The credits that an SVG document carries: Dublin Core and Creative Commons, in RDF."""

import copy
import xml.etree.ElementTree as ET

from iconstudio.model import Credit, Pictogram

UNNAMED = "an unnamed author"
UNLICENSED = "licence not stated"

_NAMESPACES = {
    "rdf": "http://www.w3.org/1999/02/22-rdf-syntax-ns#",
    "dc": "http://purl.org/dc/elements/1.1/",
    "cc": "http://creativecommons.org/ns#",
}
for _prefix, _address_of in _NAMESPACES.items():
    ET.register_namespace(_prefix, _address_of)
_RDF, _DC, _CC = (f"{{{address}}}" for address in _NAMESPACES.values())
_SOURCES = f"{_DC}source/{_RDF}Bag/{_RDF}li/{_CC}Work"
_LONGEST = 500
"""Most characters that are taken over of a title, a name or an address."""


def metadata(root: ET.Element) -> ET.Element | None:
    """Return a copy of the RDF of a parsed document; None if it has none."""
    return copy.deepcopy(next(root.iter(f"{_RDF}RDF"), None))


def credit(rdf: ET.Element | None, title: str) -> Credit:
    """Return what the metadata say of their work, as ``output.svg`` writes it or Inkscape does.

    ``title`` is what the work is called if they do not say.
    """
    return _credit(_work(rdf), title)


def titled(svg: str, title: str) -> str:
    """Return a plain document with metadata that say its title; as it is if it has any."""
    tag = svg.find(">", svg.find("<svg"))
    if not title or tag < 1 or svg[tag - 1] == "/" or "<metadata" in svg:
        return svg
    said = ET.tostring(_metadata(title), encoding="unicode")
    return f"{svg[: tag + 1]}<metadata>{said}</metadata>{svg[tag + 1 :]}"


def attributed(rdf: ET.Element | None, author: str, title: str) -> ET.Element | None:
    """Return metadata that name an author, if there is one and they name none.

    ``title`` is what the work is called if they hold no work.
    """
    work = _work(rdf)
    if not author or (work is not None and _said(work, f"{_DC}creator")):
        return rdf
    named = copy.deepcopy(rdf) if rdf is not None and work is not None else _metadata(title)
    found = _work(named)
    assert found is not None
    for empty in found.findall(f"{_DC}creator"):
        found.remove(empty)
    ET.SubElement(found, f"{_DC}creator").text = author
    return named


def sources(rdf: ET.Element | None) -> tuple[Pictogram, ...]:
    """Return the sources that a work lists, each once, without their drawings."""
    work = _work(rdf)
    found: dict[str, Pictogram] = {}
    for source in () if work is None else work.iterfind(_SOURCES):
        name = _said(source, f"{_DC}identifier")
        if name:
            found.setdefault(name, Pictogram(name, "", _credit(source, name)))
    return tuple(found.values())


def _metadata(title: str) -> ET.Element:
    """Return metadata that say nothing but what a work is called."""
    rdf = ET.Element(f"{_RDF}RDF")
    work = ET.SubElement(rdf, f"{_CC}Work", {f"{_RDF}about": ""})
    ET.SubElement(work, f"{_DC}title").text = "".join(filter(str.isprintable, title))
    return rdf


def _work(rdf: ET.Element | None) -> ET.Element | None:
    return None if rdf is None else rdf.find(f"{_CC}Work")


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
