"""Lines too thin for an area of even colour: what no two colours beside them blend to."""

from collections.abc import Sequence
from itertools import chain, combinations, product
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from iconstudio.algorithms.extremes import maximum_filter
from iconstudio.algorithms.patterns.clusters import (
    FEWEST,
    LEAST,
    Limits,
    Numbers,
    Pixels,
    clustered,
)
from iconstudio.algorithms.patterns.soft_edges import nearest_colours, three_nearest
from iconstudio.algorithms.scanning.blending import unblended
from iconstudio.algorithms.tones.regions import cielab

Colour = NDArray[np.floating]
"""(3,), red, green and blue."""

_BESIDE = 0.1
"""How many of its pixels a colour is near to if a line lies beside it."""
_LINE = 0.4
"""How much of a pixel a line has, at least, where it is narrower than that."""
_SAME = 4.0
"""Levels by which most pixels of lines in a colour of their own are apart."""


class Lines(NamedTuple):
    """Lines that are too thin for even colours."""

    number: Numbers
    """(h, w), the colours of their pixels; -1 of all others."""
    share: NDArray[np.float32]
    """(h, w), how much of a pixel they cover, from 0.5 to 1."""
    colours: list[Colour]
    """(3,) each, those that no even area has."""


def lines_of(
    pixels: Pixels,
    cores: Numbers,
    palette: Sequence[Colour],
    stray: NDArray[np.float32],
    limits: Limits,
    most: int,
) -> Lines | None:
    """Return lines that are too thin for even colours; None if there are none.

    Along one, the pixels that stray most from what is beside it have its colour, or blend it.

    Parameters
    ----------
    cores, palette
        The areas of even colour (h, w), -1 elsewhere; and their colours.
    stray
        (h, w), by how much pixels stray from what is around them.
    most
        So many colours more there are at most.
    """
    stray = np.where(cores < 0, stray, 0)
    ridge = (stray > limits.stray) & (stray >= maximum_filter(stray, 3) - 1)
    if not ridge.any():
        return None
    own = pixels[ridge].astype(np.float32)
    beside = nearest_colours(cores)[ridge]
    around, _, _ = three_nearest(pixels, cores, *np.nonzero(ridge))
    kinds = clustered(cielab(pixels[ridge]), np.ones(len(own)), FEWEST / 2, limits.alike, None)
    means = [stray[ridge][kinds == one].mean() for one in range(int(kinds.max()) + 1)]
    least = max(FEWEST, LEAST / 2 * cores.size)
    colours: list[Colour] = []
    for one in np.argsort(means)[::-1]:  # what strays less may be a blend of what strays more
        some = kinds == one
        if some.sum() < least or len(colours) == most:
            continue
        numbers = around[:, some]
        near = np.flatnonzero(np.bincount(numbers[numbers >= 0]) > _BESIDE * some.sum())
        if not _blends(own[some], near, [*palette, *colours], limits.stray):
            colours.append(np.median(own[some], axis=0))
    number = np.full(cores.shape, -1, np.int16)
    share = np.ones(cores.shape, np.float32)
    number[ridge], share[ridge] = _drawn(
        own, np.array(palette, np.float32)[beside], [*palette, *colours], limits.stray
    )
    return Lines(number, share, colours)


def _blends(
    own: NDArray[np.float32],
    near: NDArray[np.intp],
    palette: Sequence[Colour],
    stray: float,
) -> bool:
    """Whether pixels (n, 3) of lines have one of some colours, or blend it with what is near.

    Most of those of a line in a colour of its own are alike, as far as it is no blend by chance.
    """
    colour = np.median(own, axis=0)
    if (np.abs(own - colour).max(axis=1) < _SAME).mean() > 0.5:
        stray = _SAME
    besides = [palette[one] for one in near]
    some = chain(
        ((one,) for one in palette),
        product(besides, palette),
        ((*pair, one) for pair in combinations(besides, 2) for one in palette),
    )
    return any(
        unblended(colour[None], [one[None].astype(np.float32) for one in of])[1] < stray**2
        for of in some
    )


def _drawn(
    own: NDArray[np.float32],
    beside: NDArray[np.float32],
    colours: Sequence[Colour],
    stray: float,
) -> tuple[Numbers, NDArray[np.float32]]:
    """Return which colour, and how much of it, pixels (n, 3) of lines blend with what is beside.

    It is -1 for none.
    """
    found, shares = np.full(len(own), -1, np.int16), np.ones(len(own), np.float32)
    least = np.full(len(own), stray**2, np.float32)
    for number, colour in enumerate(colours):
        for blended in (False, True):
            parts, off = unblended(own, [colour[None].astype(np.float32), beside][: 1 + blended])
            better = (off < least) & (parts[0] >= _LINE) & (off < np.inf)
            better &= np.linalg.norm(beside - colour, axis=1) > stray
            found[better], least[better] = number, off[better]
            shares[better] = np.maximum(parts[0][better], 0.5)
    return found, shares
