"""The user's input for line styles: lines, and the styles that they take."""

from dataclasses import dataclass, replace

from iconstudio.model.line import Line
from iconstudio.model.line_style import LineStyle
from iconstudio.model.pictogram import Pictogram


@dataclass(frozen=True, slots=True)
class Restyling:
    """Lines of an icon, strokes drawn beside them, and how they are to be drawn."""

    style: LineStyle | None = None
    icon: Pictogram | None = None
    strokes: tuple[Line, ...] = ()
    """Drawn freehand, in canvas units; they follow the icon's own lines."""
    strength: float = 1.0
    """How far lines go from the plain ones, over what the style's examples do."""
    size: float = 1.0
    """Of the texture, over that of the examples."""
    seed: int = 0
    turning: bool | None = None
    """Whether the style turns with the line; None as it says itself."""
    others: tuple[tuple[int, LineStyle], ...] = ()
    """The styles of single lines, by number, where they are not ``style``."""

    def style_of(self, number: int) -> LineStyle | None:
        """Return the style of a line, by its number."""
        style = dict(self.others).get(number, self.style)
        if style is None or self.turning is None:
            return style
        return replace(style, rotation=self.turning)
