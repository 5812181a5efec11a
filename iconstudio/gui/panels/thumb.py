"""A finished icon as a small button: in the strip of recent results and among favourites."""

from PySide6.QtCore import QEvent, QPoint, QRectF, QSize, Qt
from PySide6.QtGui import QEnterEvent, QMouseEvent, QPainter, QPaintEvent, QPen, QPixmap
from PySide6.QtWidgets import QAbstractButton, QApplication, QWidget

from iconstudio.gui import theme
from iconstudio.gui.dragging import drag
from iconstudio.gui.pictures import Picture
from iconstudio.gui.theme import UNIT


class PictureThumb(QAbstractButton):
    """Shows a result; a click picks it, and it can be dragged to where icons are used.

    Actions that are added to it are its context menu.
    """

    def __init__(self, picture: Picture, title: str, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.picture = picture
        self.title = title
        self._pressed: QPoint | None = None
        self.setFixedSize(self.sizeHint())
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        self.setContextMenuPolicy(Qt.ContextMenuPolicy.ActionsContextMenu)
        self.setAccessibleName(title)
        self.setToolTip(title)

    def sizeHint(self) -> QSize:
        """Return the size of every thumb."""
        return QSize(7 * UNIT, 7 * UNIT)

    def mousePressEvent(self, event: QMouseEvent) -> None:
        """Remember where a drag may begin."""
        left = event.button() is Qt.MouseButton.LeftButton
        self._pressed = event.position().toPoint() if left else None
        super().mousePressEvent(event)

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        """Begin to drag the icon once the pointer has moved far enough."""
        super().mouseMoveEvent(event)
        if self._pressed is None or not event.buttons() & Qt.MouseButton.LeftButton:
            return
        distance = (event.position().toPoint() - self._pressed).manhattanLength()
        if distance >= QApplication.startDragDistance():
            self._pressed = None
            self.setDown(False)
            self._drag()

    def enterEvent(self, event: QEnterEvent) -> None:
        """Show that it can be picked."""
        super().enterEvent(event)
        self.update()

    def leaveEvent(self, event: QEvent) -> None:
        """Stop showing that it can be picked."""
        super().leaveEvent(event)
        self.update()

    def changeEvent(self, event: QEvent) -> None:
        """Draw again in the new colours."""
        super().changeEvent(event)
        if event.type() == QEvent.Type.PaletteChange:
            self.update()

    def paintEvent(self, event: QPaintEvent) -> None:
        """Draw the icon, framed when the pointer or the keyboard is at it."""
        look = theme.current()
        with QPainter(self) as painter:
            painter.setRenderHint(QPainter.RenderHint.Antialiasing)
            box = QRectF(self.rect()).adjusted(2, 2, -2, -2)
            if self.underMouse() or self.hasFocus():
                focused = QPen(look.color("accent"), 1.5)
                painter.setPen(focused if self.hasFocus() else Qt.PenStyle.NoPen)
                painter.setBrush(look.color("sunken"))
                painter.drawRoundedRect(box, 6, 6)
            self.picture.paint(painter, box, look.color("text"), coded=False)

    def _drag(self) -> None:
        from iconstudio.output.svg import pictogram_of

        ratio = self.devicePixelRatioF()
        image = QPixmap(self.size() * ratio)
        image.setDevicePixelRatio(ratio)
        image.fill(Qt.GlobalColor.transparent)
        with QPainter(image) as painter:
            ink = theme.current().color("text")
            self.picture.paint(painter, QRectF(self.rect()), ink, coded=False)
        result = self.picture.result
        drag(pictogram_of(result.composite, result.drawing, self.title), image, self)
