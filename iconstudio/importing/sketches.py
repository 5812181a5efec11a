"""Brings photos and sketches onto the page of a sketch."""

from collections.abc import Generator
from functools import partial
from pathlib import Path

from iconstudio.images.reading import SUFFIXES
from iconstudio.importing.images import photo_in
from iconstudio.importing.importer import Importer, Opened
from iconstudio.inputs.items import Drawing, File, Image, Item
from iconstudio.inputs.together import ReadTogether
from iconstudio.model import IconstudioError, Photo
from iconstudio.workflows.criteria import contradiction, with_known_icons
from iconstudio.workflows.modelling import page
from iconstudio.workflows.modelling.file import SketchFile, read_sketch
from iconstudio.workflows.modelling.page import SketchPage
from iconstudio.workflows.registry import taking_icons

PHOTOS = f"Photos ({' '.join(f'*.{one}' for one in SUFFIXES)})"


class SketchImporter(Importer[SketchPage]):
    """Puts a photo under the drawing, or a sketch in its place."""

    question = "Open a sketch"
    kinds = "Sketches"
    other = "photo"
    forms = "a file or an image"
    images_first = True
    limit = "a sketch has one photo"

    def opening(self, path: Path) -> Generator[Opened | None]:
        """Yield the sketch in a file, with the photo that it names."""
        return self.resolving(read_sketch(path))

    def resolving(self, file: SketchFile) -> Generator[Opened | None]:
        """Yield a sketch with its photo; if only the photo is missing, none, and then say so."""
        photo, trouble = None, None
        if file.photo is not None:
            try:
                photo = yield from photo_in(self.session, File(str(file.photo)))
            except IconstudioError as error:
                trouble = error
        sketch, step = file.resolved(self.session.icon), "open sketch"
        sketch, remarks = with_known_icons(sketch, self.session.icon)
        put = partial(page.load_sketch, sketch=sketch, photo=photo, text=step)
        words = " ".join([f"Opened “{file.title}”.", *remarks, contradiction(sketch)]).strip()
        yield Opened(words, put)
        if trouble is not None:
            raise IconstudioError(f"The sketch was opened without its photo: {trouble}")

    def reading(self, item: Item) -> Generator[None, None, Photo]:
        """Return a photo: of a file, or from the clipboard or a drop."""
        if isinstance(item, File | Image):
            return (yield from photo_in(self.session, item))
        raise IconstudioError(
            "A sketch is traced over a photo, not over a drawing. "
            f"Open {_quoted(item)} in {taking_icons()}."
        )

    def put(self, gathered: ReadTogether) -> tuple[str]:
        """Show a photo."""
        (photo,) = gathered.found
        page.set_photo(self.document, photo)
        return (_about(photo),)


def _quoted(item: Item) -> str:
    return "the drawing" if isinstance(item, Drawing) else f"“{item.name}”"


def _about(photo: Photo) -> str:
    size = f"{photo.width:,} × {photo.height:,} pixels"
    kept = ", shown smaller" if photo.scaled_down else ""
    return f"Photo opened ({size}{kept}). {photo.remark}".rstrip()
