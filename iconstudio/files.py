"""Reading files that may be anything, and writing files so that nobody ever sees half of one."""

import errno
import os
import secrets
import stat
from pathlib import Path

from iconstudio.model import IconstudioError

_AT_ONCE = getattr(os, "O_NONBLOCK", 0) | getattr(os, "O_NOCTTY", 0)
"""Opening and reading never wait: not for the other end of a pipe, nor for a device."""
_NO_FILE = "a device, a pipe or a socket"


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


def write_atomically(path: Path, data: bytes) -> None:
    """Write ``data`` to ``path``, replacing what is there in one step.

    Through a symbolic link its target is written. A file keeps its permissions.

    Raises
    ------
    OSError
        If it cannot be written; then ``path`` is as it was before.
    """
    target = Path(os.path.realpath(path))
    before = _replaceable(target if path.is_symlink() else path)
    temporary = target.with_name(f".{secrets.token_hex(8)}.part")
    try:
        with temporary.open("xb") as file:
            if before is not None:
                temporary.chmod(stat.S_IMODE(before.st_mode))
            file.write(data)
        os.replace(temporary, target)
    except BaseException:
        temporary.unlink(missing_ok=True)
        raise


def _why(path: Path, error: OSError) -> str:
    """Say why what is there cannot be read."""
    if os.path.isdir(path):
        return "It is a folder. Choose a file in it."
    if error.errno in (errno.ENXIO, errno.EOPNOTSUPP):  # what opening a socket gives
        return f"It is {_NO_FILE}. Choose a file on a disk."
    return f"It cannot be read: {error.strerror or error}."


def _replaceable(path: Path) -> os.stat_result | None:
    """Return what is known of a file that may be replaced; None if there is none yet."""
    try:
        found = path.stat()
    except FileNotFoundError:
        return None
    if stat.S_ISDIR(found.st_mode):
        raise IsADirectoryError(errno.EISDIR, "it is a folder")
    if not stat.S_ISREG(found.st_mode):
        raise OSError(errno.EINVAL, f"it is {_NO_FILE}")
    if not os.access(path, os.W_OK):
        raise PermissionError(errno.EACCES, os.strerror(errno.EACCES))
    return found
