"""Loads modules that are not imported before their first use, in whatever thread that is."""

import time
from importlib import import_module
from types import ModuleType

_ATTEMPTS = 3
_PAUSE = 0.1
"""Seconds until a module is tried again."""


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
