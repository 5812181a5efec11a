"""JSON files, read field by field: every mistake names the file, the place and the cure."""

import builtins
import json
import math
import os
import re
from collections import Counter
from collections.abc import Iterator, Sequence
from difflib import get_close_matches
from itertools import chain
from pathlib import Path
from typing import Any, TypeGuard

from iconstudio.algorithms.geometry import simplified, simplified_line
from iconstudio.files import is_address, read_bytes, write_atomically
from iconstudio.model import CANVAS, MARGIN, Axis, IconstudioError, Point, Polygon

LARGEST = 1e9
"""Coordinates beyond it are a mistake."""
MOST_BYTES = 32_000_000
"""Size of a file."""
MOST_POINTS = 200_000
"""Points of a line or an outline."""
MOST_IN_LIST = 10_000
"""Entries of any other list."""
LONGEST_TEXT = 4096
"""Characters of a text, as of a path."""
STRAY = 0.2
"""How far, in canvas units, lines of more than ``MANY`` points may stray to have fewer."""
MANY = 500
"""Points that nobody draws by hand."""
_OF_COLLECTION = re.compile(r"[^:/\\]+:[^:/\\]+(?<!\.svg)", re.IGNORECASE)
"""``set:name``; anything else is the path of a file."""

_NOTES = ("comment", "credit")
"""Keys that say something to people only."""
ODD = re.compile("[\0\ud800-\udfff]")
"""Characters that are none."""


class Fields:
    """The fields of a JSON object. Each method reads one, and checks it.

    Raises
    ------
    IconstudioError
        From every method, if the field is not what it must be.
    """

    def __init__(self, data: object, path: Path, place: str = "") -> None:
        self.path = path
        """Of the file."""
        self._place = place
        if not isinstance(data, dict):
            raise self.mistake('An object such as {"key": "value"} is needed.')
        self._data = data
        self.keys = frozenset(data)
        """The names of the fields that are there."""

    def mistake(self, sentence: str) -> IconstudioError:
        """Return the error that says what is wrong, and where."""
        return IconstudioError(f"In “{self.path.name}”{self._place}: {sentence}")

    def check_keys(self, known: Sequence[str]) -> None:
        """Refuse keys that mean nothing, as misspelt ones do; notes of the user's own are none.

        These are ``comment``, ``credit``, and what begins with ``_`` or ``$``.
        """
        for key in self._data:
            if key in known or key in _NOTES or key[:1] in ("_", "$"):
                continue
            near = get_close_matches(key.lower(), known, n=1)
            cure = (
                f"Write {json.dumps(near[0])} if you mean that."
                if near
                else f"There are {', '.join(map(json.dumps, known))}. Remove it, or mend its name."
            )
            said = json.dumps(key[:60], ensure_ascii=False)
            raise self.mistake(f"{said} is not known here. {cure}")

    def has(self, key: str) -> bool:
        """Whether the field is there, and not null."""
        return self._data.get(key) is not None

    def text(self, key: str, default: str = "") -> str:
        """Return a text."""
        value = self._given(key, default)
        if not isinstance(value, str):
            raise self.mistake(f'"{key}" must be a text.')
        return self._checked(value, key)

    def texts(self, key: str) -> tuple[str, ...]:
        """Return a list of texts; empty if there is none."""
        values = self._list(key, "texts") if self.has(key) else []
        if not all(isinstance(value, str) for value in values):
            raise self.mistake(f'"{key}" must be a list of texts.')
        return tuple(self._checked(value, key) for value in values)

    def flag(self, key: str) -> bool:
        """Return a truth value; false if there is none."""
        value = self._given(key, False)
        if not isinstance(value, bool):
            raise self.mistake(f'"{key}" must be true or false.')
        return value

    def number(
        self, key: str, default: float | None, least: float, most: float, *, above: bool = False
    ) -> float:
        """Return a number from ``least`` to ``most``; if ``above``, more than ``least``.

        It must be there if ``default`` is None.
        """
        value = _finite(self._given(key, default))
        if value is None or not (least < value if above else least <= value) or value > most:
            bounds = f"above {least:g} and up to" if above else f"from {least:g} to"
            raise self.mistake(f'"{key}" must be a number {bounds} {most:g}.')
        return value

    def whole(self, key: str, default: int, least: int, most: int) -> int:
        """Return a whole number from ``least`` to ``most``."""
        value = self._given(key, default)
        if isinstance(value, bool) or not isinstance(value, int) or not least <= value <= most:
            raise self.mistake(f'"{key}" must be a whole number from {least} to {most}.')
        return value

    def axis(self, key: str = "symmetry") -> Axis | None:
        """Return an axis of symmetry, or None."""
        value = self._given(key, None)
        if value in (None, "none"):
            return None
        if not isinstance(value, str) or value not in list(Axis):
            raise self.mistake(f'"{key}" must be null or one of {", ".join(Axis)}.')
        return Axis(value)

    def reference(self, key: str = "icon") -> str:
        """Return the reference of an icon: ``set:name``, or the absolute path of a file."""
        if not self.has(key):
            raise self.mistake(f'"{key}" is missing: "set:name", or the path of an SVG or a scan.')
        return _resolved(self, self.text(key), key)

    def references(self, key: str) -> tuple[str, ...]:
        """Return the references of several icons."""
        return tuple(_resolved(self, text, key) for text in self.texts(key))

    def points(self, key: str, largest: float = LARGEST) -> tuple[Point, ...]:
        """Return a list of points; no coordinate may exceed ``largest``."""
        return self._points(self._list(key, "[x, y] points", MOST_POINTS), f'of "{key}"', largest)

    def outline(self, key: str) -> Polygon:
        """Return a polygon in any unit, simplified as for the canvas if it has many points."""
        polygon = Polygon.of(self.points(key))
        if len(polygon.vertices) <= MANY:
            return polygon
        left, top, right, bottom = polygon.bounds
        return simplified(polygon, STRAY * max(right - left, bottom - top) / (CANVAS - 2 * MARGIN))

    def line(self, key: str, largest: float) -> tuple[Point, ...]:
        """Return a line in canvas units, simplified if it has many points."""
        points = self.points(key, largest)
        return simplified_line(points, STRAY) if len(points) > MANY else points

    def point_lists(self, key: str, largest: float = LARGEST) -> tuple[tuple[Point, ...], ...]:
        """Return a list of lists of points; empty if there is none."""
        values = self._list(key, "lists of points") if self.has(key) else []
        if not all(isinstance(value, list) for value in values):
            raise self.mistake(f'"{key}" must be a list of lists of [x, y] points.')
        if sum(map(len, values)) > MOST_IN_LIST:
            raise self.mistake(f'"{key}" holds too many points; at most {MOST_IN_LIST:,} are read.')
        return tuple(self._points(value, f'of "{key}"', largest) for value in values)

    def polygons(self, key: str) -> tuple[Polygon, ...]:
        """Return a list of polygons that enclose some area; empty if there is none."""
        values = self._list(key, "polygons") if self.has(key) else []
        return tuple(
            self._polygon(value, f'polygon {number} of "{key}"')
            for number, value in enumerate(values, start=1)
        )

    def objects(self, key: str, name: str) -> Iterator["Fields"]:
        """Yield the objects of a list, each called ``name`` and its number in messages."""
        values = self._list(key, f"{name}s") if self.has(key) else []
        for number, value in enumerate(values, start=1):
            yield Fields(value, self.path, f"{self._place}, {name} {number}")

    def object(self, key: str) -> "Fields":
        """Return an object; an empty one if there is none."""
        return Fields(self._given(key, {}), self.path, f"{self._place}, {key}")

    def _given(self, key: str, default: Any) -> Any:
        return self._data[key] if self.has(key) else default

    def _list(self, key: str, of: str, most: int = MOST_IN_LIST) -> list[Any]:
        value = self._data.get(key)
        if not isinstance(value, list):
            raise self.mistake(f'"{key}" must be a list of {of}.')
        if len(value) > most:
            raise self.mistake(f'"{key}" has {len(value):,} entries; at most {most:,} are read.')
        return value

    def _checked(self, text: str, key: str) -> str:
        """Refuse what neither a file name nor UTF-8 can hold."""
        if len(text) > LONGEST_TEXT:
            raise self.mistake(
                f'"{key}" has {len(text):,} characters; at most {LONGEST_TEXT:,} are read.'
            )
        if ODD.search(text):
            raise self.mistake(f'"{key}" holds characters that are none.')
        return text

    def _polygon(self, value: builtins.object, name: str) -> Polygon:
        if not isinstance(value, list):
            raise self.mistake(f"The {name} must be a list of [x, y] points.")
        if len(value) > MOST_POINTS:
            raise self.mistake(
                f"The {name} has {len(value):,} points; at most {MOST_POINTS:,} are read."
            )
        polygon = Polygon.of(self._points(value, f"of {name}"))
        try:
            polygon.check_area()
        except IconstudioError as error:
            raise self.mistake(f"The {name} is no good. {error}") from None
        return simplified(polygon, STRAY) if len(polygon.vertices) > MANY else polygon

    def _points(self, values: list[Any], of: str, largest: float = LARGEST) -> tuple[Point, ...]:
        if _are_points(values, largest):
            return tuple((float(x), float(y)) for x, y in values)
        return tuple(  # finds the mistake
            self._point(value, f"Point {number} {of}", largest)
            for number, value in enumerate(values, start=1)
        )

    def _point(self, value: builtins.object, name: str, largest: float) -> Point:
        if not isinstance(value, list) or len(value) != 2 or not all(map(_is_number, value)):
            raise self.mistake(f"{name} is not a pair of numbers such as [12, 34.5].")
        x, y = map(_finite, value)
        if x is None or y is None:
            raise self.mistake(f"{name} is not a number, or too large. Remove it.")
        if max(abs(x), abs(y)) > largest:
            raise self.mistake(f"{name} is out of all scale: [{x:g}, {y:g}].")
        return x, y


def _resolved(fields: Fields, text: str, key: str) -> str:
    text = text.strip()
    if not text:
        raise fields.mistake(
            f'"{key}" is empty: write "set:name", or the path of an SVG or a scan.'
        )
    if _OF_COLLECTION.fullmatch(text) or is_address(text):
        return text
    return os.path.realpath(fields.path.parent / text)


def read(path: Path) -> Fields:
    """Read a JSON file of the user's work.

    Raises
    ------
    IconstudioError
        If it cannot be read, or holds no JSON object.
    """
    try:
        text = read_bytes(path, MOST_BYTES)
    except IconstudioError as error:
        raise IconstudioError(f"“{path}” cannot be read. {error}") from None
    return parsed(text, path)


def parsed(text: bytes, path: Path) -> Fields:
    """Return the fields of a JSON object; ``path`` names it in messages.

    Raises
    ------
    IconstudioError
        If it is none.
    """
    try:
        data = json.loads(text, parse_int=_whole, object_pairs_hook=_object)
    except UnicodeDecodeError:
        reason = "it is no text in UTF-8, UTF-16 or UTF-32"
    except (RecursionError, MemoryError):
        reason = "it is nested too deeply, or too large"
    except ValueError as error:
        reason = str(error)
    else:
        return Fields(data, path)
    raise IconstudioError(
        f"“{path.name}” is not valid JSON: {reason}. Save it again, or mend it in an editor."
    )


def write(path: Path, data: dict[str, Any]) -> None:
    """Write a JSON file; fields that are None are left out.

    Raises
    ------
    IconstudioError
        If it cannot be written.
    """
    there = {key: value for key, value in data.items() if value is not None}
    text = json.dumps(there, ensure_ascii=False, indent=2, allow_nan=False) + "\n"
    try:
        write_atomically(path, text.encode())
    except OSError as error:
        raise IconstudioError(f"“{path}” cannot be written: {error.strerror}.") from None


def relative(reference: str, path: Path) -> str:
    """Return a reference as it is written into the file ``path``: near files by short paths."""
    file = Path(reference)
    near = file.is_absolute() and file.is_relative_to(path.resolve().parent)
    return file.relative_to(path.resolve().parent).as_posix() if near else reference


def written(points: tuple[Point, ...]) -> list[list[float]]:
    """Return points as they are written: to a hundredth of a pixel."""
    return [[round(x, 2), round(y, 2)] for x, y in points]


def _whole(digits: str) -> int | float:
    """Read a whole number; Python refuses those of thousands of digits."""
    return int(digits) if len(digits) < 400 else float(digits)


def _object(pairs: list[tuple[str, Any]]) -> dict[str, Any]:
    """Make an object of its fields, each of which may be there once."""
    found = dict(pairs)
    if len(found) < len(pairs):
        ((twice, _),) = Counter(key for key, _ in pairs).most_common(1)
        raise ValueError(f"{json.dumps(twice[:60])} is there twice")
    return found


def _are_points(values: list[Any], largest: float) -> bool:
    """Whether all are pairs of numbers up to ``largest``: said at once for very many."""
    if not set(map(type, values)) <= {list} or not set(map(len, values)) <= {2}:
        return False
    numbers = list(chain.from_iterable(values))
    kinds = set(map(type, numbers)) <= {int, float}
    return kinds and all(-largest <= number <= largest for number in numbers)


def _is_number(value: object) -> TypeGuard[float]:
    return isinstance(value, int | float) and not isinstance(value, bool)


def _finite(value: object) -> float | None:
    """Return a number as float; None if it is none, or too large for one."""
    try:
        number = float(value) if _is_number(value) else math.nan
    except OverflowError:
        return None
    return number if math.isfinite(number) else None


def plain_text(text: str) -> str:
    """Return a text that can be read back: not too long, of characters that are some."""
    return ODD.sub("\ufffd", text)[:LONGEST_TEXT]
