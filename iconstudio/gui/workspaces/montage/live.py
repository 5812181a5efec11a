"""The montage as it is made again and again: what is wanted, and the picture of it."""

from collections.abc import Generator
from dataclasses import dataclass

from iconstudio.gui.pictures.picture import Picture, pictured
from iconstudio.model import Montage, Remix
from iconstudio.output.colours import Palette, numbered_colour
from iconstudio.session import Session
from iconstudio.workflows.events import Event
from iconstudio.workflows.montage.page import MontagePage
from iconstudio.workflows.montage.spec import MONTAGE

TITLE = "montage"
"""What results are called in files."""


@dataclass(frozen=True, slots=True)
class Request:
    """A montage, and the colours of its layers."""

    montage: Montage
    palette: Palette

    @classmethod
    def of(cls, page: MontagePage) -> "Request":
        """Return what is wanted of a page."""
        colours = {
            (one.icon.pictogram.id, one.placement): numbered_colour(one.number)
            for one in page.layers
        }
        return cls(page.montage(), colours)


def made(session: Session, request: Request) -> Generator[Event | Picture]:
    """Return a run, its result as a picture in the colours of the layers."""
    return pictured(
        session.run(MONTAGE, request.montage),
        TITLE,
        colours=lambda icon: _coloured(request, icon),
    )


def _coloured(request: Request, icon: Remix) -> Palette:
    """Return the colours of an icon's sources, which may lie elsewhere than their layers."""
    from iconstudio.output.colours import key_of

    pairs = zip(icon.composite.sources, request.montage.layers, strict=True)
    palette = request.palette
    return {key_of(source): palette[layer.icon.id, layer.placement] for source, layer in pairs}
