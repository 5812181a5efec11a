"""RESTYLE.json: an icon or lines, and the style that they take."""

from collections import Counter
from collections.abc import Generator
from typing import Annotated, Self

from msgspec import Meta

from iconstudio.inputs.formats import Many, Reference, StrictRecord, Text
from iconstudio.inputs.line_style import StyleFile
from iconstudio.inputs.lines import STRAY, line, meets_canvas
from iconstudio.inputs.styles import bundled, named
from iconstudio.inputs.wide_points import WidePoints, carried, check_widths, parted, wide_points
from iconstudio.model import CANVAS, IconstudioError, Line, LineStyle, Polygon, Restyling
from iconstudio.workflows.events import Event
from iconstudio.workflows.line_style.restyling import (
    LARGEST,
    LARGEST_SEED,
    SMALLEST,
    STRONGEST,
    WEAKEST,
)
from iconstudio.workflows.workflow import File, Find, Refer, Resources

MANY_TOLD = 20_000
"""Of lines of more points it is said that they are simplified; nobody sees it."""
Seed = Annotated[int, Meta(ge=0, le=LARGEST_SEED)]


class LineFile(StrictRecord, frozen=True):
    """A stroke, or a contour of a filled shape if it has no width.

    Where a stroke is not equally wide all along, its points have a width each, ``[x, y, width]``.
    """

    points: WidePoints
    width: Annotated[float, Meta(ge=0, le=2 * CANVAS)] = 0.0
    closed: bool = False

    @classmethod
    def of(cls, drawn: Line) -> Self:
        """Return a line as it is written."""
        return cls(wide_points(drawn.points, drawn.widths), drawn.width, drawn.closed)

    @property
    def line(self) -> Line:
        """The value."""
        points, widths = parted(self.points)
        kept = line(points)
        if not widths:
            return Line(kept, self.closed, self.width)
        return Line(kept, self.closed, self.width or max(widths), carried(widths, points, kept))

    def check(self) -> None:
        """Refuse what is no line."""
        if len({point[:2] for point in self.points}) < 2:
            raise IconstudioError("A line needs at least 2 different points.")
        check_widths(self.points, "line")

    @property
    def is_drawn(self) -> bool:
        """Whether it has a width, or encloses something that is filled."""
        places, widths = parted(self.points)
        if self.width or widths:
            return True
        try:
            Polygon.of(places).check_area()
        except IconstudioError:
            return False
        return True

    @property
    def meets_canvas(self) -> bool:
        """Whether the box around it has a part of the canvas."""
        places, widths = parted(self.points)
        return meets_canvas(places, max(self.width, *widths, 0.0))


class OtherStyle(StrictRecord, frozen=True):
    """The style of one line, by its number: the icon's come first, from 0."""

    line: Annotated[int, Meta(ge=0, le=100_000)]
    style: Text | StyleFile


class RestyleFile(File[Restyling], frozen=True):
    """A RESTYLE.json."""

    style: Text | StyleFile = ""
    icon: Reference | None = None
    lines: Many[LineFile] = ()
    strength: Annotated[float, Meta(ge=WEAKEST, le=STRONGEST)] = 1.0
    size: Annotated[float, Meta(ge=SMALLEST, le=LARGEST)] = 1.0
    seed: Seed = 0
    rotation: bool | None = None
    others: Many[OtherStyle] = ()

    @classmethod
    def of(cls, work: Restyling, refer: Refer) -> Self:
        """Return the file of some work."""
        return cls(
            style="" if work.style is None else _written(work.style),
            icon=None if work.icon is None else refer(work.icon),
            lines=tuple(map(LineFile.of, work.strokes)),
            strength=work.strength,
            size=work.size,
            seed=work.seed,
            rotation=work.turning,
            others=tuple(OtherStyle(number, _written(style)) for number, style in work.others),
        )

    @property
    def remarks(self) -> tuple[str, ...]:
        """Which lines are simplified, and which cannot be seen."""
        told = []
        for number, one in enumerate(self.lines, start=1):
            if len(one.points) > MANY_TOLD:
                told.append(
                    f"Line {number} has {len(one.points):,} points; it is drawn with fewer, "
                    f"at most {STRAY} units off."
                )
            if not one.meets_canvas:
                told.append(
                    f"Line {number} lies outside the canvas, 0 to {CANVAS}: nothing of it is seen."
                )
        return tuple(told)

    def resolving(self, resources: Resources) -> Generator[Event, None, Restyling]:
        """Return the work, of which nothing would be lost: all lines are there, and are drawn.

        A project keeps what was on its page, whatever that is: see ``resolved``.
        """
        for number, one in enumerate(self.lines, start=1):
            if not one.is_drawn:
                raise IconstudioError(
                    f"In line {number}: The line encloses nothing that is filled. "
                    'Give it a "width" to be drawn with.'
                )
        for number, times in Counter(one.line for one in self.others).items():
            if times > 1:
                raise IconstudioError(f'"others" gives line {number} {times} styles. Keep one.')
        work = yield from super().resolving(resources)
        if not work.others:
            return work
        own = resources.lines(work.icon) if work.icon is not None else ()
        count = len(own) + len(work.strokes)
        for number, _ in work.others:
            if number >= count:
                there = f"are lines 0 to {count - 1}" if count > 1 else "is line 0 only"
                raise IconstudioError(
                    f'"others" gives a style to line {number}, which is not there: there '
                    f"{there if count else 'are no lines'}. Mend its number, or remove it."
                )
        return work

    def resolved(self, find: Find) -> Restyling:
        """Return the work, its icon found by ``find``."""
        return Restyling(
            _read(self.style),
            None if self.icon is None else find(self.icon),
            tuple(one.line for one in self.lines),
            self.strength,
            self.size,
            self.seed,
            self.rotation,
            tuple((one.line, _style(one.style)) for one in self.others),
        )


def _written(style: LineStyle) -> str | StyleFile:
    """Return a style that comes with the program by its name, another one whole."""
    return style.name if style in bundled() else StyleFile.of(style)


def _read(said: str | StyleFile) -> LineStyle | None:
    return None if said == "" else _style(said)


def _style(said: str | StyleFile) -> LineStyle:
    return named(said) if isinstance(said, str) else said.style
