"""Bring icons and edits into the document."""

from collections.abc import Generator
from pathlib import Path

from iconstudio.gui.exchange.opening import IconOpener
from iconstudio.model import Edit, Exemplar, Pictogram
from iconstudio.workflows.editing import page
from iconstudio.workflows.editing.spec import EDITING
from iconstudio.workflows.files import read_file


class EditOpener(IconOpener):
    """Puts an icon on the page, perhaps with areas, in place of the one that is there."""

    question = "Open an edit"
    kinds = "Edits"
    limit = "an edit has one icon"

    def open_work(self, path: str) -> None:
        """Open an edit file."""
        self.replace(lambda: self._read_edit(Path(path)))

    def take_exemplar(self, icon: Exemplar) -> None:
        """Begin with an icon that is drawn already."""
        self.replace(lambda: self._begin(icon))

    def drawn(self, pictogram: Pictogram) -> tuple[Exemplar, str]:
        """Return an icon, and what icons like it are looked for by."""
        return self._with_keyword(super().drawn(pictogram))

    def put(self, found: tuple[Exemplar, str | Edit]) -> str:
        """Start from an icon that was found with its keyword, or from an edit."""
        match found:
            case (icon, Edit() as edit):
                page.load(self.document, edit, icon)
            case (icon, keyword):
                page.begin(self.document, icon, keyword)
        return f"“{icon.pictogram.credit.title}” is on the canvas."

    def _with_keyword(self, icon: Exemplar) -> tuple[Exemplar, str]:
        return icon, self.session.keyword(icon.pictogram)

    def _begin(self, icon: Exemplar) -> Generator[tuple[Exemplar, str]]:
        yield self._with_keyword(icon)

    def _read_edit(self, path: Path) -> Generator[tuple[Exemplar, Edit]]:
        edit = yield from read_file(path, EDITING, self.session)
        yield self.session.exemplar(edit.icon), edit
