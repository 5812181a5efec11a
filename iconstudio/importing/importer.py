"""What all pages have in common when something is brought onto them."""

from collections.abc import Callable, Generator, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Generic

from iconstudio.grammar import was
from iconstudio.importing.images import is_called_image, pictogram_in
from iconstudio.inputs.items import Drawing, File, Image, Item, Reference
from iconstudio.inputs.together import ReadTogether, Sprite, quoted_list
from iconstudio.model import IconstudioError, Pictogram
from iconstudio.session import Session
from iconstudio.workflows.pages import Document, P


@dataclass(frozen=True, slots=True)
class Opened:
    """Something that was opened: what to tell the user, once it is on the page."""

    words: str
    put: Callable[[Document[Any]], Sequence[str] | None]
    """Puts it there, by one command; may return what else to tell."""


class Importer(Generic[P]):
    """What can be brought onto the page of a workflow, and how.

    A subclass says in ``opening`` what is in a file of its own. Other things, which may be given
    together, are read each by ``reading``, and put on the page together by ``put``. All that reads
    yields now and then, where it can be stopped; ``put`` is called where the document lives.
    """

    question: str = ""
    """Asks for a file of the workflow's own, “Open a sketch”."""
    kinds: str = ""
    """What such files are called, “Sketches”."""
    other: str = "drawing"
    """What else can be opened."""
    forms: str = "a file, a drawing or its markup"
    """In what forms it can be dropped or pasted."""
    images_first: bool = False
    """Whether an image of pixels is wanted rather than a drawing of the same."""
    most: int = 1
    """How many things the page has room for."""
    limit: str = ""
    """Why there is no room for more, “an edit has one icon”."""

    def __init__(self, session: Session, document: Document[P]) -> None:
        self.session = session
        self.document = document

    def opening(self, path: Path) -> Generator[Any]:
        """Yield what is in a file of the workflow's own as ``Opened``.

        Raises
        ------
        IconstudioError
            If it cannot be opened here.
        """
        raise NotImplementedError

    def becomes_icon(self, item: Item) -> bool:
        """Whether an icon is made of a single thing while the user looks on."""
        return False

    def alone(self, item: Item) -> Generator[Any] | None:
        """Yield what a single thing is as ``Opened``; None if it is read like several."""
        return None

    def reading(self, item: Item) -> Generator[Any, None, Any]:
        """Return what ``put`` puts on the page.

        Raises
        ------
        IconstudioError
            If it cannot be opened here.
        """
        raise NotImplementedError

    def put(self, gathered: ReadTogether) -> tuple[str, ...]:
        """Put all that was read on the page.

        Returns
        -------
        What to tell the user: what is there now, and then what is not, if anything.

        Raises
        ------
        IconstudioError
            If there is no room for it.
        """
        raise NotImplementedError

    def symbol(self, sprite: Sprite, name: str) -> Pictogram:
        """Return a symbol of a sprite sheet that was opened."""
        raise NotImplementedError

    def no_room(self, taken: Sequence[str], left: Sequence[Item | str]) -> str:
        """Return the sentence that says for what there was no room."""
        if self.most == 1:
            return f"Only “{taken[0]}” was opened, not {quoted_list(left)}: {self.limit}."
        return f"{quoted_list(left)} {was(left)} not added: {self.limit}."


class IconImporter(Importer[P]):
    """Reads icons: those of the collection, files, and markup; of images, they are traced."""

    def becomes_icon(self, item: Item) -> bool:
        """Whether a thing is an image of pixels, or is called so."""
        return isinstance(item, Image) or (isinstance(item, File) and is_called_image(item.path))

    def reading(self, item: Item) -> Generator[Any, None, Any]:
        """Return an icon, drawn."""
        return self.drawn((yield from self._pictogram(item)))

    def drawn(self, pictogram: Pictogram) -> Any:
        """Return what is put on the page for an icon."""
        return self.session.exemplar(pictogram)

    def symbol(self, sprite: Sprite, name: str) -> Pictogram:
        """Return a symbol of a sprite sheet that was opened."""
        match sprite.item:
            case Drawing(data, title):
                return self.session.icon_from(data, title, name)
            case File(reference) | Reference(reference):
                return self.session.icon(f"{reference}#{name}")
        raise _unusable(sprite.item)

    def _pictogram(self, item: Item) -> Generator[Any, None, Pictogram]:
        match item:
            case Pictogram() as pictogram:
                return pictogram
            case File(name) | Reference(name):
                return self.session.icon(name)
            case Drawing(data, name):
                return self.session.icon_from(data, name)
            case Image(source, name):
                return (yield from pictogram_in(self.session, source, name))
        raise _unusable(item)


def _unusable(item: Item) -> IconstudioError:
    return IconstudioError(f"“{item.name}” is nothing that can be used here.")
