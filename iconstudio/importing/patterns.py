"""Brings icons, images and patterns onto the page of a pattern."""

from collections.abc import Callable, Generator
from pathlib import Path
from typing import Any

from iconstudio.images.reading import SUFFIXES
from iconstudio.importing.images import photo_in
from iconstudio.importing.importer import IconImporter, Opened
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


class PatternImporter(IconImporter[PatternPage]):
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
        words = " ".join([f"Opened “{file.title or path.stem}”.", *file.remarks, unheeded(work)])
        page = PatternPage(work)
        yield Opened(words.strip(), lambda there: there.change("open pattern", page))

    def alone(self, item: Item) -> Generator[Any] | None:
        """Yield an image of pixels as the exemplar, unless it is to be an icon for a shape."""
        if not isinstance(item, File | Image) or self.wants_shape():
            return None
        return self.image(item) if self.becomes_icon(item) else None

    def image(self, item: File | Image) -> Generator[Any]:
        """Yield an image as the exemplar; a file, whatever it is called."""
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

    def drawn(self, pictogram: Pictogram) -> Pictogram:
        """Return an icon that can be drawn."""
        self.session.exemplar(pictogram)
        return pictogram

    def put(self, gathered: ReadTogether) -> tuple[str, ...]:
        """Add icons, or fill a shape."""
        if self.wants_shape():
            shape, *left = gathered.found
            edits.set_fill(self.document, shape)
            self.shape_taken()
            filled = f"“{shape.credit.title}” is filled with the pattern."
            rest = "A pattern fills one shape: the first of those was taken."
            return (filled, rest) if left else (filled,)
        edits.add_icons(self.document, gathered.found)
        return (f"Added {quoted_list([one.credit.title for one in gathered.found])}.",)
