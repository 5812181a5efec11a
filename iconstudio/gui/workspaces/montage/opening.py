"""Bring icons and montages onto the canvas, and save montages."""

from collections.abc import Callable, Generator, Sequence
from dataclasses import dataclass
from pathlib import Path

from iconstudio.gui.workspaces.montage.page import Icon, MontagePage
from iconstudio.gui.workspaces.opening import Opener
from iconstudio.inputs.icons import reference_to
from iconstudio.inputs.montage import LayerFile, MontageFile, read_montage, write_montage
from iconstudio.model import IconstudioError, Layer, Pictogram

_OVERLAP = (
    "Where scribbles over two icons overlapped, those of the upper icon were kept: "
    "a pixel can come from one icon only."
)


@dataclass(frozen=True, slots=True)
class Opened:
    """A montage from a file of that name."""

    title: str
    page: MontagePage


class MontageOpener(Opener):
    """Adds icons on top, or puts a montage in place of what is there."""

    question = "Open a montage"
    kinds = "Montages"

    def take(self, pictogram: Pictogram) -> None:
        """Add an icon on top."""
        self.add(lambda: self._drawn(lambda: pictogram))

    def open_file(self, path: str) -> None:
        """Add the icon of an SVG file on top."""
        self.add(lambda: self._drawn(lambda: self.session.icon(path)))

    def open_work(self, path: str) -> None:
        """Put the montage of a file in place of what is there."""
        self.replace(lambda: self._read(Path(path)))

    def put(self, found: Icon | Opened) -> str:
        """Add an icon, or show a montage."""
        if isinstance(found, Opened):
            self.document.change("open montage", found.page)
            return f"Opened “{found.title}”."
        self.document.change("add icon", self.document.page.with_icons([found]))
        return f"Added “{self.document.page.current.title}”."

    def _drawn(self, find: Callable[[], Pictogram]) -> Generator[Icon]:
        yield Icon(self.session.exemplar(find()))

    def _read(self, path: Path) -> Generator[Opened]:
        file = read_montage(path)
        layers = file.resolved(self.session.icon).layers
        page = page_of(layers, [Icon(self.session.exemplar(one.icon)) for one in layers])
        yield Opened(file.title or path.stem, page)
        if [one.strokes for one in page.layers] != [one.strokes for one in layers]:
            raise IconstudioError(_OVERLAP)


def page_of(layers: Sequence[Layer], icons: Sequence[Icon]) -> MontagePage:
    """Return a page with ``layers``; where strokes of two icons overlap, the upper one's stay."""
    page = MontagePage().with_icons(icons)
    for layer, one in zip(layers, page.layers, strict=True):
        page = page.placed(one.number, layer.placement).drawn(one.number, layer.strokes)
    return page


def write_page(path: Path, page: MontagePage) -> None:
    """Write a montage; icons that are not the collection's go into SVG files beside it.

    Raises
    ------
    IconstudioError
        If a file cannot be written.
    """
    layers = page.montage().layers
    files = (LayerFile(reference_to(one.icon, path), one.placement, one.strokes) for one in layers)
    write_montage(path, MontageFile(tuple(files)))
