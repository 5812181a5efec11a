"""What a user asked for, as reports of the grid show it: a sketch, or changes of an icon."""

from collections.abc import Callable
from dataclasses import dataclass
from functools import partial

from iconstudio.algorithms.iconification.guidance import scribble
from iconstudio.algorithms.iconification.guide import (
    UNGUIDED,
    Guide,
    filled_polygons,
    guide_of,
)
from iconstudio.algorithms.raster import Bitmap, fill_polygon
from iconstudio.model import CANVAS, Axis, Edit, Sketch, Stroke
from iconstudio.output.figure import INK, MUTED, RGB
from iconstudio.workflows.editing.placing import PlacedEdit

ADDED, REMOVED = (46, 148, 84), (206, 58, 48)
_ADDED_GROUND, _REMOVED_GROUND = (150, 214, 172), (246, 200, 195)


_STROKE = 5.0
"""Width of a sketch's lines in its picture, in canvas units."""


@dataclass(frozen=True, eq=False)
class Request:
    """What was asked for, on the canvas."""

    keyword: str
    symmetry: Axis | None
    caption: str
    layers: tuple[tuple[Bitmap, RGB], ...]
    """The picture of it: bitmaps (CANVAS, CANVAS) to be painted over each other."""
    outline: Bitmap
    """(CANVAS, CANVAS): the outline that is wanted, filled."""
    change: PlacedEdit | None = None
    """Of an edit: the icon, and what is changed."""
    guide: Guide = UNGUIDED
    """What counts beside the outline."""
    posed: Callable[[int], "Request"] | None = None
    """Poses the same request on a canvas of another side m."""

    def on(self, side: int) -> "Request":
        """Return the request on a canvas of side m: its outline and change are (side, side)."""
        return self if self.posed is None or side == len(self.outline) else self.posed(side)


def sketch_request(sketch: Sketch, side: int = CANVAS) -> Request:
    """Return the request of a sketch."""
    fitted = sketch.fitted()
    outline = fill_polygon(fitted.polygon, side)
    holes = filled_polygons(fitted.inner.holes, side)
    lines = scribble([Stroke(_STROKE, line) for line in fitted.inner.lines], side)
    return Request(
        sketch.keyword,
        sketch.symmetry,
        "sketch and keyword",
        ((outline & ~holes, MUTED), *([(lines, INK)] if lines.any() else ())),
        outline,
        guide=guide_of(fitted, side),
        posed=partial(sketch_request, sketch),
    )


def _caption(edit: Edit) -> str:
    colours = ("less red", edit.remove), ("plus green", edit.add)
    return ", ".join((edit.icon.name, *(words for words, areas in colours if areas)))


def edit_request(change: PlacedEdit) -> Request:
    """Return the request of an edit: red goes, green comes."""
    layers = (
        (change.removed, _REMOVED_GROUND),
        (change.added, _ADDED_GROUND),
        (change.ink, INK),
        (change.ink & change.removed, REMOVED),
        (change.ink & change.added, ADDED),
    )
    return Request(
        change.edit.keyword,
        change.edit.symmetry,
        _caption(change.edit),
        layers,
        change.silhouette,
        change,
        guide=change.guide,
        posed=lambda side: edit_request(change.at(side)),
    )
