"""An edit in a project file."""

from collections.abc import Generator

from iconstudio.inputs.formats import Many, Record, Text, TextSet, plain_text
from iconstudio.model import Axis
from iconstudio.workflows.areas import StoredArea
from iconstudio.workflows.editing.page import EditPage
from iconstudio.workflows.pages import PageFormat, Parts, StoredParts


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
            tuple(map(StoredArea.of, page.areas)),
            page.symmetry,
            page.exclude,
            page.include,
        )

    def read(self, stored: StoredEdit, parts: StoredParts) -> Generator[None, None, EditPage]:
        """Return the page that was written."""
        icon = None if stored.icon is None else parts.exemplar(parts.icon(stored.icon))
        yield
        areas = tuple(one.area for one in stored.areas)
        criteria = stored.symmetry, stored.exclude, stored.include
        return EditPage(icon, stored.keyword, areas, *criteria)
