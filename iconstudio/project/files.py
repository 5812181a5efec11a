"""Project files: opened with all that is in them; saved, but never over what others saved."""

from collections.abc import Generator
from contextlib import closing
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from iconstudio.model import IconstudioError
from iconstudio.project import archive
from iconstudio.project.archive import Project
from iconstudio.project.contents import Contents, Formats, reading
from iconstudio.project.journal import LeftBehind
from iconstudio.project.parts import ProjectSession

Stamp = tuple[int, int, int]
"""Time, size and number of a file: another one, and it was written since."""


@dataclass(frozen=True, slots=True, eq=False)
class OpenedProject:
    """What was read, and where."""

    contents: Contents
    path: Path | None = None
    """The file that it is of; None if it was never saved."""
    stamp: Stamp | None = None
    """Of the file as it was read; None if its work was left behind."""
    left: LeftBehind | None = None
    """What it was read from, if that was no file."""


def opening(session: ProjectSession, path: Path, formats: Formats) -> Generator[Any]:
    """Yield what is in a project file, an ``OpenedProject``, at last; before, progress or None.

    Raises
    ------
    IconstudioError
        If it cannot be read.
    """
    stamp = stamp_of(path)
    with closing(reading(session, archive.read(path), formats)) as steps:
        for step in steps:
            yield OpenedProject(step, path, stamp) if isinstance(step, Contents) else step


def restoring(session: ProjectSession, left: LeftBehind, formats: Formats) -> Generator[Any]:
    """Yield the work that a window left behind; see ``opening``."""
    path = Path(left.file) if left.file else None
    with closing(reading(session, left.read(), formats)) as steps:
        for step in steps:
            yield OpenedProject(step, path, left=left) if isinstance(step, Contents) else step


def save(path: Path, project: Project, known: Stamp | None = None) -> Stamp | None:
    """Save a project, and return the stamp of its file.

    Parameters
    ----------
    known
        The stamp of the file that may be replaced; None: any.

    Raises
    ------
    IconstudioError
        If it cannot be written, or another file is there by now.
    """
    if known is not None and stamp_of(path) not in (None, known):
        raise IconstudioError(
            f"“{path}” has changed since it was opened here, and was left as it is. "
            "Save this project under another name."
        )
    archive.save(path, project)
    return stamp_of(path)


def stamp_of(path: Path) -> Stamp | None:
    """Return what changes when a file is written; None if there is none."""
    try:
        there = path.stat()
    except OSError:
        return None
    return there.st_mtime_ns, there.st_size, there.st_ino
