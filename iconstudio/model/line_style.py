"""Styles of lines, learned from examples (*Curve Analogies*, section 3)."""

from dataclasses import dataclass

from iconstudio.model.polygon import Point


@dataclass(frozen=True, slots=True)
class StylePair:
    """An example: a plain stroke, and the same stroke in the style."""

    styled: tuple[Point, ...]
    """A', in units of a 256 canvas."""
    plain: tuple[Point, ...] = ()
    """A; empty if the style is free, and follows whatever line there is."""
    closed: bool = False
    widths: tuple[float, ...] = ()
    """The width of the styled stroke at each of its points, where the pressure changed."""


@dataclass(frozen=True, slots=True)
class LineStyle:
    """How lines are drawn, by example."""

    name: str
    pairs: tuple[StylePair, ...]
    author: str = ""
    license: str = ""
    rotation: bool = True
    """Whether it turns with the line; else it depends on the line's direction."""
    shape: bool = False
    """Whether what a line does depends on its shape (w_B = 2)."""
