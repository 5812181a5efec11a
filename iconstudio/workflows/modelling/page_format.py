"""A sketch over its photo in a project file."""

from collections.abc import Generator
from typing import Any

from iconstudio.inputs.fields import Fields, plain_text
from iconstudio.model import IconstudioError, Polygon, Sketch
from iconstudio.workflows.modelling.page import SketchPage
from iconstudio.workflows.pages import PageFormat, Parts, StoredParts


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
            "photo": None if page.photo is None else parts.photo(page.photo),
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
                photo = yield from parts.photo(fields.object("photo"))
            except IconstudioError as error:
                parts.complaints.append(f"The sketch was opened without its photo: {error}")
        return SketchPage(sketch, fields.flag("closed"), photo)
