"""Where the icons of a montage lie, and their colours, as Qt has them."""

from PySide6.QtCore import QPointF, QRectF
from PySide6.QtGui import QColor, QTransform

from iconstudio.model import Placement
from iconstudio.output.colours import numbered_colour
from iconstudio.workflows.montage.page import Box, PlacedIcon


def rect_of(box: Box) -> QRectF:
    """Return a box of the canvas."""
    left, top, right, bottom = box
    return QRectF(QPointF(left, top), QPointF(right, bottom))


def transform_of(placement: Placement) -> QTransform:
    """Return the mapping from an icon to the canvas (equation 4)."""
    return QTransform(*placement.transform)


def color_of(layer: PlacedIcon, density: float = 1.0) -> QColor:
    """Return the colour of a layer's strokes, and of its parts in the colour code."""
    color = QColor(*numbered_colour(layer.number))
    color.setAlphaF(density)
    return color
