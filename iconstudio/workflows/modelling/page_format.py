"""A sketch over its photo in a project file."""

from collections.abc import Generator, Sequence
from dataclasses import asdict

from iconstudio.inputs.formats import Many, Points, Record, Share, Text, TextSet, plain_text
from iconstudio.model import Axis, IconstudioError, Layer, Polygon, Sketch
from iconstudio.workflows.areas import StoredArea
from iconstudio.workflows.modelling.page import SketchPage
from iconstudio.workflows.montage.page_format import StoredStroke
from iconstudio.workflows.pages import (
    PageFormat,
    Parts,
    StoredParts,
    StoredPhoto,
    StoredPlacement,
)


class StoredPin(StoredPlacement, frozen=True, kw_only=True):
    """An icon where it lies, and the place that is its."""

    icon: Text
    strokes: Many[StoredStroke]


class StoredSketch(Record, frozen=True):
    """The page of a sketch."""

    polygon: Points
    closed: bool = False
    keyword: Text = ""
    exclude: TextSet = frozenset()
    symmetry: Axis | None = None
    photo: StoredPhoto | None = None
    pins: Many[StoredPin] = ()
    include: TextSet = frozenset()
    areas: Many[StoredArea] = ()
    detail: Share = 0.0


class SketchPages(PageFormat[SketchPage, StoredSketch]):
    """The sketch, finished or not, and the photo."""

    stored = StoredSketch

    def write(self, page: SketchPage, parts: Parts) -> StoredSketch:
        """Return a page as it is stored."""
        sketch = page.sketch
        return StoredSketch(
            sketch.polygon.vertices,
            page.closed,
            plain_text(sketch.keyword),
            sketch.exclude,
            sketch.symmetry,
            None if page.photo is None else parts.photo(page.photo),
            tuple(_stored(pin, parts) for pin in sketch.pins),
            sketch.include,
            tuple(map(StoredArea.of, page.areas)),
            sketch.detail,
        )

    def read(self, stored: StoredSketch, parts: StoredParts) -> Generator[None, None, SketchPage]:
        """Return the page that was written; without its photo or pins, if these are no good."""
        polygon = Polygon(stored.polygon)
        pins = tuple(_pins(stored.pins, parts))
        criteria = stored.keyword, stored.exclude, stored.symmetry, pins, stored.include
        sketch = Sketch(polygon, *criteria, detail=stored.detail)
        photo = None
        if stored.photo is not None:
            try:
                photo = yield from parts.photo(stored.photo)
            except IconstudioError as error:
                parts.complaints.append(f"The sketch was opened without its photo: {error}")
        areas = tuple(one.area for one in stored.areas)
        return SketchPage(sketch, stored.closed, photo).with_areas(areas)


def _stored(pin: Layer, parts: Parts) -> StoredPin:
    strokes = tuple(map(StoredStroke.of, pin.strokes))
    return StoredPin(icon=parts.icon(pin.icon), strokes=strokes, **asdict(pin.placement))


def _pins(stored: Sequence[StoredPin], parts: StoredParts) -> Generator[Layer]:
    for one in stored:
        try:
            icon = parts.icon(one.icon)
        except IconstudioError as error:
            parts.complaints.append(f"A pinned part of the sketch was left out: {error}")
        else:
            yield Layer(icon, one.placement, tuple(each.stroke for each in one.strokes))
