"""Brings icons and edits onto the page of an edit."""

from collections.abc import Generator
from pathlib import Path
from typing import Any

from iconstudio.importing.importer import IconImporter, Opened
from iconstudio.inputs.together import ReadTogether
from iconstudio.model import Exemplar, Pictogram
from iconstudio.workflows.criteria import contradiction, with_known_icons
from iconstudio.workflows.editing import page
from iconstudio.workflows.editing.page import EditPage
from iconstudio.workflows.editing.spec import EDITING
from iconstudio.workflows.files import read_file


class EditImporter(IconImporter[EditPage]):
    """Puts an icon on the page, perhaps with areas, in place of the one that is there."""

    question = "Open an edit"
    kinds = "Edits"
    limit = "an edit has one icon"

    def opening(self, path: Path) -> Generator[Any]:
        """Yield the edit in a file."""
        edit = yield from read_file(path, EDITING, self.session)
        edit, remarks = with_known_icons(edit, self.session.icon)
        icon = self.session.exemplar(edit.icon)
        words = " ".join([_about(icon), *remarks, contradiction(edit)]).strip()
        yield Opened(words, lambda document: page.load(document, edit, icon))

    def beginning(self, icon: Exemplar) -> Generator[Opened]:
        """Yield the beginning of an edit of an icon that is drawn already."""
        keyword = self.session.keyword(icon.pictogram)
        yield Opened(_about(icon), lambda document: page.begin(document, icon, keyword))

    def drawn(self, pictogram: Pictogram) -> tuple[Exemplar, str]:
        """Return an icon, and what icons like it are looked for by."""
        icon = self.session.exemplar(pictogram)
        return icon, self.session.keyword(icon.pictogram)

    def put(self, gathered: ReadTogether) -> tuple[str]:
        """Start from an icon."""
        ((icon, keyword),) = gathered.found
        page.begin(self.document, icon, keyword)
        return (_about(icon),)


def _about(icon: Exemplar) -> str:
    return f"“{icon.pictogram.credit.title}” is on the canvas."
