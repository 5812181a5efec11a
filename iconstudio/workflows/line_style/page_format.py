"""The page of line styles in a project file."""

from collections.abc import Generator
from dataclasses import replace
from typing import Annotated

from msgspec import Meta

from iconstudio.inputs.formats import Many, Record
from iconstudio.workflows.events import Event
from iconstudio.workflows.line_style.file import RestyleFile
from iconstudio.workflows.line_style.page import RestylePage
from iconstudio.workflows.pages import PageFormat, Parts, StoredParts


class StoredRestyling(Record, frozen=True):
    """The work as its files say it, and the lines that are selected."""

    work: RestyleFile
    selected: Many[Annotated[int, Meta(ge=0, le=100_000)]] = ()


class RestylePages(PageFormat[RestylePage, StoredRestyling]):
    """Lines and styles, whether they are complete or not."""

    stored = StoredRestyling

    def write(self, page: RestylePage, parts: Parts) -> StoredRestyling:
        """Return a page as it is stored."""
        return StoredRestyling(RestyleFile.of(page.work, parts.icon), tuple(sorted(page.selected)))

    def read(
        self, stored: StoredRestyling, parts: StoredParts
    ) -> Generator[Event, None, RestylePage]:
        """Return the page that was written."""
        yield from ()
        work = stored.work.resolved(parts.resources.icon)
        return RestylePage(work, frozenset(stored.selected))

    def alike(self, page: RestylePage, other: RestylePage) -> bool:
        """Whether the work is the same; to select lines is no edit."""
        return page == replace(other, selected=page.selected)
