"""A window of the paper's inner pictures: the masks, positions and regions that guide a cut."""

import numpy as np
from PySide6.QtCore import QPointF, QRectF, QSize, Qt
from PySide6.QtGui import QColor, QImage, QPainter, QPaintEvent
from PySide6.QtWidgets import QDialog, QGridLayout, QLabel, QWidget

from iconstudio.gui.pictures.picture import stencil
from iconstudio.gui.theme import theme
from iconstudio.gui.theme.layout import column, label, scrolled
from iconstudio.gui.theme.painting import smooth_painter
from iconstudio.gui.theme.theme import UNIT, strong
from iconstudio.model import CANVAS
from iconstudio.workflows.inner_pictures import InnerPicture

_ACROSS = 3
_SIDE = 208
_RADIUS = 9.0


class InnerPicturesWindow(QDialog):
    """Shows inner pictures beside each other, and says what is missing if there are none."""

    def __init__(self, parent: QWidget) -> None:
        super().__init__(parent)
        self.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        self.setWindowTitle("Inner pictures")
        self.note = label(wordWrap=True)
        self.pictures: tuple[InnerPicture, ...] = ()
        self._holder = QWidget()
        self._grid = QGridLayout(self._holder)
        self._grid.setSpacing(2 * UNIT)
        area = scrolled(self._holder)
        column(self.note, (area, 1), of=self, spacing=UNIT, margins=(2 * UNIT,) * 4)
        self.resize(_ACROSS * (_SIDE + 2 * UNIT) + 6 * UNIT, _SIDE + 14 * UNIT)

    def show_pictures(self, pictures: tuple[InnerPicture, ...], missing: str) -> None:
        """Show pictures, or what is ``missing``, a sentence."""
        self.pictures = pictures
        self.note.setText("Dark is near 1, white is 0." if pictures else missing)
        while (item := self._grid.takeAt(0)) is not None:
            item.widget().deleteLater()
        for number, picture in enumerate(pictures):
            row, place = divmod(number, _ACROSS)
            self._grid.addWidget(InnerPictureView(picture), 2 * row, place)
            self._grid.addWidget(_title(picture), 2 * row + 1, place)
        self._grid.setRowStretch(2 * (len(pictures) // _ACROSS + 1), 1)


class InnerPictureView(QWidget):
    """One inner picture, with its positions numbered."""

    def __init__(self, picture: InnerPicture) -> None:
        super().__init__()
        self.picture = picture
        self.setAccessibleName(picture.title)
        self.setFixedSize(self.sizeHint())

    def sizeHint(self) -> QSize:
        """Return the size of all of them."""
        return QSize(_SIDE, _SIDE)

    def paintEvent(self, event: QPaintEvent) -> None:
        """Draw the values as shades on paper, and the positions above."""
        colours = theme.current()
        with smooth_painter(self) as painter:
            box = QRectF(self.rect())
            painter.fillRect(box, QColor("white"))
            painter.drawImage(box, _shaded(self.picture, QColor("#20304a")))
            painter.setPen(colours.color("border"))
            painter.drawRect(box.adjusted(0.5, 0.5, -0.5, -0.5))
            font = painter.font()
            font.setPixelSize(11)
            painter.setFont(strong(font))
            for number, point in enumerate(self.picture.positions, start=1):
                _paint_position(painter, QPointF(*point) * (_SIDE / CANVAS), number)


def _shaded(picture: InnerPicture, ink: QColor) -> QImage:
    levels = (255 * np.clip(picture.values, 0, 1)).astype(np.uint8)
    return stencil(np.ascontiguousarray(levels), ink)


def _paint_position(painter: QPainter, at: QPointF, number: int) -> None:
    badge = QRectF(at.x() - _RADIUS, at.y() - _RADIUS, 2 * _RADIUS, 2 * _RADIUS)
    painter.setPen(QColor("white"))
    painter.setBrush(theme.current().color("accent"))
    painter.drawEllipse(badge)
    painter.setPen(theme.current().color("on_accent"))
    painter.drawText(badge, Qt.AlignmentFlag.AlignCenter, str(number))


def _title(picture: InnerPicture) -> QLabel:
    title = label(picture.title, wordWrap=True)
    title.setFixedWidth(_SIDE)
    title.setAlignment(Qt.AlignmentFlag.AlignTop)
    return title
