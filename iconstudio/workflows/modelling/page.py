"""What lies on the canvas of the sketch, and the edits of all but the outline."""

from dataclasses import dataclass, field, replace
from typing import Any

from iconstudio.algorithms.raster import Bitmap
from iconstudio.model import IconstudioError, Photo, Point, Polygon, Sketch
from iconstudio.workflows.areas import Area, areas_of, crossings, inner_of
from iconstudio.workflows.pages import Document
from iconstudio.workflows.pinning import PinnedPart, with_pin, without_pins


@dataclass(frozen=True, slots=True)
class SketchPage:
    """A sketch over a photo.

    ``sketch.polygon`` also holds an outline that is still being traced; it is finished once
    ``closed``. Coordinates are pixels of the photo, or free units without one.
    """

    sketch: Sketch = field(default_factory=Sketch)
    closed: bool = False
    photo: Photo | None = None
    draft: Area | None = None
    """A hole or a line that is still being traced: the sketch has those that are finished."""

    @property
    def areas(self) -> tuple[Area, ...]:
        """What is drawn inside the outline, first the holes; last what is not finished."""
        done = areas_of(self.sketch.inner)
        return done if self.draft is None else (*done, self.draft)

    def with_areas(self, areas: tuple[Area, ...]) -> "SketchPage":
        """Return the page with other things inside the outline."""
        draft = areas[-1] if areas and not areas[-1].closed else None
        return replace(self, sketch=replace(self.sketch, inner=inner_of(areas)), draft=draft)

    @property
    def vertices(self) -> tuple[Point, ...]:
        """The outline's vertices, finished or not."""
        return self.sketch.polygon.vertices

    @property
    def empty(self) -> bool:
        """Whether there is nothing to look at yet."""
        return not self.vertices and self.photo is None

    @property
    def criteria(self) -> Sketch:
        """What is wanted beside the outline."""
        return self.sketch

    def with_criteria(self, **values: Any) -> "SketchPage":
        """Return the page with another keyword, symmetry, or icons left out."""
        return replace(self, sketch=replace(self.sketch, **values))

    def with_outline(self, vertices: tuple[Point, ...], closed: bool) -> "SketchPage":
        """Return the page with another outline; without one, there is nothing inside it."""
        page = self if vertices else self.with_areas(())
        sketch = replace(page.sketch, polygon=Polygon(vertices))
        return replace(page, sketch=sketch, closed=closed)

    def elsewhere(self, before: "SketchPage") -> bool:
        """Whether the photo, or without one the whole outline, is another."""
        moved = len(self.vertices) > 2 and set(self.vertices).isdisjoint(before.vertices)
        return self.photo is not before.photo or (moved and self.photo is None)


SketchDocument = Document[SketchPage]


def problem(page: SketchPage) -> str:
    """Return what is missing before a sketch can be remixed, as a sentence; else nothing."""
    from iconstudio.workflows.modelling.modelling import fitted_sketch

    if not page.vertices:
        return "There is no outline yet. Click around the object on the canvas to trace it."
    try:
        fitted_sketch(page.sketch)
    except IconstudioError as error:
        return str(error)
    if not page.closed:
        return "The outline is still open. Click its first point to close it."
    if not page.sketch.keyword.strip():
        return "The object has no name yet. Type what it is below the canvas, for example “dog”."
    return ""


def set_photo(document: SketchDocument, photo: Photo | None) -> None:
    """Put another photo under the drawing, or none.

    An outline traced over something else would lie nowhere sensible, so it goes; undo
    brings it back.
    """
    page = document.page.with_outline((), False)
    document.change("set photo", replace(page, photo=photo))


def load_sketch(
    document: SketchDocument, sketch: Sketch, photo: Photo | None = None, text: str = "open"
) -> None:
    """Start from another sketch: an example, a file, or nothing at all."""
    closed = len(sketch.polygon.vertices) >= 3
    document.change(text, SketchPage(sketch, closed, photo))


def set_detail(document: SketchDocument, detail: float, gesture: object = None) -> None:
    """Say how much fine details count. Changes of one ``gesture`` are undone together."""
    page = document.page.with_criteria(detail=detail)
    document.change("weight fine details", page, gesture)


def pin_part(document: SketchDocument, part: PinnedPart) -> None:
    """Give a place of the results to a source, in every result of its style."""
    sketch = document.page.sketch
    pins = with_pin(sketch.pins, part.pin, sketch.symmetry)
    document.change("pin part", document.page.with_criteria(pins=pins))


def unpin_part(document: SketchDocument, place: Bitmap) -> None:
    """Let a place of the results, (m, m) bool, be anyone's again."""
    sketch = document.page.sketch
    pins = without_pins(sketch.pins, place, sketch.symmetry)
    document.change("unpin part", document.page.with_criteria(pins=pins))


def unpin_all(document: SketchDocument) -> None:
    """Remove all pins."""
    document.change("unpin all parts", document.page.with_criteria(pins=()))


def doubts(sketch: Sketch) -> str:
    """Return what the user should know of how a sketch is read, as a sentence, or nothing."""
    return crossings(sketch.inner, {"the outline": sketch.polygon})
