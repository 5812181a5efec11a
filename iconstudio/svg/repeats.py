"""What is repeated, and what has a viewport of its own, as groups (SVG 2, sections 5.5 and 8.2).

What comes out measures every shape in one way: by the transforms of the groups around it.
"""

import copy
import xml.etree.ElementTree as ET
from collections.abc import Mapping

from iconstudio.svg.bounds import bounds, fitted
from iconstudio.svg.geometry import DEFINITIONS
from iconstudio.svg.lengths import (
    IDENTITY,
    Box,
    Matrix,
    length,
    multiplied,
    numbers,
    transform,
    written,
)
from iconstudio.svg.percentages import write_out

_VIEWPORTS = ("svg", "symbol")
_OF_USES = ("href", "x", "y", "width", "height")
_OF_VIEWPORTS = ("viewBox", "preserveAspectRatio", "overflow", "x", "y", "width", "height")
_HOLDERS = ("defs", "symbol")
_EFFECTS = ("clip-path", "mask", "filter")
_REACH = 0.001
"""What sticks out of a viewport by no more than this part of it need not be cut off."""


def as_groups(root: ET.Element, page: Box | None, ids: dict[str, ET.Element]) -> None:
    """Turn each ``use`` into a group around a copy, and each viewport within into a group.

    Nothing may repeat itself. What a clip path repeats becomes a shape there. A viewport that hides
    something gets a clip path, whose id comes into ``ids``.
    """
    if any(one.tag == "use" or (one.tag == "svg" and one is not root) for one in root.iter()):
        _Repeats(root, page or (0.0, 0.0, 100.0, 100.0), ids).all()


class _Repeats:
    def __init__(self, root: ET.Element, page: Box, ids: dict[str, ET.Element]) -> None:
        self._root = root
        self._page = page
        self._ids = ids
        self._as_it_was = {one.get("id"): one for one in copy.deepcopy(root).iter()}
        self._clips = 0

    def all(self) -> None:
        for clip in list(self._root.iter("clipPath")):
            for child in clip:
                if child.tag == "use":
                    self._reshape(child)
        for child in list(self._root):
            self._turn(child, self._page)
        needed = {one.get("href", "#")[1:] for one in self._root.iter("textPath")}
        _clear(self._root, needed, spare=False)

    def _turn(self, element: ET.Element, page: Box) -> None:
        """Turn an element and all in it; ``page`` is what percentages refer to."""
        if element.tag == "use":
            self._repeat(element, page)
        elif element.tag == "svg":
            self._show(element, _place(element, ("x", "y", "width", "height")), page)
        elif element.tag in _HOLDERS:
            self._turn_definitions(element, page)
        else:
            for child in element:
                self._turn(child, page)

    def _turn_definitions(self, element: ET.Element, page: Box) -> None:
        """Turn what is defined in an element, and is not only there to be repeated."""
        for child in element:
            turn = self._turn if child.tag in DEFINITIONS else self._turn_definitions
            turn(child, page)

    def _repeat(self, use: ET.Element, page: Box) -> None:
        """Turn a ``use`` into a group; what it shows may be used elsewhere, turned or not."""
        place = _place(use, _OF_USES)
        target = self._as_it_was.get(place.pop("href", "#")[1:])
        use.tag = "g"
        use[:] = []
        corner = (1, 0, 0, 1, *_corner(place, page))
        _set_matrix(use, multiplied(_transform(use), corner))
        if target is None:
            return
        own = _copy(target)
        use.append(own)
        if target.tag in _VIEWPORTS:
            size = {name: place[name] for name in ("width", "height") if name in place}
            self._show(own, _place(own, ("x", "y", "width", "height")) | size, page)
        else:
            self._turn(own, page)

    def _show(self, element: ET.Element, place: Mapping[str, str], page: Box) -> None:
        """Turn what has a viewport into a group."""
        hides = element.get("overflow", "hidden") in ("hidden", "scroll")
        width, height = (
            length(place.get(name), whole, whole)
            for name, whole in zip(("width", "height"), page[2:], strict=True)
        )
        outer = multiplied(_transform(element), (1, 0, 0, 1, *_corner(place, page)))
        box = numbers(element.get("viewBox", ""))
        inner, within = IDENTITY, (0.0, 0.0, width, height)
        if len(box) == 4 and box[2] > 0 and box[3] > 0:
            within = box[0], box[1], box[2], box[3]
            inner = fitted(within, (width, height), element.get("preserveAspectRatio", ""))
        for name in _OF_VIEWPORTS:
            element.attrib.pop(name, None)
        element.tag = "g"
        group = ET.Element("g")
        group.extend(element)
        element[:] = [group]
        _set_matrix(element, outer)
        _set_matrix(group, inner)
        for child in group:
            write_out(child, within)
            self._turn(child, within)
        if width <= 0 or height <= 0:
            element.set("display", "none")
        elif hides and _sticks_out(group, (0.0, 0.0, width, height), self._ids):
            self._cut_off(element, (width, height))
        elif not any(name in element.attrib for name in _EFFECTS):
            _set_matrix(element, multiplied(outer, inner))
            element[:] = list(group)

    def _cut_off(self, element: ET.Element, size: tuple[float, float]) -> None:
        """Hide what of a viewport's group sticks out of it."""
        name = f"v{self._clips}"
        self._clips += 1
        clip = self._ids[name] = ET.SubElement(self._root, "clipPath", id=name)
        ET.SubElement(clip, "rect", width=f"{size[0]:.9g}", height=f"{size[1]:.9g}")
        if any(one in element.attrib for one in _EFFECTS):
            window = ET.Element("g")
            window.extend(element)
            element[:] = [window]
            element = window
        element.set("clip-path", f"url(#{name})")

    def _reshape(self, use: ET.Element) -> None:
        """Turn a ``use`` in a clip path, which holds no groups, into the shape that it shows."""
        matrix = IDENTITY
        said = {name: value for name, value in use.attrib.items() if name not in _OF_USES}
        target: ET.Element | None = use
        while target is not None and target.tag == "use":
            matrix = multiplied(matrix, _transform(target))
            matrix = multiplied(matrix, (1, 0, 0, 1, *_corner(target.attrib, self._page)))
            target = self._as_it_was.get(target.get("href", "#")[1:])
            said |= {} if target is None else _said(target)
        if target is None or target is use:
            return
        matrix = multiplied(matrix, _transform(target))
        own = _copy(target)
        use.tag, use.text, use[:] = own.tag, own.text, list(own)
        use.attrib.clear()
        use.attrib |= said | {name: own.attrib[name] for name in own.attrib if name in _GEOMETRY}
        _set_matrix(use, matrix)


_GEOMETRY = (
    "d", "points", "x", "y", "x1", "y1", "x2", "y2", "cx", "cy", "r", "rx", "ry", "width", "height",
)  # fmt: skip


def _clear(element: ET.Element, needed: set[str], spare: bool) -> None:
    """Take out what was only there to be repeated, but for what letters stand on.

    What holds definitions stays, as these inherit from it.
    """
    for child in list(element):
        if child.get("id") in needed:
            continue
        unseen = element.tag in _HOLDERS or spare
        _clear(child, needed, unseen and child.tag not in DEFINITIONS)
        if unseen and child.tag not in DEFINITIONS and not len(child):
            element.remove(child)
        elif (unseen and child.tag not in DEFINITIONS) or child.tag == "symbol":
            child.tag = "defs"


def _said(element: ET.Element) -> dict[str, str]:
    return {name: one for name, one in element.attrib.items() if name not in (*_OF_USES, "id")}


def _copy(element: ET.Element) -> ET.Element:
    """Return a copy of what is drawn of an element, which nothing refers to."""
    own = copy.copy(element)
    own.attrib = {name: value for name, value in element.attrib.items() if name != "id"}
    own[:] = [_copy(child) for child in element if child.tag not in DEFINITIONS]
    return own


def _place(element: ET.Element, names: tuple[str, ...]) -> dict[str, str]:
    """Take out the attributes that say where something is."""
    return {name: element.attrib.pop(name) for name in names if name in element.attrib}


def _corner(place: Mapping[str, str], page: Box) -> tuple[float, float]:
    return length(place.get("x"), page[2]), length(place.get("y"), page[3])


def _sticks_out(group: ET.Element, view: Box, ids: Mapping[str, ET.Element]) -> bool:
    box = bounds(group, view, ids)
    if box is None:
        return False
    reach = _REACH * max(view[2:])
    return (
        box[0] < view[0] - reach
        or box[1] < view[1] - reach
        or box[0] + box[2] > view[0] + view[2] + reach
        or box[1] + box[3] > view[1] + view[3] + reach
    )


def _transform(element: ET.Element) -> Matrix:
    return transform(element.get("transform")) or IDENTITY


def _set_matrix(element: ET.Element, matrix: Matrix) -> None:
    if matrix == IDENTITY:
        element.attrib.pop("transform", None)
    else:
        element.set("transform", f"matrix({written(matrix)})")
