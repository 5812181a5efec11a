"""The journal: a folder for each running window, in which its unsaved work outlives its end.

A window holds a lock on its folder, which the system releases when the window ends, in whatever
way; so a folder with work that can be locked was left behind.
"""

import os
import secrets
import shutil
import time
from collections.abc import Generator, Mapping
from contextlib import suppress
from dataclasses import dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING

from iconstudio.files import read_bytes, reason_of, write_atomically
from iconstudio.inputs import json
from iconstudio.model import IconstudioError
from iconstudio.project import archive
from iconstudio.project.archive import INDEX, Index, Project

if TYPE_CHECKING:
    from filelock import FileLock

_LOCK = "lock"
_PARTS = ("icons", "results", "photos")
_NEW = 60.0
"""Seconds in which a folder is given its first work."""


def data_folder() -> Path:
    """Return the folder in which the program keeps what it cannot make again."""
    if named := os.environ.get("ICONSTUDIO_DATA"):
        return Path(named)
    from platformdirs import user_data_path

    return user_data_path("iconstudio", appauthor=False)


def journals_folder() -> Path:
    """Return the folder of all journals."""
    return data_folder() / "journals"


class Journal:
    """The unsaved work of one window. Its methods may be called from any thread, one at a time."""

    def __init__(self, folder: Path) -> None:
        """``folder`` has those of all windows."""
        self.folder = folder / f"{os.getpid()}-{secrets.token_hex(6)}"
        self._lock: FileLock | None = None
        self._there: set[str] = set()

    def write(self, project: Project) -> None:
        """Keep this work in place of what was kept.

        Raises
        ------
        IconstudioError
            If it cannot be written.
        """
        try:
            self._write(project)
        except OSError as error:
            raise IconstudioError(
                f"The unsaved work cannot be kept in “{self.folder.parent}”: "
                f"{reason_of(error)}. Save it soon."
            ) from None

    def clear(self) -> None:
        """Keep nothing any more: it is saved, or was let go."""
        if self._lock is not None:
            _remove(self.folder, self._lock)
        self._lock = None
        self._there.clear()

    def _write(self, project: Project) -> None:
        if self._lock is None:
            for kind in _PARTS:
                (self.folder / kind).mkdir(parents=True, exist_ok=True)
            lock = _lock_of(self.folder)
            lock.acquire(timeout=0)
            self._lock = lock
        for name in project.parts.keys() - self._there:  # a part never changes
            write_atomically(self.folder / name, project.parts[name])
        self._there |= project.parts.keys()
        write_atomically(self.folder / INDEX, json.encoded(project.index))
        for name in self._there - project.parts.keys():
            (self.folder / name).unlink(missing_ok=True)
        self._there &= project.parts.keys()


@dataclass(frozen=True, slots=True, eq=False)
class LeftBehind:
    """Work that a window left behind; nobody else is offered it as long as it is held."""

    folder: Path
    when: float
    """Seconds since the epoch."""
    lock: "FileLock"
    file: str = ""
    """The path of the file that it is of; empty if it was never saved."""
    current: str = ""
    """The name of the workflow that was in sight."""

    def read(self) -> Project:
        """Return what it holds.

        Raises
        ------
        IconstudioError
            If it cannot be read.
        """
        parts = {
            f"{kind}/{file.name}": read_bytes(file, archive.MOST_BYTES)
            for kind in _PARTS
            for file in sorted((self.folder / kind).glob("[!.]*"))
        }
        return self._with(parts)

    def index(self) -> Index:
        """Return what it says, without its parts; see ``read``."""
        return self._with({}).index

    def discard(self) -> None:
        """Remove it for good."""
        _remove(self.folder, self.lock)

    def release(self) -> None:
        """Leave it for the next start."""
        self.lock.release()

    def _with(self, parts: Mapping[str, bytes]) -> Project:
        index = read_bytes(self.folder / INDEX, json.MOST_BYTES)
        return archive.project_of(index, parts)


def left_behind(folder: Path) -> Generator[LeftBehind]:
    """Yield what windows that are no more have left in the folder of all journals, newest first."""
    import filelock  # noqa: F401 - so that the first edit need not wait until that is loaded

    found = []
    with suppress(OSError):
        found = [one for one in folder.iterdir() if one.is_dir()]
    dated = [(_changed(one / INDEX), one) for one in found]
    for when, one in sorted(dated, reverse=True):
        lock = _lock_of(one)
        try:
            if when == 0 and time.time() - _changed(one) < _NEW:
                continue
            lock.acquire(timeout=0)
        except OSError:  # it lives
            continue
        if _changed(one / INDEX):
            left = LeftBehind(one, when, lock)
            with suppress(IconstudioError):  # it is told when it is to be restored
                index = left.index()
                left = replace(left, file=index.file, current=index.current)
            yield left
        else:  # what was cleared, or never written
            _remove(one, lock)


def _lock_of(folder: Path) -> "FileLock":
    from filelock import FileLock  # it loads much that the window can open without

    return FileLock(folder / _LOCK, thread_local=False)


def _remove(folder: Path, lock: "FileLock") -> None:
    with suppress(OSError):
        (folder / INDEX).unlink(missing_ok=True)  # first: half of it is nothing to offer
    lock.release(force=True)
    shutil.rmtree(folder, ignore_errors=True)


def _changed(path: Path) -> float:
    """Return when something was last written; 0 if it is not there."""
    try:
        return path.stat().st_mtime
    except OSError:
        return 0.0
