"""The page of any workflow that declares none: its work, and how its spec writes and reads it."""

from collections.abc import Generator
from dataclasses import dataclass
from typing import Any

from iconstudio.inputs.fields import Fields
from iconstudio.workflows.events import Event
from iconstudio.workflows.pages import PageFormat, Parts, StoredParts


@dataclass(frozen=True, slots=True)
class WorkPage:
    """The work of a workflow, of which nothing else is known."""

    work: Any

    def elsewhere(self, before: "WorkPage") -> bool:
        """Whether the view should be fitted anew; there is none."""
        return False


class WorkPages(PageFormat[WorkPage]):
    """Work that the spec knows how to write and to read."""

    def write(self, page: WorkPage, parts: Parts) -> dict[str, Any]:
        """Return a page as JSON."""
        return self.workflow.write(page.work, parts.icon)

    def read(self, fields: Fields, parts: StoredParts) -> Generator[Event, None, WorkPage]:
        """Return the page that was written."""
        return WorkPage((yield from self.workflow.read(fields, parts.resources)))
