"""Whether the window can be tested here, and with what."""

import importlib.util
import os
import sys

import pytest

_MISSING = ""
try:
    import PySide6.QtWidgets  # noqa: F401
    from PySide6.QtCore import QObject, Signal
except ImportError as error:
    _MISSING = str(error)

_ADVICE = (
    f"The window is not tested: {_MISSING}. On Debian or Ubuntu, apt-get install "
    "libgl1 libegl1 libxkbcommon0 libdbus-1-3 libfontconfig1 libglib2.0-0"
)


def test_qt_can_be_loaded():
    assert importlib.util.find_spec("PySide6") is not None
    if _MISSING and os.environ.get("ICONSTUDIO_REQUIRE_QT") != "1":
        pytest.skip(_ADVICE)
    assert not _MISSING, _ADVICE


@pytest.mark.skipif(bool(_MISSING), reason=_ADVICE)
def test_a_signal_keeps_the_count_of_references():
    """PySide6 6.12.0 dropped one to True with each signal, and Python 3.11 then ended."""

    class Bell(QObject):
        rung = Signal()

    bell = Bell()
    before = sys.getrefcount(True)
    for _ in range(50):
        bell.rung.emit()
    assert abs(sys.getrefcount(True) - before) < 25
