"""A sketch over its photo in a project file."""

from collections.abc import Generator

from iconstudio.inputs.formats import Points, Record, Text, TextSet, plain_text
from iconstudio.model import Axis, IconstudioError, Polygon, Sketch
from iconstudio.workflows.modelling.page import SketchPage
from iconstudio.workflows.pages import PageFormat, Parts, StoredParts, StoredPhoto


class StoredSketch(Record, frozen=True):
    """The page of a sketch."""

    polygon: Points
    closed: bool = False
    keyword: Text = ""
    exclude: TextSet = frozenset()
    symmetry: Axis | None = None
    photo: StoredPhoto | None = None
    include: TextSet = frozenset()


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
            sketch.include,
        )

    def read(self, stored: StoredSketch, parts: StoredParts) -> Generator[None, None, SketchPage]:
        """Return the page that was written; without its photo, if only that is no good."""
        polygon = Polygon(stored.polygon)
        criteria = stored.keyword, stored.exclude, stored.symmetry, stored.include
        sketch = Sketch(polygon, *criteria)
        photo = None
        if stored.photo is not None:
            try:
                photo = yield from parts.photo(stored.photo)
            except IconstudioError as error:
                parts.complaints.append(f"The sketch was opened without its photo: {error}")
        return SketchPage(sketch, stored.closed, photo)
