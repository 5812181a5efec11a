"""A scan or a picture becomes an icon: what counts as ink is chosen while the icon is in sight."""

from collections.abc import Generator
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from PySide6.QtCore import QRectF, QSignalBlocker, QSize, Qt, QTimer, Signal
from PySide6.QtGui import QImage, QPainter, QPainterPath, QPaintEvent, QTransform
from PySide6.QtWidgets import (
    QCheckBox,
    QDialog,
    QFrame,
    QHBoxLayout,
    QLabel,
    QPushButton,
    QSlider,
    QVBoxLayout,
    QWidget,
)

from iconstudio.algorithms.scanning.binarisation import Scan
from iconstudio.gui.canvas.mipmap import Mipmap
from iconstudio.gui.canvas.photo import image_of, qt_image
from iconstudio.gui.canvas.vector import painter_path
from iconstudio.gui.jobs.live import LiveRunner
from iconstudio.gui.jobs.worker import Worker
from iconstudio.gui.panels.caption import Caption
from iconstudio.gui.theme import theme
from iconstudio.gui.theme.theme import UNIT
from iconstudio.images.reading import SUFFIXES, Image, is_image_file
from iconstudio.images.scans import Tracing, doubts
from iconstudio.model import Pictogram
from iconstudio.session import Session

DARKEST = 255
_SHOWN = 1024
"""Pixels that are enough to show a scan."""
_REST = 60
"""Milliseconds for which the slider rests before the drawing is traced."""
_PATIENCE = 10_000
_WORDS = "Move the slider until the icon is as it should be: to the right, fainter strokes count."
_BY_HAND = "If you see a drawing, move the slider until the icon is as it should be."

Source = Path | bytes | QImage


def may_be_scan(path: str) -> bool:
    """Whether a file is called as images are."""
    return path.rpartition(".")[2].lower() in SUFFIXES


def pictogram_of(session: Session, source: Source, name: str) -> Generator[None, None, Pictogram]:
    """Return an image as an icon, without asking; yield now and then."""
    image = yield from _read(session, source)
    scan = yield from session.scan(image)
    tracing = yield from session.trace(scan, None, name, image.remark)
    return tracing.pictogram


class ScanView(QFrame):
    """Shows an image, ink or an outline, as large as fits."""

    def __init__(self, name: str, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setProperty("card", True)
        self.setAccessibleName(name)
        self.setMinimumSize(QSize(30 * UNIT, 30 * UNIT))
        self._image: Mipmap | None = None
        self._ink: QImage | None = None
        self._path: QPainterPath | None = None
        self._size = QSize(1, 1)

    def show_image(self, image: QImage) -> None:
        """Show an image."""
        self._image, self._size = Mipmap.of(image, 64), image.size()
        self.update()

    def show_ink(self, ink: np.ndarray) -> None:
        """Show (h, w) where there is ink, until it is traced."""
        height, width = ink.shape
        alpha = np.where(ink, np.uint8(255), np.uint8(0))
        self._ink = QImage(alpha, width, height, width, QImage.Format.Format_Alpha8).copy()
        self._path, self._size = None, self._ink.size()
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
        painter = QPainter(self)
        painter.setRenderHints(
            QPainter.RenderHint.Antialiasing | QPainter.RenderHint.SmoothPixmapTransform
        )
        if self._image is not None:
            painter.drawImage(box, self._image.at(box.width() * self.devicePixelRatioF()))
        if self._ink is not None:
            painter.drawImage(box, _tinted(self._ink, scheme))
        if self._path is not None:
            scale = box.width() / self._size.width()
            onto = QTransform.fromTranslate(box.x(), box.y()).scale(scale, scale)
            painter.fillPath(onto.map(self._path), scheme.color("text"))
        painter.end()


@dataclass(frozen=True, eq=False)
class _Request:
    """An icon that is to be traced, each time anew."""

    scan: Scan
    threshold: int
    remark: str


class ScanDialog(QDialog):
    """The picture, the icon that is made of it, and what may be changed about that.

    Reading, scanning and tracing are done by ``worker`` and, in turn, in other processes.

    Signals
    -------
    chosen(Pictogram)
        The icon that the user takes.
    failed(str)
        The picture cannot be read; a sentence for the user. The dialog has closed.
    no_image()
        What is in the file is no picture, whatever its name. The dialog has closed.
    """

    chosen = Signal(object)
    failed = Signal(str)
    no_image = Signal()

    def __init__(
        self, session: Session, worker: Worker, source: Source, name: str, parent: QWidget
    ) -> None:
        super().__init__(parent)
        self.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        self.setWindowTitle("Make an icon of a picture")
        self._session, self._name = session, name
        self._image: Image | None = None
        self._scan: Scan | None = None
        self.icon: Pictogram | None = None
        self.runner = LiveRunner(worker, self._traced, self, _PATIENCE)
        self.runner.event.connect(self._receive)
        self.runner.failed.connect(self._fail)
        self._rest = QTimer(self, singleShot=True, interval=_REST)
        self._rest.timeout.connect(self._trace)
        self._lay_out()
        self.finished.connect(self._end)
        self.runner.start(lambda: _opened(session, source))

    def _lay_out(self) -> None:
        self.picture, self.preview = ScanView("The picture"), ScanView("The icon")
        self.slider = QSlider(Qt.Orientation.Horizontal, minimum=1, maximum=DARKEST - 1)
        self.slider.setMinimumHeight(3 * UNIT)
        self.slider.setAccessibleName("How much counts as ink")
        self.slider.setToolTip("How much counts as ink: fainter strokes to the right")
        self.slider.valueChanged.connect(self._move)
        self.inverted = QCheckBox("&Light on dark")
        self.inverted.setToolTip("The drawing is lighter than its ground")
        self.inverted.clicked.connect(self._invert)
        self.automatic = QPushButton("&Automatic", toolTip="What the program thinks is best")
        self.automatic.setAutoDefault(False)
        self.automatic.clicked.connect(lambda: self._show_scan(self._scan))
        self.caption = Caption()
        self.accept_button = QPushButton("Use icon", default=True)
        self.accept_button.setProperty("primary", True)
        self.accept_button.clicked.connect(self.accept)
        cancel = QPushButton("Cancel")
        cancel.setAutoDefault(False)
        cancel.clicked.connect(self.reject)
        label = QLabel("&Ink")
        label.setBuddy(self.slider)
        pictures, controls, buttons = QHBoxLayout(), QHBoxLayout(), QHBoxLayout()
        for view in (self.picture, self.preview):
            pictures.addWidget(view, 1)
        controls.addWidget(label)
        controls.addWidget(self.slider, 1)
        controls.addWidget(self.automatic)
        controls.addWidget(self.inverted)
        buttons.addWidget(self.caption, 1)
        buttons.addWidget(cancel)
        buttons.addWidget(self.accept_button)
        column = QVBoxLayout(self)
        column.setContentsMargins(2 * UNIT, 2 * UNIT, 2 * UNIT, 2 * UNIT)
        column.setSpacing(3 * UNIT // 2)
        column.addLayout(pictures, 1)
        for row in (controls, buttons):
            row.setSpacing(3 * UNIT // 2)
            column.addLayout(row)
        self.resize(96 * UNIT, 60 * UNIT)
        self._enable(False)
        self.caption.say("Reading the picture…")

    def accept(self) -> None:
        """Take the icon that is in sight, as soon as it is traced."""
        if self.icon is not None:
            super().accept()
            self.chosen.emit(self.icon)

    def _receive(self, found: object) -> None:
        match found:
            case (Image() as image, QImage() as shown):
                self._image = image
                self.picture.show_image(shown)
                self._invert(None)
            case Scan():
                self._scan = found
                self.inverted.setChecked(found.inverted)
                self._enable(True)
                self.automatic.setEnabled(found.found)
                self.slider.setFocus()
                self._show_scan(found)
            case Tracing():
                self.icon = found.pictogram
                self.preview.show_tracing(found)
                self.accept_button.setEnabled(True)
                self.caption.say(" ".join(self.icon.remarks) or _WORDS)
                self.runner.release()
            case None:
                return
            case _:
                self.done(QDialog.DialogCode.Rejected)
                self.no_image.emit()

    def _fail(self, message: str) -> None:
        if self._image is None:
            self.done(QDialog.DialogCode.Rejected)
            self.failed.emit(message)
            return
        self.icon = None
        if self._scan is None:
            self.inverted.setEnabled(True)
            self.preview.clear()
        self.caption.say(message, error=True)

    def _invert(self, inverted: bool | None) -> None:
        image, session = self._image, self._session
        self._forget()
        self._scan = None
        self._enable(False)
        self.caption.say("Looking for the drawing…")
        self.runner.start(lambda: _answer(session.scan(image, inverted)))

    def _show_scan(self, scan: Scan) -> None:
        value = DARKEST - scan.threshold
        if not scan.found:
            self._show_doubtful(scan, value)
            return
        if self.slider.value() == value:
            self._move(value)
        self.slider.setValue(value)

    def _show_doubtful(self, scan: Scan, value: int) -> None:
        """Leave it to the user: nothing is traced before the slider is moved."""
        with QSignalBlocker(self.slider):
            self.slider.setValue(value)
        self.preview.show_ink(scan.darkness > scan.threshold)
        self.caption.say(f"{doubts(scan)} {_BY_HAND}", error=True)

    def _move(self, value: int) -> None:
        if self._scan is not None:
            self._forget()
            self.preview.show_ink(self._scan.at(DARKEST - value))
            self._rest.start()

    def _trace(self) -> None:
        if self._scan is not None:
            remark = self._image.remark
            self.runner.request(_Request(self._scan, DARKEST - self.slider.value(), remark))

    def _traced(self, request: _Request) -> Generator[object]:
        scan, threshold, remark = request.scan, request.threshold, request.remark
        return _answer(self._session.trace(scan, threshold, self._name, remark))

    def _forget(self) -> None:
        self.icon = None
        self.accept_button.setEnabled(False)

    def _enable(self, enabled: bool) -> None:
        for one in (self.slider, self.automatic, self.inverted):
            one.setEnabled(enabled)
        self.accept_button.setEnabled(enabled and self.icon is not None)

    def _end(self) -> None:
        self._rest.stop()
        self.runner.cancel()


def _opened(session: Session, source: Source) -> Generator[object]:
    """Yield an image, and a smaller one to show; or True if it is none."""
    if isinstance(source, Path) and source.is_file() and not is_image_file(source):
        yield True
        return
    image = yield from _read(session, source)
    shown = qt_image(image)
    if max(shown.width(), shown.height()) > _SHOWN:
        smooth, keep = (
            Qt.TransformationMode.SmoothTransformation,
            Qt.AspectRatioMode.KeepAspectRatio,
        )
        shown = shown.scaled(_SHOWN, _SHOWN, keep, smooth)
    yield image, shown


def _read(session: Session, source: Source) -> Generator[None, None, Image]:
    if isinstance(source, QImage):
        return image_of(source)
    return (yield from session.image(source))


def _answer(steps: Generator[None, None, object]) -> Generator[object]:
    yield (yield from steps)


def _tinted(ink: QImage, scheme: theme.Theme) -> QImage:
    """Return ink in the colour of text."""
    image = QImage(ink.size(), QImage.Format.Format_ARGB32_Premultiplied)
    image.fill(scheme.color("text"))
    painter = QPainter(image)
    painter.setCompositionMode(QPainter.CompositionMode.CompositionMode_DestinationIn)
    painter.drawImage(0, 0, ink)
    painter.end()
    return image
