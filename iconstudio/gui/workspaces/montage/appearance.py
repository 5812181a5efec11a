"""Where the icons of a montage lie, and their colours, as Qt has them."""

from PySide6.QtCore import QPointF, QRectF
from PySide6.QtGui import QColor, QTransform

from iconstudio.model import Placement
from iconstudio.output.colours import Palette, numbered_colour
from iconstudio.workflows.montage.page import Box, MontagePage, PlacedIcon


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


def palette_of(page: MontagePage) -> Palette:
    """Return the colour of each icon at its placement, for the colour code."""
    return {
        (one.icon.pictogram.id, one.placement): numbered_colour(one.number) for one in page.layers
    }
