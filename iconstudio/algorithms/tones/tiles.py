"""Tiles: the rounded squares, pages and banners that icons are put on.

A drawing stands free in its tile. What it holds tells the body of a thing from a tile:

1. a *frame*, as of a calendar or a window: what is in it is convex, and runs along much of its
   contour, with no more than a line between; a header on one side may be wider;
2. a *body with parts*, as of a floppy disk or a camera: several convex shapes lie in it, one of
   which holds another, along its sides, as labels do, or in colours of their own, as lenses do;
3. a *cut corner*, as of a floppy disk or a note.
"""

import numpy as np
import scipy

from iconstudio.algorithms.tones.linework import THICK
from iconstudio.algorithms.tones.regions import ALIKE, GREY, PALE, Mask, Regions, hull, pale

SHARP, _ROUNDED, _ROUND = 0.985, 0.9, 0.76
"""How much of its bounding box a rectangle fills, a rounded square, a circle."""
_DARK = 30.0
"""Lightness of what is dark."""
_DARKER = 15.0
"""Difference in lightness of two tones of one colour."""
_COLOURED = 30.0
"""Chroma of what is plainly coloured."""
_CONVEX = 0.95
"""How much of its convex hull a bare sign fills, such as a triangle or a disc."""
_ALONG, _LABELS = 0.5, 0.3
"""How much of a frame's contour runs along what is in it, and that of a body along its labels."""
_PARTS = 0.3
"""How much of a body its parts make, at least; the nodes of a diagram make less."""
_CUT = 0.002
"""How much of the bounding box a cut corner is at least."""
_GLOSS = 0.6
"""How much a gloss on a tile differs from it, at most, as part of what the drawing does."""


def rectangularity(found: Regions, some: Mask | None = None) -> float:
    """Return how much of its bounding box the silhouette fills, or some of the regions (k + 1,)."""
    some = np.arange(len(found.areas)) > 0 if some is None else some
    height, width = _box(some[found.labels])
    return float(found.areas[some].sum() / (height * width))


def tile(found: Regions) -> Mask:
    """Return the regions (k + 1,) that are a tile behind the drawing proper, and gloss on it."""
    on_it = np.zeros(len(found.areas), bool)
    outer = np.flatnonzero(found.lengths[0])
    if len(outer) == 1 and len(found.areas) > 2:
        number = int(outer[0])
        if _is_tile(found, number):
            on_it[number] = True
            on_it |= _gloss(found, number)
    return on_it


def is_sheet(found: Regions) -> bool:
    """Whether white goes without saying: a sharp rectangle with only black and grey on it."""
    return rectangularity(found) > SHARP and bool(_grey(found)[1:].all())


def _is_tile(found: Regions, number: int) -> bool:
    white, fill = found.white, rectangularity(found)
    sharp = fill > SHARP
    if white[number] and sharp:
        return True
    two_tones = (white | _alike(found, number))[1:].all()
    dark = found.colours[number, 0] < _DARK
    height, width = _box(found.labels > 0)
    square = max(height, width) < 1.1 * min(height, width)
    banner = sharp and dark and two_tones
    page = sharp and pale(found.colours)[number] and _is_darkened(found, number)
    if not (banner or page) and not (square and fill > (_ROUND if white[number] else _ROUNDED)):
        return False
    content = (found.labels > 0) & (found.labels != number)
    pieces = scipy.ndimage.find_objects(scipy.ndimage.label(content)[0])
    span = max(side.stop - side.start for piece in pieces for side in piece)
    share = content.sum() / found.areas[1:].sum()
    if share >= 0.6 or (span <= min(height, width) / 3 and not page):
        return False
    if white[number] or page:
        return True
    if _has_cut_corner(found) or _is_body_with_parts(found, number, content):
        return False
    return not _is_bare_sign(found, content) and not _is_body(found, number)


def _has_cut_corner(found: Regions) -> bool:
    """Whether one corner of the silhouette's bounding box is emptier than all others."""
    inside = found.labels > 0
    box = inside[scipy.ndimage.find_objects(inside.astype(np.int8))[0]]
    halves = np.array_split(~box, 2, axis=0)
    *_, second, first = sorted(
        corner.sum() for half in halves for corner in np.array_split(half, 2, axis=1)
    )
    return bool(first - second > _CUT * box.size)


def _is_body_with_parts(found: Regions, number: int, content: Mask) -> bool:
    """Whether a tile is a frame around what is on it, or a body of which that is the parts."""
    pieces, count = scipy.ndimage.label(content)
    told = ~_alike(found, number)[found.labels]
    holds = coloured = False
    for of_piece, window in enumerate(scipy.ndimage.find_objects(pieces), 1):
        piece = pieces[window] == of_piece
        if piece.sum() <= _CONVEX * hull(piece).sum():
            return False
        holds |= np.ptp(found.labels[window][piece]) > 0
        coloured |= len(np.unique(found.labels[window][piece & told[window]])) > 1
    inside = found.labels > 0
    contour = inside & ~scipy.ndimage.binary_erosion(inside)
    away = scipy.ndimage.distance_transform_edt(~content)[contour]
    along = float((away < THICK).mean())
    several = count > 1 and holds and content.sum() > _PARTS * inside.sum()
    return along > _ALONG or (several and (coloured or along > _LABELS))


def _is_bare_sign(found: Regions, content: Mask) -> bool:
    """Whether all that is on a tile is one convex shape: a button's, which says little alone."""
    if len(found.areas) > 3:
        return False
    return bool(content.sum() > _CONVEX * hull(content).sum())


def _is_body(found: Regions, number: int) -> bool:
    """Whether a tile is a shade, not too pale, of the darker tone of all that is on it.

    So drawings in two tones of one colour show the body of a thing: a picture, a speech bubble.
    """
    lightness = found.colours[:, 0]
    others = np.arange(len(lightness)) != number
    others[0] = False
    darker = lightness < lightness[number] - _DARKER
    alike = _same_hue(found, number) | _grey(found) & _grey(found)[number]
    others &= ~_alike(found, number)  # where it shows through
    return bool(lightness[number] < PALE and (darker & alike)[others].all())


def _is_darkened(found: Regions, number: int) -> bool:
    """Whether all that is on a tile is darker, but for what is of its colour."""
    darker = found.colours[:, 0] < found.colours[number, 0] - _DARKER
    return bool((darker | _alike(found, number))[1:].all())


def _alike(found: Regions, number: int) -> Mask:
    alike: Mask = np.linalg.norm(found.colours - found.colours[number], axis=1) < ALIKE
    return alike


def _grey(found: Regions) -> Mask:
    grey: Mask = np.hypot(*found.colours[:, 1:].T) < GREY
    return grey


def _same_hue(found: Regions, number: int) -> Mask:
    """Return the regions (k + 1,) whose hue is that of one of them."""
    a, b = found.colours[:, 1:].T
    chroma = np.hypot(a, b)
    same: Mask = a * a[number] + b * b[number] > 0.9 * chroma * chroma[number]
    return same


def _gloss(found: Regions, number: int) -> Mask:
    """Return the regions that are mere shades of a coloured tile, as gloss and shadows on it."""
    chroma = np.hypot(*found.colours[:, 1:].T)
    coloured = (chroma > 0.3 * chroma[number]) & (chroma[number] > _COLOURED)
    on_it = found.lengths[number] > 0.9 * found.around
    contrast = np.where(on_it, found.contrasts[number], 0)
    contrast[0] = 0
    gloss: Mask = _same_hue(found, number) & coloured & on_it & (contrast < _GLOSS * contrast.max())
    return gloss


def _box(inside: Mask) -> tuple[int, int]:
    """Return height and width of what is inside."""
    rows, columns = np.flatnonzero(inside.any(axis=1)), np.flatnonzero(inside.any(axis=0))
    return int(rows[-1] - rows[0]) + 1, int(columns[-1] - columns[0]) + 1
