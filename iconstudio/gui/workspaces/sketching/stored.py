"""A sketch over its photo in a project file."""

from collections.abc import Generator
from dataclasses import replace
from pathlib import Path
from typing import Any

from iconstudio.gui.canvas.photo import Photo, photo_of
from iconstudio.gui.document.pages import PageFormat
from iconstudio.gui.workspaces.sketching.page import SketchPage
from iconstudio.inputs.fields import Fields
from iconstudio.model import IconstudioError, Polygon, Sketch
from iconstudio.project.archive import plain_text
from iconstudio.project.parts import Parts, StoredParts

_LARGEST = 10_000_000
"""No photo has more pixels a side."""


class SketchPages(PageFormat[SketchPage]):
    """The sketch, finished or not, and the photo."""

    def write(self, page: SketchPage, parts: Parts) -> dict[str, Any]:
        """Return a page as JSON."""
        sketch = page.sketch
        return {
            "keyword": plain_text(sketch.keyword),
            "polygon": sketch.polygon.vertices,
            "closed": page.closed,
            "exclude": sorted(sketch.exclude),
            "symmetry": sketch.symmetry,
            "photo": None if page.photo is None else _photo(page.photo, parts),
        }

    def read(self, fields: Fields, parts: StoredParts) -> Generator[None, None, SketchPage]:
        """Return the page that was written; without its photo, if only that is no good."""
        sketch = Sketch(
            Polygon(fields.points("polygon")),
            fields.text("keyword"),
            frozenset(fields.texts("exclude")),
            fields.axis(),
        )
        photo = None
        if fields.has("photo"):
            try:
                photo = yield from _read_photo(fields.object("photo"), parts)
            except IconstudioError as error:
                parts.complaints.append(f"The sketch was opened without its photo: {error}")
        return SketchPage(sketch, fields.flag("closed"), photo)


def _photo(photo: Photo, parts: Parts) -> dict[str, Any]:
    part = parts.photo(photo.data, photo.suffix)
    return {"part": part, "width": photo.width, "height": photo.height}


def _read_photo(fields: Fields, parts: StoredParts) -> Generator[None, None, Photo]:
    part = fields.text("part")
    data = parts.content(part)
    image = yield from parts.session.image(data)
    width = fields.whole("width", image.width, 1, _LARGEST)
    height = fields.whole("height", image.height, 1, _LARGEST)
    photo = photo_of(replace(image, width=width, height=height), data=data)
    return replace(photo, suffix=Path(part).suffix)
