"""Brings icons and montages onto the canvas of a montage."""

from collections.abc import Generator
from pathlib import Path

from iconstudio.grammar import counted
from iconstudio.importing.importer import IconImporter, Opened
from iconstudio.inputs.together import ReadTogether, quoted_list
from iconstudio.model import IconstudioError, Pictogram, Remix
from iconstudio.workflows.montage.file import read_montage
from iconstudio.workflows.montage.montage import MOST
from iconstudio.workflows.montage.page import IconShape, MontagePage
from iconstudio.workflows.montage.reproducing import reproduction

_OVERLAP = (
    "Where scribbles over two icons overlapped, those of the upper icon were kept: "
    "a pixel can come from one icon only."
)


class MontageImporter(IconImporter[MontagePage]):
    """Adds icons on top, or puts a montage in place of what is there."""

    question = "Open a montage"
    kinds = "Montages"
    most = MOST
    limit = f"a montage takes at most {MOST} icons"

    def opening(self, path: Path) -> Generator[Opened]:
        """Yield the montage in a file, and say so if not all of its strokes could be kept."""
        file = read_montage(path)
        layers = file.resolved(self.session.icon).layers
        page = MontagePage.of(
            layers, [IconShape(self.session.exemplar(one.icon)) for one in layers]
        )
        words = " ".join([f"Opened “{file.title or path.stem}”.", *file.remarks])
        yield Opened(words, lambda document: document.change("open montage", page))
        if [one.strokes for one in page.layers] != [one.strokes for one in layers]:
            raise IconstudioError(_OVERLAP)

    def reproducing(self, result: Remix) -> Generator[Opened]:
        """Yield the sources of a result, marked so that it comes again."""
        composite = result.composite
        drawn = {one.exemplar.id: one.exemplar for one in composite.sources}
        layers = reproduction(composite).layers
        page = MontagePage.of(layers, [IconShape(drawn[one.icon.id]) for one in layers])
        words = f"Opened the {counted(len(layers), 'source')} of “{result.title}”."
        yield Opened(words, lambda document: document.change("open result", page))

    def drawn(self, pictogram: Pictogram) -> IconShape:
        """Return an icon to be added."""
        return IconShape(self.session.exemplar(pictogram))

    def put(self, gathered: ReadTogether) -> tuple[str, ...]:
        """Add icons on top, as many as there is room for."""
        page, icons = self.document.page, gathered.found
        room = max(1, MOST - len(page.layers))  # with no room at all, the page itself says so
        after = page.with_icons(icons[:room])
        self.document.change("add icon" if len(icons[:room]) == 1 else "add icons", after)
        added = f"Added {quoted_list([one.title for one in after.layers[len(page.layers) :]])}."
        left = gathered.names[room:]
        return (added, self.no_room(gathered.names[:room], left)) if left else (added,)
