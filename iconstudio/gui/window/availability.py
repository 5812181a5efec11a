"""Whether a window can open on this machine, and if not, what is missing."""

import ctypes
import importlib.util
import os
import re
import subprocess
import sys
from pathlib import Path

PACKAGES = (
    "libgl1 libegl1 libxkbcommon0 libxkbcommon-x11-0 libdbus-1-3 libfontconfig1 libglib2.0-0 "
    "libxcb-cursor0 libxcb-icccm4 libxcb-image0 libxcb-keysyms1 libxcb-randr0 "
    "libxcb-render-util0 libxcb-shape0 libxcb-xinerama0 libxcb-xkb1"
)
"""Debian's and Ubuntu's packages that hold the libraries Qt needs."""

INSTALL = f"sudo apt-get install {PACKAGES}"

_WITHOUT_SCREEN = ("offscreen", "minimal")
"""What comes with Qt and opens windows that nobody sees."""
_PATIENCE = 20.0
"""Seconds that Qt may take to start."""


def missing_library() -> str | None:
    """Return a sentence that names the system library Qt lacks, and how to get it; None if none."""
    if importlib.util.find_spec("PySide6") is None:
        return "PySide6 is not installed: pip install PySide6-Essentials."
    try:
        import PySide6.QtSvg
        import PySide6.QtWidgets
    except ImportError as error:
        return _lacks(str(error))
    if _uses_x11():
        plugin = Path(PySide6.QtWidgets.__file__).parent / "Qt/plugins/platforms/libqxcb.so"
        try:
            ctypes.CDLL(str(plugin))
        except OSError as error:
            return _lacks(str(error))
    return None


def obstacle() -> str | None:
    """Return a sentence that says why no window can open and what to do; None if one can."""
    if (missing := missing_library()) is not None:
        return missing
    platform = _platform()
    if platform in _WITHOUT_SCREEN or (not sys.platform.startswith("linux") and not platform):
        return None
    if not platform and not (os.environ.get("DISPLAY") or os.environ.get("WAYLAND_DISPLAY")):
        return "There is no screen (neither DISPLAY nor WAYLAND_DISPLAY is set)."
    if _uses_x11():
        if _x11_answers():
            return None
        if not (screen := os.environ.get("DISPLAY")):
            return "There is no screen (DISPLAY is not set)."
        return f"The screen “{screen}” (DISPLAY) does not answer."
    if not platform and _wayland_answers():
        return None
    return None if _opens_in_another_process() else _refused(platform)


def _platform() -> str:
    """Return what part of the system Qt is told to show windows by; empty if it may choose."""
    return os.environ.get("QT_QPA_PLATFORM", "").partition(":")[0]


def _uses_x11() -> bool:
    if not sys.platform.startswith("linux"):
        return False
    if platform := _platform():
        return platform == "xcb"
    return bool(os.environ.get("DISPLAY")) and not os.environ.get("WAYLAND_DISPLAY")


def _x11_answers() -> bool:
    """Open and close a connection, because Qt aborts the process if it gets none."""
    xcb = ctypes.CDLL("libxcb.so.1")
    xcb.xcb_connect.restype = ctypes.c_void_p
    xcb.xcb_connection_has_error.argtypes = xcb.xcb_disconnect.argtypes = [ctypes.c_void_p]
    connection = xcb.xcb_connect(None, None)
    failed = xcb.xcb_connection_has_error(connection)
    xcb.xcb_disconnect(connection)
    return not failed


def _wayland_answers() -> bool:
    """Open and close a connection."""
    import socket

    folder = os.environ.get("XDG_RUNTIME_DIR", "")
    with socket.socket(socket.AF_UNIX) as connection:
        try:
            connection.connect(os.path.join(folder, os.environ.get("WAYLAND_DISPLAY", "")))
        except OSError:
            return False
    return True


def _opens_in_another_process() -> bool:
    """Whether Qt starts where it may abort: a process of its own, which takes half a second."""
    start = "from PySide6.QtGui import QGuiApplication; QGuiApplication([])"
    try:
        ended = subprocess.run(
            [sys.executable, "-P", "-c", start], capture_output=True, timeout=_PATIENCE
        )
    except subprocess.TimeoutExpired:
        return False
    return ended.returncode == 0


def _refused(platform: str) -> str:
    if platform:
        return (
            f"No window can open with QT_QPA_PLATFORM={os.environ['QT_QPA_PLATFORM']}. "
            "Unset it to open one on your screen."
        )
    return f"The screen “{os.environ['WAYLAND_DISPLAY']}” (WAYLAND_DISPLAY) does not answer."


def _lacks(error: str) -> str:
    found = re.search(r"lib[\w.+-]+\.so[.\d]*", error)
    what = f"the system library {found[0]}" if found else f"a system library ({error})"
    return f"The window needs {what}. On Debian or Ubuntu: {INSTALL}"
