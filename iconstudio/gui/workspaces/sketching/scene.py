"""The canvas of the sketch, layer by layer: photo, outline, symmetry axis, salient regions."""

from collections.abc import Sequence

from PySide6.QtCore import QRectF
from PySide6.QtGui import QPainter

from iconstudio.gui.canvas import painters
from iconstudio.gui.canvas.areas import paint_inner
from iconstudio.gui.canvas.camera import Camera
from iconstudio.gui.canvas.scene import Scene
from iconstudio.gui.theme.theme import Theme
from iconstudio.model import CANVAS, Point
from iconstudio.workflows.modelling.page import SketchDocument


class SketchScene(Scene):
    """Paints the sketch over its photo."""

    welcome = (
        "Open a photo, or just start drawing",
        "Click around an object to trace its outline, and name it below: "
        "new icons are put together from parts of real ones.",
    )

    def __init__(self, document: SketchDocument) -> None:
        super().__init__(document)
        self._dim = 0.35
        self._regions: Sequence[Point] = ()
        self._details = 0

    @property
    def empty(self) -> bool:
        """Whether there is neither photo nor outline."""
        return self.document.page.empty

    def bounds(self) -> QRectF:
        """Return the area to show: the photo, the outline with some air, or an empty canvas."""
        page = self.document.page
        if page.photo is not None:
            return QRectF(0, 0, page.photo.width, page.photo.height)
        sheet = QRectF(0, 0, 2 * CANVAS, 2 * CANVAS)
        if len(page.vertices) < 3:
            return sheet
        left, top, right, bottom = page.sketch.polygon.bounds
        size = max(right - left, bottom - top)
        outline = QRectF(left, top, right - left, bottom - top)
        if sheet.contains(outline) and size > CANVAS / 2:
            return sheet
        air = size / 8
        return outline.adjusted(-air, -air, air, air)

    def set_dim(self, percent: int) -> None:
        """Fade the photo: 0 shows it as it is, 100 hides it."""
        self._dim = percent / 100
        self.changed.emit()

    def set_regions(self, centres: Sequence[Point], details: int = 0) -> None:
        """Show the salient regions at these centres (canvas pixels); none hides them.

        The last ones, so many, are small ones of details.
        """
        self._regions, self._details = centres, details
        self.changed.emit()

    def paint(self, painter: QPainter, camera: Camera, ratio: float, theme: Theme) -> None:
        """Draw the layers from back to front."""
        page = self.document.page
        if page.photo is not None:
            painters.paint_photo(painter, page.photo, self._dim, camera, ratio, theme)
        painters.paint_outline(painter, page.vertices, page.closed, camera, theme)
        paint_inner(painter, page.areas, camera, theme)
        if len(page.vertices) < 3:
            return
        left, top, right, bottom = page.sketch.polygon.bounds
        box = QRectF(left, top, right - left, bottom - top)
        if page.sketch.symmetry is not None:
            painters.paint_axis(painter, page.sketch.symmetry, box, camera, theme)
        if self._regions and page.closed:
            painters.paint_regions(painter, box, self._regions, self._details, camera, theme)
