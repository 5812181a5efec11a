"""Shades of one colour, where they are all there is.

Colours that differ little are shades of one thing, and are not told apart: shadows, gloss, cheeks.
But if nothing else were left of a flat drawing than the silhouette, these are, however little they
differ, as long as a person sees it:

1. a *figure* on its ground: it is neither along the contour, as shadows are, nor a highlight, which
   is to one side of the middle;
2. white beside grey;
3. *sides*, as of a box or an envelope: all are wide, and some differ by more than shadows do.

Where some sides are told apart, and there is nothing but sides, all that differ so are.

Other shades are left out, and told (``lost``). A pale line that goes all around paper, and pale
marks that lie free on white, are told from it in any flat drawing.
"""

from dataclasses import replace

import numpy as np
import scipy
from numpy.typing import NDArray

from iconstudio.algorithms.extremes import maximum_filter, minimum_filter
from iconstudio.algorithms.tones.linework import THICK
from iconstudio.algorithms.tones.regions import Mask, Regions, cielab, pale, regions

_SLIGHT, _LEAP = 2.0, 1.5
"""Least difference that is seen (CIEDE2000), and that of a channel of CIELAB at its edge."""
_FLOWING, _BROAD = 3.0, 0.02
"""As the first, where colours flow; and how much of the drawing a figure has there at least."""
_EDGE = 3.0
"""Half the width of an edge, in pixels, at most."""
_PLAIN, _PAINTS = 0.93, 6
"""How much of a flat drawing has one of how many colours."""
_AROUND, _FEW = 0.9, 3
"""How much of the contour has a pale line; how many more regions there may be with it."""
_FREE, _ONE = 0.75, 2.0
"""How much of their contour marks of one colour share with white, and by how much that varies."""
_PALEST, _PLAIN_TO_SEE = 4.0, 15.0
"""How much pale marks differ from white; what differs by more is told from it anyway."""
_BESIDE, _ALONG = 10, 0.25
"""Pixels beside the contour, and how much of the contour of shadows is there."""
_SIDES = 8.0
"""How much the lit side of a thing differs from the dark one; shadows and gloss differ by less."""
_LARGE = 0.1
"""How much of the drawing each of its sides has."""
_ASIDE = 0.12
"""How far from the middle, as part of the size, a highlight is."""


def shades(rgb: NDArray[np.uint8], inside: Mask, found: Regions, smallest: float) -> Regions:
    """Return the regions (k + 1,) of a drawing, of which some shades may be told apart."""
    alone = not (found.lengths[1:, 1:] > 0).any()
    flat = _is_flat(rgb, inside)
    if flat and not alone:
        closer = regions(cielab(rgb), inside, _SIDES, smallest, leap=_LEAP)
        if len(closer.areas) > len(found.areas) and _is_all_sides(closer):
            return closer
    if not (alone or _has_pale_rim(found) or (flat and found.white.any())):
        return found
    least, size = (_SLIGHT, smallest) if flat else (_FLOWING, _BROAD * inside.sum())
    closer = regions(cielab(rgb), inside, least, size, leap=_LEAP)
    more = len(closer.areas) - len(found.areas)
    if not more or (not flat and _flow_together(closer)):
        return found
    if pale_line(closer).any() and (alone or more <= _FEW):
        return closer
    if not alone:
        return _with_marks(found, closer) if flat else found
    with_white = closer.white.any() and not closer.white[1:].all()
    told = with_white or _sides(closer) or _figures(closer)
    return closer if told else found


def _flow_together(found: Regions) -> bool:
    """Whether regions go over into each other by degrees, as in a steep gradient, at no edge."""
    labels = np.where(found.labels > 0, found.labels, found.extended)
    meet = maximum_filter(labels, 3) != minimum_filter(labels, 3)
    away = scipy.ndimage.distance_transform_edt(~found.pure)[meet & (found.labels > 0)]
    return bool(away.size and away.mean() > _EDGE)


def _is_flat(rgb: NDArray[np.uint8], inside: Mask) -> bool:
    """Whether nearly all of a drawing has one of few colours."""
    packed = rgb[inside].astype(np.uint32) @ np.array([1 << 16, 1 << 8, 1], np.uint32)
    counts = np.sort(np.unique(packed, return_counts=True)[1])
    return bool(counts[-_PAINTS:].sum() > _PLAIN * len(packed))


def _has_pale_rim(found: Regions) -> bool:
    """Whether the outermost of all colours is that of paper, nearly all around."""
    outer = found.lengths[0]
    return bool(outer[pale(found.colours)].sum() > _AROUND * outer.sum())


def pale_line(found: Regions) -> Mask:
    """Return the region (k + 1,) that is a line nearly all around paper that is paler, if any."""
    outer = found.lengths[0]
    number = int(outer.argmax())
    line = np.zeros(len(outer), bool)
    if outer[number] < _AROUND * outer.sum() or found.widths[number] > THICK:
        return line
    paler = pale(found.colours) & (found.colours[:, 0] > found.colours[number, 0])
    paler[0] = False
    line[number] = found.lengths[number, paler].sum() > 0.5 * outer[number]
    return line


def _with_marks(found: Regions, closer: Regions) -> Regions:
    """Return the regions found, and those of the closer ones that lie free on white as marks do."""
    white = closer.white
    on_white = closer.lengths[:, white].sum(axis=1)
    # Lines of one colour, as of a grid, may end at what stands before them.
    difference = np.linalg.norm(closer.colours[:, None] - closer.colours, axis=2)
    alike = (difference < _ONE) & ~white & (on_white > 0.5 * closer.around)
    free = (alike @ on_white > _FREE * (alike @ closer.around)) & alike.diagonal()
    contrast = np.where(white, closer.contrasts, 0).max(axis=1)
    mark = free & (contrast > _PALEST) & (contrast < _PLAIN_TO_SEE)
    new = mark[closer.labels] & found.white[found.labels]
    if not new.any():
        return found
    count = len(found.areas)
    cores = np.where(new, np.where(closer.pure, closer.labels + count, 0), found.labels)
    number = np.unique(cores, return_inverse=True)[1].reshape(cores.shape)
    pure = found.pure & (~new | closer.pure)
    lab = np.concatenate([found.colours, closer.colours])[cores].astype(np.float32)
    return replace(regions(lab, found.labels > 0, 0, 0, number), pure=pure)


def _sides(found: Regions) -> bool:
    """Whether regions are wide, and differ by as much as the sides of a box do."""
    meeting = (found.lengths[1:, 1:] > 0).any(axis=1)
    wide = found.widths[1:][meeting] > THICK
    return bool(wide.all() and found.contrasts[1:, 1:].max() > _SIDES)


def _is_all_sides(found: Regions) -> bool:
    """Whether a drawing consists of some large sides, all of which are at the outside."""
    large = found.areas[1:] > _LARGE * found.areas[1:].sum()
    return bool((large & (found.widths[1:] > THICK) & (found.lengths[0, 1:] > 0)).all())


def _figures(found: Regions) -> bool:
    """Whether some regions are figures on others."""
    inside = found.labels > 0
    beside = inside & ~scipy.ndimage.binary_erosion(inside, iterations=_BESIDE)
    high, low = (f(found.labels, 3) for f in (maximum_filter, minimum_filter))
    contour = inside & (high != low)
    count = len(found.areas)
    whole = np.bincount(found.labels[contour], minlength=count)
    along = np.bincount(found.labels[contour & beside], minlength=count)
    figure = along < _ALONG * whole
    figure[0] = False
    if not figure.any():
        return False
    middles = [_middle(mask) for mask in (figure[found.labels], inside)]
    size = np.sqrt(inside.sum())
    aside = abs(np.subtract(*middles)) / size
    return bool(aside.min() < _ASIDE)


def _middle(mask: Mask) -> NDArray[np.float64]:
    """Return row and column of the middle of what a mask spans."""
    spans = [np.flatnonzero(mask.any(axis=axis)) for axis in (1, 0)]
    return np.array([(span[0] + span[-1]) / 2 for span in spans])
