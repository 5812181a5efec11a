"""The shapes that a plain drawing paints, in their order, as paths on the canvas."""

import re
import xml.etree.ElementTree as ET
from collections.abc import Iterator
from dataclasses import dataclass
from typing import Literal, NamedTuple, cast

from iconstudio.algorithms.areas import Cap, Join
from iconstudio.model import CANVAS, Frame
from iconstudio.model.path import Path
from iconstudio.svg.bounds import viewport
from iconstudio.svg.geometry import DEFINITIONS, SHAPES, outline, path_data
from iconstudio.svg.lengths import (
    IDENTITY,
    Box,
    Matrix,
    length,
    mapped,
    multiplied,
    numbers,
    transform,
    whole_of,
)
from iconstudio.svg.parse import parse
from iconstudio.svg.plain import plain

Tone = Literal["ink", "paper", "none"]
"""What becomes dark, what covers the dark, and what does neither."""

_MOST, _MOST_SEGMENTS = 2_000, 20_000
"""Shapes, each time that one is used, and segments of all: no icon has as many."""
_DEEPEST = 60
_CAPS = {"round": "round", "square": "square", "butt": "flat"}
_JOINS = {"round": "round", "bevel": "bevel"}
_COLOUR = re.compile(r"#([0-9a-f]{6})|rgba\((\d+),(\d+),(\d+),([\d.e-]+)\)")
_GREY = 0.299, 0.587, 0.114
_EFFECTS = ("mask", "filter", "style", "marker-start", "marker-mid", "marker-end")
_INITIAL = {
    "color": "#000000", "fill": "#000000", "stroke": "none", "fill-opacity": "1",
    "stroke-opacity": "1", "stroke-width": "1", "stroke-dasharray": "none",
    "stroke-dashoffset": "0", "stroke-linecap": "butt", "stroke-linejoin": "miter",
    "stroke-miterlimit": "4", "fill-rule": "nonzero", "clip-rule": "nonzero",
    "visibility": "visible", "paint-order": "normal",
}  # fmt: skip


class NotOfShapesError(Exception):
    """A drawing is not painted by plain fills and strokes alone."""


@dataclass(frozen=True, slots=True)
class Pen:
    """How a shape is stroked."""

    width: float
    """In units of the shape's own space."""
    cap: Cap
    join: Join
    mitre: float
    dashes: tuple[float, ...]
    offset: float


@dataclass(frozen=True, slots=True)
class Clip:
    """What is left of a shape: what lies in all of these paths, each filled by its rule."""

    paths: tuple[tuple[Path, bool], ...]
    """The paths and whether they are filled by the even-odd rule; all of them together."""


@dataclass(frozen=True, slots=True)
class Shape:
    """A path, and how it is painted."""

    path: Path
    """In its own space."""
    matrix: Matrix
    """From there to the canvas."""
    fill: Tone
    even_odd: bool
    stroke: Tone
    pen: Pen
    clips: tuple[Clip, ...]


class _Space(NamedTuple):
    """Where an element is, and what it inherits."""

    matrix: Matrix
    said: dict[str, str]
    opacity: float
    clips: tuple[Clip, ...]
    depth: int


def shapes_on_canvas(svg: str, frame: Frame) -> tuple[Box, Iterator[Shape]]:
    """Return a document's page on the canvas that ``frame`` fills, and its shapes.

    These come in the order in which they are painted.

    Raises
    ------
    IconstudioError
        If the document cannot be read.
    NotOfShapesError
        While shapes are asked for: if it is painted by more than plain fills and strokes.
    """
    drawing = plain(parse(svg)[0])
    page = drawing.page or (frame.x, frame.y, frame.size, frame.size)
    ids = {one.attrib["id"]: one for one in drawing.content.iter() if "id" in one.attrib}
    scale = CANVAS / frame.size
    matrix = scale, 0.0, 0.0, scale, -frame.x * scale, -frame.y * scale
    space = _Space(matrix, _INITIAL, 1.0, (), 0)
    return mapped(matrix, page), _Painter(page, ids).painted(drawing.content, space)


class _Painter:
    def __init__(self, page: Box, ids: dict[str, ET.Element]) -> None:
        self._page = page
        self._ids = ids
        self._count = self._segments = 0

    def painted(self, element: ET.Element, space: _Space) -> Iterator[Shape]:
        if element.tag in DEFINITIONS or element.get("display") == "none":
            return
        if space.depth > _DEEPEST or any(element.get(one, "none") != "none" for one in _EFFECTS):
            raise NotOfShapesError
        space = self._within(element, space)
        if element.tag in SHAPES:
            shape = self._shape(element, space)
            if shape is not None:
                yield shape
        elif element.tag == "use":
            yield from self._used(element, space)
        elif element.tag == "svg":
            moved = self._shifted(element, space)
            size = element.get("width"), element.get("height")
            yield from self._viewed(element, moved, size)
        elif element.tag in ("g", "a"):
            for child in element:
                yield from self.painted(child, space)
        else:
            raise NotOfShapesError

    def _within(self, element: ET.Element, space: _Space) -> _Space:
        """Return the space of an element."""
        own = transform(element.get("transform"))
        if own is None:
            raise NotOfShapesError
        said = {
            **space.said,
            **{
                name: element.attrib[name]
                for name in _INITIAL
                if element.get(name, "inherit") != "inherit"
            },
        }
        matrix = multiplied(space.matrix, own)
        space = _Space(
            matrix, said, space.opacity * _part(element.get("opacity")), space.clips,
            space.depth + 1,
        )  # fmt: skip
        clip = element.get("clip-path", "none")
        if clip != "none":
            space = space._replace(clips=(*space.clips, self._clip(clip, space)))
        return space

    def _shifted(self, element: ET.Element, space: _Space) -> _Space:
        shift = length(element.get("x"), self._page[2]), length(element.get("y"), self._page[3])
        return space._replace(matrix=multiplied(space.matrix, (1, 0, 0, 1, *shift)))

    def _used(self, element: ET.Element, space: _Space) -> Iterator[Shape]:
        target = self._ids.get(element.get("href", "").removeprefix("#"))
        if target is None:
            return
        space = self._shifted(element, space)
        if target.tag in ("symbol", "svg"):
            size = (
                element.get("width", target.get("width")),
                element.get("height", target.get("height")),
            )
            yield from self._viewed(target, self._within(target, space), size)
        else:
            yield from self.painted(target, space)

    def _viewed(
        self, element: ET.Element, space: _Space, size: tuple[str | None, str | None]
    ) -> Iterator[Shape]:
        """Yield the shapes of an element with a viewport of its own."""
        inner = viewport(element, self._page, size)
        space = space._replace(matrix=multiplied(space.matrix, inner))
        for child in element:
            yield from self.painted(child, space)

    def _shape(self, element: ET.Element, space: _Space) -> Shape | None:
        self._count += 1
        if self._count > _MOST:
            raise NotOfShapesError
        said = space.said
        if said["visibility"] != "visible":
            return None
        if said["paint-order"].startswith("stroke"):
            raise NotOfShapesError
        fill, stroke = (
            _tone(said[name], said["color"], space.opacity * _part(said[f"{name}-opacity"]))
            for name in ("fill", "stroke")
        )
        pen = self._pen(said)
        if pen.width <= 0:
            stroke = "none"
        path = outline(path_data(element, self._page), IDENTITY)
        self._segments += sum(len(one.segments) for one in path.contours)
        if self._segments > _MOST_SEGMENTS:
            raise NotOfShapesError
        if not path or fill == stroke == "none":
            return None
        return Shape(
            path, space.matrix, fill, said["fill-rule"] == "evenodd", stroke, pen, space.clips
        )

    def _pen(self, said: dict[str, str]) -> Pen:
        whole = whole_of("stroke-width", self._page)
        dashes = [] if "%" in said["stroke-dasharray"] else numbers(said["stroke-dasharray"])
        if any(one < 0 for one in dashes) or not sum(dashes):
            dashes = []
        return Pen(
            length(said["stroke-width"], whole, 1.0),
            cast(Cap, _CAPS.get(said["stroke-linecap"], "flat")),
            cast(Join, _JOINS.get(said["stroke-linejoin"], "mitre")),
            max(1.0, length(said["stroke-miterlimit"], 1.0, 4.0)),
            tuple(dashes * (1 + len(dashes) % 2)),
            length(said["stroke-dashoffset"], whole),
        )

    def _clip(self, value: str, space: _Space) -> Clip:
        """Return what a clip path leaves."""
        target = self._ids.get(value.removeprefix("url(#").removesuffix(")"))
        if target is None or target.tag != "clipPath":
            raise NotOfShapesError
        if target.get("clipPathUnits") == "objectBoundingBox" or "clip-path" in target.attrib:
            raise NotOfShapesError
        own = transform(target.get("transform"))
        if own is None:
            raise NotOfShapesError
        inner = _Space(
            multiplied(space.matrix, own), {**_INITIAL, **_rule(target)}, 1.0, (), space.depth
        )
        return Clip(tuple(self._clipping(target, inner)))

    def _clipping(self, parent: ET.Element, space: _Space) -> Iterator[tuple[Path, bool]]:
        if space.depth > _DEEPEST:
            raise NotOfShapesError
        for child in parent:
            if child.get("display") == "none":
                continue
            if child.get("clip-path", "none") != "none":
                raise NotOfShapesError
            inner = self._within(child, space)
            target = child
            if child.tag == "use":
                inner = self._shifted(child, inner)
                target = self._ids.get(child.get("href", "").removeprefix("#"), child)
                inner = self._within(target, inner)
            if target.tag not in SHAPES:
                raise NotOfShapesError
            path = outline(path_data(target, self._page), inner.matrix)
            yield path, inner.said["clip-rule"] == "evenodd"


def _rule(element: ET.Element) -> dict[str, str]:
    return {"clip-rule": element.get("clip-rule", "nonzero")}


def _part(text: str | None) -> float:
    """Return an opacity."""
    found = numbers(text or "1")
    return min(max(found[0], 0.0), 1.0) if found else 1.0


def _tone(paint: str, colour: str, opacity: float) -> Tone:
    """Return what a paint does; a pale layer does nothing."""
    if paint.lower() == "currentcolor":
        paint = colour if colour.lower() != "currentcolor" else "#000000"
    if paint == "none":
        return "none"
    match = _COLOUR.fullmatch(paint)
    if match is None:
        raise NotOfShapesError
    if match[1]:
        rgb = [int(match[1][at : at + 2], 16) for at in (0, 2, 4)]
    else:
        rgb = [int(match[at]) for at in (2, 3, 4)]
        opacity *= float(match[5])
    dark = 1 - sum(weight * one for weight, one in zip(_GREY, rgb, strict=True)) / 255
    if dark * opacity > 0.5:
        return "ink"
    return "paper" if opacity > 0.5 else "none"
