"""What lies on the canvas of a montage, and its edits."""

from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property

import numpy as np

from iconstudio.model import (
    CANVAS,
    Exemplar,
    IconstudioError,
    Layer,
    Montage,
    Pictogram,
    Placement,
    Point,
    Stroke,
)
from iconstudio.workflows.montage.montage import MOST
from iconstudio.workflows.montage.strokes import carried, cut, near_canvas, visible
from iconstudio.workflows.pages import Document

Box = tuple[float, float, float, float]
"""Left, top, right and bottom, in canvas pixels."""


@dataclass(frozen=True, eq=False)
class IconShape:
    """An icon on the canvas, before it is placed."""

    exemplar: Exemplar

    @property
    def pictogram(self) -> Pictogram:
        """The icon itself."""
        return self.exemplar.pictogram

    @cached_property
    def box(self) -> Box:
        """The tight box of its ink, in canvas pixels."""
        ink = self.exemplar.ink
        rows, columns = (np.flatnonzero(ink.any(axis=axis)) for axis in (1, 0))
        if not len(rows):
            return 0, 0, CANVAS, CANVAS
        return float(columns[0]), float(rows[0]), float(columns[-1] + 1), float(rows[-1] + 1)

    def placed_box(self, placement: Placement) -> Box:
        """Return the tight box of its ink where it lies."""
        left, top, right, bottom = self.box
        (x1, y1), (x2, y2) = placement.transform.transformPoints([(left, top), (right, bottom)])
        return min(x1, x2), min(y1, y2), max(x1, x2), max(y1, y2)


@dataclass(frozen=True, slots=True)
class PlacedIcon:
    """A layer as the window shows it: ``number`` names it on its page, and gives its colour."""

    number: int
    icon: IconShape
    placement: Placement = field(default_factory=Placement)
    strokes: tuple[Stroke, ...] = ()
    hidden: bool = False

    @property
    def title(self) -> str:
        """What to call it."""
        name = self.icon.pictogram.name
        return name.partition(":")[2] if name == self.icon.pictogram.id else name

    @property
    def box(self) -> Box:
        """The tight box of its ink where it lies."""
        return self.icon.placed_box(self.placement)

    def inks(self, point: Point) -> bool:
        """Whether there is ink within a pixel of a point of the canvas."""
        x, y = map(int, self.placement.transform.inverse().transformPoint(point))
        near = self.icon.exemplar.ink[max(0, y - 1) : max(0, y + 2), max(0, x - 1) : max(0, x + 2)]
        return bool(near.any())


@dataclass(frozen=True, slots=True)
class MontagePage:
    """Icons from back to front, and the number of the one that is worked on."""

    layers: tuple[PlacedIcon, ...] = ()
    chosen: int = -1

    @classmethod
    def of(cls, layers: Sequence[Layer], icons: Sequence[IconShape]) -> "MontagePage":
        """Return the page of ``layers``; where strokes of two icons overlap, the upper one's stay.

        ``icons`` are theirs, drawn.
        """
        page = cls().with_icons(icons)
        for layer, one in zip(layers, page.layers, strict=True):
            page = page.placed(one.number, layer.placement).drawn(one.number, layer.strokes)
        return page

    @property
    def current(self) -> PlacedIcon | None:
        """The layer that is worked on; None only if there is none at all."""
        top = self.layers[-1] if self.layers else None
        return next((one for one in self.layers if one.number == self.chosen), top)

    def found(self, point: Point) -> PlacedIcon | None:
        """Return the topmost icon with ink at a point; else the chosen, else any, whose box it is.

        A hidden icon is found only if it is the chosen one.
        """
        current = self.current
        shown = [one for one in reversed(self.layers) if not one.hidden or one is current]
        boxed = [one for one in shown if _contains(one.box, point)]
        inked = [one for one in shown if one.inks(point)]
        return next(iter(inked or ([current] if current in boxed else boxed)), None)

    @property
    def marked(self) -> bool:
        """Whether something is marked, so that a montage can be made."""
        return any(visible(stroke) for layer in self.layers for stroke in layer.strokes)

    def elsewhere(self, before: "MontagePage") -> bool:
        """Whether the view should be fitted anew: if a canvas is filled that was empty."""
        return bool(self.layers) and not before.layers

    def montage(self) -> Montage:
        """Return what is to be joined.

        An icon all of whose strokes are off the canvas waits: they count when it comes back.
        """
        layers = []
        for one in sorted(self.layers, key=lambda one: one.number):
            near = tuple(part for stroke in one.strokes for part in near_canvas(stroke))
            strokes = near if any(map(visible, near)) else ()
            layers.append(Layer(one.icon.pictogram, one.placement, strokes))
        return Montage(tuple(layers))

    # -- other pages ---------------------------------------------------------------------------

    def with_icons(self, icons: Iterable[IconShape]) -> "MontagePage":
        """Return the page with icons on top, the last one chosen.

        Raises
        ------
        IconstudioError
            If there are more than a montage can have.
        """
        page = self
        for icon in icons:
            if len(page.layers) >= MOST:
                raise IconstudioError(
                    f"A montage takes at most {MOST} icons. Delete one that is not needed first."
                )
            taken = {one.number for one in page.layers}
            number = next(n for n in range(MOST) if n not in taken)
            page = MontagePage((*page.layers, PlacedIcon(number, icon)), number)
        return page

    def without(self, number: int) -> "MontagePage":
        """Return the page without a layer; its neighbour is chosen."""
        at = self.index(number)
        layers = self.layers[:at] + self.layers[at + 1 :]
        chosen = layers[min(at, len(layers) - 1)].number if layers else -1
        return MontagePage(layers, chosen if number == self.chosen else self.chosen)

    def ordered(self, number: int, at: int) -> "MontagePage":
        """Return the page with a layer at another height, 0 being the back."""
        layer = self.layers[self.index(number)]
        others = [one for one in self.layers if one is not layer]
        others.insert(at, layer)
        return replace(self, layers=tuple(others))

    def placed(self, number: int, placement: Placement) -> "MontagePage":
        """Return the page with an icon elsewhere. Its strokes go along, and cut the others'."""
        layer = self.layers[self.index(number)]
        strokes = tuple(carried(one, layer.placement, placement) for one in layer.strokes)
        return self._laid(replace(layer, placement=placement, strokes=strokes), strokes)

    def drawn(self, number: int, strokes: Sequence[Stroke]) -> "MontagePage":
        """Return the page with more strokes over an icon. They cut the others'."""
        layer = self.layers[self.index(number)]
        return self._laid(replace(layer, strokes=(*layer.strokes, *strokes)), strokes)

    def erased(self, rubber: Sequence[Stroke], number: int | None = None) -> "MontagePage":
        """Return the page without what ``rubber`` touches of the strokes of one icon, or of all."""
        return self._cut(rubber, lambda one: number in (None, one.number))

    def hidden(self, number: int, hidden: bool) -> "MontagePage":
        """Return the page with an icon hidden or not."""
        return self._with(replace(self.layers[self.index(number)], hidden=hidden))

    def cleared(self) -> "MontagePage":
        """Return the page without any strokes."""
        return replace(self, layers=tuple(replace(one, strokes=()) for one in self.layers))

    def index(self, number: int) -> int:
        """Return the height of a layer, 0 being the back."""
        return next(at for at, one in enumerate(self.layers) if one.number == number)

    def _laid(self, layer: PlacedIcon, strokes: Sequence[Stroke]) -> "MontagePage":
        page = self._with(layer)
        return page._cut(strokes, lambda one: one.number != layer.number)

    def _with(self, layer: PlacedIcon) -> "MontagePage":
        layers = tuple(layer if one.number == layer.number else one for one in self.layers)
        return replace(self, layers=layers)

    def _cut(
        self, knives: Sequence[Stroke], concerned: Callable[[PlacedIcon], bool]
    ) -> "MontagePage":
        layers = tuple(
            replace(one, strokes=cut(one.strokes, knives)) if concerned(one) else one
            for one in self.layers
        )
        return replace(self, layers=layers)


MontageDocument = Document[MontagePage]


def choose(document: MontageDocument, number: int) -> None:
    """Work on another icon. That is no edit: undo gives back what was chosen before an edit."""
    document.show(replace(document.page, chosen=number))


def _contains(box: Box, point: Point) -> bool:
    left, top, right, bottom = box
    return left <= point[0] <= right and top <= point[1] <= bottom
