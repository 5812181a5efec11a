"""Brings icons, restylings and line styles onto the page of line styles."""

from collections.abc import Callable, Generator
from pathlib import Path
from typing import Any

from iconstudio.importing.importer import IconImporter, Opened
from iconstudio.inputs.together import ReadTogether
from iconstudio.model import Pictogram
from iconstudio.workflows.files import open_file
from iconstudio.workflows.line_style import page as edits
from iconstudio.workflows.line_style.file import RestyleFile
from iconstudio.workflows.line_style.learning import is_written, style_in
from iconstudio.workflows.line_style.page import RestylePage
from iconstudio.workflows.line_style.restyling import said_of

STYLES = "Line styles (*.json *.svg)"


class RestyleImporter(IconImporter[RestylePage]):
    """Puts an icon on the page in place of the one that is there, or the work of a file."""

    question = "Open a restyling"
    kinds = "Restylings"
    limit = "the lines of one icon are restyled at a time"

    def opening(self, path: Path) -> Generator[Any]:
        """Yield the work in a file."""
        file = open_file(path, RestyleFile)
        work = yield from file.resolving(self.session)
        if work.icon is not None:
            self.session.lines(work.icon)  # what has none is told before it is on the page
        pale = said_of(self.session, work.icon) if work.icon is not None else ""
        words = " ".join(
            filter(None, [f"Opened “{file.title or path.stem}”.", *file.remarks, pale])
        )
        page = RestylePage(work)
        yield Opened(words, lambda there: there.change("open restyling", page))

    def opening_style(self, path: Path, note: Callable[[Path], object]) -> Generator[Opened]:
        """Yield a style that is learned from a file: JSON, or the lines of a drawing.

        ``note`` is called with the file if it is one of a style.
        """
        remarks: list[str] = []
        style = style_in(self.session, str(path), remarks.append)
        words = " ".join([f"Opened the style “{style.name}”.", *remarks])
        yield Opened(words, lambda there: edits.set_style(there, style))
        if is_written(str(path)):
            note(path)

    def drawn(self, pictogram: Pictogram) -> tuple[Pictogram, str]:
        """Return an icon that has lines, and what they do not show of it."""
        self.session.lines(pictogram)
        return pictogram, said_of(self.session, pictogram)

    def put(self, gathered: ReadTogether) -> tuple[str]:
        """Restyle an icon's lines."""
        ((icon, remark),) = gathered.found
        edits.take_icon(self.document, icon)
        return (f"“{icon.credit.title}” is on the canvas. {remark}".rstrip(),)
