"""Brings icons and files of work onto the page of any workflow."""

from collections.abc import Generator, Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any

from iconstudio.importing.importer import IconImporter, Opened
from iconstudio.inputs.together import ReadTogether, quoted_list
from iconstudio.model import Exemplar, IconstudioError, Pictogram
from iconstudio.session import Session
from iconstudio.workflows.events import Event
from iconstudio.workflows.files import read_file
from iconstudio.workflows.pages import Document
from iconstudio.workflows.plain import WorkPage
from iconstudio.workflows.workflow import Workflow


class WorkImporter(IconImporter[WorkPage]):
    """Adds icons to the work, or puts that of a file in place of it."""

    most = 1000
    limit = "there is no room for more"

    def __init__(
        self, workflow: Workflow[Any], session: Session, document: Document[WorkPage]
    ) -> None:
        super().__init__(session, document)
        self._workflow = workflow
        self.question = f"Open a file with a {workflow.noun}"
        self.kinds = f"{workflow.title} files"

    def opening(self, path: Path) -> Generator[Event | Opened]:
        """Yield the work in a file."""
        work = yield from read_file(path, self._workflow, self.session)
        for icon in self._workflow.icons(work):
            self.session.exemplar(icon)  # what cannot be drawn is told before it is on the page
        step = f"open {self._workflow.noun}"
        yield Opened(f"Opened “{path.stem}”.", lambda there: there.change(step, WorkPage(work)))

    def put(self, gathered: ReadTogether) -> tuple[str]:
        """Add icons to the work."""
        self.add_icons(gathered.found)
        return (f"Added {quoted_list(gathered.names)}.",)

    def add_icons(self, icons: Sequence[Exemplar]) -> None:
        """Add icons that are drawn already, in one step; those that are there stay as they are.

        Raises
        ------
        IconstudioError
            If the workflow takes none.
        """
        before = self._workflow.icons(self.document.page.work)
        after = tuple(dict.fromkeys((*before, *(icon.pictogram for icon in icons))))
        if after != before:
            self._change("add icon" if len(icons) == 1 else "add icons", after)

    def remove_icon(self, identifier: str) -> None:
        """Take an icon out."""
        before = self._workflow.icons(self.document.page.work)
        after = tuple(icon for icon in before if icon.id != identifier)
        if after != before:
            self._change("remove icon", after)

    def _change(self, text: str, icons: tuple[Pictogram, ...]) -> None:
        with_icons, page = self._workflow.with_icons, self.document.page
        if with_icons is None:
            raise IconstudioError(f"“{self._workflow.title}” takes no icons. Open a file instead.")
        self.document.change(text, replace(page, work=with_icons(page.work, icons)))
