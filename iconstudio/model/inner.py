"""What is drawn inside an outline: holes, and lines (section 6 of the paper wishes for both)."""

from collections.abc import Callable
from dataclasses import dataclass

from iconstudio.model.errors import IconstudioError
from iconstudio.model.polygon import Point, Polygon


@dataclass(frozen=True, slots=True)
class Inner:
    """Inner outlines, in the unit of the outline around them."""

    holes: tuple[Polygon, ...] = ()
    """Areas of paper."""
    lines: tuple[tuple[Point, ...], ...] = ()
    """Strokes, each of two points or more."""

    def moved(self, move: Callable[[Point], Point]) -> "Inner":
        """Return them with every point moved."""
        holes = tuple(Polygon(tuple(map(move, hole.vertices))) for hole in self.holes)
        return Inner(holes, tuple(tuple(map(move, line)) for line in self.lines))

    def check(self) -> None:
        """Refuse holes that enclose nothing, and lines of one point.

        Raises
        ------
        IconstudioError
            A sentence that says which one.
        """
        for number, hole in enumerate(self.holes, start=1):
            try:
                hole.check_area()
            except IconstudioError as error:
                raise IconstudioError(f"Hole {number} is no good. {error}") from None
        for number, line in enumerate(self.lines, start=1):
            if len(set(line)) < 2:
                raise IconstudioError(
                    f"Line {number} has no length: draw at least 2 different points."
                )
