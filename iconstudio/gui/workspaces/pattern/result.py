"""The pattern, large: once, or side by side with itself."""

from PySide6.QtCore import QPointF, QRectF, QSizeF, Signal
from PySide6.QtGui import QBrush, QImage, QPainter, QPainterPath, QPaintEvent, QTransform
from PySide6.QtWidgets import QButtonGroup, QFrame, QToolButton

from iconstudio.gui.gallery.large import LargePicture
from iconstudio.gui.pictures.picture import Picture, within
from iconstudio.gui.preferences import prefer, preferred
from iconstudio.gui.theme import theme
from iconstudio.gui.theme.layout import segments
from iconstudio.gui.theme.painting import fill_rounded, smooth_painter
from iconstudio.gui.theme.theme import UNIT
from iconstudio.gui.workspaces.pattern.checks import checks
from iconstudio.model import Patterned

TIMES = 3
"""How often a tile is seen at least, across and down."""
_TILED = "tiled"
"""Under which it is remembered whether patterns are shown side by side with themselves."""


class TiledSwitch(QFrame):
    """Two segments: one tile, and many.

    Signals
    -------
    changed(bool)
        Whether tiles are to be shown side by side.
    """

    changed = Signal(bool)

    def __init__(self) -> None:
        super().__init__()
        self.single, self.tiled = (
            QToolButton(text=text, toolTip=tip, checkable=True)
            for text, tip in (
                ("Single", "The pattern once, as it is saved"),
                ("Tiled", "The pattern side by side with itself, as a wallpaper"),
            )
        )
        group = QButtonGroup(self)
        for button in (self.single, self.tiled):
            group.addButton(button)
        segments(self, self.single, self.tiled)
        (self.tiled if self.on else self.single).setChecked(True)
        group.buttonClicked.connect(self._note)

    @property
    def on(self) -> bool:
        """Whether tiles are shown side by side."""
        return preferred(_TILED, True)

    def _note(self) -> None:
        prefer(_TILED, self.tiled.isChecked())
        self.changed.emit(self.tiled.isChecked())


class PatternView(LargePicture):
    """The pattern as large as fits; if it tiles and should, as a wallpaper of many tiles."""

    def __init__(self, switch: TiledSwitch) -> None:
        super().__init__(wide=True)
        self._tiled = switch.on
        self._image = QImage()
        self._of: object = None
        self.setAccessibleName("The pattern")
        switch.changed.connect(self.set_tiled)

    @property
    def tiles(self) -> bool:
        """Whether tiles are in sight."""
        icon = self._picture.icon if self._picture else None
        return self._tiled and isinstance(icon, Patterned) and icon.tile

    def set_tiled(self, tiled: bool) -> None:
        """Show tiles side by side, or one."""
        self._tiled = tiled
        self.update()

    def paintEvent(self, event: QPaintEvent) -> None:
        """Draw the pattern on a sheet with round corners."""
        picture = self._picture
        if picture is None:
            return
        ratio, area = self.devicePixelRatioF(), QRectF(self.rect())
        times = TIMES if self.tiles else 1
        size = QSizeF(*picture.icon.size)
        one = within(size, QRectF(0, 0, area.width() / times, area.height() / times))
        image = self._drawn(picture, one.size() * ratio)
        # From pixel to pixel of the screen, so that all tiles are alike.
        one.setSize(QSizeF(image.size()) / ratio)
        one.moveCenter(area.center())
        one.moveTopLeft(QPointF((one.topLeft() * ratio).toPoint()) / ratio)
        sheet = area if self.tiles else one
        with smooth_painter(self) as painter:
            shape = QPainterPath()
            shape.addRoundedRect(sheet, UNIT, UNIT)
            painter.setOpacity(self.paling.opacity)
            painter.fillPath(shape, checks())
            brush = QBrush(image)
            place = QTransform.fromTranslate(one.x(), one.y())
            brush.setTransform(place.scale(1 / ratio, 1 / ratio))
            painter.fillPath(shape, brush)
            if picture.preview:
                _paint_dots(painter, sheet)

    def _drawn(self, picture: Picture, size: QSizeF) -> QImage:
        ink = theme.current().color("text")
        of = picture, size, ink.name()
        if self._of != of:
            self._image, self._of = picture.rendered(size, ink), of
        return self._image


def _paint_dots(painter: QPainter, area: QRectF) -> None:
    """Say “to be continued”."""
    scheme = theme.current()
    pill = QRectF(0, 0, 34, 16)
    pill.moveBottomRight(area.bottomRight() - QPointF(UNIT, UNIT))
    fill_rounded(painter, pill, scheme.color("surface", 0.85), 8)
    painter.setBrush(scheme.color("muted"))
    for number in (-1, 0, 1):
        painter.drawEllipse(pill.center() + QPointF(8 * number, 0), 2, 2)
