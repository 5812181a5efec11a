"""The user's input for a montage: icons on one canvas, and scribbles on them (section 4.4)."""

from dataclasses import dataclass, field

from iconstudio.model.pictogram import Pictogram
from iconstudio.model.placement import Placement
from iconstudio.model.polygon import Point


@dataclass(frozen=True, slots=True)
class Stroke:
    """A scribble: a line of a width, both in canvas pixels; of one point, a dot."""

    width: float
    points: tuple[Point, ...]


@dataclass(frozen=True, slots=True)
class Layer:
    """An icon where the user put it, and the scribbles over the parts of it to keep."""

    icon: Pictogram
    placement: Placement = field(default_factory=Placement)
    strokes: tuple[Stroke, ...] = ()


@dataclass(frozen=True, slots=True)
class Montage:
    """The layers of a montage; their order has no meaning for the result."""

    layers: tuple[Layer, ...] = ()
