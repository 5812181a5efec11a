"""Loads modules that are not imported before their first use, in whatever thread that is."""

import os
import re
import threading
import time
from collections.abc import Iterator
from importlib import import_module
from importlib.util import find_spec
from pathlib import Path
from types import ModuleType

_ATTEMPTS = 3
_PAUSE = 0.1
"""Seconds until a module is tried again."""
_CHUNK = 1 << 17
"""Bytes that the system reads at once, too."""
_COMPILED = re.compile(r"\.(so(\.[\w.]+)?|dylib|pyd|dll)$")


def load_module(name: str) -> ModuleType:
    """Import a module, though another thread may be importing what it needs.

    Packages that import each other's parts, as those of SciPy do, then wait for each other, which
    Python ends by showing one thread a half-loaded module: an ImportError that a moment later does
    not happen.

    Raises
    ------
    ImportError
        If it cannot be imported, or there is none.
    """
    for _ in range(_ATTEMPTS - 1):
        try:
            return import_module(name)
        except ModuleNotFoundError:
            raise
        except ImportError:
            time.sleep(_PAUSE)
    return import_module(name)


class Libraries:
    """Packages whose compiled parts are read from disk before they are loaded.

    While one is loaded no other thread runs, the window's neither: from a cold disk for seconds.
    While one is read all go on.

    Parameters
    ----------
    packages
        Their names. None is imported, and what is not there is passed over.
    """

    def __init__(self, *packages: str) -> None:
        self._packages = packages
        self._lock = threading.Lock()
        self._size: int | None = None

    def read(self) -> int:
        """Read them once, and return their size in bytes; who comes later waits for the first."""
        with self._lock:
            if self._size is None:
                parts = (part for name in self._packages for part in _compiled_parts(name))
                self._size = sum(map(_read, parts))
            return self._size


def _compiled_parts(package: str) -> Iterator[Path]:
    spec = find_spec(package)
    for place in (spec and spec.submodule_search_locations) or ():
        # What wheels bring along lies in a folder of its own, beside the package.
        for folder in (Path(place), Path(place).with_name(f"{package.lower()}.libs")):
            for inside, _, names in os.walk(folder):
                yield from (Path(inside, name) for name in names if _COMPILED.search(name))


def _read(path: Path) -> int:
    buffer, size = bytearray(_CHUNK), 0
    try:
        with path.open("rb", buffering=0) as file:
            size = os.fstat(file.fileno()).st_size
            for start in range(0, size, _CHUNK):
                if not _is_at_hand(file.fileno(), start):
                    file.seek(start)
                    file.readinto(buffer)
    except OSError:
        pass  # Then loading it says what is wrong.
    return size


def _is_at_hand(file: int, start: int) -> bool:
    """Whether what begins there was read already, if the system can tell."""
    if not hasattr(os, "RWF_NOWAIT"):
        return False
    try:
        return os.preadv(file, [bytearray(1)], start, os.RWF_NOWAIT) == 1
    except OSError:
        return False
