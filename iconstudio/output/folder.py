"""The folder that a run without a window fills."""

import hashlib
import json
import os
import re
import tempfile
from collections.abc import Mapping
from contextlib import suppress
from pathlib import Path
from typing import Any

from PIL import Image

from iconstudio.files import read_bytes, reason_of, replaceable, write_bytes
from iconstudio.model import Icon, IconstudioError, Remix
from iconstudio.output import export, png
from iconstudio.output.colours import Palette

_REPORT = "results.json"
_KINDS = (".svg", ".png", ".npz")
_MOST_BYTES = 100_000_000
_SOON = 2.0
"""Seconds after a report without digests in which its run may have written a file: clocks of disks
are coarse."""


def check_folder(path: Path) -> None:
    """Make sure that a folder can be written, or made; nothing is left behind.

    Raises
    ------
    IconstudioError
        If it cannot.
    """
    there = next(one for one in (path, *path.absolute().parents) if os.path.lexists(one))
    try:
        with suppress(FileNotFoundError, NotADirectoryError):
            path.lstat()  # it may have a name that nothing can have
        with tempfile.TemporaryFile(dir=there) as file:
            file.write(b"0")
    except OSError as error:
        raise _unwritable(path, error) from None
    if there != path:
        return
    try:
        replaceable(path / _REPORT)
    except OSError as error:
        raise IconstudioError(
            f"“{path / _REPORT}” cannot be written: {reason_of(error)}. Choose another folder."
        ) from None


class Folder:
    """Writes files, each in one step; it is made with the first of them.

    Raises
    ------
    IconstudioError
        On construction and from every method, if the folder cannot be written.
    """

    def __init__(self, path: Path) -> None:
        check_folder(path)
        self._path = path

    def write(self, files: Mapping[str, bytes]) -> None:
        """Write files by their names."""
        try:
            self._path.mkdir(parents=True, exist_ok=True)
        except OSError as error:
            raise _unwritable(self._path, error) from None
        for name, content in files.items():
            write_bytes(self._path / name, content)

    def write_picture(self, name: str, picture: Image.Image) -> None:
        """Write a picture as PNG."""
        self.write({name: png.encoded(picture)})

    def write_icon(self, name: str, icon: Icon, colours: Palette | None = None) -> None:
        """Write an icon: ``NAME.svg``, ``NAME.png``; of a remix, by source ``NAME-sources.png``."""
        files = {f"{name}.svg": export.svg(icon), f"{name}.png": export.png(icon, png.SIZE)}
        if isinstance(icon, Remix):
            code = export.colour_code_png(icon, png.SIZE // 2, colours)
            files[f"{name}-sources.png"] = code
        self.write(files)


class ResultsFolder(Folder):
    """A folder with a report, ``results.json``, that lists all files of a run.

    What an earlier run of the same kind left is replaced or removed; nothing else is, nor what
    was changed since. The report is there from the first file on, so that this holds for a run
    that was stopped, too; ``finished`` says whether all is there.

    Parameters
    ----------
    kind
        The workflow that fills it.
    stems
        A regular expression for the names, without ending, of all that it may write: what is in
        the way is told before any work.

    Raises
    ------
    IconstudioError
        As of a folder; also if it holds results of another kind, or a file that is in the way.
    """

    def __init__(self, path: Path, kind: str, stems: str) -> None:
        super().__init__(path)
        self._kind = kind
        self._before = _listed(path / _REPORT, kind)
        self._written: dict[str, str] = {}
        names = re.compile(rf"(?:{stems})(?:-sources)?(?:{'|'.join(map(re.escape, _KINDS))})")
        for name in sorted(os.listdir(path)) if path.is_dir() else ():
            if names.fullmatch(name):
                self._check_free(name)

    def write(self, files: Mapping[str, bytes]) -> None:
        """Write files by their names, once they are listed."""
        for name in files.keys() - self._written.keys():
            self._check_free(name)
        self._written |= {name: digest(content) for name, content in files.items()}
        self._report({"finished": False}, self._before | self._written)
        super().write(files)

    def write_report(self, report: dict[str, Any]) -> None:
        """Write ``results.json``; what the one before lists, and this run has not, is removed."""
        for name in self._before.keys() - self._written.keys():
            with suppress(OSError):  # it is in nobody's way
                (self._path / name).unlink()
        self._report(report | {"finished": True}, self._written)

    def _report(self, report: dict[str, Any], files: Mapping[str, str]) -> None:
        listed = {"kind": self._kind, "files": sorted(files), "digests": files}
        report = report | listed
        text = json.dumps(report, indent=1, ensure_ascii=False, allow_nan=False)
        super().write({_REPORT: text.encode()})

    def _check_free(self, name: str) -> None:
        path = self._path / name
        if name not in self._before and os.path.lexists(path):
            raise IconstudioError(
                f"“{path}” is there already, and no such run has made it as it is now. "
                "Choose another folder, or move it."
            )


def _unwritable(path: Path, error: OSError) -> IconstudioError:
    return IconstudioError(
        f"The folder “{path}” cannot be written: {reason_of(error)}. Choose another one."
    )


def _listed(report: Path, kind: str) -> dict[str, str]:
    """Return the files beside a report of some kind that its run wrote, and nobody since.

    With their digests. Reports of version 0.3 and before list them result by result.

    Raises
    ------
    IconstudioError
        If it is of another kind, or no report.
    """
    if not os.path.lexists(report):
        return {}
    try:
        said = json.loads(read_bytes(report, _MOST_BYTES))
        other = said.get("kind", kind)
        names = said.get("files") or [
            result[form] for result in said["results"] for form in ("svg", "png", "sources_png")
        ]
        digests = dict(said.get("digests", {}))
        ours = {name for name in names if Path(name).name == name and name.endswith(_KINDS)}
        latest = report.stat().st_mtime + _SOON
    except (
        IconstudioError,
        OSError,
        ValueError,
        RecursionError,
        TypeError,
        KeyError,
        AttributeError,
    ):
        raise IconstudioError(
            f"“{report}” is a file of yours, which would be replaced. "
            "Choose another folder, or move it."
        ) from None
    if other != kind:
        raise IconstudioError(
            f"“{report.parent}” holds the results of “{other}”. "
            "Choose another folder, or move that one."
        )
    found = {name: digest_of(report.parent / name) for name in ours}
    return {
        name: now
        for name, now in found.items()
        if digests.get(name, now) == now
        and (name in digests or _changed(report.parent / name) <= latest)
    }


def digest(content: bytes) -> str:
    """Return what tells files of other content apart."""
    return hashlib.sha256(content).hexdigest()


def digest_of(path: Path) -> str:
    """Return the digest of a file; empty if it cannot be read, or is not there."""
    try:
        return digest(read_bytes(path, _MOST_BYTES))
    except IconstudioError:
        return ""


def _changed(path: Path) -> float:
    """Return when a file was changed last; what is not there never was."""
    try:
        return path.stat().st_mtime
    except OSError:
        return 0.0
