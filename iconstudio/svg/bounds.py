"""The box around all that an element draws."""

import xml.etree.ElementTree as ET
from collections.abc import Callable, Mapping
from typing import NamedTuple

from iconstudio.svg.check import MAX_DEPTH
from iconstudio.svg.geometry import DEFINITIONS, SHAPES, data_bounds, path_data
from iconstudio.svg.lengths import (
    IDENTITY,
    Box,
    Matrix,
    enlarged,
    length,
    mapped,
    multiplied,
    numbers,
    scale_of,
    transform,
)
from iconstudio.svg.lettering import Lettering, text_boxes


def bounds(
    element: ET.Element, page: Box, ids: Mapping[str, ET.Element], painted: bool = False
) -> Box | None:
    """Return a box that holds all that an element draws, in the space around it; None if nothing.

    ``painted``, shapes without a fill or a stroke of any extent are not counted.

    It is that of the control points, with strokes; clips and masks are not counted.
    """
    found: list[Box] = []
    paint = _Paint(painted)
    _collect(element, IDENTITY, paint, page, ids, found.append, 0)
    return union(found)


def union(boxes: list[Box]) -> Box | None:
    """Return the box around several; None if there are none."""
    if not boxes:
        return None
    left, top = min(box[0] for box in boxes), min(box[1] for box in boxes)
    right, bottom = max(box[0] + box[2] for box in boxes), max(box[1] + box[3] for box in boxes)
    return left, top, right - left, bottom - top


class _Paint(NamedTuple):
    """How shapes are painted."""

    only_painted: bool
    filled: bool = True
    stroked: bool = False
    width: float = 1.0
    lettering: Lettering = Lettering()

    def of(self, element: ET.Element, page: Box) -> "_Paint":
        """Return that of an element, which it inherits unless it says otherwise."""
        filled, stroked = (
            before if (said := element.get(name, "inherit")) == "inherit" else said != "none"
            for name, before in (("fill", self.filled), ("stroke", self.stroked))
        )
        width = length(element.get("stroke-width"), page[2], self.width)
        lettering = self.lettering.of(element, page)
        return _Paint(self.only_painted, filled, stroked, width, lettering)

    def shows(self, box: Box) -> bool:
        """Whether a shape of these bounds is counted."""
        stroked = self.stroked and self.width > 0
        return not self.only_painted or stroked or (self.filled and box[2] > 0 and box[3] > 0)


_MITRE = 2
"""Widths of a stroke that the corner of a letter may reach beyond its outline."""


def reached(box: Box, page: Box, missed: float) -> tuple[bool, ...]:
    """Return whether a box reaches the left, top, right and bottom of a page.

    By at most ``missed``, a part of the page's longer side, it may miss them.
    """
    reach = missed * max(page[2:])
    return (
        box[0] <= page[0] + reach,
        box[1] <= page[1] + reach,
        box[0] + box[2] >= page[0] + page[2] - reach,
        box[1] + box[3] >= page[1] + page[3] - reach,
    )


def _collect(
    element: ET.Element, outer: Matrix, paint: "_Paint", page: Box,
    ids: Mapping[str, ET.Element], add: Callable[[Box], None], depth: int,
) -> None:  # fmt: skip
    if depth > MAX_DEPTH or element.get("display") == "none":
        return
    matrix = multiplied(outer, transform(element.get("transform")) or IDENTITY)
    paint = paint.of(element, page)
    if element.tag in SHAPES:
        box = data_bounds(path_data(element, page))
        if box is not None and paint.shows(box):
            reach = paint.width * scale_of(matrix) / 2 if paint.stroked else 0.0
            add(enlarged(mapped(matrix, box), reach))
        return
    if element.tag == "text":
        reach = paint.width * _MITRE if paint.stroked else 0.0
        for box in text_boxes(element, paint.lettering, page, ids):
            add(mapped(matrix, enlarged(box, reach)))
        return
    if element.tag == "use":
        target = ids.get(element.get("href", "").removeprefix("#"))
        if target is None:
            return
        shift = 1, 0, 0, 1, length(element.get("x"), page[2]), length(element.get("y"), page[3])
        matrix = multiplied(matrix, shift)
        if target.tag in ("symbol", "svg"):
            size = (
                element.get("width", target.get("width")),
                element.get("height", target.get("height")),
            )
            matrix = multiplied(matrix, viewport(target, page, size))
            for child in target:
                _collect(child, matrix, paint, page, ids, add, depth + 1)
        else:
            _collect(target, matrix, paint, page, ids, add, depth + 1)
        return
    if element.tag in DEFINITIONS:
        return
    if element.tag == "svg" and depth:
        corner = length(element.get("x"), page[2]), length(element.get("y"), page[3])
        matrix = multiplied(matrix, (1, 0, 0, 1, *corner))
        size = element.get("width"), element.get("height")
        matrix = multiplied(matrix, viewport(element, page, size))
    for child in element:
        _collect(child, matrix, paint, page, ids, add, depth + 1)


def viewport(element: ET.Element, page: Box, size: tuple[str | None, str | None]) -> Matrix:
    """Return how an element's ``viewBox`` is mapped to its ``size``, by default the page's."""
    box = numbers(element.get("viewBox", ""))
    if len(box) != 4 or box[2] <= 0 or box[3] <= 0:
        return IDENTITY
    width, height = length(size[0], page[2], page[2]), length(size[1], page[3], page[3])
    view = box[0], box[1], box[2], box[3]
    return fitted(view, (width, height), element.get("preserveAspectRatio", ""))


def fitted(box: Box, size: tuple[float, float], aspect: str) -> Matrix:
    """Return what maps a ``viewBox`` to a viewport at the origin."""
    x, y = size[0] / box[2], size[1] / box[3]
    words = aspect.replace("defer", "").split() or ["xMidYMid"]
    if words[0] != "none":
        x = y = max(x, y) if "slice" in words else min(x, y)
    across = 0 if "xMin" in words[0] else 1 if "xMax" in words[0] else 0.5
    down = 0 if "YMin" in words[0] else 1 if "YMax" in words[0] else 0.5
    left, top = (size[0] - box[2] * x) * across, (size[1] - box[3] * y) * down
    return x, 0.0, 0.0, y, left - box[0] * x, top - box[1] * y
