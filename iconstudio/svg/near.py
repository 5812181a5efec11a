"""Drawings in coordinates that are far, huge or tiny, brought near: a renderer counts in 24 bits.

The space of each element is mapped, evenly and without turning, so that its unit is one of the
canvas. What is left of its transform turns and shears, but neither moves nor enlarges. What it
refers to comes along: in each space where it is needed, there is a copy. Nothing is repeated any
more, and nothing has a viewport of its own (``repeats``).
"""

import math
import re
import xml.etree.ElementTree as ET
from typing import NamedTuple

from iconstudio.model import CANVAS, IconstudioError
from iconstudio.svg.check import MAX_EXPANSION
from iconstudio.svg.geometry import DEFINITIONS, SHAPES, moved, path_data
from iconstudio.svg.lengths import (
    IDENTITY,
    Box,
    Matrix,
    between,
    even_part,
    length,
    multiplied,
    numbers,
    transform,
    whole_of,
    written,
)
from iconstudio.svg.styles import INITIAL

_LEAST, _MOST = 0.001, 300.0
"""Canvas units that a unit measures where renderers are at ease."""
_BETWEEN = 100.0
"""By how much more a group's unit may differ, which those within make up for."""
_FAR = 100.0 * CANVAS
"""Canvas units that the origin may lie away."""
_OF_SHAPES = (
    "d", "x", "y", "x1", "y1", "x2", "y2", "cx", "cy", "r", "rx", "ry", "width", "height", "points",
)  # fmt: skip
_STROKES = ("stroke-width", "stroke-dasharray", "stroke-dashoffset")
"""Lengths that elements may inherit from where units are others."""
_INITIAL = tuple(INITIAL[name] for name in _STROKES)
_EFFECT = {"x": "-10%", "y": "-10%", "width": "120%", "height": "120%"}
_LENGTHS = {
    "linearGradient": ("gradientUnits", {"x1": "0", "y1": "0", "x2": "100%", "y2": "0"}),
    "radialGradient": ("gradientUnits", {"cx": "50%", "cy": "50%", "r": "50%"}),
    "pattern": ("patternUnits", {"x": "0", "y": "0", "width": "0", "height": "0"}),
    "mask": ("maskUnits", _EFFECT),
    "filter": ("filterUnits", _EFFECT),
}
"""Which attribute says whether lengths are in user space, and what they are by default."""
_CONTENT_UNITS = {
    "clipPath": "clipPathUnits", "mask": "maskContentUnits", "pattern": "patternContentUnits",
}  # fmt: skip
_USER_SPACE = "userSpaceOnUse"
_OF_SERVERS = ("gradientTransform", "patternTransform")
_ACROSS, _DOWN = ("x", "x1", "x2", "cx", "fx"), ("y", "y1", "y2", "cy", "fy")
_ALONG = ("width", "height", "r", "fr", "dx", "dy", "stdDeviation", "radius")
_RELATIVE = re.compile(r"em|ex|ch|%")
_URL = re.compile(r"url\(#([^)]*)\)")
_BLUR = re.compile(r"(?<=blur\()\s*([\d.]+(?:e[+-]?\d+)?)")


def brought_near(content: ET.Element, page: Box | None, drawn: Box) -> tuple[ET.Element, Matrix]:
    """Return a drawing in coordinates of a usual size, and how it came there.

    ``drawn`` is the box around its shapes, and ``page`` what is seen of them.

    Raises
    ------
    IconstudioError
        If it repeats too much.
    """
    shown = page or drawn
    x, y, width, height = shown
    scale = CANVAS / (max(width, height) or 1.0)
    matrix = scale, 0.0, 0.0, scale, -x * scale, -y * scale
    mover = _Mover(shown, content)
    if _is_usual(matrix) and mover.is_near(content, matrix):
        return content, IDENTITY
    return mover.all_of(content, matrix), matrix


class _Space(NamedTuple):
    """Where an element is."""

    matrix: Matrix
    """From there to the canvas, as it was."""
    near: Matrix
    """From there to where it is now."""
    strokes: tuple[str, ...] = _INITIAL
    """What it inherits."""


class _Mover:
    def __init__(self, page: Box, content: ET.Element) -> None:
        self._page = page
        self._ids = {one.attrib["id"]: one for one in content.iter() if "id" in one.attrib}
        self._parents = {child: parent for parent in content.iter() for child in parent}
        self._names: dict[tuple[str, _Space], str] = {}
        self._defs = ET.Element("defs")
        self._count = 0

    def is_near(self, element: ET.Element, outer: Matrix) -> bool:
        """Whether a renderer is at ease with all that an element shows."""
        matrix = multiplied(outer, _transform(element))
        if element.tag in (*SHAPES, "text"):
            return _is_usual(matrix)
        if not _is_usual(matrix, _BETWEEN):
            return False
        return all(self.is_near(one, matrix) for one in element if one.tag not in DEFINITIONS)

    def all_of(self, content: ET.Element, matrix: Matrix) -> ET.Element:
        """Return a content in coordinates of the canvas, to which the matrix leads."""
        root = ET.Element("g")
        root.append(self._moved(content, _Space(matrix, matrix)))
        root.append(self._defs)
        return root

    def _moved(self, element: ET.Element, outer: _Space) -> ET.Element:
        """Return what an element shows, in a space that is near."""
        own = _transform(element)
        matrix = multiplied(outer.matrix, own)
        near = _origin(element) if element.tag == "text" else even_part(matrix)
        space = _Space(matrix, near, _strokes(element, outer.strokes))
        new = self._copy(element, near)
        _set_matrix(new, "transform", between(outer.near, own, near))
        if element.tag in (*SHAPES, "text"):
            for name, value in zip(_STROKES, space.strokes, strict=True):
                new.set(name, self._placed(name, value, near))
        if element.tag in SHAPES:
            new.tag = "path"
            new.set("d", moved(path_data(element, self._page), near))
            for name in _OF_SHAPES[1:]:
                new.attrib.pop(name, None)
        elif element.tag == "text":
            self._write(new, element, near)
        else:
            new[:] = self._shown(element, space)
        return new

    def _write(self, new: ET.Element, element: ET.Element, near: Matrix) -> None:
        """Place letters, which keep their size."""
        new.text, new.tail = element.text, element.tail
        for name in ("x", "y"):
            if name in element.attrib or element.tag == "text":
                new.set(name, self._placed(name, element.get(name, "0"), near))
        for child in element:
            inner = self._as_it_is(child)
            self._write(inner, child, near)
            new.append(inner)

    def _shown(self, element: ET.Element, space: _Space) -> list[ET.Element]:
        return [self._moved(one, space) for one in element if one.tag not in DEFINITIONS]

    def _copy(self, element: ET.Element, near: Matrix) -> ET.Element:
        """Return an element without children, which refers to what is near, too."""
        self._count += 1
        if self._count > MAX_EXPANSION:
            raise IconstudioError(
                f"The SVG repeats its elements more than {MAX_EXPANSION:,} times. Simplify it."
            )
        new = ET.Element(element.tag)
        for name, value in element.attrib.items():
            if name not in ("id", *_STROKES):
                value = _BLUR.sub(lambda found: f"{float(found[1]) * near[0]:.9g}", value)
                new.set(
                    name, _URL.sub(lambda found: f"url(#{self._defined(found[1], near)})", value)
                )
        return new

    def _as_it_is(self, element: ET.Element) -> ET.Element:
        """Return an element in a space that stays."""
        new = self._copy(element, IDENTITY)
        new.attrib |= {name: element.attrib[name] for name in _STROKES if name in element.attrib}
        new.text, new.tail = element.text, element.tail
        new[:] = map(self._as_it_is, element)
        if "href" in element.attrib:
            new.set("href", f"#{self._defined(element.attrib['href'][1:], IDENTITY)}")
        return new

    def _defined(self, name: str, near: Matrix) -> str:
        """Return what a paint, a clip or the like is called that serves a space which is near."""
        element, space = self._ids.get(name), _Space(near, near)
        found = self._names.get((name, space))
        if element is None:
            return name
        if found is None:
            found = self._new_name(name, space)
            new = self._server(element, near)
            new.set("id", found)
            for key, value in self._inherited(element).items():
                new.attrib.setdefault(key, value)
            self._defs.append(new)
        return found

    def _new_name(self, name: str, space: _Space) -> str:
        return self._names.setdefault((name, space), f"n{len(self._names)}")

    def _server(self, element: ET.Element, near: Matrix) -> ET.Element:
        """Return a definition for a space that is near."""
        if element.tag not in (*_LENGTHS, *_CONTENT_UNITS):
            return self._marker(element, near)
        new = self._copy(element, near)
        if "href" in element.attrib:
            new.set("href", f"#{self._defined(element.attrib['href'][1:], near)}")
        units, defaults = _LENGTHS.get(element.tag, ("", {}))
        in_user_space = self._said(element, units) == _USER_SPACE
        if in_user_space:
            for name in (*_ACROSS, *_DOWN, *_ALONG):
                value = self._said(element, name) or defaults.get(name)
                if value is not None:
                    new.set(name, self._placed(name, value, near))
        if element.tag == "pattern" and in_user_space:
            for name, side in (("x", "width"), ("y", "height")):
                period = float(new.attrib[side]) or 1.0
                new.set(name, f"{math.remainder(float(new.attrib[name]), period):.9g}")
        for name in _OF_SERVERS:
            own = transform(element.get(name))
            if own is not None and (in_user_space or element.tag == "pattern"):
                _set_matrix(new, name, between(near, own, near))
        if element.tag == "filter":
            new[:] = [self._effect(one, element, near) for one in element]
        elif element.get(_CONTENT_UNITS.get(element.tag, ""), _USER_SPACE) == _USER_SPACE and (
            element.tag in _CONTENT_UNITS and "viewBox" not in element.attrib
        ):
            own = _transform(element)
            inner = even_part(multiplied(near, own))
            _set_matrix(new, "transform", between(near, own, inner))
            if element.tag == "pattern":  # whose origin is a corner of its tile
                inner = inner[0], 0.0, 0.0, inner[0], 0.0, 0.0
            inherited = self._inherited(element)
            strokes = tuple(inherited.get(name, INITIAL[name]) for name in _STROKES)
            new[:] = self._shown(element, _Space(inner, inner, strokes))
        else:
            new[:] = map(self._as_it_is, element)
        return new

    def _marker(self, element: ET.Element, near: Matrix) -> ET.Element:
        """Return a marker, or what else is measured by itself."""
        new = self._as_it_is(element)
        if element.get("markerUnits") == _USER_SPACE:
            sides = [
                length(element.get(name), 0.0, 3.0) for name in ("markerWidth", "markerHeight")
            ]
            new.attrib.setdefault("viewBox", written((0.0, 0.0, *sides)))
            for name, side in zip(("markerWidth", "markerHeight"), sides, strict=True):
                new.set(name, f"{side * near[0]:.9g}")
        return new

    def _effect(self, element: ET.Element, described: ET.Element, near: Matrix) -> ET.Element:
        """Return a part of a filter."""
        new = self._as_it_is(element)
        if described.get("primitiveUnits", _USER_SPACE) == _USER_SPACE:
            for name in (*_ACROSS[:1], *_DOWN[:1], *_ALONG):
                if name in new.attrib:
                    new.set(name, self._placed(name, new.attrib[name], near))
        return new

    def _inherited(self, element: ET.Element) -> dict[str, str]:
        """Return what elements around a definition say that holds for it, too."""
        said: dict[str, str] = {}
        here: ET.Element | None = element
        while here is not None:
            said = {name: here.attrib[name] for name in INITIAL if name in here.attrib} | said
            here = self._parents.get(here)
        return said

    def _said(self, element: ET.Element, name: str) -> str | None:
        """Return an attribute of a definition, or of the one that it takes over."""
        here: ET.Element | None = element
        for _ in range(MAX_EXPANSION):
            if here is None or name in here.attrib:
                break
            here = self._target(here)
        return None if here is None else here.get(name)

    def _target(self, element: ET.Element) -> ET.Element | None:
        return self._ids.get(element.get("href", "").removeprefix("#"))

    def _placed(self, name: str, value: str, near: Matrix) -> str:
        """Return a length, or several, where it is near; coordinates are moved, too."""
        shift = near[4] if name in _ACROSS else near[5] if name in _DOWN else 0.0
        parts = value.replace(",", " ").split()
        if value == "none":
            return value
        whole = whole_of(name, self._page)
        return " ".join(f"{length(one, whole) * near[0] + shift:.9g}" for one in parts)


def _origin(text: ET.Element) -> Matrix:
    """Return what brings a text's first letter to the origin, if its place is given in numbers."""
    places = {name: " ".join(one.get(name, "") for one in text.iter()) for name in ("x", "y")}
    if _RELATIVE.search(places["x"] + places["y"]) or text.find(".//textPath") is not None:
        return IDENTITY
    x, y = (next(iter(numbers(places[name])), 0.0) for name in ("x", "y"))
    return 1.0, 0.0, 0.0, 1.0, -x, -y


def _is_usual(matrix: Matrix, factor: float = 1.0) -> bool:
    scale, _, _, _, x, y = even_part(matrix)
    return _LEAST / factor <= scale <= _MOST * factor and max(abs(x), abs(y)) <= _FAR


def _transform(element: ET.Element) -> Matrix:
    return transform(element.get("transform")) or IDENTITY


def _set_matrix(element: ET.Element, name: str, matrix: Matrix) -> None:
    if matrix == IDENTITY:
        element.attrib.pop(name, None)
    else:
        element.set(name, f"matrix({written(matrix)})")


def _strokes(element: ET.Element, outer: tuple[str, ...]) -> tuple[str, ...]:
    said = (element.get(name, "inherit") for name in _STROKES)
    return tuple(
        before if one == "inherit" else one for one, before in zip(said, outer, strict=True)
    )
