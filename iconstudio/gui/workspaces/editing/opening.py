"""Bring icons and edits into the document."""

from collections.abc import Callable, Generator
from pathlib import Path

from iconstudio.gui.workspaces.editing import page
from iconstudio.gui.workspaces.opening import Opener
from iconstudio.inputs.edit import read_edit
from iconstudio.model import Edit, Exemplar, Pictogram


class EditOpener(Opener):
    """Puts an icon on the page, perhaps with areas, in place of the one that is there."""

    question = "Open an edit"
    kinds = "Edits"

    def open_work(self, path: str) -> None:
        """Open an edit file."""
        self.replace(lambda: self._read(Path(path)))

    def open_file(self, path: str) -> None:
        """Begin with an SVG file."""
        self.replace(lambda: self._begin(lambda: self.session.exemplar(self.session.icon(path))))

    def take(self, pictogram: Pictogram) -> None:
        """Begin with an icon."""
        self.replace(lambda: self._begin(lambda: self.session.exemplar(pictogram)))

    def take_exemplar(self, icon: Exemplar) -> None:
        """Begin with an icon that is drawn already."""
        self.replace(lambda: self._begin(lambda: icon))

    def put(self, found: tuple[Exemplar, str | Edit]) -> str:
        """Start from an icon that was found with its keyword, or from an edit."""
        match found:
            case (icon, Edit() as edit):
                page.load(self.document, edit, icon)
            case (icon, keyword):
                page.begin(self.document, icon, keyword)
        return f"“{icon.pictogram.credit.title}” is on the canvas."

    def _begin(self, find: Callable[[], Exemplar]) -> Generator[tuple[Exemplar, str]]:
        icon = find()
        yield icon, self.session.keyword(icon.pictogram)

    def _read(self, path: Path) -> Generator[tuple[Exemplar, Edit]]:
        edit = read_edit(path).resolved(self.session.icon)
        yield self.session.exemplar(edit.icon), edit
