"""The page of a workflow: what its user works on; how it is edited, and kept in projects."""

from collections.abc import Generator
from dataclasses import asdict
from typing import Annotated, Any, Generic, Protocol, Self, TypeVar

from msgspec import Meta

from iconstudio.inputs.formats import Record, Reference, Text, plain_text
from iconstudio.model import Credit, Exemplar, Icon, Photo, Pictogram, Placement
from iconstudio.workflows.workflow import Resources, Workflow


class Page(Protocol):
    """Everything that the edits of a workflow can change, as one immutable value."""

    def elsewhere(self, before: Self) -> bool:
        """Whether so much differs from ``before`` that the view should be fitted anew."""
        ...


P = TypeVar("P", bound=Page)
R = TypeVar("R", bound=Record)


class Document(Protocol[P]):
    """What holds a page, and keeps the way back."""

    @property
    def page(self) -> P:
        """What lies on the canvas now."""
        ...

    def change(self, text: str, after: P, gesture: object = None) -> None:
        """Replace the page, as one step that can be undone.

        ``text`` names the step. Neighbouring changes of the same ``gesture``, if it is not None,
        are one step.
        """
        ...

    def show(self, page: P) -> None:
        """Replace the page; that is no step."""
        ...


_Shift = Annotated[float, Meta(ge=-1e6, le=1e6)]
_Side = Annotated[int, Meta(ge=1, le=10_000_000)]


class StoredPlacement(Record, frozen=True, kw_only=True):
    """Where an icon lies, in a project file."""

    scale: Annotated[float, Meta(gt=0, le=1000)] = 1.0
    flip: bool = False
    dx: _Shift = 0
    dy: _Shift = 0

    @property
    def placement(self) -> Placement:
        """The value."""
        return Placement(self.scale, self.flip, round(self.dx), round(self.dy))


class StoredPhoto(Record, frozen=True):
    """A photo, in a project file; without a size, it has that of its image."""

    part: Text = ""
    width: _Side | None = None
    height: _Side | None = None


class StoredOrigin(Record, frozen=True):
    """An icon, and whom to thank for it."""

    id: Text = ""
    title: Text = ""
    author: Text = ""
    license: Text = ""
    license_url: Text = ""
    url: Text = ""

    @classmethod
    def of(cls, pictogram: Pictogram, **more: Any) -> Self:
        """Describe an icon."""
        texts = {"id": pictogram.id} | asdict(pictogram.credit)
        return cls(**{key: plain_text(text) for key, text in texts.items()}, **more)

    @property
    def credit(self) -> Credit:
        """Whom to thank."""
        return Credit(self.title, self.author, self.license, self.license_url, self.url)


class Parts(Protocol):
    """Takes in what the pages of a project refer to."""

    def icon(self, pictogram: Pictogram) -> Reference:
        """Take an icon in, and return the reference by which a page names it."""
        ...

    def photo(self, photo: Photo) -> StoredPhoto:
        """Take a photo in, and return what a page says of it."""
        ...

    def result(self, icon: Icon) -> str:
        """Take a result in, and return the name by which a page refers to it."""
        ...


class StoredParts(Protocol):
    """What the pages of a project refer to. What cannot be read raises IconstudioError."""

    complaints: list[str]
    """What could not be read, where the rest was; a sentence for the user each."""

    @property
    def resources(self) -> Resources:
        """The program's own, which know the icons of the project, too."""
        ...

    def icon(self, reference: str) -> Pictogram:
        """Return an icon that a page names."""
        ...

    def exemplar(self, pictogram: Pictogram) -> Exemplar:
        """Return an icon on the canvas; the same one for the same icon."""
        ...

    def photo(self, stored: StoredPhoto) -> Generator[None, None, Photo]:
        """Return the photo of which a page says this."""
        ...

    def results(self, names: tuple[str, ...]) -> Generator[None, None, tuple[Icon, ...]]:
        """Return those results that can be read; complain about the others."""
        ...


class PageFormat(Generic[P, R]):
    """Writes and reads the pages of one workflow, in whatever thread: pages are immutable.

    Whatever can be on a page is read back as it was, be it unfinished or no good.
    """

    stored: type[R]
    """What the JSON of a page says."""

    def __init__(self, workflow: Workflow[Any]) -> None:
        self.workflow = workflow

    def write(self, page: P, parts: Parts) -> R:
        """Return a page as it is stored; icons, photos and results go into ``parts``."""
        raise NotImplementedError

    def read(self, stored: R, parts: StoredParts) -> Generator[Any, None, P]:
        """Return the page that was written; yield progress, or None, where it can be stopped.

        Raises
        ------
        IconstudioError
            If it cannot be read.
        """
        raise NotImplementedError

    def kept(self, page: P) -> tuple[Icon, ...]:
        """Return the results that are kept on a page."""
        return ()

    def alike(self, page: P, other: P) -> bool:
        """Whether there is nothing on a page that would be lost with the other one in its place."""
        return page == other
