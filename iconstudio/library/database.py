"""The unpacked collection: one SQLite file in the user's cache, made at the first opening.

It is written beside its final place and moved there when it is complete, so an
interrupted first opening leaves nothing that could be taken for a collection, and two programs
that open at the same time do no harm: the last one's file replaces an equal one.

A checksum tells if a byte of it has changed. To read it all takes a twentieth of a second, so it is
done only where the file's time of change is not the one that the last check has given it.
"""

import errno
import json
import os
import shutil
import sqlite3
import tempfile
import time
import zlib
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from contextlib import closing, contextmanager, suppress
from itertools import repeat
from pathlib import Path
from typing import Any

from iconstudio.files import reason_of
from iconstudio.library.archive import MANIFEST, Archive, damaged
from iconstudio.model import IconstudioError
from iconstudio.model.progress import Progress

FORMAT = 3
"""To be raised when the database changes; those of other versions are then left alone."""
_ABANDONED = 3600.0
"""Seconds after which the collection of another version may be removed."""
_CHECKSUM = slice(60, 64)
"""Where a database keeps its "user version", in which no bit of its own counts."""

_SCHEMA = """
CREATE TABLE icon (
    number INTEGER PRIMARY KEY, id TEXT, joined TEXT, set_number INTEGER, view_box TEXT, body TEXT);
CREATE TABLE naming (phrase INTEGER, icon INTEGER, PRIMARY KEY (phrase, icon)) WITHOUT ROWID;
CREATE TABLE reading (
    term TEXT, phrase INTEGER, tier INTEGER, PRIMARY KEY (term, phrase)) WITHOUT ROWID;
CREATE TABLE relation (
    word TEXT, term TEXT, rank INTEGER, PRIMARY KEY (word, term)) WITHOUT ROWID;
CREATE TABLE wording (joined TEXT, phrase INTEGER, PRIMARY KEY (joined, phrase)) WITHOUT ROWID;
CREATE TABLE proposal (word TEXT);
CREATE TABLE icon_set (
    number INTEGER PRIMARY KEY, prefix TEXT, author TEXT, license TEXT, license_url TEXT, url TEXT);
CREATE TABLE shapes (cells BLOB, blackness BLOB);
"""


def unpack(archive: Archive, path: Path) -> Iterator[Progress]:
    """Write the collection of ``archive`` to the database ``path``, yielding progress.

    Raises
    ------
    IconstudioError
        If the collection is damaged, or the folder of ``path`` is full or cannot be written.
    """
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
        with _temporary(path.parent) as temporary:
            yield from _fill(archive, temporary)
            _seal(temporary)
            if path.is_dir() and not path.is_symlink():
                shutil.rmtree(path)
            os.replace(temporary, path)
        _remove_others(path)
    except (OSError, sqlite3.OperationalError) as error:
        if is_sound(path):  # another program, which may hold the file open, was first
            return
        raise IconstudioError(_no_room(path.parent, error)) from None


@contextmanager
def _temporary(folder: Path) -> Iterator[Path]:
    """Give a new file to unpack into, which nobody removes before this ends."""
    while True:
        handle, name = tempfile.mkstemp(prefix=".unpacking-", suffix=".sqlite", dir=folder)
        if _locked(handle) and os.path.exists(name):
            break
        os.close(handle)  # somebody took it for abandoned before it was locked
    try:
        yield Path(name)
    finally:
        os.close(handle)
        Path(name).unlink(missing_ok=True)


def _locked(handle: int) -> bool:
    """Lock an open file, unless another program has: a lock ends with its process."""
    try:
        import fcntl
    except ImportError:  # Windows, where no open file can be removed
        return True
    try:
        fcntl.flock(handle, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except BlockingIOError:
        return False
    except OSError:  # a file system without locks
        return time.time() - os.fstat(handle).st_mtime > _ABANDONED
    return True


def remove_abandoned(folder: Path) -> None:
    """Remove what programs that were killed left half unpacked, however young it is."""
    for file in folder.glob(".unpacking-*"):
        with suppress(OSError):
            handle = os.open(file, os.O_RDWR)
            try:
                if _locked(handle) and os.name != "nt":
                    file.unlink()
            finally:
                os.close(handle)
            if os.name == "nt":
                file.unlink()


def _remove_others(path: Path) -> None:
    """Remove the collections of other versions."""
    old = time.time() - _ABANDONED
    for other in path.parent.glob("collection-*.sqlite"):
        with suppress(OSError):
            if other != path and other.stat().st_mtime < old:
                other.unlink()


def _no_room(folder: Path, error: Exception) -> str:
    full = getattr(error, "errno", None) == errno.ENOSPC or "full" in str(error)
    why = reason_of(error) if isinstance(error, OSError) else error
    reason = "The disk is full" if full else f"It cannot be written ({why})"
    return (
        f"The icon collection cannot be unpacked into {folder}. {reason}. Make room for 150 MB "
        "there, or name another folder in the environment variable ICONSTUDIO_CACHE."
    )


def _fill(archive: Archive, path: Path) -> Iterator[Progress]:
    yield Progress("search", 0.0, "Unpacking the icon collection (only this once)")
    with ThreadPoolExecutor(3) as pool:  # liblzma lets other threads run
        bodies, index, shapes = (
            pool.submit(archive.read, name)
            for name in ("bodies.txt.xz", "index.json.xz", "shapes.bin.xz")
        )
        columns = _columns(index.result().decode())
        yield Progress("search", 0.3, "Unpacking the icon collection: the words")
        with closing(sqlite3.connect(path, isolation_level=None)) as database:
            database.executescript(
                "PRAGMA journal_mode = OFF; PRAGMA synchronous = OFF; BEGIN;" + _SCHEMA
            )
            _insert_words(database, columns)
            yield Progress("search", 0.6, "Unpacking the icon collection: the drawings")
            lines = bodies.result().decode().split("\n")
            cells = shapes.result()
            count = archive.icons
            if len(lines) != count or len(columns["names"]) != count:
                raise damaged(archive.folder / MANIFEST, "the files do not belong together")
            _insert_icons(database, columns, lines)
            database.execute("INSERT INTO shapes VALUES (?, ?)", (cells[:-count], cells[-count:]))
            database.execute("COMMIT")
    yield Progress("search", 1.0, "The icon collection is unpacked")


def _columns(index: str) -> dict[str, Any]:
    """Return what an index holds, one column after another.

    No other thread runs while JSON is decoded: all of it at once would hold up the window.
    """
    decoder, columns, at = json.JSONDecoder(), {}, 1
    while index[at : at + 1] == '"':
        name, at = decoder.raw_decode(index, at)
        columns[name], at = decoder.raw_decode(index, at + 1)
        at += 1
    return columns


def _insert_words(database: sqlite3.Connection, columns: dict[str, Any]) -> None:
    database.executemany(
        "INSERT INTO reading VALUES (?, ?, ?)",
        (
            (term, phrase, tier)
            for term, pairs in columns["readings"].items()
            for phrase, tier in zip(pairs[::2], pairs[1::2], strict=True)
        ),
    )
    database.executemany(
        "INSERT INTO relation VALUES (?, ?, ?)",
        (
            (word, term, rank)
            for word, pairs in columns["relations"].items()
            for term, rank in zip(pairs[::2], pairs[1::2], strict=True)
        ),
    )
    joined = sorted((name.replace("-", ""), n) for n, name in enumerate(columns["wordings"]))
    database.executemany("INSERT INTO wording VALUES (?, ?)", joined)
    database.executemany(
        "INSERT INTO proposal VALUES (?)", ((word,) for word in columns["proposals"])
    )
    named = sorted(
        pair
        for icon, phrases in enumerate(columns["phrases"])
        for pair in zip(phrases, repeat(icon))
    )
    database.executemany("INSERT INTO naming VALUES (?, ?)", named)


def _insert_icons(database: sqlite3.Connection, columns: dict[str, Any], bodies: list[str]) -> None:
    sets = columns["sets"]
    database.executemany(
        "INSERT INTO icon_set VALUES (?, ?, ?, ?, ?, ?)",
        (
            (number, *(one[key] for key in ("prefix", "author", "license", "license_url", "url")))
            for number, one in enumerate(sets)
        ),
    )
    rows = zip(columns["set_of"], columns["names"], columns["view_boxes"], bodies, strict=True)
    database.executemany(
        "INSERT INTO icon VALUES (?, ?, ?, ?, ?, ?)",
        (
            (number, f"{sets[one]['prefix']}:{name}", name.replace("-", ""), one, view_box, body)
            for number, (one, name, view_box, body) in enumerate(rows)
        ),
    )
    database.execute("CREATE UNIQUE INDEX icon_by_id ON icon (id)")
    database.execute("CREATE INDEX icon_by_name ON icon (joined)")


def is_sound(path: Path, thorough: bool = False) -> bool:
    """Whether ``path`` is the database that was once unpacked there, to the last byte.

    It is read only if its time of change is not that of the last check, or to be ``thorough``.
    """
    try:
        with path.open("rb") as file:
            header = file.read(100)
        if not _is_complete(header, path.stat().st_size):
            return False
        stored = int.from_bytes(header[_CHECKSUM], "big")
        if not thorough and path.stat().st_mtime_ns % 10**9 == _fraction(stored):
            return True
        if _checksum(path) != stored:
            return False
        with suppress(OSError):  # of another user, perhaps
            _mark(path, stored)
        return True
    except OSError:
        return False


def _is_complete(header: bytes, size: int) -> bool:
    """Whether a database is as long as its header says."""
    page = int.from_bytes(header[16:18], "big")
    page = 65536 if page == 1 else page
    pages = int.from_bytes(header[28:32], "big")
    return header.startswith(b"SQLite format 3\0") and size == page * pages


def _seal(path: Path) -> None:
    """Write a database's checksum into it."""
    checksum = _checksum(path)
    with path.open("r+b") as file:
        file.seek(_CHECKSUM.start)
        file.write(checksum.to_bytes(4, "big"))
    _mark(path, checksum)


def _mark(path: Path, checksum: int) -> None:
    """Remember in a file's time of change that it was checked: any change ends that."""
    now = int(time.time()) * 10**9 + _fraction(checksum)
    os.utime(path, ns=(now, now))


def _fraction(checksum: int) -> int:
    """Return the nanoseconds of a second that stand for a checksum; NTFS counts in hundreds."""
    return checksum % 10**7 * 100


def _checksum(path: Path) -> int:
    """Return the CRC-32 of a file but for the place where it is kept."""
    with path.open("rb") as file:
        head = bytearray(file.read(100))
        head[_CHECKSUM] = bytes(4)
        checksum = zlib.crc32(head)
        while block := file.read(1 << 20):
            checksum = zlib.crc32(block, checksum)
    return checksum
