"""Drawings that ``image`` elements hold, as ``data:`` addresses: drawn as parts of their own."""

import re
import xml.etree.ElementTree as ET

from iconstudio.model import IconstudioError
from iconstudio.svg.animation import finish
from iconstudio.svg.decode import decode
from iconstudio.svg.markup import markup_of
from iconstudio.svg.parse import parse
from iconstudio.svg.styles import INITIAL, apply_styles

_ADDRESS = re.compile(r"\s*data:(?:image/svg(?:\+xml)?|(?:text|application)/xml)\b", re.IGNORECASE)
_URL = re.compile(r"url\(\s*[\"']?#")
_DEEPEST = 3
_MOST = 50
_OF_IMAGES = ("x", "y", "width", "height", "preserveAspectRatio")


def embed(root: ET.Element, depth: int = 0) -> list[str]:
    """Put the drawings that images hold in their places, once styles are attributes.

    Returns
    -------
    Sentences about what could not be read of them.
    """
    remarks: list[str] = []
    images = [one for one in root.iter("image") if _ADDRESS.match(one.get("href", ""))]
    for number, image in enumerate(images[:_MOST] if depth < _DEEPEST else ()):
        try:
            markup, said = markup_of(decode(image.attrib["href"].encode()))
            inner, left_out = parse(markup)
        except IconstudioError as error:
            remarks.append(f"A drawing that is embedded in it was left out. {error}")
            image.tag = "g"
            continue
        remarks += [*said, *left_out, *finish(inner), *apply_styles(inner)]
        remarks += embed(inner, depth + 1)
        _rename(inner, f"{depth}-{number}-")
        _replace(image, inner)
    return remarks


def _rename(inner: ET.Element, prefix: str) -> None:
    """Let the ids of a drawing be no other's."""
    for element in inner.iter():
        for name, value in element.items():
            if name == "id":
                element.set(name, prefix + value)
            elif name == "href" and value.startswith("#"):
                element.set(name, f"#{prefix}{value[1:]}")
            elif "url(" in value:
                element.set(name, _URL.sub(f"url(#{prefix}", value))


def _replace(image: ET.Element, inner: ET.Element) -> None:
    """Turn an image into a group that holds a drawing, which inherits nothing."""
    frame = {name: image.attrib.pop(name) for name in _OF_IMAGES if name in image.attrib}
    size = {name: inner.attrib.pop(name, None) for name in ("width", "height")}
    if "viewBox" not in inner.attrib and size["width"] and size["height"]:
        inner.set("viewBox", f"0 0 {size['width']} {size['height']}")
    for name, value in size.items():
        if frame.get(name, "auto") == "auto" and value:
            frame[name] = value
    for name in ("x", "y", "preserveAspectRatio"):
        inner.attrib.pop(name, None)
    inner.attrib.update(frame)
    for name, value in INITIAL.items():
        inner.attrib.setdefault(name, value)
    del image.attrib["href"]
    image.tag = "g"
    image[:] = [inner]
