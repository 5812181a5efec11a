"""What a user gives to be opened: an icon, a file, markup, an image, in whichever form it comes."""

import os
import re
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Any
from urllib.request import url2pathname

from iconstudio.model import Pictogram

_LONGEST = 60
"""Most characters that are shown of an address."""
_PATH = re.compile(r"[/~]|[A-Za-z]:[\\/]|\\\\")
_FILE = re.compile(r"file:(?://([^/?#]*))?([^?#]*)", re.IGNORECASE)
_WEB = re.compile(r"[A-Za-z][A-Za-z0-9+.-]*://")
_REFERENCE = re.compile(r"[a-z][a-z0-9-]*:[a-z0-9][a-z0-9-]*")
_MOST_LINES = 200
"""A longer text is no list of files."""


@dataclass(frozen=True, slots=True)
class Reference:
    """An icon of the collection, ``set:name``."""

    name: str


@dataclass(frozen=True, slots=True)
class File:
    """A file on this computer, or a folder."""

    path: str

    @property
    def name(self) -> str:
        """What to call it."""
        return Path(self.path).name or self.path


@dataclass(frozen=True, slots=True)
class Drawing:
    """SVG markup that is in no file."""

    data: bytes
    name: str = "drawing"


@dataclass(frozen=True, slots=True, eq=False)
class Image:
    """An image of pixels that is in no file: its bytes in whatever format, or what decodes it.

    That may be called in any thread, and is: an image may be large.
    """

    image: bytes | Callable[[], Any]
    name: str = "image"


@dataclass(frozen=True, slots=True)
class Elsewhere:
    """An address that is not on this computer."""

    address: str

    @property
    def name(self) -> str:
        """What to call it."""
        longer = len(self.address) > _LONGEST
        return self.address[: _LONGEST - 1] + "…" if longer else self.address


Item = Pictogram | Reference | File | Drawing | Image | Elsewhere


def named_in(text: str) -> tuple[Item, ...]:
    """Return what the lines of a text name, once each; nothing if one of them names nothing."""
    lines = [line.strip().strip("\"'") for line in text.splitlines() if line.strip()]
    if len(lines) > _MOST_LINES:
        return ()
    found = [_in_line(line) for line in lines]
    named = tuple(dict.fromkeys(one for one in found if one is not None))
    return () if None in found else named


def _in_line(line: str) -> Item | None:
    if (url := _FILE.match(line)) is not None:
        server, path = url[1], url2pathname(url[2])
        return File(f"//{server}{path}" if server and server != "localhost" else path)
    if _WEB.match(line):
        return Elsewhere(line)
    if _PATH.match(line):
        return File(os.path.expanduser(line))
    return Reference(line) if _REFERENCE.fullmatch(line) else None
