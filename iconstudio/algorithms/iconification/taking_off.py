"""What is meant by an area that is marked, roughly, to be taken off an icon (section 4.2)."""

import numpy as np
import scipy

from iconstudio.algorithms.raster import Bitmap
from iconstudio.model import CANVAS

_ROUGH, _STUB = 8, 32
"""Canvas units by which an outline may miss the end of what is removed, and the width of the widest
stubs that this leaves."""
_EIGHT = np.ones((3, 3), dtype=bool)


def meant(ink: Bitmap, marked: Bitmap) -> Bitmap:
    """Return what is marked without the rim of wider ink that a rough mark cuts into; all (m, m).

    Where a mark covers a handle and a little of the wall beside it, the wall stays. What has no
    more than a rim marked, has it marked on purpose.
    """
    unit = len(ink) / CANVAS
    radius = _ROUGH / 2 * unit
    hit, beyond = ink & marked, ink & ~marked
    core = _opened(hit, radius)
    areas, _ = scipy.ndimage.label(marked, _EIGHT)
    rough = np.isin(areas, np.unique(areas[core])) & marked
    rims, count = scipy.ndimage.label(_opened(ink, radius) & hit & ~core & rough, _EIGHT)
    beside = np.zeros(count + 1, dtype=bool)
    beside[rims[scipy.ndimage.binary_dilation(beyond, _EIGHT)]] = True
    # Smaller ones are corners of where a stroke is cut across.
    beside &= np.bincount(rims.ravel(), minlength=count + 1) > radius**2
    beside[0] = False
    rim = beside[rims]
    if not rim.any():
        return marked
    # The wall goes on where the handle joined it.
    whole = ~_opened(~(beyond | rim), 2 * _STUB * unit)
    depth = scipy.ndimage.distance_transform_edt(~beyond)
    stays: Bitmap = rim | (whole & hit & rough & (depth <= np.median(depth[rim]) * 2))
    found: Bitmap = marked & ~stays
    return found


def taken_off(ink: Bitmap, filled: Bitmap, removed: Bitmap) -> Bitmap:
    """Return what is removed, and what a rough outline leaves of it; all (m, m).

    If most of a hole is removed, as of a handle, so is its rest, and the stubs beside that; and so
    are loose ends. ``filled`` is the icon's ink with its holes filled.
    """
    if not removed.any():
        return removed
    unit = len(ink) / CANVAS
    missed = scipy.ndimage.distance_transform_edt(~removed)
    pieces, count = scipy.ndimage.label(ink & ~removed, _EIGHT)
    farthest = scipy.ndimage.maximum(missed, pieces, np.arange(count + 1))
    loose = np.array(farthest) < _ROUGH * unit
    loose[0] = False
    removed = removed | loose[pieces]
    holes, _ = scipy.ndimage.label(filled & ~ink)
    sizes = np.bincount(holes.ravel())
    mostly = 2 * np.bincount(holes[removed], minlength=len(sizes)) > sizes
    mostly[0] = False
    gone: Bitmap = removed | mostly[holes]
    rest = gone & ~removed
    if not rest.any():
        return gone
    left = filled & ~gone
    away = [scipy.ndimage.distance_transform_edt(~mask) for mask in (removed, rest)]
    depth = scipy.ndimage.distance_transform_edt(np.pad(left, 1))[1:-1, 1:-1]
    opened = _opened(left, min(_STUB * unit, 0.75 * depth.max()))
    near = (away[0] < _ROUGH * unit) & (away[1] < _STUB * unit)
    pieces, _ = scipy.ndimage.label(left & ~opened & near)
    stubs = np.unique(pieces[scipy.ndimage.binary_dilation(removed)])
    gone |= np.isin(pieces, stubs[stubs > 0])
    return gone


def _opened(shape: Bitmap, radius: float) -> Bitmap:
    """Return where discs of that radius fit into a shape; beyond the canvas there is none."""
    depth = scipy.ndimage.distance_transform_edt(np.pad(shape, 1))[1:-1, 1:-1]
    opened: Bitmap = scipy.ndimage.distance_transform_edt(depth <= radius) <= radius
    return opened & shape
