"""The axes of reflection that a result can be held to (section 3.4)."""

from enum import StrEnum


class Axis(StrEnum):
    """Which halves of the canvas mirror each other; the axis goes through the centre.

    The names are the paper's: a face has horizontal symmetry, its left half mirrors its right.
    """

    HORIZONTAL = "horizontal"
    """Left and right: the axis is upright."""
    VERTICAL = "vertical"
    """Top and bottom: the axis is level."""
    DIAGONAL = "diagonal"
    """Across the diagonal from the top left to the bottom right."""
    ANTIDIAGONAL = "antidiagonal"
    """Across the diagonal from the top right to the bottom left."""
