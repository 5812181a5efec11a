"""A scan or a picture becomes an icon: what counts as ink is chosen while the icon is in sight."""

from collections.abc import Generator
from dataclasses import dataclass
from pathlib import Path

from PySide6.QtCore import QSignalBlocker, Qt, QTimer, Signal
from PySide6.QtGui import QImage
from PySide6.QtWidgets import QCheckBox, QLabel, QSlider, QWidget

from iconstudio.algorithms.scanning.binarisation import Scan
from iconstudio.gui.exchange.icon_dialog import GAP, IconDialog, ScanView
from iconstudio.gui.jobs.live import LiveRunner
from iconstudio.gui.jobs.worker import Worker
from iconstudio.gui.pictures.mipmap import fitted
from iconstudio.gui.pictures.photo import qt_image
from iconstudio.gui.theme.layout import push_button, row
from iconstudio.gui.theme.theme import UNIT
from iconstudio.images.reading import Image, is_image_file
from iconstudio.images.scans import Tracing, doubts
from iconstudio.importing.images import ImageSource, image_in
from iconstudio.session import Session

DARKEST = 255
_SHOWN = 1024
"""Pixels that are enough to show a scan."""
_REST = 60
"""Milliseconds for which the slider rests before the drawing is traced."""
_PATIENCE = 10_000
_WORDS = "Move the slider until the icon is as it should be: to the right, fainter strokes count."
_BY_HAND = "If you see a drawing, move the slider until the icon is as it should be."


@dataclass(frozen=True, eq=False)
class _Request:
    """An icon that is to be traced, each time anew."""

    scan: Scan
    threshold: int
    remark: str


class ScanDialog(IconDialog):
    """The picture, the icon that is made of it, and what may be changed about that.

    Reading, scanning and tracing are done by ``worker`` and, in turn, in other processes.

    Signals
    -------
    failed(str)
        The picture cannot be read; a sentence for the user. The dialog has closed.
    no_image()
        What is in the file is no picture, whatever its name. The dialog has closed.
    """

    failed = Signal(str)
    no_image = Signal()

    def __init__(
        self, session: Session, worker: Worker, source: ImageSource, name: str, parent: QWidget
    ) -> None:
        super().__init__("Make an icon of a picture", "Use icon", parent)
        self._session, self._name = session, name
        self._image: Image | None = None
        self._scan: Scan | None = None
        self.runner = LiveRunner(worker, self._traced, self, _PATIENCE)
        self.runner.event.connect(self._receive)
        self.runner.failed.connect(self._fail)
        self._rest = QTimer(self, singleShot=True, interval=_REST)
        self._rest.timeout.connect(self._trace)
        self._make_controls()
        self.finished.connect(self._end)
        self.runner.start(lambda: _opened(session, source))

    def _make_controls(self) -> None:
        self.picture, self.preview = ScanView("The picture"), ScanView("The icon")
        self.slider = QSlider(Qt.Orientation.Horizontal, minimum=1, maximum=DARKEST - 1)
        self.slider.setMinimumHeight(3 * UNIT)
        self.slider.setAccessibleName("How much counts as ink")
        self.slider.setToolTip("How much counts as ink: fainter strokes to the right")
        self.slider.valueChanged.connect(self._move)
        self.inverted = QCheckBox("&Light on dark")
        self.inverted.setToolTip("The drawing is lighter than its ground")
        self.inverted.clicked.connect(self._invert)
        self.automatic = push_button(
            "&Automatic", "What the program thinks is best", lambda: self._show_scan(self._scan)
        )
        words = QLabel("&Ink")
        words.setBuddy(self.slider)
        controls = row(words, (self.slider, 1), self.automatic, self.inverted, spacing=GAP)
        self.lay_out(row((self.picture, 1), (self.preview, 1)), controls)
        self.resize(96 * UNIT, 60 * UNIT)
        self._enable(False)
        self.caption.say("Reading the picture…")

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
                self.preview.show_tracing(found)
                self.offer(found.pictogram, _WORDS)
                self.runner.release()
            case None:
                return
            case _:
                self.done(IconDialog.DialogCode.Rejected)
                self.no_image.emit()

    def _fail(self, message: str) -> None:
        if self._image is None:
            self.done(IconDialog.DialogCode.Rejected)
            self.failed.emit(message)
            return
        self.icon = None
        if self._scan is None:
            self.inverted.setEnabled(True)
            self.preview.clear()
        self.caption.say(message, error=True)

    def _invert(self, inverted: bool | None) -> None:
        image, session = self._image, self._session
        self.forget()
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
            self.forget()
            self.preview.show_ink(self._scan.at(DARKEST - value))
            self._rest.start()

    def _trace(self) -> None:
        if self._scan is not None:
            remark = self._image.remark
            self.runner.request(_Request(self._scan, DARKEST - self.slider.value(), remark))

    def _traced(self, request: _Request) -> Generator[object]:
        scan, threshold, remark = request.scan, request.threshold, request.remark
        return _answer(self._session.trace(scan, threshold, self._name, remark))

    def _enable(self, enabled: bool) -> None:
        for one in (self.slider, self.automatic, self.inverted):
            one.setEnabled(enabled)
        self.accept_button.setEnabled(enabled and self.icon is not None)

    def _end(self) -> None:
        self._rest.stop()
        self.runner.cancel()


def _opened(session: Session, source: ImageSource) -> Generator[object]:
    """Yield an image, and a smaller one to show; or True if it is none."""
    if isinstance(source, Path) and source.is_file() and not is_image_file(source):
        yield True
        return
    image = yield from image_in(session, source)
    shown = qt_image(image)
    if max(shown.width(), shown.height()) > _SHOWN:
        shown = fitted(shown, _SHOWN)
    yield image, shown


def _answer(steps: Generator[None, None, object]) -> Generator[object]:
    yield (yield from steps)
