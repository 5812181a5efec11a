"""From a coloured drawing to a pictogram: what of it is ink, and what is paper.

The rule. All that is more than half as opaque as the drawing's body is its silhouette, divided
into regions of even colour (``regions``). Of these,

1. *one tone*, all over, is ink, whatever its colour and opacity;
2. in a *line drawing*, with a dark line around most of it, the lines and what is about as dark
   are ink, and the fills are paper; a detail that stands out within a fill is ink;
3. a *tile* behind the drawing is paper: a rectangle or a rounded square in which the drawing
   stands free, neither in small pieces (as a die's dots) nor filling it (as a screen). A disc is
   a badge or a face, and a tile only if it is near white;
4. *near white* on other colours is paper, unless it stands by itself or makes a large part of
   the silhouette (a cloud before the sun);
5. of the others, what mainly borders on the outside is ink; what mainly borders on ink is paper
   (eyes in a face, the door of a house), and what mainly borders on paper is ink;
6. between two regions of ink runs a line of paper; in a line drawing, between fills that differ
   strongly, one of ink.
"""

from enum import Enum
from typing import NamedTuple

import numpy as np
import scipy
from numpy.typing import NDArray

from iconstudio.algorithms.regions import Mask, Regions, cielab, nearest, regions

SIDE = 512
"""Pixels to a side at which regions are found."""
CONTRAST = 14.0
"""Neighbouring colours that differ by less (CIEDE2000) are shades of one."""
STRIKING = 35.0
"""Fills of a line drawing, and narrow regions, that differ by more are told apart."""
SMALLEST = 60
"""Pixels of the smallest detail that reads."""
LINE = 7.0
"""Width of the lines drawn between regions, in pixels: 3.5 on the canvas of 256."""
WHITE = 92.0
"""Lightness of near white, whose chroma is less than ``_GREY``."""
_GREY = 8.0
_AS_DARK, _DARK, _PALE = 18.0, 30.0, 75.0
"""Lightness: how much lighter than its lines the dark parts of a line drawing are at most, or how
dark; and that of shadows."""
_BLENDS = 4.0
"""Pixels on either side of an edge that may blend its colours."""
_FREE = 0.9
"""How much of its contour a shape that stands by itself shares with the outside."""
_NARROW = 2 * LINE
"""Width of regions that no line sets off, unless their colour is striking."""
_THICK = SIDE / 10
"""Width of the thickest lines of a line drawing, and bands of white."""


class Paints(Enum):
    """Which paints of a drawing are ink, if its shapes can be kept as they are."""

    ALL = "all paints are ink"
    DARK = "near white is paper, all other paints are ink"
    LIGHT = "near white is ink, all other paints are paper"


class _Tones(NamedTuple):
    ink: Mask
    """(k + 1,): the regions that are ink."""
    lines: Mask
    """(k + 1, k + 1): the neighbours with a line between them."""


def pictogram(rgba: NDArray[np.uint8]) -> NDArray[np.uint8]:
    """Return the coverage (n, n), 255 = ink, of the pictogram of a drawing (n, n, 4).

    The drawing is sRGB with straight alpha, fitted to the square; n is best a multiple of SIDE.
    A drawing without anything to see has no ink.
    """
    rgb, alpha = _reduced(rgba)
    body = _body(alpha)
    silhouette = np.minimum(rgba[..., 3] * (255 / body), 255)
    inside = alpha > body / 2
    if inside.any():
        found = regions(cielab(rgb), inside, CONTRAST, SMALLEST)
        tones = _tones(found)
        if tones.lines.any() or not tones.ink[1:].all():
            silhouette *= _enlarged(_soft(rgb, found, tones), len(rgba))
    return (silhouette + 0.5).astype(np.uint8)


def paints(rgba: NDArray[np.uint8], coverage: NDArray[np.uint8]) -> Paints | None:
    """Return which paints of a drawing are ink, given its pictogram; None if shapes must change.

    Painted so, and with the opacity of its body raised to 1, the drawing looks as the pictogram
    does but for specks; if there is no such way, the pictogram is to be traced.
    """
    rgb, alpha = _reduced(rgba)
    visible = alpha > _body(alpha) / 2
    white = near_white(rgb)
    ink = _averaged(coverage[..., None].astype(np.float32))[..., 0] > 127.5
    for choice, painted in (
        (Paints.ALL, visible),
        (Paints.DARK, visible & ~white),
        (Paints.LIGHT, visible & white),
    ):
        # Edges, where colours blend, do not count.
        amiss = scipy.ndimage.binary_opening(painted != ink, np.ones((3, 3)))
        if amiss.sum() < SMALLEST:
            return choice
    return None


def near_white(rgb: NDArray[np.uint8]) -> Mask:
    """Return which of the sRGB colours (..., 3) are near white."""
    return _near_white(cielab(rgb))


def _near_white(colours: NDArray) -> Mask:
    lightness, a, b = np.moveaxis(colours, -1, 0)
    return (lightness > WHITE) & (np.hypot(a, b) < _GREY)


def _reduced(rgba: NDArray[np.uint8]) -> tuple[NDArray[np.uint8], NDArray[np.float32]]:
    """Return the colours and the alpha, 0 to 255, of a drawing on SIDE by SIDE pixels."""
    premultiplied = rgba.astype(np.float32)
    premultiplied[..., :3] *= premultiplied[..., 3:] / 255
    small = _averaged(premultiplied)
    alpha = small[..., 3]
    rgb = small[..., :3] * (255 / np.maximum(alpha, 1))[..., None]
    return np.clip(rgb + 0.5, 0, 255).astype(np.uint8), alpha


def _averaged(values: NDArray[np.float32]) -> NDArray[np.float32]:
    """Return the means (SIDE, SIDE, c) of values (n, n, c)."""
    from skimage.transform import resize_local_mean

    n, _, channels = values.shape
    if n % SIDE:
        return resize_local_mean(values, (SIDE, SIDE), channel_axis=2)
    return values.reshape(SIDE, n // SIDE, SIDE, n // SIDE, channels).mean(axis=(1, 3))


def _body(alpha: NDArray[np.float32]) -> float:
    """Return the alpha of a drawing's body: all but its most opaque specks have no more."""
    visible = alpha[alpha > 4]
    return float(np.quantile(visible, 0.95)) if visible.size else 255.0


def _tones(found: Regions) -> _Tones:
    line = _line(found)
    if line is not None:
        return _line_drawing(found, line)
    ink = _alternating(found, _tile(found))
    # A line would leave little of a narrow region.
    narrow = found.widths < _NARROW
    narrow = (narrow | narrow[:, None]) & (found.contrasts < STRIKING)
    return _Tones(ink, ink & ink[:, None] & (found.lengths > 0) & ~narrow)


def _alternating(found: Regions, tile: int | None) -> Mask:
    """Return which regions are ink: those on the outside, and what lies within their holes."""
    paper = np.zeros(len(found.areas), bool)
    paper[0] = True
    if tile is not None:
        paper[tile] = True
    # Of paper on the outside colours do not matter.
    weights = found.lengths * np.minimum(found.contrasts, 60)
    weights[:, paper] = 120 * found.lengths[:, paper]
    tone = np.where(paper, -1, 0)
    if tile is None:
        tone[_white_on_colour(found)] = -1
    # The shade along a contour is no outline of what it is the shade of.
    inner = found.contrasts[:, 1:].max(axis=1)
    shade = (tone == 0) & (found.widths < _NARROW) & (inner > 0) & (inner < STRIKING)
    weights[shade] = found.lengths[shade]
    _decide(tone, found, weights, shade)
    return tone > 0


def _decide(
    tone: NDArray[np.intp], found: Regions, weights: NDArray[np.float64], last: Mask
) -> None:
    """Give each region of ``tone`` 0 the tone, 1 ink or -1 paper, that differs from its neighbours.

    ``weights`` (k + 1, k + 1) say how much it matters that two neighbours differ; ``last`` are
    the regions that the others do not heed.
    """
    around = np.maximum(found.lengths[:, ~last].sum(axis=1), 1)
    while not tone.all():
        # Next is the region whose neighbours are known best; of several, the largest.
        known = (found.lengths[:, (tone != 0) & ~last].sum(axis=1) / around).round(2)
        number = max(
            np.flatnonzero(tone == 0), key=lambda r: (not last[r], known[r], found.areas[r])
        )
        tone[number] = -1 if weights[number] @ tone > 0 else 1


def _pieces(found: Regions) -> tuple[int, NDArray[np.intp]]:
    """Return the number of separate pieces, and which each region belongs to; 0 is one, too."""
    meet = found.lengths > 0
    meet[0] = meet[:, 0] = False
    return scipy.sparse.csgraph.connected_components(meet)


def _white(found: Regions) -> Mask:
    white = _near_white(found.colours)
    white[0] = False
    return white


def _white_on_colour(found: Regions) -> Mask:
    """Return the white regions that are paper, as they make no part of the silhouette."""
    white = _white(found)
    total = found.areas[1:].sum()
    if found.areas[1:][~white[1:]].sum() < 0.05 * total:
        return np.zeros_like(white)
    page = white & (found.lengths[0] > 0.75 * found.lengths[0].sum())
    if page.any() and _rectangle(found) > _SHARP:
        return white
    outer = found.lengths[0]
    free = outer > _FREE * found.lengths.sum(axis=1)
    at_outside = outer > 0
    at_outside[0] = True
    # What is drawn on the white does not count. A narrow band sets other colours off.
    large = (found.areas > 0.05 * total) & (found.widths > _THICK)
    part = large & (outer > 0.5 * found.lengths[:, at_outside].sum(axis=1))
    return white & ~free & ~part


_SHARP, _ROUNDED, _ROUND = 0.985, 0.9, 0.76
"""How much of its bounding box a rectangle fills, a rounded square, a circle."""


def _box(inside: Mask) -> tuple[int, int]:
    """Return height and width of what is inside."""
    rows, columns = np.flatnonzero(inside.any(axis=1)), np.flatnonzero(inside.any(axis=0))
    return rows[-1] - rows[0] + 1, columns[-1] - columns[0] + 1


def _rectangle(found: Regions) -> float:
    """Return how much of its bounding box the silhouette fills."""
    height, width = _box(found.labels > 0)
    return found.areas[1:].sum() / (height * width)


def _tile(found: Regions) -> int | None:
    """Return the region that is a tile behind the drawing proper, or None."""
    outer = np.flatnonzero(found.lengths[0])
    if len(outer) != 1 or len(found.areas) == 2:
        return None
    tile = int(outer[0])
    white, fill = _white(found), _rectangle(found)
    sharp = fill > _SHARP
    if white[tile] and sharp:
        return tile
    alike = np.linalg.norm(found.colours - found.colours[tile], axis=1) < CONTRAST
    two_tones = (white | alike)[1:].all()
    dark = found.colours[tile, 0] < _DARK
    height, width = _box(found.labels > 0)
    square = max(height, width) < 1.1 * min(height, width)
    banner = sharp and dark and two_tones
    if not banner and not (square and fill > (_ROUND if white[tile] else _ROUNDED)):
        return None
    content = (found.labels > 0) & (found.labels != tile)
    pieces = scipy.ndimage.find_objects(scipy.ndimage.label(content)[0])
    span = max(side.stop - side.start for piece in pieces for side in piece)
    share = content.sum() / found.areas[1:].sum()
    return tile if share < 0.6 and span > min(height, width) / 3 else None


def _line(found: Regions) -> Mask | None:
    """Return the regions (k + 1,) that are the outline of a line drawing, or None."""
    around = found.lengths[0]
    _, piece = _pieces(found)
    for number in np.argsort(-around)[:3]:
        line = abs(found.colours - found.colours[number]).max(axis=1) < 12
        line[0] = False
        of_it = np.isin(piece, piece[line])
        of_it[0] = False
        fills = of_it & ~line
        if (
            around[number] > 0
            and around[line].sum() > 0.6 * around[of_it].sum()
            and around[line].sum() > 0.4 * around.sum()
            and found.areas[line].sum() < 0.6 * found.areas[of_it].sum()
            and np.average(found.colours[fills, 0], weights=found.areas[fills])
            > found.colours[number, 0] + 20
            and found.colours[number, 0] < 55
            and np.average(found.widths[line], weights=found.areas[line]) < _THICK
        ):
            return line
    return None


def _line_drawing(found: Regions, line: Mask) -> _Tones:
    """Return the tones of a line drawing: its fills are paper, what stands out in them is ink."""
    lightness, *chromatic = found.colours.T
    dark = lightness < max(lightness[line].max() + _AS_DARK, _DARK)
    _, piece = _pieces(found)
    beside = ~np.isin(piece, piece[line])
    shadow = (lightness > _PALE) & (np.hypot(*chromatic) < 3 * _GREY)
    tone = np.where(dark | (beside & ~shadow), 1, 0)
    around = np.maximum(found.lengths.sum(axis=1), 1)
    tone[(tone == 0) & (beside | (found.lengths[:, line].sum(axis=1) > around / 3))] = -1
    tone[0] = -1
    striking = found.contrasts > STRIKING
    # What differs little is as its neighbours are.
    _decide(tone, found, np.where(striking, 1, -0.2) * found.lengths, tone > 1)
    fills = tone < 0
    fills[0] = False
    return _Tones(tone > 0, fills & fills[:, None] & striking)


def _soft(rgb: NDArray[np.uint8], found: Regions, tones: _Tones) -> NDArray[np.float32]:
    """Return how much of each pixel is ink, (SIDE, SIDE) from 0 to 1, were all inside."""
    soft = _blended(rgb, found, tones.ink)
    labels = found.extended
    edge = np.zeros(labels.shape, bool)
    for one, other in ((np.s_[1:], np.s_[:-1]), (np.s_[:, 1:], np.s_[:, :-1])):
        edge[one] |= tones.lines[labels[one], labels[other]]
    if edge.any():
        # Smoothing takes the staircase off the lines.
        away = _smooth(scipy.ndimage.distance_transform_edt(~edge), LINE / 4)
        drawn = np.clip(LINE / 2 + 0.5 - away, 0, 1)
        at_ink = tones.ink[labels]
        soft = np.where(at_ink, np.minimum(soft, 1 - drawn), np.maximum(soft, drawn))
    return _without_crumbs(soft, found.labels > 0)


def _blended(rgb: NDArray[np.uint8], found: Regions, ink: Mask) -> NDArray[np.float32]:
    """Return how much of each pixel is ink, as its blend of the colours of ink and paper tells."""
    toned = ink[found.extended]
    pure = found.pure & (found.labels > 0)
    if not (pure & toned).any() or not (pure & ~toned).any():
        return toned.astype(np.float32)
    at_ink, at_paper = nearest(pure & toned), nearest(pure & ~toned)
    here = np.indices(toned.shape)
    near = [np.hypot(*(np.array(at) - here)) <= _BLENDS for at in (at_ink, at_paper)]
    mixed = near[0] & near[1] & ~pure & (found.labels > 0)
    full, none = (rgb[at][mixed].astype(np.float32) for at in (at_ink, at_paper))
    way = full - none
    share = ((rgb[mixed] - none) * way).sum(axis=1) / np.maximum((way**2).sum(axis=1), 1)
    soft = toned.astype(np.float32)
    soft[mixed] = np.clip(share, 0, 1)
    return _smooth(soft, 0.6)


def _without_crumbs(soft: NDArray[np.float32], inside: Mask) -> NDArray[np.float32]:
    """Take away what lines leave of ink or paper that is smaller than any detail."""
    soft = soft.copy()
    for tone in (1, 0):
        of_tone = (soft > 0.5) == tone
        pieces, _ = scipy.ndimage.label(of_tone & inside)
        small = (np.bincount(pieces.ravel()) < SMALLEST)[pieces] & (pieces > 0)
        around = scipy.ndimage.binary_dilation(small, np.ones((3, 3)))
        # A dot of the drawing's own has nothing else around it.
        reached = scipy.ndimage.maximum_filter(np.where(small, pieces, 0), 3)
        crumbs = np.unique(reached[around & inside & ~of_tone])
        at = scipy.ndimage.binary_dilation(np.isin(pieces, crumbs[crumbs > 0]), np.ones((3, 3)))
        soft[at] = 1 - tone
    return soft


def _smooth(values: NDArray, sigma: float) -> NDArray[np.float32]:
    return scipy.ndimage.gaussian_filter(values.astype(np.float32), sigma)


def _enlarged(soft: NDArray[np.float32], n: int) -> NDArray[np.float32]:
    from skimage.transform import resize

    return soft if n == SIDE else resize(soft, (n, n), order=1)
