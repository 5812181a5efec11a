"""An icon that the program made: its outline, its title, whom to thank, and how it was made."""

from dataclasses import dataclass, replace

from iconstudio.model.canvas import CANVAS
from iconstudio.model.composite import Composite, Drawing
from iconstudio.model.line import Line
from iconstudio.model.mix import Seeds
from iconstudio.model.path import Contour, Path
from iconstudio.model.pictogram import Pictogram
from iconstudio.model.score import Score


@dataclass(frozen=True, slots=True)
class Fill:
    """A shape in a colour, ``#rrggbb``; without one, it has that of the text around it."""

    path: Path
    colour: str = ""


@dataclass(frozen=True, slots=True)
class ColouredLayer:
    """A layer of a drawing."""

    name: str
    fills: tuple[Fill, ...]
    """From back to front."""


@dataclass(frozen=True, eq=False)
class Icon:
    """What every workflow makes, and everything that shows, saves, sends or keeps icons takes."""

    path: Path
    """In canvas units, 0 to CANVAS."""
    title: str
    """What it shows."""
    credits: tuple[Pictogram, ...] = ()
    """The pictograms to thank, each once, from the largest part down."""

    @property
    def fills(self) -> tuple[Fill, ...]:
        """What it is drawn with, from back to front."""
        return (Fill(self.path),)

    @property
    def size(self) -> tuple[int, int]:
        """Width and height of what it is drawn on: the canvas, but for patterns."""
        return CANVAS, CANVAS

    def looks_like(self, other: "Icon") -> bool:
        """Whether two icons are drawn by the same shapes in the same colours."""
        return self is other or self.fills == other.fills


@dataclass(frozen=True, eq=False, kw_only=True)
class Remix(Icon):
    """An icon made by a graph cut (section 3.4)."""

    composite: Composite
    """The labelling, with lambda_S and energy."""
    drawing: Drawing
    score: Score
    seeds: Seeds = ()
    """Of a hybrid: where each source was seeded."""
    draw: int = -1
    """Of a hybrid: the number of its draw."""
    unchanged: float | None = None
    """Of an edit: the part of the pixels well outside the change that equal the icon's own."""

    @classmethod
    def of(
        cls, composite: Composite, drawing: Drawing, score: Score, title: str = "icon"
    ) -> "Remix":
        """Return the icon of a drawing, which is thanks to all that own ink of it."""
        return cls(
            drawing.path,
            title,
            composite.contributors,
            composite=composite,
            drawing=drawing,
            score=score,
        )

    def drawn(self, drawing: Drawing) -> "Remix":
        """Return the same remix drawn in another way."""
        return replace(self, path=drawing.path, drawing=drawing)


@dataclass(frozen=True, eq=False, kw_only=True)
class Restyled(Icon):
    """An icon whose lines are drawn in a style (*Curve Analogies*)."""

    lines: tuple[Line, ...]
    """As they were drawn: what was a stroke still is one."""
    scale: float = 1.0
    """How large they are, over the plain ones: below 1 if they had no room on the canvas."""


@dataclass(frozen=True, eq=False, kw_only=True)
class Patterned(Icon):
    """A pattern (*Art Pattern Synthesis Using Level Sets*); ``path`` is its ink, on the canvas."""

    layers: tuple[ColouredLayer, ...]
    """From back to front, in units of its own size."""
    ground: str
    """The colour behind them, ``#rrggbb``; empty if it is transparent."""
    width: int
    height: int
    tile: bool
    """Whether it continues itself, side by side."""
    torn: float
    """The share of its ink in torn elements."""

    @property
    def fills(self) -> tuple[Fill, ...]:
        """The ground, and what lies on it."""
        right, bottom = float(self.width), float(self.height)
        corners = ((right, 0.0),), ((right, bottom),), ((0.0, bottom),)
        ground = Fill(Path((Contour((0.0, 0.0), corners),)), self.ground)
        shapes = (fill for layer in self.layers for fill in layer.fills)
        return (ground, *shapes) if self.ground else tuple(shapes)

    @property
    def size(self) -> tuple[int, int]:
        """Its own width and height."""
        return self.width, self.height
