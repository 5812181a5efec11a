"""The icons of a montage as they lie on the canvas, painted once and kept until they change."""

import math
import time
from collections.abc import Callable, Hashable, Sequence
from dataclasses import dataclass, replace
from functools import reduce

from PySide6.QtCore import QObject, QPoint, QPointF, QRect, QRectF, Qt, QTimer, Signal
from PySide6.QtGui import QColor, QImage, QPainter

from iconstudio.gui.canvas.camera import Camera
from iconstudio.gui.canvas.outlines import IconOutlines
from iconstudio.gui.pictures.picture import stencil
from iconstudio.gui.workspaces.montage.appearance import rect_of, transform_of
from iconstudio.workflows.montage.page import PlacedIcon

BUDGET = 0.008
"""Seconds after which painting a picture goes on later: the pointer must not wait for it."""

_REST = 100
"""Milliseconds without another zoom after which pictures are made for it."""

_ROUGH = 0.5
"""Pixels to each of the view, in pictures that stand in for a moment."""

_ROOM = 2
"""Pictures are no more than so many times as wide and high as the view: of larger icons, only what
is in sight is painted."""

Tinted = tuple[PlacedIcon, QColor]
Paint = Callable[[QPainter, PlacedIcon, QColor, Camera], None]


@dataclass(frozen=True, slots=True)
class _Sight:
    """What a picture is to show: layers that look so, in an area of what a camera sees."""

    looks: tuple[Hashable, ...]
    camera: Camera
    area: tuple[int, int, int, int]
    ratio: float

    def seen_by(self, camera: Camera) -> QRectF:
        """Return where the area lies for another camera."""
        grown = camera.zoom / self.camera.zoom
        area = QRectF(*self.area).translated(-self.camera.x, -self.camera.y)
        corner, size = area.topLeft() * grown, area.size() * grown
        return QRectF(corner + QPointF(camera.x, camera.y), size)

    def covers(self, other: "_Sight") -> bool:
        """Whether a picture of this one has all that one of the other would show."""
        ink = QRectF(*other.area).adjusted(2, 2, -2, -2)
        return self.looks == other.looks and self.seen_by(other.camera).contains(ink)


class _Picture:
    """A picture, painted as far as there was time."""

    def __init__(self, sight: _Sight, layers: Sequence[Tinted]) -> None:
        self.sight = sight
        self.seconds = 0.0
        """How long painting took so far."""
        self._left = list(layers)
        self._image: QImage | None = None

    @property
    def finished(self) -> bool:
        """Whether nothing is left to paint."""
        return not self._left

    def paint_on(self, paint: Paint, budget: float) -> None:
        """Paint on, layer by layer, for ``budget`` seconds, but one layer at least."""
        began, sight = time.perf_counter(), self.sight
        if self._image is None:
            size = (QRectF(*sight.area).size() * sight.ratio).toSize()
            self._image = QImage(size, QImage.Format.Format_ARGB32_Premultiplied)
            self._image.fill(Qt.GlobalColor.transparent)
        with QPainter(self._image) as painter:
            painter.setRenderHint(QPainter.RenderHint.Antialiasing)
            painter.scale(sight.ratio, sight.ratio)
            painter.translate(-sight.area[0], -sight.area[1])
            while self._left:
                paint(painter, *self._left.pop(0), sight.camera)
                if time.perf_counter() > began + budget:
                    break
        self.seconds += time.perf_counter() - began

    def draw(self, painter: QPainter, camera: Camera) -> None:
        """Draw the picture as ``camera`` sees it, in view coordinates."""
        place = self.sight.seen_by(camera)
        if camera.zoom == self.sight.camera.zoom:  # pixel on pixel
            place.moveTopLeft(QPointF(place.topLeft().toPoint()))
        painter.save()
        painter.setRenderHint(QPainter.RenderHint.SmoothPixmapTransform)
        painter.drawImage(place, self._image)
        painter.restore()


class LayerPainter(QObject):
    """Paints layers from outlines, or of pixels as long as there are none.

    Layers painted under the same name as before are painted as a picture, which is made anew only
    if one of them, or the zoom, is another; the page may have moved by whole pixels. If that takes
    long, the last picture stands in for it, scaled, or a rough one.

    Signals
    -------
    sharpened()
        Nothing is shown any more by what stood in for it.
    """

    sharpened = Signal()

    def __init__(self, outlines: IconOutlines, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._crisp = outlines
        self._shown: dict[str, _Picture] = {}
        self._begun: dict[str, _Picture] = {}
        self._timer = QTimer(self, singleShot=True)
        self._timer.timeout.connect(self._go_on)

    def paint(self, painter: QPainter, layer: PlacedIcon, color: QColor, camera: Camera) -> None:
        """Draw one layer in ``color``, in view coordinates."""
        path = self._crisp.outline(layer.icon.exemplar)
        if path is None:
            _paint_pixels(painter, layer, color, camera)
            return
        painter.save()
        painter.setTransform(transform_of(layer.placement) * camera.transform, True)
        painter.fillPath(path, color)
        painter.restore()

    def paint_all(
        self,
        name: str,
        painter: QPainter,
        layers: Sequence[Tinted],
        camera: Camera,
        ratio: float,
    ) -> None:
        """Draw layers, each in its colour; ``ratio`` is the pixels of the device to each."""
        if not layers:
            self._begun.pop(name, None)
            return
        origin = QPoint(math.floor(camera.x), math.floor(camera.y))
        near = replace(camera, x=camera.x - origin.x(), y=camera.y - origin.y())
        area = _area([one for one, _ in layers], near)
        view = painter.window()
        if area.width() > _ROOM * view.width() or area.height() > _ROOM * view.height():
            area &= view.translated(-origin)
        if not area.isEmpty():
            looks = tuple(map(self._look, layers))
            sight = _Sight(looks, near, area.getRect(), ratio)
            self._picture(name, sight, layers).draw(painter, camera)

    def _picture(self, name: str, sight: _Sight, layers: Sequence[Tinted]) -> _Picture:
        """Return the picture of a sight, or what stands in for it while it is made."""
        shown, begun = self._shown.get(name), self._begun.get(name)
        if shown is not None and shown.sight == sight:
            self._begun.pop(name, None)
            return shown
        zoomed = shown is not None and shown.sight.looks == sight.looks
        if begun is None or begun.sight != sight:
            begun = self._begun[name] = _Picture(sight, layers)
            if not (zoomed and shown.seconds > BUDGET):
                begun.paint_on(self.paint, BUDGET)
            if begun.finished:
                self._shown[name] = self._begun.pop(name)
                return begun
            self._timer.start(_REST if zoomed else 0)
        if shown is None or not shown.sight.covers(sight):
            shown = self._shown[name] = _Picture(replace(sight, ratio=_ROUGH), layers)
            shown.paint_on(_paint_pixels, math.inf)
            shown.seconds = math.inf
        return shown

    def _go_on(self) -> None:
        """Paint on what has begun; when all of it is finished, it is shown."""
        name, begun = next(iter(self._begun.items()), ("", None))
        if begun is not None:
            begun.paint_on(self.paint, BUDGET)
            if begun.finished:
                self._shown[name] = self._begun.pop(name)
        if self._begun:
            self._timer.start(0)
        else:
            self.sharpened.emit()

    def _look(self, layer: Tinted) -> Hashable:
        """Return what the picture of a layer depends on."""
        one, color = layer
        traced = self._crisp.outline(one.icon.exemplar) is not None
        return one.icon, one.placement, color.rgba(), traced


def _paint_pixels(painter: QPainter, layer: PlacedIcon, color: QColor, camera: Camera) -> None:
    """Draw one layer of its pixels, in view coordinates."""
    painter.save()
    painter.setTransform(transform_of(layer.placement) * camera.transform, True)
    painter.setOpacity(color.alphaF())
    painter.setRenderHint(QPainter.RenderHint.SmoothPixmapTransform)
    painter.drawImage(0, 0, stencil(layer.icon.exemplar.coverage, color))
    painter.restore()


def _area(layers: Sequence[PlacedIcon], camera: Camera) -> QRect:
    """Return what icons cover, in view coordinates, and a pixel around it."""
    boxes = (camera.transform.mapRect(rect_of(one.box)) for one in layers)
    return reduce(lambda one, other: one | other, boxes).toAlignedRect().adjusted(-1, -1, 1, 1)
