"""RESTYLE.json: an icon or lines, and the style that they take."""

from typing import Annotated, Self

from msgspec import Meta

from iconstudio.inputs.formats import Many, Reference, StrictRecord, Text
from iconstudio.inputs.line_style import StyleFile
from iconstudio.inputs.lines import STRAY, line
from iconstudio.inputs.styles import bundled, named
from iconstudio.inputs.wide_points import WidePoints, carried, check_widths, parted, wide_points
from iconstudio.model import CANVAS, IconstudioError, Line, LineStyle, Restyling
from iconstudio.workflows.line_style.restyling import (
    LARGEST,
    LARGEST_SEED,
    SMALLEST,
    STRONGEST,
    WEAKEST,
)
from iconstudio.workflows.workflow import File, Find, Refer

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
        """Which lines are simplified."""
        return tuple(
            f"Line {number} has {len(one.points):,} points; it is drawn with fewer, "
            f"at most {STRAY} units off."
            for number, one in enumerate(self.lines, start=1)
            if len(one.points) > MANY_TOLD
        )

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
