"""Reading files that may be anything, and writing files so that nobody ever sees half of one."""

import errno
import os
import re
import secrets
import stat
import time
from collections.abc import Callable, Iterable
from contextlib import suppress
from pathlib import Path

from iconstudio.model import IconstudioError

_AT_ONCE = getattr(os, "O_NONBLOCK", 0) | getattr(os, "O_NOCTTY", 0)
"""Opening and reading never wait: not for the other end of a pipe, nor for a device."""
_NO_FILE = "a device, a pipe or a socket"
_ABANDONED = 60.0
"""Seconds that no file takes to be written."""
_QUOTED = re.compile(r"“(?:[A-Za-z]:)?[/\\][^“”]*[/\\]([^/\\“”]+\.[^/\\“”]+)”")
"""The whole path of a file in a sentence; in brackets its name."""
_REASONS = {
    errno.EACCES: "you have no permission",
    errno.EPERM: "you have no permission",
    errno.EROFS: "nothing can be written on that disk",
    errno.ENOENT: "there is no such folder",
    errno.ENOTDIR: "a part of its path is a file, not a folder",
    errno.EISDIR: "it is a folder",
    errno.ENAMETOOLONG: "its name is too long",
    errno.ELOOP: "the links on the way there lead in a circle",
    errno.ENOSPC: "the disk is full",
    errno.EDQUOT: "you have used all your room on the disk",
    errno.EFBIG: "the disk takes no file so large",
    errno.EIO: "the disk does not work as it should",
    errno.EBUSY: "another program uses it",
    errno.EMFILE: "too many files are open",
    errno.ENFILE: "too many files are open",
}
"""Why a file cannot be read or written, by the usual numbers; else the system says it."""
_ADDRESS = re.compile(r"[a-z][a-z0-9+.-]+://", re.IGNORECASE)
"""How what lies elsewhere is addressed: it is never fetched, and no path."""


def is_address(reference: str) -> bool:
    """Whether a reference is an address of the web, say, and not the path of a file."""
    return _ADDRESS.match(reference) is not None


def with_names(sentence: str) -> str:
    """Return a sentence with the names of files in place of their whole paths.

    >>> with_names("Saved “/home/ann/icons/cat.svg”.")
    'Saved “cat.svg”.'
    """
    return _QUOTED.sub(r"“\1”", sentence)


def reason_of(error: OSError) -> str:
    """Return why a file cannot be read or written, in a few words.

    >>> reason_of(NotADirectoryError(errno.ENOTDIR, "Not a directory"))
    'a part of its path is a file, not a folder'
    """
    return _REASONS.get(error.errno or 0) or error.strerror or str(error)


def read_bytes(path: Path, most: int) -> bytes:
    """Return what is in a file of at most ``most`` bytes.

    What is no file on a disk is refused at once. It is looked at after it is opened, so that
    nothing can take its place in between.

    Raises
    ------
    IconstudioError
        If it cannot be read; the sentence calls the file “it”, so that the caller can name it.
    """
    try:
        with open(path, "rb", opener=lambda name, flags: os.open(name, flags | _AT_ONCE)) as file:
            found = os.fstat(file.fileno())
            if not stat.S_ISREG(found.st_mode):
                raise IconstudioError(f"It is {_NO_FILE}. Choose a file on a disk.")
            data = file.read(most + 1) if found.st_size <= most else None
    except FileNotFoundError:
        raise IconstudioError("There is no such file. Check its name and folder.") from None
    except OSError as error:
        raise IconstudioError(_why(path, error)) from None
    except ValueError:  # a zero byte, or half of a surrogate pair
        raise IconstudioError("No file can have such a name. Check it.") from None
    if data is None or len(data) > most:
        raise IconstudioError(f"It has more than {most:,} bytes. Choose a smaller one.")
    return data


def replaceable(path: Path) -> os.stat_result | None:
    """Return what is known of a file that is there and may be written; None if there is none.

    Raises
    ------
    OSError
        If it may not, or is no file on a disk.
    """
    try:
        found = path.stat()
    except FileNotFoundError:
        if not Path(os.path.realpath(path)).parent.is_dir():
            raise
        return None
    if stat.S_ISDIR(found.st_mode):
        raise IsADirectoryError(errno.EISDIR, _REASONS[errno.EISDIR])
    if not stat.S_ISREG(found.st_mode):
        raise OSError(errno.EINVAL, f"it is {_NO_FILE}")
    if not os.access(path, os.W_OK):
        raise PermissionError(errno.EACCES, os.strerror(errno.EACCES))
    return found


def write_atomically(path: Path, data: bytes) -> None:
    """Write ``data`` to ``path``, replacing what is there in one step.

    Through a symbolic link its target is written. A file keeps its permissions.

    Raises
    ------
    OSError
        If it cannot be written; then ``path`` is as it was before.
    """
    target = Path(os.path.realpath(path))
    before = replaceable(path)
    temporary = target.with_name(f".{os.getpid()}-{secrets.token_hex(8)}.part")
    try:
        with temporary.open("xb") as file:
            if before is not None:
                temporary.chmod(stat.S_IMODE(before.st_mode))
            file.write(data)
        os.replace(temporary, target)
    except BaseException:
        temporary.unlink(missing_ok=True)
        raise


def write_bytes(path: Path, data: bytes) -> None:
    """Write a file in one step; see ``write_atomically``.

    Raises
    ------
    IconstudioError
        If it cannot be written.
    """
    _writing(path, lambda: write_atomically(path, data))


def check_writable(path: Path, read: Iterable[str | Path | None] = ()) -> None:
    """Make sure that a file can be written, before what takes long; nothing is changed.

    Raises
    ------
    IconstudioError
        If it cannot, or is one of those that are ``read``.
    """
    for one in read:
        with suppress(OSError, ValueError):  # there is no such file
            if one is not None and path.samefile(one):
                raise IconstudioError(
                    f"“{path}” is read, and what is made would replace it. Choose another name."
                )
    _writing(path, lambda: replaceable(path))


def _writing(path: Path, write: Callable[[], object]) -> None:
    try:
        write()
    except OSError as error:
        reason = reason_of(error)
        if isinstance(error, FileNotFoundError) and path.parent.is_dir():
            reason = "that folder takes no files"
    except ValueError:  # a zero byte, or half of a surrogate pair
        reason = "no file can have such a name"
    else:
        return
    raise IconstudioError(f"“{path}” cannot be written: {reason}. Choose another place.")


def _why(path: Path, error: OSError) -> str:
    """Say why what is there cannot be read."""
    if os.path.isdir(path):
        return "It is a folder. Choose a file in it."
    if error.errno in (errno.ENXIO, errno.EOPNOTSUPP):  # what opening a socket gives
        return f"It is {_NO_FILE}. Choose a file on a disk."
    reason = reason_of(error)
    return f"{reason[:1].upper()}{reason[1:]}."


def remove_abandoned(folder: Path) -> None:
    """Remove what killed programs left half written in ``folder`` and the folders in it."""
    for file in (*folder.glob(".*.part"), *folder.glob("*/.*.part")):
        owner = file.name[1:].partition("-")[0]
        with suppress(OSError):
            if not (owner.isdecimal() and _lives(int(owner), file)):
                file.unlink()


def _lives(process: int, file: Path) -> bool:
    """Whether a process still writes a file, as far as that can be told."""
    if os.name == "nt":  # there, to ask would end it
        return time.time() - file.stat().st_mtime < _ABANDONED
    try:
        os.kill(process, 0)
    except ProcessLookupError:
        return False
    except OSError:
        pass
    return True
