"""The bundled collection as files: written by the builder, read once by the first opening.

``manifest.json`` says which files belong to the collection, with their lengths and SHA-256 digests.
``index.json.xz`` holds everything but the drawings, in columns; ``bodies.txt.xz`` one body a line;
``shapes.bin.xz`` the fingerprints. Times and machines leave no trace in them. The same input gives
the same bytes with the same version of liblzma; another may pack differently, with the
same contents.
"""

import hashlib
import json
import lzma
import os
from dataclasses import asdict, dataclass, field
from pathlib import Path
from typing import Any

from iconstudio.library.iconify import IconSet
from iconstudio.library.words.indexing import Index
from iconstudio.model import IconstudioError

FORMAT = 2
MANIFEST = "manifest.json"
_FILTERS = [
    {
        "id": lzma.FILTER_LZMA2,
        "preset": 9 | lzma.PRESET_EXTREME,
        "dict_size": 1 << 26,
        "lc": 4,
        "lp": 0,
        "pb": 0,
    }
]


@dataclass(frozen=True, slots=True)
class Contents:
    """A collection in memory: columns of equal length, one row an icon, and what finds the rows."""

    sets: tuple[IconSet, ...]
    set_of: list[int]
    """Index into ``sets``."""
    names: list[str]
    view_boxes: list[str]
    bodies: list[str]
    cells: bytes
    """Fingerprints, joined (see ``fingerprint``)."""
    blackness: bytes
    """Per cent, a byte an icon."""
    index: Index = field(default_factory=Index)


def write(contents: Contents, folder: Path) -> None:
    """Write the files of a collection into ``folder``, the manifest last.

    Each file replaces an older one at once, or not at all.
    """
    index = {
        "sets": [asdict(one) | {"url": one.url} for one in contents.sets],
        "set_of": contents.set_of,
        "names": contents.names,
        "view_boxes": contents.view_boxes,
        **asdict(contents.index),
    }
    streams = {
        "index.json.xz": json.dumps(index, separators=(",", ":"), ensure_ascii=False).encode(),
        "bodies.txt.xz": "\n".join(contents.bodies).encode(),
        "shapes.bin.xz": contents.cells + contents.blackness,
    }
    files: dict[str, dict[str, Any]] = {}
    for name, data in streams.items():
        packed = lzma.compress(data, format=lzma.FORMAT_XZ, filters=_FILTERS)
        _replace(folder / name, packed)
        files[name] = {"bytes": len(packed), "sha256": hashlib.sha256(packed).hexdigest()}
    manifest = {"format": FORMAT, "icons": len(contents.names), "files": files}
    _replace(folder / MANIFEST, (json.dumps(manifest, indent=1) + "\n").encode())


def _replace(path: Path, data: bytes) -> None:
    temporary = path.with_name(f".{path.name}.{os.getpid()}")
    try:
        temporary.write_bytes(data)
        os.replace(temporary, path)
    finally:
        temporary.unlink(missing_ok=True)


@dataclass(frozen=True, slots=True)
class Archive:
    """The files of a collection; nothing but the manifest has been read."""

    folder: Path
    icons: int
    files: dict[str, dict[str, Any]]

    @classmethod
    def at(cls, folder: Path) -> "Archive":
        """Return the collection in ``folder``.

        Raises
        ------
        IconstudioError
            If there is none, or its manifest is damaged.
        """
        try:
            manifest = json.loads((folder / MANIFEST).read_text(encoding="utf-8"))
            if manifest["format"] != FORMAT:
                raise ValueError(f"format {manifest['format']}")
            return cls(folder, int(manifest["icons"]), dict(manifest["files"]))
        except (OSError, ValueError, KeyError, TypeError) as error:
            raise damaged(folder / MANIFEST, str(error)) from None

    @property
    def digest(self) -> str:
        """Name of the contents: equal for equal collections only."""
        text = json.dumps([FORMAT, self.files], sort_keys=True)
        return hashlib.sha256(text.encode()).hexdigest()[:16]

    def read(self, name: str) -> bytes:
        """Return a file's contents, unpacked.

        Raises
        ------
        IconstudioError
            If the file is missing, cut short or changed.
        """
        path = self.folder / name
        try:
            packed = path.read_bytes()
            if hashlib.sha256(packed).hexdigest() != self.files[name]["sha256"]:
                raise ValueError(f"{len(packed)} of {self.files[name]['bytes']} bytes are there")
            return lzma.decompress(packed, format=lzma.FORMAT_XZ)
        except (OSError, ValueError, KeyError, lzma.LZMAError) as error:
            raise damaged(path, str(error)) from None


def damaged(path: Path, reason: str) -> IconstudioError:
    """Return the error that says that the bundled collection cannot be used."""
    return IconstudioError(
        f"The bundled icon collection is damaged or cut short: {path} ({reason}). "
        "Reinstall Iconstudio."
    )
