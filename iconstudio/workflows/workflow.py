"""What a workflow declares, once: command line, files, examples and window are made of that."""

from collections.abc import Callable, Generator
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Concatenate, Generic, Protocol, Self, TypeVar

from iconstudio.inputs.formats import Reference, StrictRecord, Text
from iconstudio.loading import load_module
from iconstudio.model import Axis, Drawing, Exemplar, Line, Pictogram, Separation
from iconstudio.workers import Workers
from iconstudio.workflows.events import Event

W = TypeVar("W")


class Resources(Protocol):
    """What a run works with: a ``Session``, as far as workflows know it."""

    @property
    def workers(self) -> Workers:
        """The worker processes."""
        ...

    def icon(self, reference: str) -> Pictogram:
        """Return an icon of the collection, ``set:name``, or of a file."""
        ...

    def artwork(self, path: Path) -> Generator[Any, None, Separation]:
        """Return the image in a file, or an SVG drawing in its colours, with its credits."""
        ...

    def exemplar(self, pictogram: Pictogram) -> Exemplar:
        """Return an icon on the canvas."""
        ...

    def drawing(self, exemplar: Exemplar) -> Drawing:
        """Return an icon drawn and traced as results are."""
        ...

    def lines(self, pictogram: Pictogram) -> tuple[Line, ...]:
        """Return the lines of an icon on the canvas."""
        ...

    def retrieve(
        self, keyword: str, exclude: frozenset[str] = ...
    ) -> Generator[Event, None, tuple[Exemplar, ...]]:
        """Return a keyword's icons on the canvas, best first."""
        ...

    def choose(
        self, keyword: str, count: int, symmetry: Axis | None = ..., seed: int = ...
    ) -> Generator[Event, None, tuple[Pictogram, ...]]:
        """Return icons of a keyword that mix well; each seed another group of them."""
        ...


Find = Callable[[str], Pictogram]
"""Returns the icon of a reference."""
Refer = Callable[[Pictogram], Reference]
"""Returns the reference of an icon for a file, once it can be found there."""
Run = Callable[Concatenate[Any, W, ...], Generator[Event]]
"""Called with a ``Session``, the work, and the settings if the workflow has any."""


class File(StrictRecord, Generic[W], frozen=True, kw_only=True):
    """The file of some work: its fields are those of the JSON, their types what may be in them."""

    title: Text = ""
    workflow: Text = ""
    """The name of the workflow that it is of, in files that the program writes."""

    @classmethod
    def of(cls, work: W, refer: Refer) -> Self:
        """Return the file of some work; ``refer`` returns the references of its icons."""
        raise NotImplementedError

    @property
    def remarks(self) -> tuple[str, ...]:
        """What a user should know of how it is read."""
        return ()

    def resolved(self, find: Find) -> W:
        """Return the work, its icons found by ``find``."""
        raise NotImplementedError

    def resolving(self, resources: Resources) -> Generator[Event, None, W]:
        """Return the work; yield progress where that takes a while."""
        yield from ()
        return self.resolved(resources.icon)


@dataclass(frozen=True, kw_only=True, eq=False)
class Workflow(Generic[W]):
    """A way to make icons. Its work is an immutable value: what the results depend on."""

    name: str
    """Of its command, and of its work in files of several workflows."""
    title: str
    """On the switch of the window."""
    noun: str
    """What its work is called: “sketch”."""
    help: str
    """What its command does, in a sentence."""
    invitation: str = ""
    """The words that offer to send an icon to it; empty if it takes none."""
    opens_results: bool = False
    """Whether the sources of a result can be opened in it, as work that makes the result again: its
    workspace's opener has an ``open_result``."""
    file: type[File[W]]
    """The format of its files."""
    run: Run[W]
    """Makes icons of some work; yields events."""
    examples: str | None = None
    """Folder of its examples, in ``resources/examples``; None if there are none."""
    command: str = ""
    """``module:name`` of its command; empty: one that reads, runs and writes."""
    workspace: str = ""
    """``module:name`` of its class in the window; empty: one that collects icons, by the three
    functions below, and shows results."""
    page_format: str = "iconstudio.workflows.plain:WorkPages"
    """``module:name`` of the ``PageFormat`` that keeps its pages in projects."""
    inner_pictures: str = ""
    """``module:name`` of what returns the inner pictures of a page and its picked icon, if any."""
    work: Callable[[], W] | None = None
    """Returns the work to begin with."""
    icons: Callable[[W], tuple[Pictogram, ...]] = lambda work: ()
    """Returns the icons of some work."""
    with_icons: Callable[[W, tuple[Pictogram, ...]], W] | None = None
    """Returns the work with these icons in place of its own; None if it takes none."""

    def __post_init__(self) -> None:
        if not self.workspace and self.work is None:
            raise TypeError(f"{self.name}: without a workspace of its own, it must declare `work`")


def load_object(reference: str) -> Any:
    """Return what ``module:name`` names.

    >>> load_object("math:hypot")(3, 4)
    5.0
    """
    module, _, name = reference.partition(":")
    return getattr(load_module(module), name)


def lazily(reference: str) -> Callable[..., Any]:
    """Return a function that calls what ``module:name`` names, imported when it is first called."""

    def call(*args: Any) -> Any:
        return load_object(reference)(*args)

    return call
