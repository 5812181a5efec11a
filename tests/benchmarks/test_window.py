"""How soon the window opens, and the longest that it stands still (the aims: 1.5 s and 50 ms).

Run with ``pytest -n 0 tests/benchmarks/test_window.py --benchmark-only -s``. On a machine that
is busy with other things, look at the busy milliseconds.
"""

import os
import subprocess
import sys
from pathlib import Path

import pytest

pytest.importorskip("PySide6.QtWidgets")

OPENING = """
import gc
import sys
gc.disable()  # as the program does, before it imports the window
from iconstudio.gui import app
from iconstudio.gui.canvas.view import CanvasView
from PySide6.QtCore import QTimer
painted = CanvasView.paintEvent
def paint(self, event):
    painted(self, event)
    CanvasView.paintEvent = painted
    QTimer.singleShot(0, self.window().close)
CanvasView.paintEvent = paint
from iconstudio.__main__ import main
sys.argv = ["iconstudio"]
if __name__ == "__main__":
    main()
"""
"""Opens the window as the program does, and closes it as soon as it is painted and takes input."""

OFFSCREEN = {**os.environ, "QT_QPA_PLATFORM": "offscreen"}


@pytest.mark.benchmark(group="from the start of the program to a painted window, and its end")
def test_opening(benchmark, tmp_path):
    script = tmp_path / "open.py"
    script.write_text(OPENING)
    # Where modules may not be compiled once for all, each start would compile them again.
    environment = {**OFFSCREEN, "PYTHONPYCACHEPREFIX": str(tmp_path / "compiled")}
    environment.pop("PYTHONDONTWRITEBYTECODE", None)
    command = [sys.executable, str(script)]
    benchmark.pedantic(
        lambda: subprocess.run(command, check=True, capture_output=True, env=environment),
        rounds=5,
        warmup_rounds=1,
    )


@pytest.mark.benchmark(group="the longest that the window stands still")
def test_gaps(benchmark):
    """The stages of ``gaps.py``; milliseconds of the worst gap of each, and busy ones therein."""
    command = [sys.executable, str(Path(__file__).with_name("gaps.py"))]
    environment = {**OFFSCREEN, "QT_SCALE_FACTOR": "2"}
    told = benchmark.pedantic(
        lambda: (
            subprocess.run(
                command, check=True, capture_output=True, text=True, env=environment
            ).stdout
        )
    )
    for line in told.splitlines():
        stage, *milliseconds = line.split("\t")
        benchmark.extra_info[stage] = " / ".join(milliseconds)
        print(f"{stage:24} {' / '.join(milliseconds):>12} ms")
