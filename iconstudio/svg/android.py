"""Drawings of Android (VectorDrawable, in XML), as SVG."""

import itertools
import re
import xml.etree.ElementTree as ET

from iconstudio.model import IconstudioError

_ANDROID = "{http://schemas.android.com/apk/res/android}"
_ROOT = re.compile(r"<(?:animated-)?vector\b[^>]*\bxmlns:", re.DOTALL)
_COLOUR = re.compile(r"#([0-9a-fA-F]{3,8})")
_PATHS = {
    "pathData": "d",
    "strokeWidth": "stroke-width",
    "strokeLineCap": "stroke-linecap",
    "strokeLineJoin": "stroke-linejoin",
    "strokeMiterLimit": "stroke-miterlimit",
    "fillAlpha": "fill-opacity",
    "strokeAlpha": "stroke-opacity",
}
_GRADIENTS = {
    "linear": (
        "linearGradient",
        {"x1": "startX", "y1": "startY", "x2": "endX", "y2": "endY"},
    ),
    "radial": ("radialGradient", {"cx": "centerX", "cy": "centerY", "r": "gradientRadius"}),
}
_SPREAD = {"repeat": "repeat", "mirror": "reflect"}
_LONGEST = 60
_numbers = itertools.count()
LOOKED_UP = "Colours that the app looks up elsewhere were drawn in black."
SWEEP = "Gradients that turn around a point (sweep) were drawn in their first colour."
TRIMMED = "Paths that are drawn in part only (trimPath) were drawn whole."
UNTINTED = "A tint that is mixed with the drawing's colours ({}) was left out."


def is_vector(text: str) -> bool:
    """Whether a text is a VectorDrawable."""
    return _ROOT.search(text) is not None and _ANDROID[1:-1] in text


def as_svg(text: str) -> tuple[str, list[str]]:
    """Return a VectorDrawable as an SVG document, and what could not be read, in sentences.

    Raises
    ------
    IconstudioError
        If it is not well-formed, or its drawing lies in another file.
    """
    if "<!DOCTYPE" in text:
        raise IconstudioError("It is a drawing of Android with a DOCTYPE. Remove that.")
    try:
        vector = next(ET.fromstring(text).iter("vector"), None)
    except ET.ParseError as error:
        raise IconstudioError(
            f"It is a drawing of Android, and not well-formed XML: {error}. Save it again."
        ) from None
    if vector is None:
        raise IconstudioError(
            "It is an animation of Android whose drawing lies in another file. Open that."
        )
    remarks = _without_references(vector)
    box = f"0 0 {_said(vector, 'viewportWidth', '24')} {_said(vector, 'viewportHeight', '24')}"
    root = ET.Element("svg", xmlns="http://www.w3.org/2000/svg", viewBox=box)
    root.set("opacity", _said(vector, "alpha", "1"))
    _convert(vector, root, remarks)
    remarks += _tint(vector, root)
    return ET.tostring(root, encoding="unicode"), remarks


def _without_references(vector: ET.Element) -> list[str]:
    """Take out what says where else in the app a value lies; colours may be looked up later."""
    remarks = []
    for element in vector.iter():
        for name, value in list(element.items()):
            known = name.lower().endswith(("color", "tint")) or not name.startswith(_ANDROID)
            if value[:1] in ("@", "?") and not known:
                del element.attrib[name]
                said = f"{name.removeprefix(_ANDROID)}: {value[:_LONGEST]}"
                remarks.append(f"“{said}” lies elsewhere in the app, and was left out.")
    return remarks


def _tint(vector: ET.Element, root: ET.Element) -> list[str]:
    """Give a drawing the colour of its tint, which keeps but its opacity."""
    said = vector.get(f"{_ANDROID}tint")
    mode = _said(vector, "tintMode", "src_in")
    if said is None:
        return []
    if mode not in ("src_in", "src_atop", "multiply"):
        return [UNTINTED.format(mode)]
    tint = _colour(said, [])  # one that is looked up elsewhere is ink, whatever its colour
    for element in root.iter():
        for name in ("fill", "stroke", "stop-color"):
            if element.get(name, "").startswith("#"):
                element.set(name, _tinted(element.attrib[name], tint, mode == "multiply"))
    return []


def _tinted(colour: str, tint: str, multiplied: bool) -> str:
    """Return ``#rrggbbaa``: a tint as opaque as a colour, or times it."""
    one, other = (
        [int(f"{code[1:]}ff"[at : at + 2], 16) for at in (0, 2, 4, 6)] for code in (colour, tint)
    )
    mixed = [a * b // 255 if multiplied else b for a, b in zip(one[:3], other[:3], strict=True)]
    return "#" + "".join(f"{level:02x}" for level in (*mixed, one[3] * other[3] // 255))


def _said(element: ET.Element, name: str, default: str) -> str:
    return element.get(_ANDROID + name, default)


def _convert(vector: ET.Element, parent: ET.Element, remarks: list[str]) -> None:
    """Add what is below an element of Android's to one of SVG's."""
    for child in vector:
        if child.tag == "group":
            _convert(child, ET.SubElement(parent, "g", transform=_placed(child)), remarks)
        elif child.tag == "clip-path":  # which clips all that follows it in its group
            clip = ET.SubElement(parent, "clipPath", id=f"clip-{next(_numbers)}")
            ET.SubElement(clip, "path", d=_said(child, "pathData", ""))
            parent = ET.SubElement(parent, "g", {"clip-path": f"url(#{clip.get('id')})"})
        elif child.tag == "path":
            _path(child, parent, remarks)


def _placed(group: ET.Element) -> str:
    """Return the transform of a group: scaled, then turned about its pivot, then moved."""

    def at(name: str, default: str = "0") -> float:
        return float(_said(group, name, default))

    x, y = at("pivotX"), at("pivotY")
    return (
        f"translate({at('translateX') + x} {at('translateY') + y}) rotate({at('rotation')}) "
        f"scale({at('scaleX', '1')} {at('scaleY', '1')}) translate({-x} {-y})"
    )


def _path(path: ET.Element, parent: ET.Element, remarks: list[str]) -> None:
    """Add a path, and the gradients that it is painted with."""
    given = {
        svg: path.attrib[_ANDROID + name]
        for name, svg in _PATHS.items()
        if _ANDROID + name in path.attrib
    }
    for name in ("fill", "stroke"):
        given[name] = _paint(path, f"{name}Color", parent, remarks)
    if _said(path, "fillType", "").lower() == "evenodd":
        given["fill-rule"] = "evenodd"
    if any(name.startswith(f"{_ANDROID}trimPath") for name in path.attrib):
        remarks.append(TRIMMED)
    ET.SubElement(parent, "path", given)


def _paint(path: ET.Element, name: str, parent: ET.Element, remarks: list[str]) -> str:
    """Return a colour, or the reference to a gradient, which is added."""
    value = path.get(_ANDROID + name)
    if value is not None:
        return _colour(value, remarks)
    # What is no plain value stands in an element of its own: <aapt:attr name="android:fillColor">
    inner = next((one for one in path if one.get("name", "").endswith(f":{name}")), None)
    if inner is None:
        return "none"
    gradient = inner.find("gradient")
    if gradient is None:
        remarks.append(LOOKED_UP)
        return "#000000"
    stops = _stops(gradient, remarks)
    kind = _said(gradient, "type", "linear")
    if kind not in _GRADIENTS:
        remarks.append(SWEEP)
        return stops[0][1] if stops else "none"
    tag, places = _GRADIENTS[kind]
    given = {svg: _said(gradient, place, "0") for svg, place in places.items()}
    given["spreadMethod"] = _SPREAD.get(_said(gradient, "tileMode", ""), "pad")
    number = f"gradient-{next(_numbers)}"
    found = ET.SubElement(parent, tag, given | {"id": number, "gradientUnits": "userSpaceOnUse"})
    for offset, colour in stops:
        ET.SubElement(found, "stop", {"offset": offset, "stop-color": colour})
    return f"url(#{number})"


def _stops(gradient: ET.Element, remarks: list[str]) -> list[tuple[str, str]]:
    """Return the offsets and colours of a gradient."""
    said = [(_said(one, "offset", "0"), one.get(f"{_ANDROID}color")) for one in gradient]
    if not said:
        ends = (("0", "start"), ("0.5", "center"), ("1", "end"))
        said = [(offset, gradient.get(f"{_ANDROID}{end}Color")) for offset, end in ends]
    return [(offset, _colour(value, remarks)) for offset, value in said if value is not None]


def _colour(value: str, remarks: list[str]) -> str:
    """Return a colour, which Android writes with its alpha in front."""
    match = _COLOUR.fullmatch(value.strip())
    if match is None or len(match[1]) in (5, 7):
        if not value.startswith("@android:color/black"):
            remarks.append(LOOKED_UP)
        return "#00000000" if value == "@android:color/transparent" else "#000000"
    digits = match[1]
    if len(digits) in (3, 4):
        digits = "".join(2 * one for one in digits)
    return f"#{digits[2:]}{digits[:2]}" if len(digits) == 8 else f"#{digits}"
