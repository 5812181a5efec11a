"""Opaque colours, ``#rrggbb``."""

from collections.abc import Iterable


def hex_colour(levels: Iterable[int]) -> str:
    """Return the colour of a red, a green and a blue from 0 to 255.

    >>> hex_colour((255, 0, 16))
    '#ff0010'
    """
    return "#" + bytes(map(int, levels)).hex()


def levels_of(colour: str) -> tuple[int, int, int]:
    """Return the red, green and blue of a colour, from 0 to 255.

    >>> levels_of("#ff0010")
    (255, 0, 16)
    """
    red, green, blue = bytes.fromhex(colour[1:])
    return red, green, blue
