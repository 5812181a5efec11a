"""How the page of a workspace is written into a project, and read from one."""

from collections.abc import Generator
from typing import Any, Generic, TypeVar

from iconstudio.gui.document.document import Page
from iconstudio.gui.gallery.pictures import Picture, picture_of
from iconstudio.inputs.fields import Fields
from iconstudio.model import IconstudioError
from iconstudio.project.parts import Parts, StoredParts
from iconstudio.workflows.workflow import Workflow

P = TypeVar("P", bound=Page)


class PageFormat(Generic[P]):
    """Writes and reads pages of one workspace, in whatever thread: pages are immutable.

    Whatever can be on a page is read back as it was, be it unfinished or no good.
    """

    def __init__(self, workflow: Workflow) -> None:
        self.workflow = workflow

    def write(self, page: P, parts: Parts) -> dict[str, Any]:
        """Return a page as JSON; icons, photos and results go into ``parts``."""
        raise NotImplementedError

    def read(self, fields: Fields, parts: StoredParts) -> Generator[Any, None, P]:
        """Return the page that was written; yield progress, or None, where it can be stopped.

        Raises
        ------
        IconstudioError
            If it cannot be read.
        """
        raise NotImplementedError

    def alike(self, page: P, other: P) -> bool:
        """Whether there is nothing on a page that would be lost with the other one in its place."""
        return page == other


def pictures_in(
    names: tuple[str, ...], parts: StoredParts, side: int | None = None
) -> Generator[None, None, tuple[Picture, ...]]:
    """Return results that were picked; what is no good of them is told.

    ``side`` is that of the colour-coded pictures, in pixels.
    """
    found = []
    for name in names:
        try:
            found.append(picture_of(parts.result(name), side))
        except IconstudioError as error:
            parts.complaints.append(f"A result that was picked could not be read. {error}")
        yield
    return tuple(found)
