"""The elements of an SVG document: parsed as leniently as browsers and Inkscape do, within bounds.

Only SVG's own elements and attributes are kept, by their local names. What other programs keep for
themselves in a file (private data, editor's settings, comments) never gets further.
"""

import re
import xml.etree.ElementTree as ET
from html.entities import html5
from xml.parsers import expat

from iconstudio.model import IconstudioError
from iconstudio.svg.check import MAX_DEPTH as MAX_DRAWN
from iconstudio.svg.entities import OF_XML, written_out
from iconstudio.svg.lenient import parse_leniently
from iconstudio.svg.mark import ATTRIBUTE
from iconstudio.svg.names import attribute_name, tag_name

MAX_CHARACTERS = 2_000_000
"""Of attributes and text that are kept."""
MAX_ELEMENTS = 20_000
MAX_DEPTH = 250
"""Of all elements, before it is known which are drawn: of those there is ``check.MAX_DEPTH``."""

SVG = "http://www.w3.org/2000/svg"
_XLINK = "http://www.w3.org/1999/xlink"
_RDF = "http://www.w3.org/1999/02/22-rdf-syntax-ns#"
_ENTITY = re.compile(r"&([A-Za-z_]\w*);")
_AMPERSAND = re.compile(r"&(?!#?\w+;)")
_VERBATIM = re.compile(r"(<!\[CDATA\[.*?\]\]>|<!DOCTYPE[^>\[]*\[.*?\]\s*>)", re.DOTALL)
SHEET_ELSEWHERE = (
    "A style sheet outside of the file was not read. If colours are wrong, save the "
    "drawing with its styles embedded."
)
_ANDROID_LAYERS = "It only names its layers: open the drawings that it names instead."
_XAML = "It may be XAML: save the drawing as SVG in the program that made it."
_OTHERS = {
    **dict.fromkeys(
        ("adaptive-icon", "layer-list", "selector", "animated-vector"), _ANDROID_LAYERS
    ),
    **dict.fromkeys(("Viewbox", "Canvas", "DrawingImage", "ResourceDictionary", "Page"), _XAML),
}
"""What to do with files of other kinds, by their root."""
_NAME = re.compile(r"[A-Za-z_][\w.-]*", re.ASCII)
_CONTROL = re.compile("[\0-\x08\x0b\x0c\x0e-\x1f\ufffe\uffff\ud800-\udfff]")


def parse(text: str) -> tuple[ET.Element, list[str]]:
    """Return the root ``svg`` of a document, and what could not be read, in sentences.

    Tags and attributes are SVG's, by local name. ``href`` is also what XLink calls so. The
    metadata's ``RDF`` is kept as a child with its namespaces, as ElementTree writes them; all other
    foreign elements are gone. What is not well-formed is read as browsers read pages.

    Raises
    ------
    IconstudioError
        If the document has external entities, or too many, is no SVG, or is too large.
    """
    if _CONTROL.search(text):
        raise IconstudioError("It holds characters that are no text: the file is damaged.")
    text = _without_html_entities(written_out(text))
    builder = _Builder()
    try:
        _parse_strictly(text, builder)
    except expat.ExpatError as error:
        mistake = f"It is not well-formed XML: {_reason(error)}. Save it again."
        builder = _Builder()
        parse_leniently(text, builder)
        if builder.root is None:
            raise IconstudioError(mistake) from None
    if builder.root is None:
        raise IconstudioError("The file is empty. Save the drawing again.")
    return builder.root, builder.remarks


def _parse_strictly(text: str, builder: "_Builder") -> None:
    parser = expat.ParserCreate("utf-8")
    parser.buffer_text = True
    parser.StartElementHandler = builder.start
    parser.EndElementHandler = builder.end
    parser.CharacterDataHandler = builder.characters
    parser.ProcessingInstructionHandler = builder.instruction
    parser.Parse(text.encode(), True)


def _reason(error: expat.ExpatError) -> str:
    reason = expat.errors.messages.get(error.code, error)
    return f"{reason} in line {error.lineno}, column {error.offset + 1}"


def _without_html_entities(text: str) -> str:
    """Replace HTML's names of characters, which pages' drawings use, and write other & rightly."""
    if "&" not in text:
        return text

    def replaced(match: re.Match[str]) -> str:
        return match[0] if match[1] in OF_XML else html5.get(f"{match[1]};", f"&amp;{match[1]};")

    parts = _VERBATIM.split(text)
    parts[::2] = [_ENTITY.sub(replaced, _AMPERSAND.sub("&amp;", part)) for part in parts[::2]]
    return "".join(parts)


class _Builder:
    """Builds the tree while expat reads."""

    def __init__(self) -> None:
        self.root: ET.Element | None = None
        self.remarks: list[str] = []
        self._open: list[ET.Element] = []
        self._namespaces: list[dict[str, str]] = [{}]
        self._skipping = 0
        """Elements that are open and not kept."""
        self._foreign = False
        """Whether the elements that are open are those of metadata."""
        self._elements = self._characters = 0
        self._svg = SVG

    def instruction(self, target: str, data: str) -> None:
        """Say that a style sheet lies elsewhere."""
        if target == "xml-stylesheet" and 'alternate="yes"' not in data:
            self._elsewhere()

    def _elsewhere(self) -> None:
        if SHEET_ELSEWHERE not in self.remarks:
            self.remarks.append(SHEET_ELSEWHERE)

    def start(self, name: str, attributes: dict[str, str]) -> None:
        """Open an element."""
        spaces = self._spaces(attributes)
        self._namespaces.append(spaces)
        space, local = self._resolved(name, spaces)
        if len(self._namespaces) > MAX_DEPTH + 1:
            raise IconstudioError(
                f"The SVG nests its elements more than {MAX_DRAWN} deep. Ungroup some of them."
            )
        if self.root is None:
            if local.lower() != "svg":
                said = f"It is not an SVG drawing: its root element is <{local}>."
                raise IconstudioError(" ".join(filter(None, [said, _OTHERS.get(local)])))
            self._svg, local = space, "svg"
        else:
            local = tag_name(local)
        if local == "link" and "stylesheet" in attributes.get("rel", "").lower():
            self._elsewhere()
            self._skipping += 1
            return
        metadata = self._foreign or (space, local) == (_RDF, "RDF")
        if self._skipping or (space != self._svg and not metadata):
            self._skipping += 1
            return
        self._foreign = metadata
        self._count(attributes)
        kept = (
            {
                _qualified(key, spaces): value
                for key, value in attributes.items()
                if not key.startswith("xmlns")
            }
            if metadata
            else self._own(attributes, spaces)
        )
        tag = f"{{{space}}}{local}" if metadata else local
        element = ET.Element(tag, kept)
        if self._open:
            self._open[-1].append(element)
        else:
            self.root = element
        self._open.append(element)

    def end(self, _name: str) -> None:
        """Close an element."""
        self._namespaces.pop()
        if self._skipping:
            self._skipping -= 1
            return
        element = self._open.pop()
        if element.tag == f"{{{_RDF}}}RDF":
            self._foreign = False

    def characters(self, text: str) -> None:
        """Add text to the element that is open."""
        if self._skipping or not self._open:
            return
        element = self._open[-1]
        if not self._foreign and element.tag not in _WITH_TEXT:
            return
        self._characters += len(text)
        self._check_characters()
        if len(element):
            element[-1].tail = (element[-1].tail or "") + text
        else:
            element.text = (element.text or "") + text

    def _spaces(self, attributes: dict[str, str]) -> dict[str, str]:
        """Return the namespaces that hold from here on, by prefix."""
        declared = {
            name[6:]: value
            for name, value in attributes.items()
            if name == "xmlns" or name.startswith("xmlns:")
        }
        return self._namespaces[-1] | declared if declared else self._namespaces[-1]

    def _resolved(self, name: str, spaces: dict[str, str]) -> tuple[str, str]:
        """Return namespace and local name; a prefix that is not declared is its own namespace."""
        prefix, colon, local = name.rpartition(":")
        if not colon:
            return spaces.get("", self._svg), local
        return spaces.get(prefix, SVG if prefix == "svg" else prefix), local

    def _own(self, attributes: dict[str, str], spaces: dict[str, str]) -> dict[str, str]:
        """Return SVG's own attributes, and the one of XLink."""
        kept: dict[str, str] = {}
        for name, value in attributes.items():
            prefix, colon, local = name.rpartition(":")
            if not colon:
                if name != "xmlns" and _NAME.fullmatch(name):
                    kept.setdefault(attribute_name(name), value)
            elif local == "href" and spaces.get(prefix, prefix) in (_XLINK, "xlink"):
                kept.setdefault("href", value)
            elif name == "xml:space":
                kept[name] = value
            elif self.root is None and _qualified(name, spaces) == ATTRIBUTE:
                kept[ATTRIBUTE] = value
        return kept

    def _count(self, attributes: dict[str, str]) -> None:
        self._elements += 1
        if self._elements > MAX_ELEMENTS:
            raise IconstudioError(f"It has more than {MAX_ELEMENTS:,} elements. Simplify it.")
        self._characters += sum(map(len, attributes.values()))
        self._check_characters()

    def _check_characters(self) -> None:
        if self._characters > MAX_CHARACTERS:
            raise IconstudioError(
                f"Its shapes take more than {MAX_CHARACTERS:,} characters. Simplify the drawing."
            )


_WITH_TEXT = ("style", "text", "tspan", "textPath", "tref", "a", "title", "desc", "foreignObject")


def _qualified(name: str, spaces: dict[str, str]) -> str:
    prefix, colon, local = name.rpartition(":")
    return f"{{{spaces.get(prefix, prefix)}}}{local}" if colon else local
