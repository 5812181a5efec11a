"""What lies on the canvas, layer by layer, each drawn by one function.

All draw in view coordinates (device-independent pixels).
"""

from collections.abc import Sequence

from PySide6.QtCore import QPointF, QRectF, Qt
from PySide6.QtGui import QColor, QFont, QPainter, QPainterPath, QPen, QPolygonF

from iconstudio.algorithms.geometry import simplified_line
from iconstudio.gui.canvas.camera import Camera
from iconstudio.gui.pictures.photo import mipmap_of
from iconstudio.gui.theme.theme import UNIT, Theme, strong
from iconstudio.model import CANVAS, MARGIN, Axis, Photo, Point

_SOLID = Qt.PenStyle.SolidLine

HINT_ROOM = 48.0
"""How high the lower end of the canvas is where hints are written, in pixels."""

OFFER_ROOM = 36.0
"""The same of the upper end, where something may be offered by a button."""

MANY = 500
"""An outline of more points is drawn with less care: nobody clicked them."""

REGION = 100.0
"""Side of a salient region in canvas pixels (section 3.2)."""

DETAIL = 40.0
"""The same of one of fine details."""

_ALONG = {
    Axis.HORIZONTAL: (0.0, 1.0),
    Axis.VERTICAL: (1.0, 0.0),
    Axis.DIAGONAL: (1.0, 1.0),
    Axis.ANTIDIAGONAL: (1.0, -1.0),
}
"""The way each axis runs."""


def paint_backdrop(painter: QPainter, area: QRectF, camera: Camera, theme: Theme) -> None:
    """Fill the canvas, with a faint lattice of dots that moves with the page."""
    painter.fillRect(area, theme.color("surface"))
    step = 16 * camera.zoom
    while step < 16:
        step *= 2
    while step > 32:
        step /= 2
    columns = range(int(area.width() / step) + 2)
    rows = range(int(area.height() / step) + 2)
    left, top = camera.x % step - step, camera.y % step - step
    painter.setPen(QPen(theme.color("border"), 1.6, _SOLID, Qt.PenCapStyle.RoundCap))
    painter.drawPoints(
        [QPointF(left + column * step, top + row * step) for column in columns for row in rows]
    )


def paint_photo(
    painter: QPainter, photo: Photo, dim: float, camera: Camera, ratio: float, theme: Theme
) -> None:
    """Draw the photo; ``dim`` from 0 (as it is) to 1 (gone)."""
    target = camera.transform.mapRect(QRectF(0, 0, photo.width, photo.height))
    image = mipmap_of(photo).at(target.width() * ratio)
    painter.setRenderHint(QPainter.RenderHint.SmoothPixmapTransform, camera.zoom * ratio < 4)
    painter.drawImage(target, image, QRectF(image.rect()))
    painter.fillRect(target, theme.color("surface", dim))


def paint_outline(
    painter: QPainter, vertices: Sequence[Point], closed: bool, camera: Camera, theme: Theme
) -> None:
    """Draw the outline, filled once it is closed; a pale rim keeps it visible on any photo."""
    if len(vertices) < 2:
        return
    path = outline_path(vertices, closed, camera)
    if closed:
        painter.fillPath(path, theme.color("accent", 0.18))
    join = outline_join(path)
    for color, width in ((theme.color("surface", 0.8), 5.0), (theme.color("accent"), 2.0)):
        painter.strokePath(path, QPen(color, width, _SOLID, Qt.PenCapStyle.RoundCap, join))


def outline_path(vertices: Sequence[Point], closed: bool, camera: Camera) -> QPainterPath:
    """Return an outline in view coordinates; one of very many points within half a pixel."""
    points = [camera.to_view(vertex) for vertex in vertices]
    if len(points) > MANY:
        line = [point.toTuple() for point in (points + points[:1] if closed else points)]
        points = [QPointF(*point) for point in simplified_line(line, 0.5)]
    path = QPainterPath()
    path.setFillRule(Qt.FillRule.WindingFill)
    path.addPolygon(QPolygonF(points))
    if closed:
        path.closeSubpath()
    return path


def outline_join(path: QPainterPath) -> Qt.PenJoinStyle:
    """Return how the corners of an outline are drawn: round ones take long if they are many."""
    few = path.elementCount() <= MANY
    return Qt.PenJoinStyle.RoundJoin if few else Qt.PenJoinStyle.BevelJoin


def paint_axis(painter: QPainter, axis: Axis, box: QRectF, camera: Camera, theme: Theme) -> None:
    """Draw the axis of symmetry of what fills ``box`` (page units), a little longer than that."""
    along = _ALONG[axis]
    half = 0.56 * max(box.width(), box.height()) * QPointF(*along)
    ends = [
        camera.to_view((end.x(), end.y())) for end in (box.center() - half, box.center() + half)
    ]
    for color, width in ((theme.color("surface", 0.8), 3.5), (theme.color("accent"), 1.5)):
        pen = QPen(color, width, _SOLID, Qt.PenCapStyle.FlatCap)
        pen.setDashPattern([9 / width, 6 / width])
        painter.setPen(pen)
        painter.drawLine(*ends)


def paint_regions(
    painter: QPainter,
    box: QRectF,
    centres: Sequence[Point],
    details: int,
    camera: Camera,
    theme: Theme,
) -> None:
    """Draw the salient regions of the outline that fills ``box``, the most salient first.

    The last ``details`` of them are small ones.
    """
    unit = max(box.width(), box.height()) / (CANVAS - 2 * MARGIN)
    middle = box.center().toTuple()
    painter.setFont(strong(_sized(11)))
    for number, (x, y) in enumerate(centres, start=1):
        centre = camera.to_view(
            (middle[0] + (x - CANVAS / 2) * unit, middle[1] + (y - CANVAS / 2) * unit)
        )
        side = REGION if number <= len(centres) - details else DETAIL
        radius = side / 2 * unit * camera.zoom
        painter.setPen(QPen(theme.color("accent", 0.55), 1, Qt.PenStyle.DashLine))
        painter.setBrush(theme.color("accent", 0.05))
        painter.drawEllipse(centre, radius, radius)
        badge = QRectF(centre.x() - 9, centre.y() - 9, 18, 18)
        painter.setPen(Qt.PenStyle.NoPen)
        painter.setBrush(theme.color("accent"))
        painter.drawEllipse(badge)
        painter.setPen(theme.color("on_accent"))
        painter.drawText(badge, Qt.AlignmentFlag.AlignCenter, str(number))


def paint_welcome(painter: QPainter, area: QRectF, heading: str, text: str, theme: Theme) -> None:
    """Say what to do first, above the middle: more lines of text begin higher up."""
    centre = area.center()
    wrapped = int(Qt.AlignmentFlag.AlignHCenter) | int(Qt.TextFlag.TextWordWrap)
    painter.setFont(_sized(14))

    def height(width: float) -> float:
        return painter.boundingRect(QRectF(0, 0, width, 1), wrapped, text).height()

    width = most = min(360.0, area.width() - 4 * UNIT)
    while width > most / 2 and height(width - UNIT) == height(most):
        width -= UNIT  # until its lines are about as long
    box = QRectF(centre.x() - width / 2, centre.y() - 64, width, 72)
    box.setTop(min(box.top(), box.bottom() - height(width)))
    painter.setPen(theme.color("muted"))
    painter.drawText(box, wrapped, text)
    painter.setPen(theme.color("text"))
    painter.setFont(strong(_sized(20)))
    box = QRectF(area.left(), box.top() - 40, area.width(), 32)
    painter.drawText(box, Qt.AlignmentFlag.AlignCenter, heading)


def paint_hint(painter: QPainter, area: QRectF, text: str, theme: Theme) -> None:
    """Write a short sentence in a pill at the bottom of the canvas."""
    painter.setFont(_sized(12))
    metrics = painter.fontMetrics()
    room = int(area.width() - 6 * UNIT)
    text = metrics.elidedText(text, Qt.TextElideMode.ElideRight, room)
    width = metrics.horizontalAdvance(text) + 3 * UNIT
    pill = QRectF(area.center().x() - width / 2, area.bottom() - HINT_ROOM + UNIT, width, 28)
    painter.setPen(Qt.PenStyle.NoPen)
    painter.setBrush(QColor(20, 20, 24, 215))
    painter.drawRoundedRect(pill, 14, 14)
    painter.setPen(QColor("#ffffff"))
    painter.drawText(pill, Qt.AlignmentFlag.AlignCenter, text)


def _sized(pixels: int) -> QFont:
    font = QFont()
    font.setPixelSize(pixels)
    return font
