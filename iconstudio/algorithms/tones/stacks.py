"""Regions that are ink as their neighbours are, though these are ink on both sides of them.

1. The middle stripe of a flag in three colours, and what lies in the midst of a mosaic, where the
   marks upon it, as the days of a calendar, do not count.
2. A *layer*, as of a burger: thick, it reaches from one side of the drawing to the other, so that
   the drawing would fall apart without it, and what it parts differs in colour. But the bands of
   a rainbow, which are as thick as the first and the last, alternate.
3. The *sectors* of a wheel, of which each has a colour of its own: so that none is missing.
"""

import numpy as np
import scipy

from iconstudio.algorithms.tones.regions import ALIKE, Mask, Regions
from iconstudio.algorithms.tones.tiles import SHARP, rectangularity

_SEVERAL, _MOST_BESIDE = 4, 0.4
"""Neighbours that a piece of a mosaic has, and how much of its contour one of them has at most."""
_SQUARES = 4
"""Of either colour of a board, at least: a page with dots has one of paper."""
_UNLIKE = 3.0
"""How many times as large as usual a square of a board is at most."""
_CORNER = 4
"""Pixel sides at which squares may meet that are aslant of each other."""
_THICK = 28.0
"""Width in pixels of the thinnest layer; a thinner one reads as a line of paper."""
_THICKER, _FEW = 1.3, 3
"""By how much what is on either side is thicker, unless there are no more layers than that."""
_SHARE = 0.15
"""How much of a layer's contour it shares with what is on either side, at least."""


def stacked(found: Regions) -> Mask:
    """Return the regions (k + 1,) that are as those of other colours beside them."""
    outer = found.lengths[0] > 0
    outer[0] = False
    sectors = _sectors(found, outer)
    if rectangularity(found) < SHARP:
        return _layers(found, outer) | sectors
    middle: Mask = sectors
    for number in np.flatnonzero(outer):
        beside = np.flatnonzero(outer & (found.lengths[number] > 0))
        middle[number] |= len(beside) == 2 and not _are_alike(found, *beside)
    around = found.beside
    several = (around > 0).sum(axis=1) >= _SEVERAL
    middle |= several & (around.max(axis=1) < _MOST_BESIDE * around.sum(axis=1)) & ~outer
    middle[0] = False
    return middle


def checkered(found: Regions) -> Mask | None:
    """Return the regions (k + 1,) that are ink of a board in two colours; None if it is none.

    These are its darker squares, and the pole that it is on, if it is a flag.
    """
    square = found.areas <= _UNLIKE * np.median(found.areas[1:])
    square[0] = False
    tones = [one for one in _tones(found, square) if one.sum() >= _SQUARES]
    if len(tones) != 2:
        return None
    board = tones[0] | tones[1]
    beside = ~board
    beside[0] = False
    pole = (found.lengths[0] > 0) & ~found.white
    if beside.sum() > 1 or (beside & ~pole).any() or rectangularity(found, board) < SHARP:
        return None
    if any((found.lengths[np.ix_(tone, tone)] > _CORNER).any() for tone in tones):
        return None
    dark = min(tones, key=lambda tone: float(found.colours[tone, 0].mean()))
    return dark | beside


def _tones(found: Regions, some: Mask) -> list[Mask]:
    """Return which of some regions (k + 1,) have each colour."""
    rest = some.copy()
    tones: list[Mask] = []
    while rest.any():
        first = found.colours[rest.argmax()]
        alike = rest & (np.linalg.norm(found.colours - first, axis=1) <= ALIKE)
        tones.append(alike)
        rest &= ~alike
    return tones


def _layers(found: Regions, outer: Mask) -> Mask:
    layers, thinner = np.zeros((2, len(outer)), bool)
    reaches = outer & (found.lengths[0] > _THICK)  # more than the points of an overlap
    for number in np.flatnonzero(reaches & (found.widths > _THICK)):
        meet = found.lengths > 0
        meet[0] = meet[:, 0] = meet[number] = meet[:, number] = False
        _, piece = scipy.sparse.csgraph.connected_components(meet)
        beside = np.where(outer, found.lengths[number], 0)
        first, *others = np.argsort(-beside)
        second = next((one for one in others if piece[one] != piece[first]), 0)
        wide = beside[second] > _SHARE * found.around[number]
        layers[number] = wide and not _are_alike(found, first, second)
        thickest = [found.widths[piece == piece[one]].max() for one in (first, second)]
        thinner[number] = min(thickest) > _THICKER * found.widths[number]
    return layers if layers.sum() <= _FEW else layers & thinner


def _sectors(found: Regions, outer: Mask) -> Mask:
    """Return the regions (k + 1,) at the outside that meet two others each, all around."""
    meet = (found.lengths > _THICK) & outer & outer[:, None]  # more than at the hub
    _, ring = scipy.sparse.csgraph.connected_components(meet)
    sectors = outer.copy()
    for number in np.unique(ring[outer]):
        of_ring = ring == number
        colours = found.colours[of_ring]
        apart = np.linalg.norm(colours[:, None] - colours, axis=2) + ALIKE * np.eye(len(colours))
        closed = len(colours) > 2 and (meet[of_ring].sum(axis=1) == 2).all()
        sectors[of_ring] = closed and (apart >= ALIKE).all()
    return sectors


def _are_alike(found: Regions, one: int, other: int) -> bool:
    return bool(np.linalg.norm(found.colours[one] - found.colours[other]) <= ALIKE)
