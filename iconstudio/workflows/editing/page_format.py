"""An edit in a project file."""

from collections.abc import Generator

from iconstudio.inputs.formats import Many, Points, Record, Text, TextSet, plain_text
from iconstudio.model import Axis
from iconstudio.workflows.editing.page import Area, EditPage, Kind
from iconstudio.workflows.pages import PageFormat, Parts, StoredParts


class StoredArea(Record, frozen=True):
    """An area, finished or not."""

    kind: Kind
    points: Points
    closed: bool = False


class StoredEdit(Record, frozen=True):
    """The page of an edit."""

    icon: Text | None = None
    keyword: Text = ""
    areas: Many[StoredArea] = ()
    symmetry: Axis | None = None
    exclude: TextSet = frozenset()
    include: TextSet = frozenset()


class EditPages(PageFormat[EditPage, StoredEdit]):
    """The icon, and all areas, the one too that is still being traced."""

    stored = StoredEdit

    def write(self, page: EditPage, parts: Parts) -> StoredEdit:
        """Return a page as it is stored."""
        return StoredEdit(
            None if page.icon is None else parts.icon(page.icon.pictogram),
            plain_text(page.keyword),
            tuple(StoredArea(one.kind, one.vertices, one.closed) for one in page.areas),
            page.symmetry,
            page.exclude,
            page.include,
        )

    def read(self, stored: StoredEdit, parts: StoredParts) -> Generator[None, None, EditPage]:
        """Return the page that was written."""
        icon = None if stored.icon is None else parts.exemplar(parts.icon(stored.icon))
        yield
        areas = tuple(Area(one.kind, one.points, one.closed) for one in stored.areas)
        criteria = stored.symmetry, stored.exclude, stored.include
        return EditPage(icon, stored.keyword, areas, *criteria)
