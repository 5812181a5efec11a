"""Project files: a zip of ``project.json`` and its parts, read with bounds on everything.

Nothing is ever unpacked to a disk: parts are looked up by the names that ``project.json`` gives.
"""

import hashlib
import io
import re
import struct
import zipfile
import zlib
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Annotated, Any

from msgspec import Meta, field

from iconstudio.files import read_bytes, write_bytes
from iconstudio.inputs import json
from iconstudio.inputs.formats import Many, Record, Text
from iconstudio.model import IconstudioError

SUFFIX = ".iconstudio"
"""How names of project files end."""
VERSION = 1
"""Of the format; files of a later one are refused."""
INDEX = "project.json"
"""What names all other parts."""

MOST_BYTES = 1 << 29
"""Of a file; and of all that is in it, unpacked."""
MOST_PARTS = 10_000
_MOST_DIRECTORY = 2_000_000
"""Bytes of the list of parts, which is read whole."""
_END = b"PK\x05\x06"
"""Begins the last record of a zip, of 22 bytes and a remark."""
_PART = re.compile(r"(?:icons|results|photos)/[A-Za-z0-9_.-]{1,100}")
_NO_WORD = re.compile(r"[^A-Za-z0-9]+")
_SLUG = 40
"""Most characters that a name lends to a part's."""
_STORED = (".jpg", ".jpeg", ".png", ".webp", ".heic", ".avif")
"""What is compressed already."""
_EPOCH = (1980, 1, 1, 0, 0, 0)
"""The same work makes the same file."""


class Version(Record, frozen=True):
    """Of the format, as ``project.json`` says it; 0 if it does not."""

    version: Annotated[int, Meta(ge=0, le=1 << 30)] = 0


class Index(Record, frozen=True, omit_defaults=False):
    """``project.json``; each page and each icon in it is read by itself, if it can be."""

    version: int = VERSION
    current: Text = ""
    """The name of the workflow in sight."""
    pages: dict[str, Any] = field(default_factory=dict)
    """By the names of their workflows, as the format of each has it."""
    recent: Many[Text] = ()
    """The parts of the results that were picked."""
    icons: dict[str, Any] = field(default_factory=dict)
    """What is known of each, all but its drawing, by its reference."""
    file: Text = ""
    """Where it was saved, in a journal."""


@dataclass(frozen=True, slots=True)
class Project:
    """What a project file holds."""

    index: Index
    parts: Mapping[str, bytes]
    """By their names, ``icons/cat-1a2b3c4d.svg``."""
    unknown: tuple[str, ...] = ()
    """Fields of ``project.json`` that are not known here."""


def part_name(folder: str, name: str, suffix: str, data: bytes) -> str:
    """Return the name of a part, which says what is in it: no part ever changes."""
    slug = _NO_WORD.sub("-", name)[:_SLUG].strip("-").lower() or "part"
    return f"{folder}/{slug}-{hashlib.sha256(data).hexdigest()[:16]}{suffix}"


def save(path: Path, project: Project) -> None:
    """Write a project file in one step.

    Raises
    ------
    IconstudioError
        If it cannot be written; what was there is there still.
    """
    write_bytes(path, packed(project))


def packed(project: Project) -> bytes:
    """Return a project as a zip."""
    file = io.BytesIO()
    with zipfile.ZipFile(file, "w") as archive:
        for name, data in [(INDEX, json.encoded(project.index)), *sorted(project.parts.items())]:
            stored = name.lower().endswith(_STORED)
            how = zipfile.ZIP_STORED if stored else zipfile.ZIP_DEFLATED
            archive.writestr(zipfile.ZipInfo(name, _EPOCH), data, how)
    return file.getvalue()


def read(path: Path) -> Project:
    """Return what a project file holds.

    Raises
    ------
    IconstudioError
        If it cannot be read, is none, is damaged, or of a later version.
    """
    try:
        return unpacked(read_bytes(path, MOST_BYTES))
    except IconstudioError as error:
        raise IconstudioError(f"“{path.name}” cannot be opened. {error}") from None


def unpacked(data: bytes) -> Project:
    """Return what the bytes of a project file hold.

    Raises
    ------
    IconstudioError
        As ``read``; the sentence calls the file “it”.
    """
    _check_directory(data)
    try:
        with zipfile.ZipFile(io.BytesIO(data)) as archive:
            parts = _parts(archive)
    except IconstudioError:
        raise
    except (zipfile.BadZipFile, zlib.error, EOFError, OSError, struct.error):
        raise IconstudioError(f"It is damaged. {_ANOTHER}") from None
    except (RuntimeError, NotImplementedError, LookupError, ValueError, MemoryError):
        # It is encrypted, packed in a way of others, or holds lengths that make no sense.
        raise IconstudioError(f"It is packed in a way that is not understood. {_ANOTHER}") from None
    if INDEX not in parts:
        raise IconstudioError(_NONE)
    return project_of(parts.pop(INDEX), parts)


def project_of(text: bytes, parts: Mapping[str, bytes]) -> Project:
    """Return a project with a ``project.json`` of a version that can be read.

    Raises
    ------
    IconstudioError
        If that is no good, or of a later version.
    """
    here = Path(INDEX)
    try:
        data = json.parsed(text, here)
    except IconstudioError:
        raise IconstudioError(f"It is damaged: “{INDEX}” in it is no JSON. {_ANOTHER}") from None
    version = json.converted(data, Version, here).version
    if version > VERSION:
        raise IconstudioError(
            "It was saved by a later version of Iconstudio. Open it with that, or update this one."
        )
    if version < 1:
        raise IconstudioError(_NONE)
    index = json.converted(data, Index, here)
    return Project(index, parts, tuple(json.unknown_fields(index, data)))


_NONE = "It is no Iconstudio project. Choose a file that was saved by Iconstudio."
_ANOTHER = "Open an earlier copy of it, if there is one."


def _check_directory(data: bytes) -> None:
    """Refuse what is no zip, or one whose list of parts is too long, before it is read."""
    if not data.startswith(b"PK"):
        raise IconstudioError(_NONE)
    at = data.rfind(_END, max(0, len(data) - (1 << 16) - 22))
    if at < 0 or len(data) - at < 22:
        raise IconstudioError(f"It is damaged: its end is missing. {_ANOTHER}")
    (size,) = struct.unpack_from("<L", data, at + 12)
    if size > _MOST_DIRECTORY or data[max(0, at - 20) : at].startswith(b"PK\x06\x07"):
        raise IconstudioError(f"It holds more than {MOST_PARTS:,} parts. {_ANOTHER}")


def _parts(archive: zipfile.ZipFile) -> dict[str, bytes]:
    """Return the parts that a project can have; what else is there does not count."""
    infos = archive.infolist()
    if len(infos) > MOST_PARTS:
        raise IconstudioError(f"It holds more than {MOST_PARTS:,} parts. {_ANOTHER}")
    parts: dict[str, bytes] = {}
    room = MOST_BYTES
    for info in infos:
        if info.filename != INDEX and not _PART.fullmatch(info.filename):
            continue
        if info.filename in parts:
            raise IconstudioError(f"It holds “{info.filename}” twice. {_ANOTHER}")
        most = min(room, json.MOST_BYTES) if info.filename == INDEX else room
        with archive.open(info) as file:  # what it says of its length need not be true
            content = file.read(most + 1)
        if len(content) > most:
            raise IconstudioError(f"It holds more than {most:,} bytes. {_ANOTHER}")
        room -= len(content)
        parts[info.filename] = content
    return parts
