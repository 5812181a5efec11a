"""Parts are taken off an outline, which is closed where they were (section 4.2).

An addition to the paper, where a cut has only other icons, or none, to put in their place. A part
ends where the outline turns inwards sharply (the minima rule of Hoffman and Richards, *Parts of
recognition*, 1984), whether the mark around it ends there or a little before or behind; of such
places, those are taken between which the outline goes on best. All else is the outline itself.

Points are complex numbers, x + iy, in pixels of which ``FINE`` make a canvas unit.
"""

import itertools
from collections.abc import Iterator
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray
from scipy.ndimage import maximum_filter1d

from iconstudio.algorithms.areas import Area, filled, grown, hold
from iconstudio.algorithms.flattening import flattened
from iconstudio.algorithms.raster import Bitmap, fill_polygon
from iconstudio.algorithms.tidying.sides import angle
from iconstudio.algorithms.tracing.bezier import Points
from iconstudio.algorithms.tracing.pieces import Piece
from iconstudio.algorithms.tracing.source_curve import SourceCurve, points_on
from iconstudio.model import CANVAS, Point, Polygon
from iconstudio.model.path import Contour, Path, Segment

FINE = 4
_OFF = 24 * FINE
"""How far beyond the mark a part may end."""
_SIDE = 4 * FINE
"""So much of an outline, to each side, tells how sharply it turns, or twice as much."""
_ROUGH = 8 * FINE
"""By how much a mark may miss what is meant; nor is what is left between marked parts longer."""
_ALL = 0.98
"""So much of a hole's rim lies within ink at least; there are soft spots where both touch."""
_SHARP = np.radians(25)
"""By how much it turns at a corner, at least."""
_MOST = 0.6
"""So much of what is marked goes with a part at least; the rest is the rim of what stays."""
_BENT, _WAVY = np.radians(75), np.radians(30)
"""By how much a curve may turn from its chord; and at one end at least if that makes it an S."""
_STRAIGHT = np.radians(5)
"""What turns by less goes straight on."""
_CORNER = np.radians(120)
"""Sides that turn by more have no corner near where they meet."""
_CAP = 32 * FINE
"""The widest end of a stroke that is closed straight across."""
_ASTRAY = np.radians(60)
"""Parts end at a corner, unless the outline goes on better by so much from where the mark ends."""
_TIGHT = 6 * FINE
"""A rounded corner begins and ends no further from its middle."""
_NEXT = 1.5
"""Pixels between the places that are tried, and a little."""
_STEADY = np.radians(8)
"""Where the outline turns by less, it is no longer in such a corner."""
_TRIED = 12
"""So many places, of those next to the end of the mark, are tried."""
_BESIDE, _SAMPLES = 4 * FINE, 9
"""What is no further from the edge of the mark runs along it, and so many points tell."""


class _Run(NamedTuple):
    """What of a contour is marked, from one place along it to another, in pixels."""

    first: float
    last: float
    """May be beyond the end of the contour, and the beginning of the next round."""


class _Joint(NamedTuple):
    """How a contour goes on where a part was."""

    first: float
    last: float
    """The places along the contour between which it does."""
    pieces: list[Piece]
    cost: float


class _Marked(NamedTuple):
    """What is marked."""

    mask: Bitmap
    """(FINE * CANVAS, FINE * CANVAS)"""
    near: Area
    """It, and what a rough mark may miss, in canvas units."""

    @classmethod
    def by(cls, mark: Polygon) -> "_Marked":
        """Return what a polygon in canvas units marks."""
        near = grown(filled([np.array(mark.vertices)]), _ROUGH / FINE)
        return cls(fill_polygon(mark, FINE * CANVAS), near)

    def covers(self, curve: SourceCurve, hole: bool) -> bool:
        """Whether it is all of a contour, but for what is near, or the greater part of a hole."""
        points = np.stack([curve.points.real, curve.points.imag], axis=1) / FINE
        if hold(self.near, points).all():
            return True
        whole = fill_polygon(Polygon.of(points.tolist()), len(self.mask))
        return hole and bool(2 * (whole & self.mask).sum() > whole.sum())


def detached(outline: Path, mark: Polygon) -> Path | None:
    """Return an outline without what a polygon marks; None if nothing closes it well.

    ``outline`` is in canvas units and filled by the nonzero rule, its holes run the other way.
    What is wholly marked goes; of what is marked in part, the part that sticks out.
    """
    marked = _Marked.by(mark)
    found: list[Contour] = []
    for contour in outline.contours:
        rest = _without(contour, marked)
        if rest is None:
            return None
        found += rest
    return _without_loose_holes(found)


def _without(contour: Contour, marked: _Marked) -> tuple[Contour, ...] | None:
    """Return what is left of a contour, if anything is; None if it does not close.

    What is marked but for a little goes, and a hole if most of it is, as that of a handle.
    """
    curve = SourceCurve.of(contour, 1 / FINE)
    runs = _runs(curve, marked.mask)
    if not runs:
        return (contour,)
    hole = Path((contour,)).area < 0
    if runs[0].last - runs[0].first >= curve.length or marked.covers(curve, hole):
        return ()
    joints = _apart(curve, runs, marked.mask)
    if not joints:
        return None if joints is None else (contour,)
    ends = [one.first for one in joints[1:]] + [joints[0].first + curve.length]
    pieces: list[Piece] = []
    for joint, end in zip(joints, ends, strict=True):
        pieces += [*joint.pieces, *curve.part(joint.last, end)]
    return (_contour(pieces),)


def _apart(curve: SourceCurve, runs: list[_Run], mask: Bitmap) -> list[_Joint] | None:
    """Return how a contour goes on without its runs, but for shallow ones; None if it does not.

    Runs that end where others begin are one.
    """
    joints: list[_Joint] = []
    taken: list[_Run] = []
    for run in runs:
        joint = min(_joints(curve, run, mask), key=lambda one: one.cost, default=None)
        if joint is not None:
            joints.append(joint)
            taken.append(run)
        elif not _is_shallow(curve, run):
            return None
    for here, joint in enumerate(joints):
        turn = curve.length if here == len(joints) - 1 else 0.0
        other = (here + 1) % len(joints)
        if joint.last > joints[other].first + turn:
            if here == other:
                return None
            both = _Run(taken[here].first - turn, taken[other].last)
            others = [one for one in taken if one not in (taken[here], taken[other])]
            return _apart(curve, sorted([*others, both]), mask)
    return joints


def _without_loose_holes(contours: list[Contour]) -> Path | None:
    """Return the path of contours without holes in what is gone; None if the outline cuts any."""
    rows = [points for points, _ in flattened(Path(tuple(contours)))]
    holes = [Path((one,)).area < 0 for one in contours]
    pieces = filled(row for row, hole in zip(rows, holes, strict=True) if not hole)
    left = []
    for contour, row, hole in zip(contours, rows, holes, strict=True):
        within = hold(pieces, row).mean() if hole else 1.0
        if within > _ALL:
            left.append(contour)
        elif within > 0.5:
            return None
    return Path(tuple(left))


def _runs(curve: SourceCurve, mask: Bitmap) -> list[_Run]:
    """Return what is marked of a contour; all of it is one run around it."""
    inside = _hits(curve.points[:-1], mask)
    if not inside.any():
        return []
    around = _Run(0.0, curve.length)
    if inside.all():
        return [around]
    begins = np.flatnonzero(inside & ~np.roll(inside, 1))
    ends = np.flatnonzero(inside & ~np.roll(inside, -1))
    if ends[0] < begins[0]:
        ends = np.roll(ends, -1)
    runs: list[_Run] = []
    for begin, end in zip(begins, ends, strict=True):
        turn = curve.length if end < begin else 0.0
        run = _Run(float(curve.along[begin]), float(curve.along[end]) + turn)
        if runs and run.first - runs[-1].last < _ROUGH:
            run = _Run(runs.pop().first, run.last)
        runs.append(run)
    if runs[0].first + curve.length - runs[-1].last < _ROUGH:
        if len(runs) == 1:
            return [around]
        last = runs.pop()
        runs[0] = _Run(last.first - curve.length, runs[0].last)
    return runs


def _is_shallow(curve: SourceCurve, run: _Run) -> bool:
    """Whether a run is no more than the rim of what stays."""
    row = curve.at(np.linspace(run.first, run.last, 4 * _SAMPLES))
    way = (row[-1] - row[0]) / max(abs(row[-1] - row[0]), 1)
    return bool(abs(((row - row[0]) * way.conjugate()).imag).max() < _ROUGH)


def _along_edge(pieces: list[Piece], mask: Bitmap, side: float) -> bool:
    """Whether pieces run along the edge of what is marked, on their left if ``side`` is 1."""
    for piece in pieces:
        points = points_on(piece, np.linspace(0.1, 0.9, _SAMPLES))
        aside = side * 1j * (piece[-1] - piece[0]) / abs(piece[-1] - piece[0]) * _BESIDE
        if _hits(points + aside, mask).any() or not _hits(points - aside, mask).all():
            return False
    return True


def _hits(points: Points, mask: Bitmap) -> NDArray[np.bool_]:
    column, row = (np.clip(one.astype(int), 0, len(mask) - 1) for one in (points.real, points.imag))
    hit: NDArray[np.bool_] = mask[row, column]
    return hit


def _joints(curve: SourceCurve, run: _Run, mask: Bitmap) -> Iterator[_Joint]:
    """Yield the ways in which a contour could go on without what is marked of it."""
    bulge = _bulge(curve, run)
    firsts, lasts = _places(curve, run, np.sign(bulge))
    for first, last in itertools.product(firsts, lasts):
        within = run.last - curve.length < first < last < run.first + curve.length
        if within and _bulge(curve, _Run(first, last)) * np.sign(bulge) >= _MOST * abs(bulge):
            cuts = (first == run.first) + (last == run.last)
            begin, end = _steady(curve, first, -1), _steady(curve, last, 1)
            bridge = _bridge(curve, begin, end, cuts)
            if bridge is not None:
                pieces, turn = bridge
                if cuts == 2 and not _along_edge(pieces, mask, np.sign(bulge)):
                    continue
                yield _Joint(begin, end, pieces, turn + _ASTRAY * cuts)


def _bulge(curve: SourceCurve, run: _Run) -> float:
    """Return what a run encloses with its chord; negative if it is on the right of that."""
    count = max(3, int(run.last - run.first))
    row = curve.at(np.linspace(run.first, run.last, count))
    row = row - row[0]
    return float((row.conj() * np.roll(row, -1)).imag.sum()) / 2


def _places(curve: SourceCurve, run: _Run, side: float) -> tuple[list[float], list[float]]:
    """Return where a part may begin, and where it may end, if it bulges to that side."""
    half = (run.last - run.first) / 2
    before, after = np.arange(-_OFF, half), np.arange(-half, _OFF)
    return (
        [run.first, *_corners(curve, run.first, before, side)],
        [run.last, *_corners(curve, run.last, after, side)],
    )


def _corners(
    curve: SourceCurve, end: float, around: NDArray[np.float64], side: float
) -> list[float]:
    """Return the corners against a bulge to that side, of places around an end of a mark."""
    along = end + around
    found: set[float] = set()
    for reach in (_SIDE, 2 * _SIDE):
        more = np.arange(1, reach + 1)
        wide = np.concatenate([along[0] - more[::-1], along, along[-1] + more])
        here = curve.at(wide)
        ways = here - curve.at(wide - reach), curve.at(wide + reach) - here
        turns = -side * np.angle(ways[1] * ways[0].conj())
        highest = maximum_filter1d(turns, 2 * reach + 1)
        corners = ((turns == highest) & (turns > _SHARP))[reach:-reach]
        found.update(along[corners].tolist())
    nodes = np.interp(np.arange(len(curve.pieces)), curve.place, curve.along)
    nearest = sorted(found, key=lambda one: abs(one - end))[:_TRIED]
    return [_snapped(one, nodes, curve.length) for one in nearest]


def _snapped(along: float, nodes: NDArray[np.float64], length: float) -> float:
    """Return a place, or the node that is next to it."""
    off = (nodes - along + length / 2) % length - length / 2
    nearest = float(off[abs(off).argmin()])
    return along + nearest if abs(nearest) < _NEXT else along


def _steady(curve: SourceCurve, along: float, step: int) -> float:
    """Return a place, or the nearest one before the bend that a rounded corner is."""
    for off in range(_TIGHT):
        at = along + step * off
        near, far = curve.at(at + step * np.array([FINE / 2, _SIDE])) - curve.at(np.array([at, at]))
        if abs(angle(complex(near), complex(far))) < _STEADY:
            return at
    return along


def _bridge(
    curve: SourceCurve, first: float, last: float, cuts: int
) -> tuple[list[Piece], float] | None:
    """Return the pieces that join two places of a contour, and by how much they turn.

    So many of the places are no corners, but ``cuts`` where the mark ends.
    """
    start, end = (complex(one) for one in curve.at(np.array([first, last])))
    around = curve.at(np.array([first - FINE / 2, last + FINE / 2]))
    way, onward = start - complex(around[0]), complex(around[1]) - end
    chord = end - start
    if abs(chord) < 1 or not abs(way) or not abs(onward):
        return None
    one, other = angle(way, chord), angle(chord, onward)
    turn, most = abs(one) + abs(other), max(abs(one), abs(other))
    if most < _STRAIGHT or (cuts == 2 and most > _WAVY and one * other > 0):
        return [(start, end)], turn
    if most < _BENT and (one * other >= 0 or min(abs(one), abs(other)) < _WAVY):
        handles = _handles(abs(chord), one, other)
        way, onward = (
            handle * along / abs(along)
            for handle, along in zip(handles, (way, onward), strict=True)
        )
        return [(start, start + way, end - onward, end)], turn
    if one * other > 0 and turn < _CORNER:
        corner = start + way * (chord * onward.conjugate()).imag / (way * onward.conjugate()).imag
        if not cuts or min(abs(corner - start), abs(corner - end)) < _ROUGH:
            return [(start, corner), (corner, end)], turn
    return ([(start, end)], turn) if abs(chord) < _CAP and one * other > 0 else None


def _handles(chord: float, one: float, other: float) -> tuple[float, float]:
    """Return how long the handles of a cubic are that turns by two angles against its chord.

    If both are the same, it is an arc of a circle.
    """
    turn = one + other
    if one * other <= 0 or abs(turn) < _STRAIGHT:
        return chord / 3, chord / 3
    part = 4 / 3 * np.tan(turn / 4) / np.tan(turn / 2) * chord / np.sin(turn)
    return float(part * np.sin(other)), float(part * np.sin(one))


def _contour(pieces: list[Piece]) -> Contour:
    """Return pieces as a contour in canvas units."""
    segments: list[Segment] = []
    for piece in pieces:
        _, *ends = map(_point, piece)
        segments.append((ends[0],) if len(ends) == 1 else (ends[0], ends[1], ends[2]))
    return Contour(_point(pieces[0][0]), tuple(segments))


def _point(at: complex) -> Point:
    return float(at.real / FINE), float(at.imag / FINE)
