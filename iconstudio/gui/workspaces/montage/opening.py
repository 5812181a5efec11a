"""Bring icons and montages onto the canvas, and save montages."""

from collections.abc import Generator
from dataclasses import dataclass
from pathlib import Path

from iconstudio.gui.exchange.opening import IconOpener
from iconstudio.inputs.together import ReadTogether, quoted_list
from iconstudio.model import IconstudioError, Pictogram
from iconstudio.workflows.montage.file import read_montage
from iconstudio.workflows.montage.montage import MOST
from iconstudio.workflows.montage.page import Icon, MontagePage

_OVERLAP = (
    "Where scribbles over two icons overlapped, those of the upper icon were kept: "
    "a pixel can come from one icon only."
)


@dataclass(frozen=True, slots=True)
class OpenedMontage:
    """A montage from a file of that name."""

    title: str
    page: MontagePage


class MontageOpener(IconOpener):
    """Adds icons on top, or puts a montage in place of what is there."""

    question = "Open a montage"
    kinds = "Montages"
    most = MOST
    limit = f"a montage takes at most {MOST} icons"

    def open_work(self, path: str) -> None:
        """Put the montage of a file in place of what is there."""
        self.replace(lambda: self._read_montage(Path(path)))

    def drawn(self, pictogram: Pictogram) -> Icon:
        """Return an icon to be added."""
        return Icon(super().drawn(pictogram))

    def put(self, found: OpenedMontage) -> str:
        """Show a montage."""
        self.document.change("open montage", found.page)
        return f"Opened “{found.title}”."

    def put_all(self, gathered: ReadTogether) -> str:
        """Add icons on top, as many as there is room for."""
        page, icons = self.document.page, gathered.found
        room = max(1, MOST - len(page.layers))  # with no room at all, the page itself says so
        after = page.with_icons(icons[:room])
        self.document.change("add icon" if len(icons[:room]) == 1 else "add icons", after)
        if left := gathered.names[room:]:
            self.complain(self.no_room(gathered.names[:room], left))
        return f"Added {quoted_list([one.title for one in after.layers[len(page.layers) :]])}."

    def _read_montage(self, path: Path) -> Generator[OpenedMontage]:
        file = read_montage(path)
        layers = file.resolved(self.session.icon).layers
        page = MontagePage.of(layers, [Icon(self.session.exemplar(one.icon)) for one in layers])
        yield OpenedMontage(file.title or path.stem, page)
        if [one.strokes for one in page.layers] != [one.strokes for one in layers]:
            raise IconstudioError(_OVERLAP)
