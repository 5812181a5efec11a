"""The mark of a drawing that was made plain and black here, so that it is read back as it is.

How a coloured drawing becomes black is decided once: read as a new one, what came of it might lose
another tile. The mark is an attribute of the root. Other programs leave it there while they edit
the drawing, and anyone can write it: it says nothing of what is safe, nor of the colours.
"""

import re
import xml.etree.ElementTree as ET

NAMESPACE = "urn:iconstudio"
ATTRIBUTE = f"{{{NAMESPACE}}}pictogram"
IN_MARKUP = f'xmlns:iconstudio="{NAMESPACE}" iconstudio:pictogram="yes"'
"""The mark as the attributes of a root in a document."""
PAGE = f"{{{NAMESPACE}}}page"
"""An attribute of the root: its page, ``x y w h``, if the document shows a part of that."""
ET.register_namespace("iconstudio", NAMESPACE)

_PLAIN = re.compile(r"#000000|#ffffff|none|inherit|currentcolor", re.IGNORECASE)
_PAINTS = ("fill", "stroke", "color", "stop-color")
_OPACITIES = ("opacity", "fill-opacity", "stroke-opacity", "stop-opacity")
_OPAQUE = ("0", "1", "inherit")
_EFFECTS = ("filter", "style")


def in_black_and_white(element: ET.Element) -> bool:
    """Whether all of a plain drawing is painted black or white, opaque, and without effects."""
    if element.tag == "mask":
        return True  # whose colours say how much shows
    paints = (element.get(name, "none") for name in _PAINTS)
    return (
        all(one.startswith("url(") or _PLAIN.fullmatch(one) for one in paints)
        and all(element.get(name, "1") in _OPAQUE for name in _OPACITIES)
        and not any(name in element.attrib for name in _EFFECTS)
        and element.tag not in ("text", "pattern")
        and all(map(in_black_and_white, element))
    )
