"""How long the window's event loop stands still while everything is used once.

A timer of 5 ms ticks in the window's thread; a gap is the time between two ticks. Run as a
program; it prints each stage with its worst gap, and of that gap the seconds that the window's
own thread was busy: the rest it waited, for the interpreter lock or for a processor. ``--where``
prints what it was doing in gaps over 50 ms; ``sketching``, ``mixing``, ``joining`` and ``looking``
choose a part.
"""

import gc
import sys
import tempfile
import threading
import time
import traceback
from collections.abc import Callable, Generator, Iterator
from itertools import chain
from pathlib import Path

from PySide6.QtCore import QObject, QPoint, QPointF, Qt, QTimer
from PySide6.QtGui import QColor, QImage, QPainter
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication

from iconstudio.gui.app import application, keep_going
from iconstudio.gui.gallery.cell import ResultCell
from iconstudio.gui.project import questions
from iconstudio.gui.theme import theme
from iconstudio.gui.window.main_window import MainWindow
from iconstudio.session import Session
from iconstudio.workflows.modelling.file import example

LIMIT = 0.05
PATIENCE = 45.0
"""Seconds after which a stage goes on without what it waits for."""
LEFT = Qt.MouseButton.LeftButton
Wanted = str | float | Callable[[], bool]
Stages = Generator[Wanted]


class Probe(QObject):
    """Measures the gaps of the event loop, stage by stage."""

    def __init__(self, where: bool = False) -> None:
        super().__init__()
        self.worst: dict[str, tuple[float, float]] = {}
        """Of each stage: the longest gap and the busy seconds in it."""
        self._stage = ""
        self._last = time.perf_counter(), time.thread_time()
        self._timer = QTimer(self, interval=5)
        self._timer.setTimerType(Qt.TimerType.PreciseTimer)
        self._timer.timeout.connect(self._tick)
        self._timer.start()
        self.collecting = 0.0
        """The longest that the garbage collector took, in seconds; all threads stand still then."""
        gc.callbacks.append(self._note_collection)
        if where:
            thread = threading.get_ident()
            threading.Thread(target=self._watch, args=(thread,), daemon=True).start()

    def begin(self, stage: str) -> None:
        """Count from now on for another stage; print the last one."""
        if self._stage:
            gap, busy = self.worst[self._stage]
            print(f"{self._stage}\t{1000 * gap:.0f}\t{1000 * busy:.0f}", flush=True)
        self._stage = stage
        self.worst.setdefault(stage, (0.0, 0.0))
        self._last = time.perf_counter(), time.thread_time()

    def _tick(self) -> None:
        now = time.perf_counter(), time.thread_time()
        gap = now[0] - self._last[0], now[1] - self._last[1]
        self._last = now
        self.worst[self._stage] = max(self.worst.get(self._stage, (0.0, 0.0)), gap)

    def _note_collection(self, phase: str, info: dict[str, int]) -> None:
        if phase == "start":
            self._collection = time.thread_time()
        else:
            self.collecting = max(self.collecting, time.thread_time() - self._collection)

    def _watch(self, thread: int) -> None:
        told = None
        while True:
            time.sleep(0.005)
            last = self._last[0]
            if time.perf_counter() - last > LIMIT and last != told:
                told = last
                frames = sys._current_frames()
                if thread not in frames:
                    return
                stack = traceback.extract_stack(frames[thread])
                print(f"-- {self._stage}", *traceback.format_list(stack[-4:]), file=sys.stderr)
                for number, frame in frames.items():
                    if number not in (thread, threading.get_ident()):
                        stack = traceback.extract_stack(frame)
                        print("   meanwhile", stack[-1], file=sys.stderr)


class Player(QObject):
    """Goes through stages in the event loop, as a user would.

    They yield the name of a stage that begins, milliseconds to wait, or a question to wait for.
    """

    def __init__(self, probe: Probe, stages: Iterator[Wanted], end: Callable[[], object]) -> None:
        super().__init__()
        self._probe, self._stages, self._end = probe, stages, end
        self.error: Exception | None = None
        QTimer.singleShot(0, self._go_on)

    def _go_on(self) -> None:
        try:
            self._await(next(self._stages))
        except StopIteration:
            self._end()
        except Exception as error:
            self._fail(error)

    def _await(self, wanted: Wanted) -> None:
        if isinstance(wanted, str):
            self._probe.begin(wanted)
            QTimer.singleShot(0, self._go_on)
        elif callable(wanted):
            self._wait(wanted, time.perf_counter() + PATIENCE)
        else:
            QTimer.singleShot(round(wanted), self._go_on)

    def _wait(self, until: Callable[[], bool], end: float) -> None:
        try:
            ready = until() or time.perf_counter() > end
        except Exception as error:
            self._fail(error)
            return
        QTimer.singleShot(30, self._go_on if ready else lambda: self._wait(until, end))

    def _fail(self, error: Exception) -> None:
        self.error = error
        self._end()


def sketching(window: MainWindow, folder: Path) -> Stages:
    place = window.workspace
    yield "after opening"
    yield 3000
    yield "typing a keyword"
    field = place.keyword_panel.field
    field.setFocus()
    for letter in "bicycle":
        QTest.keyClicks(field, letter)
        yield 40
    yield 600
    yield lambda: not place.preparation.runner.running
    photo = _photo(folder)
    yield "photo of 12 megapixels"
    place.opener.open_file(str(photo))
    yield lambda: place.document.page.photo is not None
    yield 200
    yield "run of the motorbike"
    place.demonstrate(example("motorbike"))
    yield lambda: len(place.browser.results.pictures) > 0
    yield lambda: not (place.runner.running or place.preparation.runner.running)
    yield 200
    yield "picking cells"
    for cell in place.browser.results.findChildren(ResultCell):
        QTest.mouseClick(cell, LEFT)
        yield 30
    yield "colour code"
    for on in (True, False, True, False):
        window.workspace.actions_by_name["coded" if on else "plain"].setChecked(True)
        yield 150
    yield "zooming the sketch"
    for step in range(20):
        place.view.zoom_by(1.2 if step < 10 else 1 / 1.2)
        yield 10
    yield "dragging a vertex"
    a = place.view.camera.to_view(place.document.page.vertices[0]).toPoint()
    yield from _drag(place.view, a, a + QPoint(30, 20))
    yield 2500
    place.cancel()
    yield "saving"
    window.saver.ask_path = lambda what, name, kind: folder / f"{name}.{kind}"
    for name in ("svg", "png", "copy", "save"):
        window.workspace.actions_by_name[name].trigger()
        yield 400


def mixing(window: MainWindow) -> Stages:
    yield "entering Hybrids"
    window.show_workspace(2)
    yield 300
    place = window.workspace
    sheet = place.sheet
    yield "drawing 40 hybrids"
    place.panel.start.menu().actions()[0].trigger()
    yield lambda: len(place.sections.pictures) > 0 and not place.draws.runner.running
    yield 300
    yield "scrolling hybrids"
    bar = sheet.verticalScrollBar()
    for step in range(60):
        bar.setValue(bar.maximum() * (step % 30) // 30)
        yield 15
    yield lambda: not place.draws.runner.running
    yield "colouring hybrids"
    window.workspace.actions_by_name["coded"].setChecked(True)
    yield 200
    place.cancel()


def joining(window: MainWindow, session: Session) -> Stages:
    yield "entering Montage"
    window.show_workspace(3)
    yield 300
    place = window.workspace
    yield "adding 10 layers"
    for icon in session.search("house")[:10]:
        place.take(icon)
        yield 30
    yield lambda: len(place.document.page.layers) == 10
    yield 1500
    middle = QPoint(place.view.width() // 2, place.view.height() // 2)
    yield "scribbling"
    for shift in range(0, 100, 20):
        yield from _drag(place.view, middle + QPoint(shift - 60, -60), middle + QPoint(shift, 60))
        yield 400
    yield lambda: not place.live.running
    yield "dragging a layer"
    window.workspace.actions_by_name["arrange"].trigger()
    yield from _drag(place.view, middle, middle + QPoint(50, 40))
    yield lambda: not place.live.running
    yield "zooming 10 layers"
    for step in range(24):
        place.view.zoom_by(1.1 if step < 12 else 1 / 1.1, QPointF(middle))
        yield 16
    yield 300
    yield "panning 10 layers"
    for _ in range(20):
        place.view.pan(QPointF(3, 2))
        yield 16
    place.cancel()


def looking(window: MainWindow) -> Stages:
    yield "switching workspaces"
    for number in (0, 1, 2, 3, 0, 1, 2, 3, 0):
        window.show_workspace(number)
        yield 120
    yield "resizing the window"
    for number in (0, 2, 3):
        window.show_workspace(number)
        yield 100
        for step in range(12):
            window.resize(1280 + 20 * step, 720 + 12 * step)
            yield 20
        window.resize(1280, 720)
        yield 60
    yield "changing the theme"
    app = QApplication.instance()
    for look in (theme.DARK, theme.LIGHT):
        theme.change(app, look)
        yield 400


def _drag(view: QObject, a: QPoint, b: QPoint, steps: int = 20) -> Stages:
    QTest.mouseMove(view, a)
    QTest.mousePress(view, LEFT, pos=a)
    for step in range(1, steps + 1):
        QTest.mouseMove(view, a + (b - a) * step / steps)
        yield 10
    QTest.mouseRelease(view, LEFT, pos=b)


def _photo(folder: Path) -> Path:
    image = QImage(4000, 3000, QImage.Format.Format_RGB32)
    image.fill(QColor("#88aacc"))
    with QPainter(image) as painter:
        for step in range(200):
            painter.fillRect(20 * step, 13 * step, 400, 300, QColor.fromHsv(step, 200, 200))
    path = folder / "photo.jpg"
    image.save(str(path))
    return path


def main() -> int:
    app = application()
    session = Session()
    window = MainWindow(session)
    window.resize(1280, 720)
    window.show()
    keep_going()
    questions.ask_about_unsaved = lambda *_: questions.Answer.DISCARD  # to quit asks it
    probe = Probe("--where" in sys.argv)

    with tempfile.TemporaryDirectory() as folder:
        parts = {
            "sketching": sketching(window, Path(folder)),
            "mixing": mixing(window),
            "joining": joining(window, session),
            "looking": looking(window),
        }
        chosen = [parts[name] for name in parts if name in sys.argv] or parts.values()
        player = Player(probe, chain.from_iterable(chosen), app.quit)
        app.exec()
    probe.begin("")
    print(f"collecting garbage\t{1000 * probe.collecting:.0f}")
    window.close()
    if player.error is not None:
        traceback.print_exception(player.error)
    return 1 if player.error is not None else 0


if __name__ == "__main__":
    sys.exit(main())
