"""The icons of a montage as they lie on the canvas, painted once and kept until they change."""

import math
from collections.abc import Hashable, Sequence
from dataclasses import dataclass, replace
from functools import reduce

from PySide6.QtCore import QPoint, QRect, Qt
from PySide6.QtGui import QColor, QImage, QPainter

from iconstudio.gui.canvas.camera import Camera
from iconstudio.gui.crisp import CrispIcons
from iconstudio.gui.pictures import stencil
from iconstudio.gui.workspaces.montage.page import PlacedIcon

_ROOM = 2
"""Pictures are no more than so many times as wide and high as the view: of larger icons, only what
is in sight is painted."""


@dataclass(frozen=True, slots=True)
class _Picture:
    key: Hashable
    area: QRect
    image: QImage


class LayerPainter:
    """Paints layers from outlines, or of pixels as long as there are none.

    Layers painted under the same name as before are painted as a picture, which is made anew only
    if one of them, or the zoom, is another; the page may have moved by whole pixels.
    """

    def __init__(self, crisp: CrispIcons) -> None:
        self._crisp = crisp
        self._pictures: dict[str, _Picture] = {}

    def paint(self, painter: QPainter, layer: PlacedIcon, color: QColor, camera: Camera) -> None:
        """Draw one layer in ``color``, in view coordinates."""
        icon = layer.icon.exemplar
        path = self._crisp.outline(icon)
        painter.save()
        painter.setTransform(layer.transform * camera.transform, True)
        if path is None:
            painter.setOpacity(color.alphaF())
            painter.setRenderHint(QPainter.RenderHint.SmoothPixmapTransform)
            painter.drawImage(0, 0, stencil(icon.coverage, color))
        else:
            painter.fillPath(path, color)
        painter.restore()

    def paint_all(
        self,
        name: str,
        painter: QPainter,
        layers: Sequence[tuple[PlacedIcon, QColor]],
        camera: Camera,
        ratio: float,
    ) -> None:
        """Draw layers, each in its colour; ``ratio`` is the pixels of the device to each."""
        if not layers:
            return
        origin = QPoint(math.floor(camera.x), math.floor(camera.y))
        camera = replace(camera, x=camera.x - origin.x(), y=camera.y - origin.y())
        area = _area([one for one, _ in layers], camera)
        view = painter.window()
        if area.width() > _ROOM * view.width() or area.height() > _ROOM * view.height():
            area &= view.translated(-origin)
        key = (camera, ratio, area.getRect(), tuple(map(self._look, layers)))
        picture = self._pictures.get(name)
        if picture is None or picture.key != key:
            picture = self._pictures[name] = _Picture(
                key, area, self._made(layers, camera, area, ratio)
            )
        painter.drawImage(area.topLeft() + origin, picture.image)

    def _look(self, layer: tuple[PlacedIcon, QColor]) -> Hashable:
        """Return what the picture of a layer depends on."""
        one, color = layer
        traced = self._crisp.outline(one.icon.exemplar) is not None
        return one.icon, one.placement, color.rgba(), traced

    def _made(
        self,
        layers: Sequence[tuple[PlacedIcon, QColor]],
        camera: Camera,
        area: QRect,
        ratio: float,
    ) -> QImage:
        image = QImage(area.size() * ratio, QImage.Format.Format_ARGB32_Premultiplied)
        image.setDevicePixelRatio(ratio)
        image.fill(Qt.GlobalColor.transparent)
        with QPainter(image) as painter:
            painter.setRenderHint(QPainter.RenderHint.Antialiasing)
            painter.translate(-area.topLeft())
            for layer, color in layers:
                self.paint(painter, layer, color, camera)
        return image


def _area(layers: Sequence[PlacedIcon], camera: Camera) -> QRect:
    """Return what icons cover, in view coordinates, and a pixel around it."""
    boxes = (camera.transform.mapRect(one.box) for one in layers)
    return reduce(lambda one, other: one | other, boxes).toAlignedRect().adjusted(-1, -1, 1, 1)
