"""White on colour is paper; where it makes a part of the silhouette, within an outline.

1. White that is all around a piece of the drawing, as of an egg or a ghost, is the piece's body,
   and ink. If it makes a sharp rectangle, it is a *page*, and paper.
2. Other white that reaches the outside is paper. A line of ink goes along the contour there (a
   cloud before the sun, a panda's head, the white half of a flag, the snowy tip of a mountain,
   the sole of a shoe),
   alike along all of one paint; not along a narrow band, which sets off what is beside it, nor
   along a *bite*. White in a line of another paint that leaves a narrow gap all along it, as in the
   wheels of a bicycle, needs no other outline, and is no body; nor is other white in the lines.
3. White within the drawing is paper if it is on what reaches the outside (eyes in a face), else it
   differs from what is around it, as all colours do (teeth in a mouth). What lies upon it does not
   count, nor is a pale line around it one of what is darker (the header of a calendar).

A *bite* is pure white, as pages are, and hides a good part of a colour, as in a crescent made of a
disc and a white one, or a bitten apple, or divides it, as the cross of a flag does. What a colour
is behind the white is told by its convex hull.
"""

from typing import NamedTuple

import numpy as np
import scipy
from numpy.typing import NDArray

from iconstudio.algorithms.tones.linework import THICK
from iconstudio.algorithms.tones.regions import ALIKE, Mask, Regions, hull, sums
from iconstudio.algorithms.tones.shades import pale_line
from iconstudio.algorithms.tones.tiles import SHARP, rectangularity

_AROUND = 0.9
"""How much of the contour of a white body is white."""
_OUTSIDE, _COMPACT, _ONE_SIDE = 0.45, 6.0, 0.6
"""How much of its contour a tip has on the outside; how large it is, in squares as wide; and how
much of the drawing's contour a band has that is on one side of it, as the sole of a shoe."""
_BAND = 28.0
"""Width in pixels from which white that is of one paint with an outlined part is outlined, too."""
_PURE = 99.0
"""Lightness from which white is that of a page."""
_STEP = 2
"""Of so many rows and columns of pixels one is looked at for hulls."""
_HIDING, _BITING = 0.3, 0.1
"""How much of a bite lies where the colour behind it was, at least; if it is convex, as knives and
discs are, and clouds are not."""
_CONVEX = 0.98
"""How much of its convex hull a convex shape fills."""
_WITHIN = 0.9
"""How much of its contour a shape that is drawn on the white shares with it."""
_GAP, _ALONG = 12.0, 0.6
"""Width in pixels of the widest gap between white and the line that it lies in; how much of its
contour on the outside runs along one."""
_PALE = 55.0
"""Lightness of the darkest line that is a pale outline."""
_MARKED = 1.5
"""How much larger than its paper a page with marks is, at most."""
_WHOLE = 0.95
"""How much of its convex hull a shape fills that a band of white divides, with that band."""


class Whites(NamedTuple):
    """What the white regions of a drawing are, (k + 1,) each."""

    paper: Mask
    outlined: Mask
    """Those that are paper, but a part of the silhouette."""
    page: Mask
    """Those that are paper, and behind the drawing."""


def whites(found: Regions) -> Whites:
    """Return which white regions are paper; of the others it depends on what is around them."""
    white, outer = found.white & ~pale_line(found), found.lengths[0]
    none = np.zeros_like(white)
    total = found.areas[1:].sum()
    if found.areas[1:][~white[1:]].sum() < 0.05 * total:
        return Whites(none, none, none)
    sharp = rectangularity(found) > SHARP
    page = white & (outer > 0.75 * outer.sum())
    if page.any() and sharp:
        return Whites(white & ((outer > 0) | _on_ink(found)), none, page)
    at_outside = white & (outer > 0)
    framed = at_outside & _framed(found)
    at_outside &= ~framed
    widths = _widths(found, at_outside & (found.widths <= THICK))
    wide = (widths > THICK) | (outer > _AROUND * found.around)
    body = at_outside & wide & _is_white_around(found)
    for number in np.flatnonzero(body & (outer <= _AROUND * found.around)):
        body[number] = not _is_rim(found, int(number))
    # A narrow band sets other colours off.
    compact = (found.areas < _COMPACT * found.widths**2) & (found.widths > _BAND / 2)
    on_one_side = (found.widths > _BAND) & (outer < _ONE_SIDE * outer.sum())
    tip = (outer > _OUTSIDE * found.around) & (compact | on_one_side)
    part = at_outside & ~body & ((wide & (found.areas > 0.05 * total)) | tip)
    for number in np.flatnonzero(part):
        part[number] = not _is_bite(found, int(number), sharp)
    alike = np.linalg.norm(found.colours[:, None] - found.colours, axis=2) < ALIKE
    outlined = at_outside & ~body & (found.widths > _BAND) & (part & alike & wide).any(axis=1)
    paper = white & ~body & (at_outside | framed | _on_ink(found))
    return Whites(paper, part | outlined, none)


def _widths(found: Regions, some: Mask) -> NDArray[np.float64]:
    """Return the mean widths (k + 1,), of some without the marks upon them, as days on a page."""
    widths = found.widths.copy()
    for number in np.flatnonzero(some):
        whole = scipy.ndimage.binary_fill_holes(found.labels == number) & (found.labels > 0)
        # What is mostly hole is a rim around something.
        if found.areas[number] < whole.sum() < found.areas[number] * _MARKED:
            away = scipy.ndimage.distance_transform_edt(np.pad(whole, 1))
            widths[number] = 4 * away.sum() / whole.sum()
    return widths


def beside_outline(found: Regions, paper: Mask) -> Mask:
    """Return the pairs (k + 1, k + 1) of a pale line around white paper and what is darker in it.

    As with the header of a calendar whose page has a grey line around it, that line is no outline
    of the darker part.
    """
    lightness = found.colours[:, 0]
    line = (found.widths < _BAND) & (lightness > _PALE) & ~paper
    line &= found.lengths[:, paper].any(axis=1)
    line &= found.lengths[0] > 0.5 * found.lengths[0].sum()
    darker: Mask = line[:, None] & (lightness < lightness[:, None])
    darker[:, 0] = False
    return darker | darker.T


def _framed(found: Regions) -> Mask:
    """Return the white regions (k + 1,) in lines that leave a gap, and others in the same lines."""
    around = found.labels == 0
    paint = ~around & ~found.white[found.labels]
    framed: Mask = found.white & (_along_gaps(found, around, paint) > _ALONG * found.lengths[0])
    if framed.any():
        within = scipy.ndimage.binary_fill_holes(paint)
        enclosed = np.bincount(found.labels[within], minlength=len(framed))
        framed |= found.white & (enclosed > _WITHIN * found.areas)
    return framed


def _along_gaps(found: Regions, around: Mask, paint: Mask) -> NDArray[np.float64]:
    """Return at how many pixel sides (k + 1,) regions meet a gap between them and a paint."""
    along = np.zeros(len(found.areas))
    away, (rows, columns) = scipy.ndimage.distance_transform_edt(~paint, return_indices=True)
    here = np.indices(paint.shape)
    # A rim of white is as near to what it is the rim of, but there is white between.
    middle = (here[0] + rows) // 2, (here[1] + columns) // 2
    gap = around & (away <= _GAP) & around[middle]
    for one, other in ((np.s_[1:], np.s_[:-1]), (np.s_[:, 1:], np.s_[:, :-1])):
        for at, beside in ((one, other), (other, one)):
            along += np.bincount(found.labels[beside][gap[at]], minlength=len(along))
    return along


def _is_white_around(found: Regions) -> Mask:
    """Return the regions (k + 1,) whose piece of the drawing is white nearly all around."""
    piece, outer = found.pieces(), found.lengths[0]
    of_white = sums(piece, np.where(found.white, outer, 0))
    around: Mask = (of_white > _AROUND * sums(piece, outer))[piece]
    return around


def _is_rim(found: Regions, number: int) -> bool:
    """Whether a white region is on the outside mostly as a narrow line around other colours.

    Such are the seams between facets, which go over into facets that are white.
    """
    mask = found.labels == number
    away = scipy.ndimage.distance_transform_edt(np.pad(mask, 1))[1:-1, 1:-1]
    thick = scipy.ndimage.distance_transform_edt(away <= _BAND / 2) <= _BAND / 2 + 1
    edge = mask & scipy.ndimage.binary_dilation(found.labels == 0)
    return bool((edge & thick).sum() < 0.5 * edge.sum())


def _on_ink(found: Regions) -> Mask:
    """Return the regions (k + 1,) that are mostly on what reaches the outside, which is ink.

    What lies upon a region, as the days of a calendar do, does not count.
    """
    reaching = found.lengths[0] > 0
    beside = found.beside
    on_ink: Mask = beside[:, reaching].sum(axis=1) > 0.5 * beside.sum(axis=1)
    return on_ink


def _is_bite(found: Regions, number: int, sharp: bool) -> bool:
    """Whether a white region takes a bite out of a colour, and nothing else is drawn on it.

    If what the two make together is a ``sharp`` rectangle, as a flag is, it must divide the colour.
    """
    if found.colours[number, 0] < _PURE:
        return False
    meeting = ~found.white & (found.lengths[number] > 0)
    meeting[0] = False
    on_it = meeting & (found.lengths[number] > _WITHIN * found.around)
    behind = np.flatnonzero(meeting & ~on_it)
    alike = np.linalg.norm(found.colours[:, None] - found.colours, axis=2) < ALIKE
    if not alike[on_it][:, behind].any(axis=1).all():
        return False
    labels = found.labels[::_STEP, ::_STEP]
    white = labels == number
    filled = white | on_it[labels]
    least = _BITING if filled.sum() > _CONVEX * hull(filled).sum() else _HIDING
    for one in behind:
        if not sharp and (hull(labels == one) & white).sum() > least * white.sum():
            return True
        parts = behind[alike[one, behind]]
        if len(parts) > 1:
            around = hull(np.isin(labels, parts))
            whole = np.isin(labels[around], [*parts, number]).mean() > _WHOLE
            if whole and (around & white).sum() > _HIDING * white.sum():
                return True
    return False
