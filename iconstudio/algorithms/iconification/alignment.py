"""Sources that miss each other by little are moved so that their contours meet.

The positions of matching are whole pixels (section 3.3), so that two halves of one circle may lie a
pixel apart where they meet. What the curves on both sides of a seam miss each other by, across the
way they go, is made as small as can be for all seams at once, by least squares, without moving any
source far.
"""

from collections.abc import Iterator, Sequence

import numpy as np

from iconstudio.algorithms.tracing.bezier import Points
from iconstudio.algorithms.tracing.exact import Followed
from iconstudio.algorithms.tracing.pieces import Outline

_FARTHEST = 2.0
"""Canvas units by which a source is moved at most."""
_WIDEST = 3.0
"""Canvas units by which curves that belong together may miss each other."""
_LONGEST = 24.0
"""Canvas units of a seam across which it is told whether they do."""
_ALIKE = np.radians(12)
"""By how much their directions may differ."""
_STAY = 0.01
"""Weight of not being moved, beside one for each seam."""


def alignment(
    outlines: Sequence[Outline],
    followed: Sequence[Sequence[Followed]],
    count: int,
    unit: float,
) -> Points:
    """Return by how much each of ``count`` sources is moved, in pixels, as complex numbers.

    ``followed`` are, for each closed outline, its rows in order; ``unit`` is in canvas units to a
    pixel.
    """
    seams = [
        seam
        for outline, rows in zip(outlines, followed, strict=True)
        for seam in _misses(outline, rows, unit)
    ]
    moves = np.zeros(count, dtype=np.complex128)
    if not seams:
        return moves
    # Unknowns are x and y of each source; each seam is an equation along its normal.
    system = np.zeros((len(seams) + 2 * count, 2 * count))
    wanted = np.zeros(len(system))
    for row, (one, other, normal, miss) in enumerate(seams):
        system[row, 2 * one : 2 * one + 2] = normal.real, normal.imag
        system[row, 2 * other : 2 * other + 2] = -normal.real, -normal.imag
        wanted[row] = miss
    system[len(seams) :] = np.sqrt(_STAY) * np.eye(2 * count)
    found = np.linalg.lstsq(system, wanted, rcond=None)[0]
    moves = found[::2] + 1j * found[1::2]
    farthest = _FARTHEST / unit
    return moves * np.minimum(1, farthest / np.maximum(abs(moves), 1e-9))


def _misses(
    outline: Outline, rows: Sequence[Followed], unit: float
) -> Iterator[tuple[int, int, complex, float]]:
    """Yield, for each seam, its sources, a normal, and how far along it the first is to move."""
    for here, one in enumerate(rows):
        other = rows[(here + 1) % len(rows)]
        if one.source == other.source:
            continue
        gap = (other.first - one.last) % len(outline)
        if gap * unit > _LONGEST:
            continue
        # Both are drawn out over the seam: they should be one there.
        steps = np.arange(max(gap, 1) + 1)
        first = one.curve.at(one.along[-1] + one.way * steps)
        second = other.curve.at(other.along[0] - other.way * steps[::-1])
        ways = np.diff([first, second])
        if abs(np.angle(ways[1] * ways[0].conj())).max() > _ALIKE or not ways.all():
            continue
        middle = len(steps) // 2
        way = ways[:, middle - 1].sum()
        normal = 1j * way / abs(way)
        miss = float(((second - first)[middle] * normal.conjugate()).real)
        if abs(miss) * unit < _WIDEST:
            yield one.source, other.source, complex(normal), miss


def moved(
    outline: Outline, rows: Sequence[Followed], moves: Points
) -> tuple[Outline, list[Followed]]:
    """Return an outline and its rows with their sources moved; what is between goes along."""
    if not rows or not moves.any():
        return outline, list(rows)
    count = len(outline)
    places = np.concatenate([[row.first, row.last] for row in rows])
    by = np.repeat([moves[row.source] for row in rows], 2)
    around = np.concatenate([places[-2:] - count, places, places[:2] + count])
    shifts = np.interp(np.arange(count), around, np.concatenate([by[-2:], by, by[:2]]))
    return Outline(outline.points + shifts), [row.moved(moves[row.source]) for row in rows]
