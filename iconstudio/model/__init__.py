"""Immutable values: what flows between the library, the algorithms and the window."""

from iconstudio.model.canvas import CANVAS, MARGIN
from iconstudio.model.colour import hex_colour, levels_of
from iconstudio.model.composite import Composite, Drawing
from iconstudio.model.edit import Edit
from iconstudio.model.errors import BitmapError, IconstudioError, SpriteError
from iconstudio.model.exemplar import Exemplar, Frame
from iconstudio.model.icon import ColouredLayer, Fill, Icon, Patterned, Remix, Restyled
from iconstudio.model.inner import Inner
from iconstudio.model.line import Line
from iconstudio.model.line_style import LineStyle, StylePair
from iconstudio.model.mix import Mix, Seeds
from iconstudio.model.montage import Layer, Montage, Stroke
from iconstudio.model.path import Contour, Path, PathPen, Transform
from iconstudio.model.patterning import Correction, Motif, Patterning, Separation
from iconstudio.model.photo import Photo
from iconstudio.model.pictogram import Credit, Pictogram
from iconstudio.model.placement import Placement, Source
from iconstudio.model.polygon import Point, Polygon
from iconstudio.model.restyling import Restyling
from iconstudio.model.score import Score
from iconstudio.model.sketch import Sketch
from iconstudio.model.symmetry import Axis

__all__ = [
    "CANVAS",
    "MARGIN",
    "Axis",
    "BitmapError",
    "ColouredLayer",
    "Composite",
    "Contour",
    "Correction",
    "Credit",
    "Drawing",
    "Edit",
    "Exemplar",
    "Fill",
    "Frame",
    "Icon",
    "IconstudioError",
    "Inner",
    "Layer",
    "Line",
    "LineStyle",
    "Mix",
    "Montage",
    "Motif",
    "Path",
    "PathPen",
    "Patterned",
    "Patterning",
    "Photo",
    "Pictogram",
    "Placement",
    "Point",
    "Polygon",
    "Remix",
    "Restyled",
    "Restyling",
    "Score",
    "Seeds",
    "Separation",
    "Sketch",
    "Source",
    "SpriteError",
    "Stroke",
    "StylePair",
    "Transform",
    "hex_colour",
    "levels_of",
]
