"""Whether the window can be tested here, and with what."""

import os
import sys

import pytest

from iconstudio.gui.window.availability import missing_library

_MISSING = missing_library()


def test_qt_can_be_loaded():
    if _MISSING and os.environ.get("ICONSTUDIO_REQUIRE_QT") != "1":
        pytest.skip(f"The window's tests are left out. {_MISSING}")
    assert not _MISSING


@pytest.mark.skipif(_MISSING is not None, reason="Qt cannot be loaded")
def test_a_signal_keeps_the_count_of_references():
    """PySide6 6.12.0 dropped one to True with each signal, and Python 3.11 then ended."""
    from PySide6.QtCore import QObject, Signal

    class Bell(QObject):
        rung = Signal()

    bell = Bell()
    before = sys.getrefcount(True)
    for _ in range(50):
        bell.rung.emit()
    assert abs(sys.getrefcount(True) - before) < 25
