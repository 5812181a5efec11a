"""How soon a montage of four icons is made anew after one more stroke (the aim is 0.15 s).

Run with ``pytest -n 0 tests/benchmarks --benchmark-only``; figures are medians.
"""

import itertools
from dataclasses import replace

import pytest

from iconstudio.model import Layer, Montage, Stroke
from iconstudio.session import Session
from iconstudio.workflows.events import Result
from iconstudio.workflows.montage.spec import MONTAGE

ICONS = ("glyphs:house-bold", "bi:houses", "lucide:houses", "reicon:house-duotone")
ROUNDS = 15


def line(x: float, top: float, bottom: float) -> tuple[tuple[float, float], ...]:
    """A scribble downwards that shakes a little, as a hand does."""
    return tuple((x + n % 3, top + (bottom - top) * n / 12) for n in range(13))


@pytest.fixture(scope="module")
def session():
    with Session() as session:
        yield session


@pytest.fixture(scope="module")
def montage(session):
    """Four icons, a quarter of the canvas of each marked."""
    return Montage(
        tuple(
            Layer(session.icon(icon), strokes=(Stroke(12.0, line(40 + 55 * k, 60, 180)),))
            for k, icon in enumerate(ICONS)
        )
    )


@pytest.mark.benchmark(group="a montage of 4 icons after one more stroke")
def test_session(benchmark, session, montage):
    bottoms = itertools.count(190.0, 2.0)

    def one_more_stroke():
        last = montage.layers[-1]
        more = Stroke(12.0, line(200, 185, next(bottoms)))
        marked = replace(last, strokes=(*last.strokes, more))
        return (Montage((*montage.layers[:-1], marked)),), {}

    def make(wanted):
        return [event for event in session.run(MONTAGE, wanted) if isinstance(event, Result)]

    (result,) = benchmark.pedantic(make, setup=one_more_stroke, rounds=ROUNDS, warmup_rounds=4)
    benchmark.extra_info["cut, seconds"] = result.worked["remix"]
    benchmark.extra_info["draw and trace, seconds"] = result.worked["vectorize"]


@pytest.mark.benchmark(group="a montage of 4 icons after one more stroke")
def test_window(benchmark, session, montage, qtbot, monkeypatch):
    """From lifting the pen to the picture on the screen."""
    pytest.importorskip("PySide6.QtWidgets")
    from PySide6.QtCore import QPoint, Qt
    from PySide6.QtTest import QTest

    from iconstudio.gui.project import questions
    from iconstudio.gui.window.main_window import MainWindow
    from iconstudio.workflows.montage.page import IconShape, MontagePage

    left = Qt.MouseButton.LeftButton
    window = MainWindow(session, (MONTAGE,))
    window.resize(1280, 720)
    window.show()
    place = window.workspace
    icons = [IconShape(session.exemplar(layer.icon)) for layer in montage.layers]
    place.document.change("open", MontagePage.of(montage.layers, icons))

    def spot(x: float, y: float) -> QPoint:
        return place.view.camera.to_view((x, y)).toPoint()

    def rest():
        qtbot.waitUntil(lambda: not place.live.running, timeout=60000)

    tops = itertools.count(190, 2)

    def press_and_draw():
        rest()
        top = next(tops)
        QTest.mousePress(place.view, left, pos=spot(190, top))
        for x in range(190, 215, 3):
            QTest.mouseMove(place.view, spot(x, top))
        return (spot(214, top),), {}

    def lift(end):
        with qtbot.waitSignal(place.picked, timeout=60000):
            QTest.mouseRelease(place.view, left, pos=end)
        place.detail.repaint()

    rest()
    benchmark.pedantic(lift, setup=press_and_draw, rounds=ROUNDS, warmup_rounds=4)
    rest()
    monkeypatch.setattr(questions, "ask_about_unsaved", lambda *_: questions.Answer.DISCARD)
    window.close()
