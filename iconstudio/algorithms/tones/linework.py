"""Line drawings: dark lines around fills, which are paper, and what else there is beside them.

The rule. A shape is all that has one colour, also where a line runs over it. A shape that reaches
the outside

1. is a *fill*, and paper, if the lines enclose most of it, but for small gaps, or run along most
   of its contour;
2. is a *backdrop*, and paper, if most of the lines run over it, as over a blob behind a drawing;
3. is a *line*, and ink, if it is as narrow as the lines, and free;
4. else is a part of the drawing, and ink; the lines over it are set off by paper.

A fill that reaches out of the lines and a backdrop are decoration, and left out. So is what is pale
beside the lines, whether they are filled or not: a shadow, or a glow. Within the lines, all that
stands out in a fill is ink, and so is grey that lies free in a pale grey. A shape that has dark
lines along one side, with little of it enclosed, is shaded by them; that is no line drawing. Around
fills as pale as paper, lines need not be dark.
"""

from typing import NamedTuple

import numpy as np
import scipy
from numpy.typing import NDArray

from iconstudio.algorithms.tones.alternation import Omission, Tones, decide
from iconstudio.algorithms.tones.regions import (
    ALIKE,
    GREY,
    VISIBLE,
    VIVID,
    Mask,
    Regions,
    nearest,
    pale,
    sums,
)  # fmt: skip

_SQUARES, _ASTRAY = 6, 0.1
"""Squares of each colour that a board to play on has at least; how much of where they meet may lie
between two of one colour."""
THICK = 512 / 10
"""Width in pixels of the thickest lines of a line drawing, and bands of white."""
_GAP = 20
"""Half the width in pixels of the gaps that an outline may have."""
_AS_DARK, _DARK, _PALE = 18.0, 30.0, 75.0
"""Lightness: how much lighter than its lines the dark parts of a line drawing are at most, or how
dark; and that of shadows."""
_LIGHT, _LIGHTER = 55.0, 78.0
"""Lightness of the lightest lines, and of the lightest around fills that are all pale."""
_MOSTLY = 0.8
"""How much of fills is pale if they are."""
_WIDER = 1.2
"""How much wider than lines pale shadows are at least."""
_FREE, _DARKER = 0.95, 10.0
"""How much of its contour a mark on a fill shares with that, and how much darker it is."""
_OUT = 0.1
"""How much of a fill may reach out of its outline without being told."""


class _Shapes(NamedTuple):
    """What the regions that are no lines make together, for each region (k + 1,)."""

    enclosed: NDArray[np.float64]
    """How much of the shape that it belongs to the lines enclose."""
    behind: NDArray[np.float64]
    """How much of the lines runs over that shape."""
    free: NDArray[np.float64]
    """How much of that shape's contour is on the outside."""


def outline(found: Regions) -> Mask | None:
    """Return the regions (k + 1,) that are the outline of a line drawing, or None."""
    for number in np.argsort(-found.lengths[0])[:3]:
        line: Mask = abs(found.colours - found.colours[number]).max(axis=1) < 12
        line[0] = False
        if found.lengths[0, number] > 0 and _is_outline(found, line, found.colours[number, 0]):
            return line
    return None


def _is_outline(found: Regions, line: Mask, lightness: float) -> bool:
    """Whether regions of that lightness are dark, thin, and around most of their pieces."""
    piece = found.pieces()
    of_it = np.isin(piece, piece[line])
    of_it[0] = False
    fills = of_it & ~line
    around, areas = found.lengths[0], found.areas
    on_paper = _mostly_pale(found, fills)
    if lightness > (_LIGHTER if on_paper else _LIGHT) or not line.any():
        return False
    if _has_only_shadows(found, line):
        return True
    if (
        around[line].sum() <= 0.4 * around.sum()
        or areas[line].sum() >= 0.6 * areas[of_it].sum()
        or _lightness(found, fills & (found.colours[:, 0] > lightness) if on_paper else fills)
        <= lightness + 20
        or _width(found, line) >= THICK
    ):
        return False
    if around[line].sum() > 0.6 * around[of_it].sum():
        return True
    # A fill that reaches out and a part that the lines cross need have none around them, if there
    # is nothing else without; what has them along one side only is shaded by them.
    shapes = _shapes(found, line)
    crossed = (shapes.enclosed > _OUT) & (shapes.enclosed < 1 - _OUT)
    crossed &= (shapes.enclosed > 0.5) | (shapes.free > 0.5)
    crossed[0] = False
    return bool(around[line].sum() > 0.8 * around[~crossed].sum())


def _lightness(found: Regions, some: Mask) -> float:
    """Return the mean lightness of some of the regions."""
    return float(np.average(found.colours[some, 0], weights=found.areas[some]))


def _mostly_pale(found: Regions, fills: Mask) -> bool:
    """Whether fills are as pale as paper, but for what is drawn on them."""
    areas = found.areas
    return bool(areas[fills & pale(found.colours)].sum() > _MOSTLY * areas[fills].sum())


def _has_only_shadows(found: Regions, line: Mask) -> bool:
    """Whether all beside lines that enclose much, and have no fills, is pale and outside."""
    others = ~line
    others[0] = False
    if not others.any() or not (_shady(found) & ~found.white)[others].all():
        return False
    # Pale lines, which are as narrow, are lines of a second tone.
    if _width(found, others) < _WIDER * _width(found, line):
        return False
    enclosed = _enclosed(line[found.labels])
    within = (enclosed & others[found.labels]).sum() / found.areas[others].sum()
    return bool(within < _OUT and enclosed.sum() > 1.5 * found.areas[line].sum())


def _width(found: Regions, some: Mask) -> float:
    """Return the mean width of some of the regions."""
    return float(np.average(found.widths[some], weights=found.areas[some]))


def _shady(found: Regions) -> Mask:
    lightness, *chromatic = found.colours.T
    pale: Mask = (lightness > _PALE) & (np.hypot(*chromatic) < 3 * GREY)
    return pale


def line_drawing(found: Regions, line: Mask) -> Tones:
    """Return the tones of a drawing with that outline."""
    lightness = found.colours[:, 0]
    dark = lightness < max(lightness[line].max() + _AS_DARK, _DARK)
    piece = found.pieces()
    beside = ~np.isin(piece, piece[line])
    shady = _shady(found)
    shapes = _shapes(found, line)
    reaches_out = ~dark & ~beside & (shapes.free > 0)
    thin = found.widths < np.where(shady, _WIDER, 1.5) * _width(found, line)
    strokes = reaches_out & thin & (found.lengths[0] > 0.7 * found.around)
    apart = reaches_out & (shapes.enclosed < 0.5) & (shapes.free > 0.5)
    part = apart & ~shady & ~strokes & (shapes.behind < 0.6)
    # What lies within such a part is as in drawings without lines.
    within = found.lengths[:, part].sum(axis=1) > 0.9 * found.around
    tone = np.where(dark | (beside & ~shady) | strokes | part, 1, 0)
    tone[within & (tone > 0)] = 0
    at_line = found.lengths[:, line].sum(axis=1) > found.around / 3
    tone[(tone == 0) & ~within & (beside | at_line | (apart & shady))] = -1
    tone[_marks(found) & (tone == 0)] = 1
    for squares, of_tone in zip(_chequered(found, line), (1, -1), strict=True):
        tone[squares] = of_tone
    tone[0] = -1
    striking = found.striking
    # What differs little is as its neighbours are.
    decide(tone, found, np.where(striking, 1, -0.2) * found.lengths, tone > 1)
    paper = tone < 0
    paper[0] = False
    decoration = reaches_out & (shapes.enclosed < 1 - _OUT)
    decoration &= (shapes.enclosed > 0.5) | (shapes.free > 0.4)
    left_out = paper & ~found.white & ((beside & shady) | decoration)
    fills = paper & ~left_out
    over = (tone > 0) & dark & (found.lengths[:, part].sum(axis=1) > 0)
    omissions = frozenset([Omission.DECORATION] if left_out.any() else [])
    bare = np.zeros_like(over)
    return Tones(tone > 0, fills & fills[:, None] & striking, over, bare, omissions)


def _marks(found: Regions) -> Mask:
    """Return what lies free in a fill, and is no shade: grey in a pale grey, vivid in white."""
    around = found.lengths.argmax(axis=1)
    grey = np.hypot(found.colours[:, 1], found.colours[:, 2]) < GREY
    free = found.lengths.max(axis=1) > _FREE * found.around
    ground = (grey & pale(found.colours))[around] & (around > 0)
    darker = found.colours[:, 0] < found.colours[around, 0] - _DARKER
    apart = np.linalg.norm(found.colours - found.colours[around], axis=1)
    vivid = (apart > VIVID) & (found.contrasts.max(axis=1) > VISIBLE) & found.white[around]
    # In a white letter, what is of the colour around it is its counter.
    behind = found.colours[around[around]]
    vivid &= np.linalg.norm(found.colours - behind, axis=1) > ALIKE
    marks: Mask = free & ((grey & ground & darker) | vivid)
    return marks


def _chequered(found: Regions, line: Mask) -> tuple[Mask, Mask]:
    """Return the darker and the lighter squares of a board to play on, if the lines are around one.

    Many of each meet the others alone.
    """
    rest = ~line
    rest[0] = False
    of_either: list[tuple[float, Mask]] = []
    for _ in range(2):
        largest = int(np.argmax(np.where(rest, found.areas, 0)))
        alike = rest & (np.linalg.norm(found.colours - found.colours[largest], axis=1) < ALIKE)
        of_either.append((float(found.colours[largest, 0]), alike))
        rest &= ~alike
    darker, lighter = (alike for _, alike in sorted(of_either, key=lambda one: one[0]))
    meet = found.lengths[darker][:, lighter].sum()
    own = (found.lengths[some][:, some].sum() for some in (darker, lighter))
    alone = max(own) < _ASTRAY * meet
    if min(darker.sum(), lighter.sum()) < _SQUARES or not alone:
        return np.zeros_like(line), np.zeros_like(line)
    return darker, lighter


def _shapes(found: Regions, line: Mask) -> _Shapes:
    count = len(line)
    at_line = line[found.labels]
    # Below the lines, what is beside them goes on.
    below = found.labels[nearest(~at_line)]
    meet = np.zeros((count, count), bool)
    for one, other in ((np.s_[1:], np.s_[:-1]), (np.s_[:, 1:], np.s_[:, :-1])):
        meet[below[one], below[other]] = True
    difference = np.linalg.norm(found.colours[:, None] - found.colours, axis=2)
    joined = meet & (difference < ALIKE) & (found.white == found.white[:, None])
    joined[0] = joined[:, 0] = False
    number, shape = scipy.sparse.csgraph.connected_components(joined, directed=False)

    def total(values: NDArray[np.integer | np.floating]) -> NDArray[np.float64]:
        whole: NDArray[np.float64] = sums(shape, values, number)[shape]
        return whole

    areas = np.maximum(total(found.areas), 1)
    inner = np.bincount(found.labels[_enclosed(at_line)], minlength=count)
    behind = np.bincount(below[at_line], minlength=count)
    return _Shapes(
        total(inner) / areas,
        total(behind) / max(at_line.sum(), 1),
        total(found.lengths[0]) / total(found.around),
    )


def _enclosed(lines: Mask) -> Mask:
    """Return what lines enclose, with themselves, were gaps closed."""
    margin = _GAP + 2
    away = scipy.ndimage.distance_transform_edt(~np.pad(lines, margin))
    filled = scipy.ndimage.binary_fill_holes(away <= _GAP)
    enclosed: Mask = scipy.ndimage.distance_transform_edt(filled) > _GAP
    return enclosed[margin:-margin, margin:-margin]
