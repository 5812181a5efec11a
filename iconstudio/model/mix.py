"""The user's input for hybrids: the icons to mix, and how (section 4.3)."""

from dataclasses import dataclass

from iconstudio.model.pictogram import Pictogram
from iconstudio.model.polygon import Point
from iconstudio.model.symmetry import Axis

Seeds = tuple[tuple[Point, ...], ...]
"""For each icon, the seed positions, in canvas pixels, around which it is kept."""


DRAWS = 40
"""Hybrids that are drawn in one go."""


@dataclass(frozen=True, slots=True)
class Mix:
    """Icons to mix by random draws."""

    icons: tuple[Pictogram, ...]
    draws: int = DRAWS
    seed: int = 0
    """Of the random generator: the same seed gives the same hybrids."""
    symmetry: Axis | None = None
    pins: Seeds = ()
    """For each icon, positions that every draw keeps; empty if there are none at all."""
    like: Seeds = ()
    """Seeds of a hybrid of the same icons that the draws should resemble: each keeps those of some
    icons and redraws the others. Empty: all are drawn."""
    first: int = 0
    """Number of the first draw: the draws of one seed can be had in several goes."""
