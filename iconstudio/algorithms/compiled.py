"""Compiled functions: the adapter of numba.

Importing it takes a third of a second, and the first call of a function some seconds to compile,
once: the result is kept beside the source, or in the user's cache folder if that cannot be written
(``NUMBA_CACHE_DIR`` names another). So only processes that cut import this.

What is kept carries a digest: numba itself would run code whose bytes have changed, and fails on a
file that was cut short. What is damaged is thrown away, and compiled anew.
"""

import hashlib
import io
import logging
import os
import pickle
import shutil
from collections.abc import Callable, Iterator
from contextlib import chdir, contextmanager, suppress
from typing import Any, ParamSpec, TypeVar

import numpy as np

with chdir(os.path.dirname(__file__)):  # numba looks for settings in the current folder,
    from numba import njit, types
    from numba.core import config
    from numba.core.caching import FunctionCache, IndexDataCacheFile
    from numba.extending import intrinsic
config._config_fname = os.devnull  # and does so again each time that it compiles

log = logging.getLogger(__name__)

P = ParamSpec("P")
R = TypeVar("R")


def part(function: Callable[P, R]) -> Callable[P, R]:
    """Compile a function that only compiled functions call: one without a cache of its own."""
    return njit(nogil=True)(function)


def inner(function: Callable[P, R]) -> Callable[P, R]:
    """Do the same, written out where it is called: arguments that are arrays cost time there."""
    return njit(nogil=True, inline="always")(function)


def entry(function: Callable[P, R]) -> Callable[P, R]:
    """Compile a function that Python calls; it runs without the interpreter lock."""
    compiled = njit(nogil=True)(function)
    with suppress(RuntimeError):  # nowhere to keep what is compiled
        compiled._cache = _Cache(function)  # type: ignore[attr-defined]  # numba does not tell it
    return compiled


class _Cache(FunctionCache):
    """Numba's cache of a function; what it cannot read or write is compiled and not kept."""

    _cache_file: "_CheckedFile"

    def __init__(self, function: Callable[..., object]) -> None:
        super().__init__(function)
        given = self._cache_file
        self._cache_file = _CheckedFile(
            given._cache_path, f"{self._impl.filename_base}.sha256", given._source_stamp
        )

    def load_overload(self, sig: object, target_context: object) -> object:
        try:
            return super().load_overload(sig, target_context)
        except Exception as error:
            self._cache_file.throw_away(error)
            return None

    def save_overload(self, sig: object, data: object) -> None:
        try:
            super().save_overload(sig, data)
        except OSError as error:
            log.warning("Compiled code cannot be kept in %s: %s", self.cache_path, error)


class _CheckedFile(IndexDataCacheFile):
    """Numba's index and data files, each after the digest of its contents."""

    def throw_away(self, reason: object, path: str | None = None) -> None:
        """Remove a damaged file, by default the index, with a line in the log."""
        path = path or self._index_path
        log.warning("Damaged compiled code is thrown away and made anew: %s (%s)", path, reason)
        with suppress(OSError):
            if os.path.isdir(path):
                shutil.rmtree(path)
            else:
                os.remove(path)

    def _load_index(self) -> dict[Any, Any]:
        contents = self._contents(self._index_path)
        if contents is None:
            return {}
        file = io.BytesIO(contents)
        if pickle.load(file) != self._version:
            return {}
        stamp, overloads = pickle.load(file)
        return dict(overloads) if stamp == self._source_stamp else {}

    def _load_data(self, name: str) -> object:
        contents = self._contents(self._data_path(name))
        if contents is None:
            raise FileNotFoundError(name)
        return pickle.loads(contents)

    def _contents(self, path: str) -> bytes | None:
        """Return what a file holds; None if it is not there, or was damaged."""
        try:
            with open(path, "rb") as file:
                digest, contents = file.read(32), file.read()
        except FileNotFoundError:
            return None
        except OSError as error:
            self.throw_away(error, path)
            return None
        if hashlib.sha256(contents).digest() != digest:
            self.throw_away("its digest is wrong", path)
            return None
        return contents

    @contextmanager
    def _open_for_write(self, filepath: str) -> Iterator[io.BytesIO]:
        contents = io.BytesIO()
        yield contents
        data = contents.getvalue()
        with super()._open_for_write(filepath) as file:
            file.write(hashlib.sha256(data).digest() + data)


@intrinsic
def _ones(typing_context: object, word: types.Type) -> tuple[object, Callable[..., object]]:
    def code(context: object, builder: Any, signature: object, arguments: Any) -> object:
        return builder.ctpop(arguments[0])

    return types.uint64(types.uint64), code


ones: Callable[[np.uint64], np.uint64] = _ones  # type: ignore[assignment]  # for compiled callers
"""Count the ones of a word; only compiled functions can."""
