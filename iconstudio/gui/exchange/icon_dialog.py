"""A dialog in which an icon is made or chosen while a picture of it is in sight."""

import numpy as np
from PySide6.QtCore import QRectF, QSize, Qt, Signal
from PySide6.QtGui import QImage, QPainterPath, QPaintEvent, QTransform
from PySide6.QtWidgets import QDialog, QFrame, QHBoxLayout, QWidget

from iconstudio.gui.pictures.mipmap import Mipmap
from iconstudio.gui.pictures.picture import stencil
from iconstudio.gui.pictures.vector import painter_path
from iconstudio.gui.theme import theme
from iconstudio.gui.theme.caption import Caption
from iconstudio.gui.theme.layout import Part, column, push_button, row, with_role
from iconstudio.gui.theme.painting import smooth_painter
from iconstudio.gui.theme.theme import UNIT
from iconstudio.images.scans import Tracing
from iconstudio.model import Pictogram

GAP = 3 * UNIT // 2
"""Between the parts of a dialog, in device-independent pixels."""


class IconDialog(QDialog):
    """A caption, and buttons to take the icon that is in sight, or none.

    Signals
    -------
    chosen(Pictogram)
        The icon that the user takes.
    """

    chosen = Signal(object)

    def __init__(self, title: str, take: str, parent: QWidget) -> None:
        super().__init__(parent)
        self.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        self.setWindowTitle(title)
        self.icon: Pictogram | None = None
        self.caption = Caption()
        self.accept_button = push_button(take, do=self.accept, role="primary")
        self.accept_button.setDefault(True)
        self.forget()

    def lay_out(self, above: QHBoxLayout, *parts: Part) -> None:
        """Put the parts one below the other, and caption and buttons below them."""
        cancel = push_button("Cancel", do=self.reject)
        buttons = row((self.caption, 1), cancel, self.accept_button, spacing=GAP)
        margins = (2 * UNIT,) * 4
        column((above, 1), *parts, buttons, of=self, spacing=GAP, margins=margins)

    def accept(self) -> None:
        """Take the icon that is in sight, as soon as there is one."""
        if self.icon is not None:
            super().accept()
            self.chosen.emit(self.icon)

    def forget(self) -> None:
        """Let nothing be taken for now."""
        self.icon = None
        self.accept_button.setEnabled(False)

    def offer(self, icon: Pictogram, words: str) -> None:
        """Let an icon be taken; ``words`` are said unless it has remarks."""
        self.icon = icon
        self.accept_button.setEnabled(True)
        self.caption.say(" ".join(icon.remarks) or words)


class ScanView(QFrame):
    """Shows an image, ink or an outline, as large as fits."""

    def __init__(self, name: str) -> None:
        super().__init__()
        with_role(self, "card")
        self.setAccessibleName(name)
        self.setMinimumSize(QSize(30 * UNIT, 30 * UNIT))
        self._image: Mipmap | None = None
        self._ink: np.ndarray | None = None
        self._path: QPainterPath | None = None
        self._size = QSize(1, 1)

    def show_image(self, image: QImage) -> None:
        """Show an image."""
        self._image, self._size = Mipmap.of(image, 64), image.size()
        self.update()

    def show_ink(self, ink: np.ndarray) -> None:
        """Show (h, w) where there is ink, until it is traced."""
        height, width = ink.shape
        self._ink = np.where(ink, np.uint8(255), np.uint8(0))
        self._path, self._size = None, QSize(width, height)
        self.update()

    def show_tracing(self, tracing: Tracing) -> None:
        """Show an icon that was traced."""
        self._path = painter_path(tracing.path)
        self._path.setFillRule(Qt.FillRule.OddEvenFill)
        self._ink, self._size = None, QSize(tracing.width, tracing.height)
        self.update()

    def clear(self) -> None:
        """Show nothing."""
        self._image = self._ink = self._path = None
        self.update()

    def paintEvent(self, event: QPaintEvent) -> None:
        """Draw what there is in the middle."""
        super().paintEvent(event)
        room = self.contentsRect().adjusted(UNIT, UNIT, -UNIT, -UNIT)
        size = self._size.scaled(room.size(), Qt.AspectRatioMode.KeepAspectRatio)
        box = QRectF(0, 0, size.width(), size.height())
        box.moveCenter(QRectF(room).center())
        scheme = theme.current()
        with smooth_painter(self) as painter:
            if self._image is not None:
                painter.drawImage(box, self._image.at(box.width() * self.devicePixelRatioF()))
            if self._ink is not None:
                painter.drawImage(box, stencil(self._ink, scheme.color("text")))
            if self._path is not None:
                scale = box.width() / self._size.width()
                onto = QTransform.fromTranslate(box.x(), box.y()).scale(scale, scale)
                painter.fillPath(onto.map(self._path), scheme.color("text"))
