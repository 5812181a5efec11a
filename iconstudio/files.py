"""Writing files so that nobody ever sees half of one."""

import os
import secrets
import time
from contextlib import suppress
from pathlib import Path

_ABANDONED = 60.0
"""Seconds that no file takes to be written."""


def write_atomically(path: Path, data: bytes) -> None:
    """Write ``data`` to ``path``, replacing what is there in one step.

    Raises
    ------
    OSError
        If it cannot be written; then ``path`` is as it was before.
    """
    temporary = path.with_name(f".{os.getpid()}-{secrets.token_hex(8)}.part")
    try:
        with temporary.open("xb") as file:
            file.write(data)
        os.replace(temporary, path)
    except BaseException:
        temporary.unlink(missing_ok=True)
        raise


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
