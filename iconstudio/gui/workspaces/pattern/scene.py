"""The canvas of an exemplar: its motifs in their colours, or its image with its layers."""

import numpy as np
from PySide6.QtCore import QRectF, Qt
from PySide6.QtGui import QColor, QImage, QPainter, QPen

from iconstudio.gui.canvas.camera import Camera
from iconstudio.gui.canvas.outlines import IconOutlines
from iconstudio.gui.canvas.painters import paint_photo
from iconstudio.gui.canvas.scene import Scene
from iconstudio.gui.pictures.picture import rgba_image
from iconstudio.gui.theme.theme import Theme
from iconstudio.gui.workspaces.pattern.checks import checks
from iconstudio.gui.workspaces.pattern.motifs import MotifShapes, transform_of
from iconstudio.model import CANVAS, Motif
from iconstudio.output.colours import numbered_colour
from iconstudio.workflows.pattern.layering import ImageLayers
from iconstudio.workflows.pattern.page import PatternDocument, PatternPage

_OUTSIDE = 0.25
"""Opacity of what reaches out of the canvas: it is no part of the exemplar."""
_TINT = 0.55


class PatternScene(Scene):
    """Paints the exemplar."""

    welcome = (
        "Continue a few icons as a pattern",
        "Find icons below, or drop some here: they are scattered over the canvas. "
        "Or open an ornament, an image of flat colours.",
    )

    def __init__(self, document: PatternDocument, outlines: IconOutlines) -> None:
        super().__init__(document)
        self.shapes = MotifShapes(outlines)
        self._tints = QImage()
        self._tinted = True
        outlines.changed.connect(self.changed)

    @property
    def page(self) -> PatternPage:
        """What is shown."""
        return self.document.page

    @property
    def empty(self) -> bool:
        """Whether there is no exemplar."""
        return self.page.empty

    def bounds(self) -> QRectF:
        """Return the canvas of the motifs, or the image, whose unit is a pixel."""
        image = self.page.work.image
        if image is None:
            return super().bounds()
        return QRectF(0, 0, image.photo.width, image.photo.height)

    def show_layers(self, layers: ImageLayers | None) -> None:
        """Show where the layers of the image are."""
        self._tints = QImage() if layers is None else _tints(layers)
        self.changed.emit()

    def set_tinted(self, tinted: bool) -> None:
        """Tint the layers of the image, or not."""
        self._tinted = tinted
        self.changed.emit()

    def paint(self, painter: QPainter, camera: Camera, ratio: float, theme: Theme) -> None:
        """Draw the canvas with what lies on it."""
        if self.empty:
            return
        sheet = camera.transform.mapRect(self.bounds())
        image = self.page.work.image
        if image is not None:
            paint_photo(painter, image.photo, 0.0, camera, ratio, theme)
            if self._tinted and not self._tints.isNull():
                painter.drawImage(sheet, self._tints)
        else:
            ground = self.page.work.ground
            painter.fillRect(sheet, QColor(ground) if ground else checks())
            self._paint_motifs(painter, camera)
        painter.setPen(QPen(theme.color("border"), 1))
        painter.setBrush(Qt.BrushStyle.NoBrush)
        painter.drawRect(sheet)

    def _paint_motifs(self, painter: QPainter, camera: Camera) -> None:
        motifs = self.page.work.motifs
        painter.save()
        painter.setTransform(camera.transform, True)
        painter.setOpacity(_OUTSIDE)
        for motif in filter(self._reaches_out, motifs):
            self._paint(painter, motif)
        painter.setOpacity(1.0)
        painter.setClipRect(self.bounds())
        for motif in motifs:
            self._paint(painter, motif)
        painter.restore()

    def _reaches_out(self, motif: Motif) -> bool:
        return not self.bounds().contains(self.shapes.frame(motif).boundingRect())

    def _paint(self, painter: QPainter, motif: Motif) -> None:
        path = self.shapes.outline(motif)
        painter.save()
        painter.setTransform(transform_of(motif), True)
        color = QColor(motif.colour)
        if path is None:  # it is being traced
            color.setAlphaF(0.15)
            painter.setPen(Qt.PenStyle.NoPen)
            painter.setBrush(color)
            painter.drawRoundedRect(self.shapes.box(motif), CANVAS / 10, CANVAS / 10)
        else:
            painter.fillPath(path, color)
        painter.restore()


def tint(layer: int, alpha: float = 1.0) -> QColor:
    """Return the colour in which a layer is shown: not its own, so that it stands out."""
    color = QColor(*numbered_colour(layer - 1)) if layer else QColor("#ffffff")
    color.setAlphaF(alpha)
    return color


def _tints(layers: ImageLayers) -> QImage:
    """Return an image of the tints of all layers but the ground."""
    count = len(layers.colours)
    colours = [tint(number, _TINT if number else 0.0).getRgb() for number in range(count)]
    return rgba_image(np.array(colours, np.uint8)[layers.numbers])
