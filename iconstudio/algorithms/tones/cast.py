"""The flat shadow that a figure casts on the tile or the badge that it is on, to one side."""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from iconstudio.algorithms.extremes import maximum_filter
from iconstudio.algorithms.tones.regions import ALIKE, Mask, Regions, cielab, hull, nearest, regions

_DEEPEST, _FAINTEST = 0.45, 0.97
"""How bright a shadow is at least and at most, as part of what it lies on."""
_TINGE = 45.0
"""Levels by which it misses the colour of that, made darker; palettes have shades of their own."""
_MEET = 15
"""Pixels across, of where they meet."""
_PLATE = 0.95
"""How much of its convex hull a tile or a badge fills, with all that is on it."""
_BEHIND, _BEFORE, _STRAY = 0.92, 0.6, 0.012
"""How much of a shadow lies behind the figure at least, seen aslant, and before it at most; and by
how much it may be wider, as part of the picture's side."""
_NEAR, _BEGINS = 0.06, 0.6
"""So near to the figure, as part of the side, so much of what lies behind it is in shadow."""
_SLIGHT, _LEAP = 4.0, 3.0
"""Least difference between a shadow and what it lies on (CIEDE2000), and that of a channel of
CIELAB at its edge."""
_LEAST = 0.004
"""Size of a shadow, as part of the picture, at least."""
_STEP, _APART, _FEW = 2, 2, 12
"""Of so many rows and columns one is looked at for plates and shades; so many of them lie between
two colours at an edge; and places where they meet that a shadow has at least."""
_EDGE = 5
"""Pixels across, of where two colours blend."""
_DIRECTIONS = ((1, 1), (1, -1), (-1, 1), (-1, -1))


class _Light(NamedTuple):
    """What is left of the light in a shadow."""

    bright: float
    """How bright it is, as part of what it lies on."""
    tinge: NDArray[np.float64]
    """(3,): levels of sRGB that it lacks beside."""


def is_cast(shadow: Mask, figure: Mask, ground: Mask) -> bool:
    """Whether a shadow (h, w) is what a figure hides of its ground, seen aslant from one corner."""
    size = max(shadow.shape)
    if shadow.sum() < _LEAST * shadow.size or not figure.any():
        return False
    stray = 2 * round(_STRAY * size) + 1
    wide = maximum_filter(figure, stray)
    for down, across in _DIRECTIONS:
        behind, before = (_swept(wide, side * down, side * across, size) for side in (1, -1))
        if (behind & shadow).sum() < _BEHIND * shadow.sum():
            continue
        # A line around a figure is on all sides of it.
        if (before & shadow).sum() > _BEFORE * shadow.sum():
            continue
        near = _swept(figure, down, across, round(_NEAR * size)) & (shadow | ground)
        if (near & shadow).sum() > _BEGINS * near.sum():
            return True
    return False


def without_cast_shadow(
    rgba: NDArray[np.uint8], rgb: NDArray[np.uint8], found: Regions, smallest: float
) -> tuple[NDArray[np.uint8], NDArray[np.uint8]] | None:
    """Return a drawing (n, n, 4) with its shadow lit as its plate is, or None if it has none.

    Also its colours (m, m, 3), sRGB, at the resolution of its regions, before and after. The
    plate, a tile or a badge, is what is all around, but for the shadow.
    """
    inside = found.labels > 0
    if len(found.areas) < 3:
        return None
    seen = inside[::_STEP, ::_STEP]
    if seen.sum() < _PLATE * hull(seen).sum() or not _is_shaded(rgb, found):
        return None
    # On a gradient, what differs little in places differs more elsewhere.
    closer = regions(cielab(rgb), inside, _SLIGHT, smallest, leap=_LEAP)
    shadow, light = _shadow(closer, rgb)
    if shadow is None:
        return None
    lit = rgb.copy()
    lit[shadow] = np.clip(np.rint(rgb[shadow] / light.bright + light.tinge), 0, 255)
    # Between the two, pixels have neither colour.
    ground = found.labels == found.lengths[0].argmax()
    plain = closer.pure & (shadow | ground)
    edge = ~closer.pure & inside & maximum_filter(shadow & plain, _EDGE)
    edge &= maximum_filter(ground & plain, _EDGE)
    edge &= ~maximum_filter(closer.pure & inside & ~plain, _EDGE)
    lit[edge] = lit[nearest(plain)][edge]
    at = np.arange(len(rgba)) * len(rgb) // len(rgba)
    painted = rgba.copy()
    changed = (shadow | edge)[at][:, at]
    painted[changed, :3] = lit[at][:, at][changed]
    return painted, lit


def _is_shaded(rgb: NDArray[np.uint8], found: Regions) -> bool:
    """Whether what is all around meets a darker shade of it anywhere, which is soon seen."""
    labels = found.labels[::_STEP, ::_STEP]
    ground = labels == found.lengths[0].argmax()
    colours, inside = rgb[::_STEP, ::_STEP].astype(np.float32), labels > 0
    met = 0
    for one, other in (
        (np.s_[_APART:], np.s_[:-_APART]),
        (np.s_[:, _APART:], np.s_[:, :-_APART]),
    ):
        for lit, dark in ((one, other), (other, one)):
            at = ground[lit] & inside[dark]
            beside, shadow = colours[lit][at], colours[dark][at]
            bright = shadow.sum(axis=1, keepdims=True) / np.maximum(beside.sum(axis=1), 1)[:, None]
            shade = (bright[:, 0] > _DEEPEST) & (bright[:, 0] < _FAINTEST)
            met += int((shade & (_astray(shadow, beside, bright) < _TINGE)).sum())
    return met > _FEW


def _astray(
    shadow: NDArray[np.floating], lit: NDArray[np.floating], bright: float | NDArray[np.floating]
) -> NDArray[np.floating]:
    """Return by how many levels each colour (m, 3) misses another one made so bright."""
    missed: NDArray[np.floating] = abs(shadow - bright * lit).max(axis=1)
    return missed


def _shadow(found: Regions, rgb: NDArray[np.uint8]) -> tuple[Mask | None, _Light]:
    """Return where the shadow (n, n) of the figure on a plate lies, or None; and its light."""
    ground = int(found.lengths[0].argmax())
    shaded = np.zeros(len(found.areas), bool)
    lights: list[_Light] = []
    for one in np.flatnonzero(found.lengths[ground] > 0):
        if one:
            light = _light(found, rgb, int(one), ground)
            if light is not None:
                shaded[one] = True
                lights.append(light)
    if not shaded.any():
        return None, _Light(1.0, np.zeros(3))
    # What of it the figure cuts off from its ground has the same colour.
    apart = np.linalg.norm(found.colours[:, None] - found.colours[shaded], axis=2).min(axis=1)
    shaded |= (apart < ALIKE) & (found.colours[:, 0] < found.colours[ground, 0])
    shaded[[0, ground]] = False
    plate = shaded.copy()
    plate[ground] = True
    rim = found.lengths[0]
    figure = (found.labels > 0) & ~plate[found.labels]
    shadow: Mask = shaded[found.labels]
    on_plate = rim[plate].sum() > _PLATE * rim.sum()
    cast = on_plate and is_cast(shadow, figure, found.labels == ground)
    bright, tinge = (np.median(values, axis=0) for values in zip(*lights, strict=True))
    return (shadow if cast else None), _Light(float(bright), tinge)


def _light(found: Regions, rgb: NDArray[np.uint8], one: int, ground: int) -> _Light | None:
    """Return the light of a region where it meets another one; None if it is no shade of that."""
    here, beside = (found.pure & (found.labels == number) for number in (one, ground))
    here &= maximum_filter(beside, _MEET)
    if not here.any():
        return None
    shadow, lit = rgb[here].astype(float), rgb[nearest(beside)][here].astype(float)
    bright = float((shadow * lit).sum() / max((lit * lit).sum(), 1))
    amiss = np.median(_astray(shadow, lit, bright))
    if not (_DEEPEST < bright < _FAINTEST and amiss < _TINGE):
        return None
    return _Light(bright, np.median(lit - shadow / bright, axis=0))


def _swept(mask: Mask, down: int, across: int, length: int) -> Mask:
    """Return where a mask (h, w) comes as it is moved by so many steps aslant, or fewer."""
    swept, moved = mask.copy(), 1
    while moved <= length:
        swept |= _moved(swept, down * moved, across * moved)
        moved *= 2
    return swept


def _moved(mask: Mask, down: int, across: int) -> Mask:
    height, width = mask.shape
    moved = np.zeros_like(mask)
    if abs(down) < height and abs(across) < width:
        moved[max(0, down) : height + min(0, down), max(0, across) : width + min(0, across)] = mask[
            max(0, -down) : height - max(0, down), max(0, -across) : width - max(0, across)
        ]
    return moved
