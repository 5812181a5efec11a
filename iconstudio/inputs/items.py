"""What a user gives to be opened: an icon, a file, markup, an image, in whichever form it comes."""

from dataclasses import dataclass
from pathlib import Path
from typing import Any

from iconstudio.model import Pictogram

_LONGEST = 60
"""Most characters that are shown of an address."""


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
    """An image of pixels that is in no file: its bytes in whatever format, or as the window has it.

    What the window has, only the window can read.
    """

    image: bytes | Any
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
