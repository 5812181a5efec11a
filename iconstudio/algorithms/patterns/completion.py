"""What upper layers hide of a layer, recovered (section 3), where in the paper a person does it.

A contour of the layer comes to an end where it goes beneath an upper one, and another begins where
one comes out again. Ends and beginnings are joined by Hermite curves, all of them at the least
bending: so bars go on straight beneath a disc, a cross stays one, a disc that is covered in part is
round, and a line of which only one end is seen ends rounded beneath.
Points are complex numbers, x + iy, in pixels; the centre of the first pixel is 0.
"""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray
from scipy import ndimage
from scipy.sparse import coo_array
from scipy.sparse.csgraph import min_weight_full_bipartite_matching
from scipy.spatial import cKDTree
from skimage.draw import polygon
from skimage.measure import find_contours

Mask = NDArray[np.float32]
"""(h, w), how much of each pixel is covered, from 0 to 1."""
Bitmap = NDArray[np.bool_]
Points = NDArray[np.complex128]

_EIGHT = np.ones((3, 3), np.bool_)
_BESIDE = 1.6
"""Pixels between a contour and what hides its layer, at most."""
_GAP = 3
"""A contour that is seen for so few pixels is not."""
_BLUNTED, _SIDE = 2, 14
"""Pixels of a contour, where it comes to an end, that are blunted, and that tell its direction."""
_STRAIGHT = 0.2
"""Pixels by which those stray from a line, if they are straight."""
_APART = 1e-3
"""What a pixel between two ends costs, beside the squares of the angles in radians, ..."""
_IN_SIGHT = 8.0
"""... and what it costs if all of the curve between them lies where it would be seen."""
_NEAREST = 16
"""So many ends are looked at, from another one."""
_MOST = 500
"""Ends beneath what is connected, of which nothing is recovered if there are more: it is a mesh."""
_STEPS = 24
"""Points of a curve."""


class End(NamedTuple):
    """Where a contour comes to an end, or (n,) several do."""

    point: Points
    way: Points
    """The direction there, along the contour, of length 1."""


@dataclass(frozen=True, slots=True, eq=False)
class _Hidden:
    """A part of a contour that runs along what hides the layer."""

    region: int
    """The number of the connected region that hides it."""
    arriving: End
    leaving: End
    along: Points
    """From the first to the last of its points."""


def completed(own: Mask, hiding: Bitmap, ends: bool = True) -> Mask:
    """Return all of a layer.

    Parameters
    ----------
    own
        What is seen of it.
    hiding
        (h, w), where what may hide it is seen.
    ends
        Whether some of it may end beneath; else only what comes out again is recovered.
    """
    if not hiding.any():
        return own
    regions, _ = ndimage.label(hiding, _EIGHT)
    away, nearest = ndimage.distance_transform_edt(~hiding, return_indices=True)
    covered = away < _BESIDE
    recovered = np.zeros(own.shape, np.bool_)
    parts: list[_Hidden] = []
    for outline in outlines_of(own):
        beside = _sampled(covered, outline)
        if ends and beside.all() and _is_hole(outline, own):
            recovered[_inside(outline, own.shape)] = True
        for first, last in _runs(beside):
            middle = outline.take((first + last) // 2, mode="wrap")
            row, column = _pixel(middle, own.shape)
            region = int(regions[tuple(nearest[:, row, column])])
            parts.append(_part(outline, first, last, region, own.shape))
    for patch in _patches(parts, covered, ends):
        recovered[_inside(patch, own.shape)] = True
    return _united(own, recovered & covered, covered)


def _united(own: Mask, recovered: Bitmap, covered: Bitmap) -> Mask:
    """Return a layer with what is recovered, without gaps between them, nor any that are hidden."""
    edge = ndimage.binary_dilation(recovered, _EIGHT) & covered & (own > 0)
    whole = recovered | (own > 0.5) | (edge & ndimage.binary_dilation(own > 0.5, _EIGHT))
    gaps, count = ndimage.label(~whole)
    if count:
        hidden = ndimage.minimum(covered, gaps, np.arange(count + 1)).astype(np.bool_)
        hidden[0] = False
        whole |= hidden[gaps]
    return np.where(whole & covered, np.float32(1), own)


# -- where contours come to an end -----------------------------------------------------------------


def outlines_of(mask: Mask) -> list[Points]:
    """Return the contours of a mask, closed, by points a pixel apart."""
    return [
        _even((contour[:, 1] - 1) + 1j * (contour[:, 0] - 1))
        for contour in find_contours(np.pad(mask, 1), 0.5)
    ]


def _even(outline: Points) -> Points:
    """Return a closed outline, whose last point is its first, by points a pixel apart."""
    along = np.concatenate([[0], np.cumsum(abs(np.diff(outline)))])
    count = max(8, round(along[-1]))
    even: Points = np.interp(np.arange(count) * along[-1] / count, along, outline)
    return even


def _pixel(point: complex, shape: tuple[int, ...]) -> tuple[int, int]:
    return (
        min(max(round(point.imag), 0), shape[0] - 1),
        min(max(round(point.real), 0), shape[1] - 1),
    )


def _sampled(bitmap: Bitmap, points: Points) -> Bitmap:
    """Return what a bitmap says at points; beyond its border, what it says there."""
    rows = np.clip(np.rint(points.imag).astype(int), 0, bitmap.shape[0] - 1)
    columns = np.clip(np.rint(points.real).astype(int), 0, bitmap.shape[1] - 1)
    sampled: Bitmap = bitmap[rows, columns]
    return sampled


def _is_hole(outline: Points, own: Mask) -> bool:
    """Whether a closed outline runs around what is not of a layer."""
    inside = own[_inside(outline, own.shape)]
    return bool(inside.size and inside.mean() < 0.5)


def _runs(beside: Bitmap) -> Iterator[tuple[int, int]]:
    """Give the first and the last of the points of a closed row that are marked, run by run."""
    count = len(beside)
    if beside.all() or not beside.any():
        return
    start = int(np.flatnonzero(~beside)[0])
    marked = np.append(np.roll(beside, -start), False)
    edges = np.flatnonzero(np.diff(marked.astype(np.int8), prepend=0))
    runs = [[int(first), int(stop)] for first, stop in edges.reshape(-1, 2)]
    joined = runs[:1]
    for first, stop in runs[1:]:
        if first - joined[-1][1] <= _GAP:
            joined[-1][1] = stop
        else:
            joined.append([first, stop])
    if len(joined) > 1 and joined[0][0] + count - joined[-1][1] <= _GAP:
        joined[0][0] = joined.pop()[0] - count
    for first, stop in joined:
        if stop - first + _GAP < count:
            yield first + start, stop - 1 + start


def _part(outline: Points, first: int, last: int, region: int, shape: tuple[int, ...]) -> _Hidden:
    seen = len(outline) - (last - first + 1)
    arriving = end_of(outline.take(range(first, first - min(seen, _SIDE) - 1, -1), mode="wrap"))
    leaving = end_of(outline.take(range(last, last + min(seen, _SIDE) + 1), mode="wrap"))
    along = outline.take(range(first, last + 1), mode="wrap")
    return _Hidden(region, End(arriving.point, -arriving.way), leaving, along)


def end_of(points: Points) -> End:
    """Return where a contour begins, which these points tell, from there on."""
    skipped = min(_BLUNTED, max(0, len(points) - 3))
    s, side = np.arange(skipped, len(points)), points[skipped:]
    if len(s) < 2:
        return End(points[0], np.ones((), complex))
    for degree in (1, 2):
        powers = np.vander(s, degree + 1).astype(float)
        found = np.linalg.lstsq(powers, side, rcond=None)[0]
        if len(s) < 8 or abs(powers @ found - side).max() < _STRAIGHT:
            break
    way = found[-2] or np.ones((), complex)
    return End(found[-1], way / np.abs(way))


# -- how they go on --------------------------------------------------------------------------------


def _patches(parts: Sequence[_Hidden], covered: Bitmap, ends: bool) -> Iterator[Points]:
    """Give closed outlines around what is hidden between the ends of contours."""
    regions: dict[int, list[_Hidden]] = {}
    for one in parts:
        regions.setdefault(one.region, []).append(one)
    for own in regions.values():
        if len(own) > _MOST:
            continue
        joined = _joined(own, covered)
        left = dict.fromkeys(range(len(own)))
        while left:
            at = next(iter(left))
            outline: list[Points] = []
            while at in left:
                del left[at]
                to = int(joined[at])
                outline += [_curve(own[at].arriving, own[to].leaving), own[to].along[::-1]]
                at = to
            if ends or len(outline) > 2:  # it takes two of either where it comes out again
                yield np.concatenate(outline)


def _joined(own: Sequence[_Hidden], covered: Bitmap) -> NDArray[np.intp]:
    """Return at which of n the contour leaves that arrives at each: one of those near by."""
    leaving = End(*map(np.array, zip(*(one.leaving for one in own), strict=True)))
    points = np.stack([leaving.point.real, leaving.point.imag], axis=1)
    tree, count = cKDTree(points), len(own)
    rows, columns, costs = [], [], []
    for row, one in enumerate(own):
        at = one.arriving.point.real, one.arriving.point.imag
        near = np.union1d(tree.query(at, min(count, _NEAREST))[1], row)
        rows.append(np.full(len(near), row))
        columns.append(near)
        costs.append(_costs(one.arriving, End(leaving.point[near], leaving.way[near]), covered))
    graph = coo_array(
        (np.concatenate(costs) + _APART, (np.concatenate(rows), np.concatenate(columns))),
        (count, count),
    )
    return np.asarray(min_weight_full_bipartite_matching(graph.tocsr())[1])


def _costs(arriving: End, leaving: End, covered: Bitmap) -> NDArray[np.float64]:
    """Return how unlikely it is that the contour that arrives at an end leaves at others (n,).

    That is the energy that it takes to bend a rod of any length so, but for a factor.
    """
    turn, end = _turns(arriving, leaving)
    chord = np.abs(leaving.point - arriving.point)
    seen = 1 - _sampled(covered, _curve(arriving, leaving)).mean(axis=0)
    costs: NDArray[np.float64] = (
        turn**2 - turn * end + end**2 + _APART * chord + _IN_SIGHT * seen**2
    )
    return costs


def _turns(arriving: End, leaving: End) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Return by how many radians contours turn to the chord, and from it."""
    chord = leaving.point - arriving.point
    whole = np.angle(leaving.way * np.conj(arriving.way)) / 2
    none = np.abs(chord) < 1
    turn = np.where(none, whole, np.angle(chord * np.conj(arriving.way)))
    return turn, np.where(none, whole, np.angle(leaving.way * np.conj(chord)))


def _curve(arriving: End, leaving: End) -> Points:
    """Return the Hermite curves (t, ...) between ends; nearly circles where there are such.

    Their speeds there are those of the cubic that is nearest to a circle.
    """
    chord = leaving.point - arriving.point
    turn, end = _turns(arriving, leaving)
    bend = np.where(turn * end > 0, np.abs(turn + end), 0)
    speed = np.abs(chord) / np.cos(np.minimum(bend, np.pi) / 4) ** 2
    t = np.linspace(0, 1, _STEPS).reshape(-1, *(1,) * np.ndim(chord))
    curve: Points = (
        (2 * t**3 - 3 * t**2 + 1) * arriving.point
        + (t**3 - 2 * t**2 + t) * speed * arriving.way
        + (3 * t**2 - 2 * t**3) * leaving.point
        + (t**3 - t**2) * speed * leaving.way
    )
    return curve


def _inside(outline: Points, shape: tuple[int, ...]) -> tuple[NDArray[np.intp], NDArray[np.intp]]:
    """Return rows and columns of the pixels whose centres a closed outline encloses."""
    rows, columns = polygon(outline.imag, outline.real, shape)
    return rows, columns
