"""The page of any workflow that declares none: its work, as its files say it."""

from collections.abc import Generator
from dataclasses import dataclass
from typing import Any

from iconstudio.workflows.events import Event
from iconstudio.workflows.pages import PageFormat, Parts, StoredParts
from iconstudio.workflows.workflow import File, Workflow


@dataclass(frozen=True, slots=True)
class WorkPage:
    """The work of a workflow, of which nothing else is known."""

    work: Any

    def elsewhere(self, before: "WorkPage") -> bool:
        """Whether the view should be fitted anew; there is none."""
        return False


class WorkPages(PageFormat[WorkPage, File[Any]]):
    """Work in the format of its files."""

    def __init__(self, workflow: Workflow[Any]) -> None:
        super().__init__(workflow)
        self.stored = workflow.file

    def write(self, page: WorkPage, parts: Parts) -> File[Any]:
        """Return a page as it is stored."""
        return self.workflow.file.of(page.work, parts.icon)

    def read(self, stored: File[Any], parts: StoredParts) -> Generator[Event, None, WorkPage]:
        """Return the page that was written."""
        return WorkPage((yield from stored.resolving(parts.resources)))
