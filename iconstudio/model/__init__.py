"""Immutable values: what flows between the library, the algorithms and the window."""

from iconstudio.model.canvas import CANVAS, MARGIN
from iconstudio.model.composite import Composite, Drawing
from iconstudio.model.errors import IconstudioError
from iconstudio.model.exemplar import Exemplar, Frame
from iconstudio.model.pictogram import Credit, Pictogram
from iconstudio.model.placement import Placement, Source
from iconstudio.model.sketch import Point, Polygon, Sketch

__all__ = [
    "CANVAS",
    "MARGIN",
    "Composite",
    "Credit",
    "Drawing",
    "Exemplar",
    "Frame",
    "IconstudioError",
    "Pictogram",
    "Placement",
    "Point",
    "Polygon",
    "Sketch",
    "Source",
]
