"""What the style of each element comes to (CSS Cascading, Custom Properties; SVG 2, section 6).

Rules, ``style`` attributes and variables become presentation attributes as SVG 1.1 writes them,
which every renderer reads alike.
"""

import re
import xml.etree.ElementTree as ET
from collections.abc import Sequence
from urllib.parse import quote

from iconstudio.svg import filters
from iconstudio.svg.animation import ENDED, MIDWAY, MOVING, vanishes
from iconstudio.svg.calculation import calculated
from iconstudio.svg.clipping import is_basic_shape
from iconstudio.svg.colours import colour
from iconstudio.svg.fonts import font
from iconstudio.svg.instances import own_copies
from iconstudio.svg.lengths import Box, page_of, whole_of
from iconstudio.svg.properties import not_understood
from iconstudio.svg.stylesheet import Declared, Frame, StyleSheet

_COLOURS = ("color", "stop-color", "flood-color", "lighting-color")
_PAINTS = ("fill", "stroke")
_OPACITIES = ("opacity", "fill-opacity", "stroke-opacity", "stop-opacity", "flood-opacity")
_LENGTHS = (
    "stroke-width", "stroke-dashoffset", "x", "y", "cx", "cy", "r", "rx", "ry", "width", "height",
    "font-size", "letter-spacing", "word-spacing", "baseline-shift", "stroke-miterlimit",
)  # fmt: skip
_REFERENCES = ("clip-path", "mask", "filter", "marker-start", "marker-mid", "marker-end")
_KEYWORDS = (
    "display", "visibility", "overflow", "fill-rule", "clip-rule", "stroke-linecap",
    "stroke-linejoin", "paint-order", "vector-effect", "mask-type", "text-anchor", "font-style",
    "font-variant", "font-weight", "font-stretch", "dominant-baseline", "alignment-baseline",
    "writing-mode", "direction", "text-decoration", "text-transform", "shape-rendering",
    "color-interpolation", "color-interpolation-filters", "mix-blend-mode", "isolation",
    "transform-box",
)  # fmt: skip
_OTHER = ("stroke-dasharray", "font-family", "transform", "transform-origin", "translate", "rotate",
          "scale", "d")  # fmt: skip
PROPERTIES = frozenset(
    (*_COLOURS, *_PAINTS, *_OPACITIES, *_LENGTHS, *_REFERENCES, *_KEYWORDS, *_OTHER)
)
_INHERITED = frozenset(
    (
        "color", "fill", "stroke", "fill-opacity", "stroke-opacity", "stroke-width",
        "stroke-dashoffset", "stroke-dasharray", "stroke-linecap", "stroke-linejoin",
        "stroke-miterlimit", "fill-rule", "clip-rule", "visibility", "marker-start", "marker-mid",
        "marker-end", "paint-order", "text-anchor", "font-size", "font-family", "font-style",
        "font-variant", "font-weight", "font-stretch", "letter-spacing", "word-spacing",
        "shape-rendering", "color-interpolation", "color-interpolation-filters", "writing-mode",
        "direction", "text-transform",
    )
)  # fmt: skip
INITIAL = {
    "color": "#000000", "fill": "#000000", "stroke": "none", "fill-opacity": "1",
    "stroke-opacity": "1", "stroke-width": "1", "stroke-dasharray": "none",
    "stroke-dashoffset": "0", "stroke-linecap": "butt", "stroke-linejoin": "miter",
    "stroke-miterlimit": "4", "fill-rule": "nonzero", "clip-rule": "nonzero",
    "visibility": "visible",
}  # fmt: skip
"""Initial values of properties that are inherited."""
_SHORTHANDS = {
    "marker": ("marker-start", "marker-mid", "marker-end"),
    "mask-image": ("mask",),
    "-webkit-mask": ("mask",),
    "-webkit-mask-image": ("mask",),
    "-webkit-filter": ("filter",),
    "-webkit-clip-path": ("clip-path",),
    "-webkit-transform": ("transform",),
    "-webkit-transform-origin": ("transform-origin",),
}
ONLY_IN_STYLE = ("mix-blend-mode", "isolation")
"""Properties that are no attributes."""
_BLEND_MODES = (
    "normal", "multiply", "screen", "overlay", "darken", "lighten", "color-dodge", "color-burn",
    "hard-light", "soft-light", "difference", "exclusion", "hue", "saturation", "color",
    "luminosity",
)  # fmt: skip
_DROPPED = ("style", "class")
_MOTION = ("offset-path", "offset", "motion-path")
_UNMOVED = (
    "A path of motion (offset-path) was left out: what moves along it was drawn where it stands "
    "without. Place it by a transform."
)

_NUMBER = r"[+-]?(?:\d+(?:\.\d*)?|\.\d+)(?:e[+-]?\d+)?"
_LENGTH = re.compile(rf"({_NUMBER})\s*([a-z]*|%)", re.IGNORECASE)
_UNITS = {
    "": "", "%": "%", "px": "", "pt": "pt", "pc": "pc", "mm": "mm", "cm": "cm", "in": "in",
    "em": "em", "ex": "ex",
}  # fmt: skip
_IN_PIXELS = {"rem": 16.0, "ch": 8.0, "q": 96 / 101.6}
_URL = re.compile(
    r"url\(\s*(?:\"([^\"]*)\"|'([^']*)'|([^)]*?))\s*\)(.*)", re.DOTALL | re.IGNORECASE
)
_VAR = re.compile(r"\bvar\(", re.IGNORECASE)
_PATH = re.compile(r"path\(\s*(?:evenodd\s*,|nonzero\s*,)?\s*([\"'])(.*)\1\s*\)", re.DOTALL)
_LONGEST = 10_000
"""Characters of a value once its variables are replaced."""
_DEEPEST = 20


class _UnsetError(Exception):
    """A variable has no value."""


def apply_styles(root: ET.Element, midway: bool = False) -> list[str]:
    """Turn all styles of a document into presentation attributes, in place.

    ``midway``, animations that end with nothing are shown in their middle.

    Returns
    -------
    Sentences about what was not understood.
    """
    sheet = StyleSheet.of(root)
    page = page_of(root)
    remarks = list(sheet.remarks)
    parents = {child: element for element in root.iter() for child in element}
    variables: dict[ET.Element, dict[str, str]] = {}
    matched = list(sheet.matches())  # before any attribute changes
    matched += own_copies(root, matched, parents)
    for element, declared in matched:
        declared += _ends(declared, sheet, remarks, midway)
        remarks += [_UNMOVED for name, value, _ in declared if name in _MOTION and "(" in value]
        own = {name: value for name, value, _ in declared if name.startswith("--")}
        above = parents.get(element)
        inherited = {} if above is None else variables.get(above, {})
        known = variables[element] = inherited | own if own else inherited
        _apply(element, _by_property(declared, known), known, page, remarks)
    return remarks


def _ends(
    declared: list[Declared], sheet: StyleSheet, remarks: list[str], midway: bool
) -> list[Declared]:
    """Return what the animations of style sheets leave at their end, or show in their middle."""
    said = " ".join(value for name, value, _ in declared if name.startswith("animation")).split()
    names = [name.strip("\"',") for name in said if name.strip("\"',") in sheet.keyframes]
    if not names:
        return []
    frames = [one for name in names for one in sheet.keyframes[name]]
    ends = "infinite" not in said and ("forwards" in said or "both" in said)
    end = [one for when, frame in frames if when == 1 for one in frame] if ends else []
    dashed = {one[0] for _, frame in frames for one in frame} & {"stroke-dasharray"}
    whole = not ends and dashed and "stroke-dasharray" not in {one[0] for one in declared}
    if (ends and not midway) or not (whole or vanishes(_animated([*declared, *end], frames))):
        remarks.append(ENDED if ends else MOVING)
        return end
    remarks.append(MIDWAY)
    frames.sort(key=lambda frame: abs(frame[0] - 0.5))
    middle = [frame for _, frame in frames if not vanishes(_animated([*declared, *frame], frames))]
    return middle[0] if middle else []


def _animated(declared: list[Declared], frames: Sequence[Frame]) -> dict[str, str]:
    """Return the values, of those declared, of what key frames animate."""
    names = {name for _, frame in frames for name, *_ in frame}
    if "stroke-dashoffset" in names:
        names.add("stroke-dasharray")
    return {name: value for name, value, _ in declared if name in names}


def _by_property(
    declared: list[Declared], variables: dict[str, str]
) -> dict[str, list[tuple[str, str]]]:
    """Return the values of each property, by what it is called there, the strongest last."""
    found: dict[str, list[tuple[str, str]]] = {}
    for name, value, _ in declared:
        parts = _font(value, variables) if name == "font" else None
        for one in _SHORTHANDS.get(name, (name,)) if parts is None else parts:
            if one in PROPERTIES:
                said = (name, value) if parts is None else (one, parts[one])
                found.setdefault(one, []).append(said)
    return found


def _font(value: str, variables: dict[str, str]) -> dict[str, str]:
    """Return the properties that the shorthand of fonts sets; none if it is not understood."""
    try:
        return font(_substituted(value, variables))
    except _UnsetError:
        return {}


def _apply(
    element: ET.Element,
    values: dict[str, list[tuple[str, str]]],
    variables: dict[str, str],
    page: Box | None,
    remarks: list[str],
) -> None:
    for name in _DROPPED:
        if name in element.attrib:
            del element.attrib[name]
    for name, candidates in values.items():
        if name == "d" and element.tag != "path":
            continue
        found = _first(name, candidates, variables, page)
        if found is None:
            remarks.append(not_understood(*candidates[-1]))
        if found:
            element.set(name, found)
        elif name in element.attrib:
            del element.attrib[name]


def _first(
    name: str,
    candidates: list[tuple[str, str]],
    variables: dict[str, str],
    page: Box | None,
) -> str | None:
    """Return the strongest value that is understood; "" if none is to be set, None if none is."""
    for _, candidate in reversed(candidates):
        try:
            value = calculated(_substituted(candidate, variables), page and whole_of(name, page))
        except _UnsetError:
            return ""
        found = _understood(name, value.strip())
        if found is not None:
            return found
    return None


def _substituted(value: str, variables: dict[str, str], depth: int = 0) -> str:
    """Replace ``var(--name, fallback)`` by what it stands for."""
    match = _VAR.search(value)
    while match is not None:
        end = _closing(value, match.end())
        name, _, fallback = value[match.end() : end].partition(",")
        name = name.strip()
        if depth > _DEEPEST:
            raise _UnsetError
        if name in variables:
            others = {key: one for key, one in variables.items() if key != name}
            try:
                found = _substituted(variables[name], others, depth + 1)
            except _UnsetError:
                if not fallback.strip():
                    raise
                found = _substituted(fallback, variables, depth + 1)
        elif fallback.strip():
            found = _substituted(fallback, variables, depth + 1)
        else:
            raise _UnsetError
        value = value[: match.start()] + found + value[end + 1 :]
        if len(value) > _LONGEST:
            raise _UnsetError
        match = _VAR.search(value, match.start() + len(found))
    return value


def _closing(value: str, start: int) -> int:
    """Return where the parenthesis that is open at ``start`` closes."""
    depth = 1
    for place in range(start, len(value)):
        depth += {"(": 1, ")": -1}.get(value[place], 0)
        if not depth:
            return place
    return len(value)


def _understood(name: str, value: str) -> str | None:
    """Return a value as SVG 1.1 writes it; "" if it need not be set, None if it means nothing."""
    word = value.lower()
    if word in ("inherit", "unset", "initial", "revert", "revert-layer"):
        if name not in _INHERITED:
            return "inherit" if word == "inherit" else ""
        return INITIAL.get(name, "") if word == "initial" else ""
    if name in _PAINTS:
        return _paint(value)
    if name in _COLOURS:
        return colour(value)
    if name in _OPACITIES:
        return _opacity(word)
    if name in _LENGTHS:
        return _length(word)
    if name in _REFERENCES:
        return _reference(name, value)
    if name == "stroke-dasharray":
        return _dashes(word)
    if name == "d":
        match = _PATH.fullmatch(value)
        return match[2] if match else "" if word == "none" else value
    if name == "mix-blend-mode" and word not in _BLEND_MODES:
        return None
    if name in _KEYWORDS:
        return word
    return value


def _paint(value: str) -> str | None:
    word = value.lower()
    if word == "none":
        return "none"
    if word.startswith(("context-fill", "context-stroke", "context-value")):
        return word.split()[0]
    match = _URL.fullmatch(value)
    if match is None:
        return colour(value)
    rest = match[4].strip()
    fallback = (_paint(rest) if rest else None) or ""
    return f"url({_target(match)}) {fallback}".strip()


def _target(match: re.Match[str]) -> str:
    said = (match[1] or match[2] or match[3] or "").strip()
    return re.sub(r"[\s()\"']", lambda one: quote(one[0]), said)


def _opacity(word: str) -> str | None:
    if word.startswith("context-"):
        return ""
    match = _LENGTH.fullmatch(word)
    if match is None or match[2] not in ("", "%"):
        return None
    number = float(match[1]) / (100 if match[2] else 1)
    return f"{min(max(number, 0.0), 1.0):.6g}"


def _length(word: str) -> str | None:
    if re.fullmatch(r"[a-z]+(-[a-z]+)*", word):
        return word  # of a font, or of a size: a keyword
    parts = re.split(r"[\s,]+", word)
    if len(parts) > 1:  # of text: a list
        return word if all(_LENGTH.fullmatch(part) for part in parts) else None
    match = _LENGTH.fullmatch(word)
    if match is None:
        return None
    if match[2] in _IN_PIXELS:
        return f"{float(match[1]) * _IN_PIXELS[match[2]]:.6g}"
    if match[2] not in _UNITS:
        return None
    return match[1] + _UNITS[match[2]]


def _dashes(word: str) -> str | None:
    if word == "none":
        return word
    parts = [_length(part) for part in re.split(r"[\s,]+", word) if part]
    return None if None in parts else " ".join(map(str, parts))


def _reference(name: str, value: str) -> str | None:
    if value.lower() == "none" or (name == "clip-path" and is_basic_shape(value)):
        return value.lower() if value.lower() == "none" else value
    match = _URL.match(value)
    if match is not None and (name != "filter" or not match[4].strip()):
        return f"url({_target(match)})"
    return filters.written(value) if name == "filter" else None
