"""The work of any workflow in a project file, as its spec writes and reads it."""

from collections.abc import Generator
from typing import Any

from iconstudio.gui.document.pages import PageFormat
from iconstudio.gui.workspaces.plain.opening import WorkPage
from iconstudio.inputs.fields import Fields
from iconstudio.model import Exemplar, Pictogram
from iconstudio.project.parts import Parts, StoredParts
from iconstudio.workflows.events import Event


class WorkPages(PageFormat[WorkPage]):
    """Work that the spec knows how to write and to read."""

    def write(self, page: WorkPage, parts: Parts) -> dict[str, Any]:
        """Return a page as JSON."""
        return self.workflow.write(page.work, parts.icon)

    def read(self, fields: Fields, parts: StoredParts) -> Generator[Event, None, WorkPage]:
        """Return the page that was written."""
        return WorkPage((yield from self.workflow.read(fields, _Resources(parts))))


class _Resources:
    """A session that finds the icons of a project, too."""

    def __init__(self, parts: StoredParts) -> None:
        self._parts = parts

    def icon(self, reference: str) -> Pictogram:
        return self._parts.icon(reference)

    def exemplar(self, pictogram: Pictogram) -> Exemplar:
        return self._parts.exemplar(pictogram)

    def __getattr__(self, name: str) -> Any:
        return getattr(self._parts.session, name)
