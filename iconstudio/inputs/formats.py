"""What the formats of files are declared with: records, and types with bounds.

Every number needs some: those of JSON may be infinite, or none.

A format is a ``Record`` beside what it is of: its fields are those of the JSON object, and their
types say what may be in them. ``json`` reads and writes it, and says what is wrong in a sentence.
"""

import re
from typing import Annotated, TypeVar

from msgspec import Meta, Struct

LARGEST = 1e9
"""Coordinates beyond it are a mistake."""
MOST_POINTS = 200_000
"""Points of a line or an outline."""
MOST_INNER = 200
"""Holes, or lines, inside an outline."""
MOST_IN_LIST = 10_000
"""Entries of any other list."""
LONGEST_TEXT = 4096
"""Characters of a text, as of a path."""

ODD = re.compile(r"[\0\ud800-\udfff]")
"""Characters that are none."""

T = TypeVar("T")
Many = Annotated[tuple[T, ...], Meta(max_length=MOST_IN_LIST)]
"""A list."""
Text = Annotated[str, Meta(max_length=LONGEST_TEXT, pattern=r"^[^\0\ud800-\udfff]*$")]
TextSet = Annotated[frozenset[Text], Meta(max_length=MOST_IN_LIST)]

Coordinate = Annotated[float, Meta(ge=-LARGEST, le=LARGEST)]
Points = Annotated[tuple[tuple[Coordinate, Coordinate], ...], Meta(max_length=MOST_POINTS)]
Polygons = Many[Annotated[Points, Meta(title="polygon")]]
Holes = Annotated[tuple[Annotated[Points, Meta(title="hole")], ...], Meta(max_length=MOST_INNER)]
Lines = Annotated[tuple[Annotated[Points, Meta(title="line")], ...], Meta(max_length=MOST_INNER)]
Share = Annotated[float, Meta(ge=0, le=1)]


class Reference(str):
    """An icon: ``set:name``, or the path of a file; absolute once it is read."""

    __slots__ = ()


class Record(Struct, frozen=True, omit_defaults=True):
    """An object in a file. Fields that it does not declare are passed over."""

    def check(self) -> None:
        """Refuse what no type can, once it is read.

        Raises
        ------
        IconstudioError
            A sentence; who reads names the file and the place.
        """


class StrictRecord(Record, frozen=True, omit_defaults=True, forbid_unknown_fields=True):
    """An object in a file that people write by hand: what is misspelt is refused.

    Notes of their own are not: ``comment``, ``credit``, and what begins with ``_`` or ``$``.
    """


def plain_text(text: str) -> str:
    """Return a text that can be read back: not too long, of characters that are some."""
    return ODD.sub("\ufffd", text)[:LONGEST_TEXT]
