"""Files of line styles: strokes to learn from, in units of a 256 canvas, as JSON.

``{"name", "author", "license", "pairs": [{"plain": [[x, y], ...], "styled": [[x, y], ...],
"closed": false}, ...], "rotation": true, "shape": false}``; a styled point may have a width,
``[x, y, width]``. Strokes of as many points correspond point by point, others by arc length.
"""

from collections.abc import Callable, Iterable, Sequence
from dataclasses import replace
from itertools import pairwise
from math import dist, hypot
from pathlib import Path
from typing import Annotated, Self, TypeVar

from msgspec import Meta

from iconstudio.files import write_bytes
from iconstudio.inputs import json
from iconstudio.inputs.formats import MOST_POINTS, Many, StrictRecord, Text, plain_text
from iconstudio.inputs.lines import rounded
from iconstudio.inputs.wide_points import Length, WidePoints, check_widths, parted, wide_points
from iconstudio.model import CANVAS, IconstudioError, Line, LineStyle, Point, StylePair

VERSION = 1
"""Files of a later version say so, and are not read."""
MOST_LEARNED = 20_000
"""Points of a stroke; one of more is thinned."""
LONGEST = 20_000.0
"""Length of all styled strokes together; learning takes time and memory in proportion."""
SHORTEST = 10.0
"""Length of a styled stroke: about a neighbourhood of the finest texture."""
_ADVANCING = 0.02
"""How far a stroke without a plain one gets, over its length."""
_EVEN = 1.0
"""Width of a stroke that has the same all along: only how it changes is learned."""

T = TypeVar("T")
_Points = Annotated[tuple[tuple[Length, Length], ...], Meta(max_length=MOST_POINTS)]


class PairFile(StrictRecord, frozen=True):
    """An example: a stroke in the style, and the plain one it was made of, if any."""

    styled: WidePoints
    plain: _Points = ()
    closed: bool = False

    @classmethod
    def of(cls, pair: StylePair) -> Self:
        """Return a pair as it is written: to a hundredth of a unit."""
        styled = wide_points(pair.styled, pair.widths)
        return cls(styled, rounded(pair.plain), pair.closed)

    @property
    def pair(self) -> StylePair:
        """The value."""
        points, widths = parted(self.styled)
        if len(points) == len(self.plain):  # they stay side by side
            kept = _thinned(range(len(points)))
            plain = tuple(self.plain[index] for index in kept)
        else:
            plain = _thinned(self.plain)
        return StylePair(_thinned(points), plain, self.closed, _thinned(widths))

    @property
    def length(self) -> float:
        """The length of the styled stroke."""
        return _length(parted(self.styled)[0], self.closed)

    @property
    def has_widths(self) -> bool:
        """Whether the styled stroke has a width at each of its points."""
        return bool(self.styled) and len(self.styled[0]) == 3

    def check(self) -> None:
        """Refuse what nothing can be learned from."""
        if len(self.styled) < 3:
            raise IconstudioError(
                f"The styled stroke has {_count(len(self.styled))}; it needs at least 3."
            )
        check_widths(self.styled, "styled stroke")
        points, _ = parted(self.styled)
        if self.length < SHORTEST:
            raise IconstudioError(
                f"The styled stroke is {self.length:.3g} units long; it needs at least "
                f"{SHORTEST:g}, on a canvas of {CANVAS}. Draw it longer, or scale it up."
            )
        if not (self.plain or self.closed) and _advance(points) < _ADVANCING * self.length:
            raise IconstudioError(
                "The styled stroke gets nowhere: it ends where it began, or goes there and back. "
                "Draw it along a line, or give its plain stroke."
            )
        if self.plain and _length(self.plain, self.closed) < SHORTEST:
            raise IconstudioError(
                f"The plain stroke is {_length(self.plain, self.closed):.3g} units long; it needs "
                f"at least {SHORTEST:g}. Draw it longer, or leave it out."
            )


class StyleFile(StrictRecord, frozen=True):
    """A line style."""

    name: Text
    pairs: Many[PairFile]
    author: Text = ""
    license: Text = ""
    rotation: bool = True
    shape: bool = False

    @classmethod
    def of(cls, style: LineStyle) -> Self:
        """Return the file of a style."""
        return cls(
            style.name,
            tuple(map(PairFile.of, style.pairs)),
            style.author,
            style.license,
            style.rotation,
            style.shape,
        )

    @property
    def style(self) -> LineStyle:
        """The value."""
        pairs = tuple(one.pair for one in self.pairs)
        return LineStyle(self.name, pairs, self.author, self.license, self.rotation, self.shape)

    def check(self) -> None:
        """Refuse what nothing can be learned from, or too much to learn."""
        if not self.name.strip():
            raise IconstudioError('"name" is empty: give the style a name.')
        if len(self.name.splitlines()) > 1:
            raise IconstudioError('"name" has a line break. Write it on one line.')
        if not self.pairs:
            raise IconstudioError(
                'There is no pair. Add at least one: {"styled": [[x, y], ...]} is enough.'
            )
        if len({bool(one.plain) for one in self.pairs}) > 1:
            raise IconstudioError(
                "Some pairs have a plain stroke, and some have none. Give one to all, or to none."
            )
        if self.shape and not self.pairs[0].plain:
            raise IconstudioError(
                '"shape" is true, but the pairs have no plain strokes, whose shape would count. '
                'Give each its "plain" stroke, or leave "shape" out.'
            )
        if len({one.has_widths for one in self.pairs}) > 1:
            raise IconstudioError(
                "The points of some pairs have widths, and those of others have none. "
                "Give widths to all pairs, or to none."
            )
        length = sum(one.length for one in self.pairs)
        if length > LONGEST:
            raise IconstudioError(
                f"The styled strokes are {length:,.0f} units long together; at most "
                f"{LONGEST:,.0f} are learned, on a canvas of {CANVAS}. Scale them down, or leave "
                "some out."
            )


def read_style(path: Path, tell: Callable[[str], None] = lambda sentence: None) -> LineStyle:
    """Return the style in a file; ``tell`` is called with what a user should know of it.

    Raises
    ------
    IconstudioError
        If it cannot be read, or holds no style.
    """
    return _read(json.load(path), path, tell)


def check_style(style: LineStyle) -> None:
    """Refuse a style that nothing can be learned from, or that is too much to learn.

    Raises
    ------
    IconstudioError
        If it is so; it says what to do.
    """
    file = StyleFile.of(style)
    for pair in file.pairs:
        pair.check()
    file.check()


def written(style: LineStyle) -> str:
    """Return the text of a style's file."""
    return json.encoded(StyleFile.of(style)).decode() + "\n"


def write_style(path: Path, style: LineStyle) -> None:
    """Write the file of a style.

    Raises
    ------
    IconstudioError
        If it cannot be written.
    """
    write_bytes(path, written(style).encode())


def with_widths(pairs: Iterable[StylePair]) -> tuple[StylePair, ...]:
    """Return examples that all have widths if one has: the same all along where there were none."""
    pairs = tuple(pairs)
    if not any(one.widths for one in pairs):
        return pairs
    return tuple(
        one if one.widths else replace(one, widths=(_EVEN,) * len(one.styled)) for one in pairs
    )


def style_of_lines(lines: Iterable[Line], name: str) -> LineStyle:
    """Return the style of lines, as of an SVG file: each long enough is an example by itself.

    Raises
    ------
    IconstudioError
        If none is long enough.
    """
    strokes = with_widths(
        StylePair(line.points, closed=line.closed, widths=line.widths)
        for line in lines
        if len(line.points) >= 3 and _length(line.points, line.closed) >= SHORTEST
    )
    if not strokes:
        raise IconstudioError(
            f"“{name}” has no line of at least 3 points and {SHORTEST:g} units of a canvas of "
            f"{CANVAS} to learn from. Draw a longer one."
        )
    file = StyleFile(" ".join(plain_text(name).split()), tuple(map(PairFile.of, strokes)))
    file.check()
    return file.style


def _read(data: object, path: Path, tell: Callable[[str], None]) -> LineStyle:
    if isinstance(data, dict):
        data = dict(data)
        version = data.pop("version", VERSION)
        if version != VERSION:
            raise IconstudioError(
                f"“{path.name}” is of version {str(version)[:20]} of line styles; this program "
                f"reads version {VERSION}. Update Iconstudio, or save it as version {VERSION}."
            )
        if "pairs" not in data:
            raise IconstudioError(
                f"In “{path.name}”: this is no line style, which has pairs of strokes in "
                '"pairs". Choose another file, or open this one with Open.'
            )
    file = json.converted(data, StyleFile, path)
    for number, pair in enumerate(file.pairs, start=1):
        count = max(len(pair.styled), len(pair.plain))
        if count > MOST_LEARNED:
            tell(
                f"In “{path.name}”, pair {number}: of {count:,} points of a stroke "
                f"{MOST_LEARNED:,} are learned from."
            )
    return file.style


def _thinned(some: Sequence[T]) -> tuple[T, ...]:
    """Return at most ``MOST_LEARNED`` of some, evenly, with the first and the last."""
    last, most = len(some) - 1, MOST_LEARNED - 1
    if last <= most:
        return tuple(some)
    return tuple(some[index * last // most] for index in range(MOST_LEARNED))


def _length(points: Sequence[Point], closed: bool) -> float:
    following = (*points[1:], *points[:1]) if closed else points[1:]
    return sum(map(dist, points, following))


def _advance(points: Sequence[Point]) -> float:
    """Return the length of the straight line that runs along a stroke, by least squares."""
    whole = _length(points, False)
    along, moments = 0.0, [0.0, 0.0]
    for one, other in pairwise(points):
        step = dist(one, other)
        middle = along + step / 2 - whole / 2
        for axis in (0, 1):
            mean, rise = (one[axis] + other[axis]) / 2, other[axis] - one[axis]
            moments[axis] += step * (middle * mean + step * rise / 12)
        along += step
    return hypot(*moments) * 12 / whole**2


def _count(points: int) -> str:
    return ("no point", "one point", "two points")[points]
