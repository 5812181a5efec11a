"""Bring icons, images and patterns onto the page."""

from collections.abc import Callable, Generator
from pathlib import Path
from typing import Any

from iconstudio.gui.exchange.opening import IconOpener, Opened
from iconstudio.gui.exchange.photos import photo_in
from iconstudio.gui.exchange.scanning import may_be_scan
from iconstudio.images.reading import SUFFIXES
from iconstudio.inputs.items import File, Image, Item
from iconstudio.inputs.together import ReadTogether, quoted_list
from iconstudio.model import IconstudioError, Pictogram, Separation, SpriteError
from iconstudio.workflows.files import open_file
from iconstudio.workflows.pattern import page as edits
from iconstudio.workflows.pattern.bounds import MOST_MOTIFS
from iconstudio.workflows.pattern.file import PatternFile
from iconstudio.workflows.pattern.page import PatternPage

DRAWINGS = ".svg", ".svgz"
IMAGES = f"Images ({' '.join(f'*.{one}' for one in (*SUFFIXES, 'svg', 'svgz'))})"


class PatternOpener(IconOpener):
    """Adds icons to the exemplar, lets an image be it, or puts the work of a file in its place.

    While ``wants_shape`` says so, the next icon is not added, but is the shape that is filled;
    then ``shape_taken`` is called.
    """

    question = "Open a pattern"
    kinds = "Patterns"
    most = MOST_MOTIFS
    limit = f"an exemplar takes at most {MOST_MOTIFS} icons"

    wants_shape: Callable[[], bool] = staticmethod(lambda: False)
    shape_taken: Callable[[], object] = staticmethod(lambda: None)

    def opening(self, path: Path) -> Generator[Any]:
        """Yield the work in a file."""
        from iconstudio.workflows.pattern.imaging import unheeded
        from iconstudio.workflows.pattern.patterning import check

        file = open_file(path, PatternFile)
        work = yield from file.resolving(self.session)
        check(work)
        words = " ".join(
            [f"Opened “{file.title or path.stem}”.", *file.remarks, unheeded(work)]
        ).strip()
        yield Opened(words, lambda there: there.change("open pattern", PatternPage(work)))

    def open_image(self, path: str) -> None:
        """Open a file as an image, whatever it is called."""
        self.replace(lambda: self._image(File(path)))

    def open_item(self, item: Item) -> None:
        """Open a single thing; an image of pixels becomes the exemplar, or an icon for a shape."""
        match item:
            case File(path) if may_be_scan(path) and not self.wants_shape():
                self.replace(lambda: self._image(item))
            case Image() if not self.wants_shape():
                self.replace(lambda: self._image(item))
            case _:
                super().open_item(item)

    def drawn(self, pictogram: Pictogram) -> Pictogram:
        """Return an icon that can be drawn."""
        self.session.exemplar(pictogram)
        return pictogram

    def put(self, gathered: ReadTogether) -> str:
        """Add icons, or fill a shape."""
        if self.wants_shape():
            shape, *left = gathered.found
            edits.set_fill(self.document, shape)
            self.shape_taken()
            if left:
                self.complain("A pattern fills one shape: the first of those was taken.")
            return f"“{shape.credit.title}” is filled with the pattern."
        edits.add_icons(self.document, gathered.found)
        return f"Added {quoted_list([one.credit.title for one in gathered.found])}."

    def _image(self, item: File | Image) -> Generator[Opened | None]:
        from iconstudio.workflows.pattern.imaging import check_size, reduction_of

        if isinstance(item, File) and item.path.lower().endswith(DRAWINGS):
            try:
                image = yield from self.session.artwork(Path(item.path))
            except SpriteError as error:
                advice = "Drop it on the canvas to choose a symbol as an icon."
                raise IconstudioError(f"{error.what} {advice}") from None
        else:
            image = Separation((yield from photo_in(self.session, item)))
        photo, credits = image.photo, image.credits
        check_size(photo)
        remarks = [reduction_of(photo), photo.remark, *(r for one in credits for r in one.remarks)]
        words = " ".join([f"“{item.name}” is the exemplar.", *filter(None, remarks)])
        yield Opened(words, lambda there: edits.take_image(there, photo, credits))
