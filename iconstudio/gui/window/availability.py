"""Whether a window can open on this machine, and if not, what is missing."""

import ctypes
import importlib.util
import os
import re
import sys
from pathlib import Path

PACKAGES = (
    "libgl1 libegl1 libxkbcommon0 libxkbcommon-x11-0 libdbus-1-3 libfontconfig1 libglib2.0-0 "
    "libxcb-cursor0 libxcb-icccm4 libxcb-image0 libxcb-keysyms1 libxcb-randr0 "
    "libxcb-render-util0 libxcb-shape0 libxcb-xinerama0 libxcb-xkb1"
)
"""Debian's and Ubuntu's packages that hold the libraries Qt needs."""

INSTALL = f"sudo apt-get install {PACKAGES}"


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
    if sys.platform.startswith("linux") and "QT_QPA_PLATFORM" not in os.environ:
        if not (os.environ.get("DISPLAY") or os.environ.get("WAYLAND_DISPLAY")):
            return "There is no screen (neither DISPLAY nor WAYLAND_DISPLAY is set)."
        if _uses_x11() and not _x11_answers():
            return f"The screen {os.environ['DISPLAY']} does not answer."
    return None


def _uses_x11() -> bool:
    return (
        sys.platform.startswith("linux")
        and "QT_QPA_PLATFORM" not in os.environ
        and bool(os.environ.get("DISPLAY"))
        and not os.environ.get("WAYLAND_DISPLAY")
    )


def _x11_answers() -> bool:
    """Open and close a connection, because Qt aborts the process if it gets none."""
    xcb = ctypes.CDLL("libxcb.so.1")
    xcb.xcb_connect.restype = ctypes.c_void_p
    xcb.xcb_connection_has_error.argtypes = xcb.xcb_disconnect.argtypes = [ctypes.c_void_p]
    connection = xcb.xcb_connect(None, None)
    failed = xcb.xcb_connection_has_error(connection)
    xcb.xcb_disconnect(connection)
    return not failed


def _lacks(error: str) -> str:
    found = re.search(r"lib[\w.+-]+\.so[.\d]*", error)
    what = f"the system library {found[0]}" if found else f"a system library ({error})"
    return f"The window needs {what}. On Debian or Ubuntu: {INSTALL}"
