"""A montage in a project file."""

from collections.abc import Generator
from dataclasses import asdict, replace
from typing import Annotated, Self

from msgspec import Meta

from iconstudio.inputs.formats import Many, Points, Record, Text
from iconstudio.model import CANVAS, IconstudioError, Stroke
from iconstudio.workflows.montage.montage import MOST
from iconstudio.workflows.montage.page import IconShape, MontagePage, PlacedIcon
from iconstudio.workflows.pages import PageFormat, Parts, StoredParts, StoredPlacement


class StoredStroke(Record, frozen=True):
    """A scribble; of one point, a dot."""

    width: Annotated[float, Meta(gt=0, le=2 * CANVAS)]
    points: Points

    @classmethod
    def of(cls, stroke: Stroke) -> Self:
        """Return a stroke as it is stored."""
        return cls(stroke.width, stroke.points)

    @property
    def stroke(self) -> Stroke:
        """The value."""
        return Stroke(self.width, self.points)

    def check(self) -> None:
        """Refuse what is nowhere."""
        if not self.points:
            raise IconstudioError("The stroke has no point.")


class StoredLayer(StoredPlacement, frozen=True, kw_only=True):
    """An icon where it lies."""

    number: Annotated[int, Meta(ge=0, le=MOST - 1)]
    icon: Text
    hidden: bool = False
    strokes: Many[StoredStroke] = ()


class StoredMontage(Record, frozen=True):
    """The page of a montage."""

    chosen: Annotated[int, Meta(ge=-1, le=MOST - 1)] = -1
    layers: Many[StoredLayer] = ()

    def check(self) -> None:
        """Refuse two layers of one number."""
        if len({one.number for one in self.layers}) < len(self.layers):
            raise IconstudioError("Two layers have the same number.")


class MontagePages(PageFormat[MontagePage, StoredMontage]):
    """The icons from back to front, wherever they lie, with all their strokes."""

    stored = StoredMontage

    def write(self, page: MontagePage, parts: Parts) -> StoredMontage:
        """Return a page as it is stored."""
        layers = (
            StoredLayer(
                number=one.number,
                icon=parts.icon(one.icon.pictogram),
                hidden=one.hidden,
                strokes=tuple(map(StoredStroke.of, one.strokes)),
                **asdict(one.placement),
            )
            for one in page.layers
        )
        return StoredMontage(page.chosen, tuple(layers))

    def read(self, stored: StoredMontage, parts: StoredParts) -> Generator[None, None, MontagePage]:
        """Return the page that was written."""
        layers = []
        for one in stored.layers:
            icon = IconShape(parts.exemplar(parts.icon(one.icon)))
            strokes = tuple(each.stroke for each in one.strokes)
            layers.append(PlacedIcon(one.number, icon, one.placement, strokes, one.hidden))
            yield
        return MontagePage(tuple(layers), stored.chosen)

    def alike(self, page: MontagePage, other: MontagePage) -> bool:
        """Whether the layers are the same; to choose one of them is no edit."""
        return page == replace(other, chosen=page.chosen)
