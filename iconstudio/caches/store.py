"""A folder of small files, each found by a key: what was computed once and need not be again."""

import hashlib
import logging
import shutil
from pathlib import Path

from iconstudio.files import reason_of, write_atomically

log = logging.getLogger(__name__)


class Store:
    """Keeps bytes in ``folder`` by key. Several processes may use the same folder.

    Where the folder cannot be written, nothing is kept, and everything works without it.

    Attributes
    ----------
    trouble:
        A sentence for the user if the folder cannot be used, else None.
    """

    def __init__(self, folder: Path) -> None:
        self.trouble: str | None = None
        self._folder = folder
        self._damaged = False

    def read(self, key: str) -> bytes:
        """Return what was written under ``key``, if it is whole; else it may be anything.

        Raises
        ------
        OSError
            If there is nothing.
        """
        return self._path(key).read_bytes()

    def write(self, key: str, data: bytes) -> None:
        """Keep ``data`` under ``key``, if the folder can be written."""
        if self.trouble is not None:
            return
        path = self._path(key)
        try:
            self._clear(path)
            path.parent.mkdir(parents=True, exist_ok=True)
            write_atomically(path, data)
        except OSError as error:
            self.trouble = (
                f"Drawings are not kept in {self._folder}: {reason_of(error)}. "
                "The next start will be slower."
            )

    def note_damage(self, key: str, reason: Exception) -> None:
        """Write a line in the log, once, that what was read is no good; it is to be made anew."""
        if not self._damaged and not isinstance(reason, FileNotFoundError):
            log.warning(
                "Damaged files of the cache are made anew: %s (%s)", self._path(key), reason
            )
            self._damaged = True

    def _clear(self, path: Path) -> None:
        """Remove what no store has put there: a folder for a file, a file for a folder."""
        if path.is_dir() and not path.is_symlink():
            shutil.rmtree(path)
        if path.parent != self._folder and path.parent.is_file():
            path.parent.unlink()

    def _path(self, key: str) -> Path:
        return self._folder / key[:2] / key[2:]


def key_of(*parts: object) -> str:
    """Return a key that differs if any of the parts, texts or bytes, does."""
    digest = hashlib.sha256()
    for part in parts:
        data = part if isinstance(part, bytes) else str(part).encode(errors="surrogatepass")
        digest.update(len(data).to_bytes(8, "little") + data)
    return digest.hexdigest()[:40]
