"""The canvas of an edit: what of the icon stays, what goes (red), and what comes (green)."""

from PySide6.QtCore import QRectF, Qt
from PySide6.QtGui import QPainter, QPainterPath, QPen

from iconstudio.gui.canvas import painters
from iconstudio.gui.canvas.areas import TOKENS, paint_inner
from iconstudio.gui.canvas.camera import Camera
from iconstudio.gui.canvas.outlines import IconOutlines
from iconstudio.gui.canvas.scene import Scene
from iconstudio.gui.pictures.picture import stencil
from iconstudio.gui.theme.theme import UNIT, Theme
from iconstudio.model import CANVAS, MARGIN, Exemplar
from iconstudio.workflows.areas import Area, Kind
from iconstudio.workflows.editing.page import EditDocument

_SHEET = QRectF(0, 0, CANVAS, CANVAS)
_BODY = _SHEET.adjusted(MARGIN, MARGIN, -MARGIN, -MARGIN)
"""Where the icon lies."""


class EditScene(Scene):
    """Paints the icon under the areas: of pixels until its outline is there."""

    def __init__(self, document: EditDocument, outlines: IconOutlines) -> None:
        super().__init__(document)
        self._crisp = outlines
        outlines.changed.connect(self.changed)

    def bounds(self) -> QRectF:
        """Return the area to show: the icon's canvas, and room below for the hint."""
        return _SHEET.adjusted(0, 0, 0, 3 * UNIT)

    def paint(self, painter: QPainter, camera: Camera, ratio: float, theme: Theme) -> None:
        """Draw the layers from back to front."""
        page = self.document.page
        if page.icon is None:
            return
        sheet = camera.transform.mapRect(_SHEET)
        painter.setPen(QPen(theme.color("border"), 1))
        painter.setBrush(theme.color("surface"))
        painter.drawRoundedRect(sheet, UNIT, UNIT)
        removed = [area for area in page.areas if area.kind is Kind.REMOVE]
        added = [area for area in page.areas if area.kind is Kind.ADD]
        gone = _union(removed, camera)
        self._paint_icon(painter, page.icon, gone, camera, theme)
        for area in removed:
            _paint_area(painter, area, camera, theme, Qt.PenStyle.DashLine, 0.07)
        for area in added:
            _paint_area(painter, area, camera, theme, Qt.PenStyle.SolidLine, 0.35)
        paint_inner(painter, page.areas, camera, theme)
        if page.symmetry is not None:
            painters.paint_axis(painter, page.symmetry, _BODY, camera, theme)

    def _paint_icon(
        self, painter: QPainter, icon: Exemplar, gone: QPainterPath, camera: Camera, theme: Theme
    ) -> None:
        """Draw the icon, and red what of it lies in the area ``gone``."""
        sheet = camera.transform.mapRect(_SHEET)
        everywhere = QPainterPath()
        everywhere.addRect(sheet.adjusted(-1, -1, 1, 1))
        path = self._crisp.outline(icon)
        for part, color, density in (
            (everywhere - gone, theme.color("text"), 0.62),
            (gone, theme.color("danger"), 0.5),
        ):
            painter.save()
            painter.setOpacity(density)
            painter.setClipPath(part)
            if path is None:
                painter.setRenderHint(QPainter.RenderHint.SmoothPixmapTransform)
                painter.drawImage(sheet, stencil(icon.coverage, color))
            else:
                painter.setTransform(camera.transform, True)
                painter.fillPath(path, color)
            painter.restore()


def _union(areas: list[Area], camera: Camera) -> QPainterPath:
    """Return what finished areas cover, in view coordinates."""
    union = QPainterPath()
    for area in areas:
        if area.closed:
            union = union.united(painters.outline_path(area.vertices, True, camera))
    return union


def _paint_area(
    painter: QPainter,
    area: Area,
    camera: Camera,
    theme: Theme,
    style: Qt.PenStyle,
    density: float,
) -> None:
    path = painters.outline_path(area.vertices, area.closed, camera)
    if area.closed:
        painter.fillPath(path, theme.color(TOKENS[area.kind], density))
    cap, join = Qt.PenCapStyle.FlatCap, painters.outline_join(path)
    rim = QPen(theme.color("surface", 0.8), 4.0, Qt.PenStyle.SolidLine, cap, join)
    painter.strokePath(path, rim)
    painter.strokePath(path, QPen(theme.color(TOKENS[area.kind]), 1.8, style, cap, join))
