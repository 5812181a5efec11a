"""Lines in the style of an example: what the program calls, and what the sections come to."""

from collections.abc import Iterable, Sequence
from dataclasses import replace

import numpy as np

from iconstudio.algorithms.areas import one_piece
from iconstudio.algorithms.curves.constraints import Constraint
from iconstudio.algorithms.curves.corners import joined, parted
from iconstudio.algorithms.curves.curve import Curve, Numbers
from iconstudio.algorithms.curves.dots import LONGEST, length, with_rings
from iconstudio.algorithms.curves.junctions import junctions
from iconstudio.algorithms.curves.kinks import without_kinks
from iconstudio.algorithms.curves.multiresolution import analogy
from iconstudio.algorithms.curves.prepared import Prepared, prepare, smoothed
from iconstudio.algorithms.curves.thickness import held_back
from iconstudio.algorithms.curves.untangling import untangled
from iconstudio.model import Line

__all__ = ["Prepared", "prepare", "restyled"]

_ROUND = 0.3
"""An open line that encloses so much of what a circle of its length does has an inside."""
_CLOSE = 2.0
"""Canvas units between points of a smooth curve, at most."""
_MEETS = 0.05
"""Canvas units between the ends of a line that is closed."""
_NECK = 0.8
"""Canvas units by which loops of a contour hang together with it, at least."""
_SLIM = 1e-6
"""What encloses so little of what a circle of its length does encloses nothing."""


def restyled(
    lines: Iterable[tuple[Line, Prepared]], seed: int = 0, coarse: bool = False
) -> list[Line]:
    """Return lines, each in its style. The same seed gives the same lines.

    If they may be ``coarse``, they are the blurred ones from which the others are made.

    Lines that met still meet, and none cross or touch that did not. Styles with two sides show the
    same one on the outside of whatever is closed, and of its holes within. Dots, and
    shapes beside strokes, become rings.
    """
    given, styles = zip(*lines, strict=True) if (lines := tuple(lines)) else ((), ())
    lines = list(zip(with_rings([*map(_ring, given)]), styles, strict=True))
    long = [number for number, (line, _) in enumerate(lines) if length(line) > LONGEST]
    made = dict(zip(long, _styled([lines[number] for number in long], seed, coarse), strict=True))
    return [made.get(number, line) for number, (line, _) in enumerate(lines)]


def _styled(lines: Sequence[tuple[Line, Prepared]], seed: int, coarse: bool) -> list[Line]:
    given = [Curve.of(np.array(line.points) @ [1, 1j], line.closed).unit for line, _ in lines]
    backwards = [_is_anticlockwise(curve) for curve in given]
    plain = [
        Curve.of(curve.points[::-1], curve.closed).unit if turned else curve
        for curve, turned in zip(given, backwards, strict=True)
    ]
    widths = [line.width for line, _ in lines]
    met = junctions(plain, widths)
    made = [
        _one(curve, line.width, prepared, seed * 1_000_003 + number, constraints, coarse)
        for number, (curve, (line, prepared), constraints) in enumerate(
            zip(plain, lines, met, strict=True)
        )
    ]
    styled = [curve for curve, _ in made]
    if styled:
        loop = max(prepared.loop for _, prepared in lines)
        styled = untangled(plain, held_back(plain, styled, widths), widths, loop)
    return [
        _line(line, curve, own, turned)
        for (line, _), curve, (_, own), turned in zip(lines, styled, made, backwards, strict=True)
    ]


def _one(
    plain: Curve,
    width: float,
    prepared: Prepared,
    seed: int,
    constraints: Sequence[Constraint],
    coarse: bool,
) -> tuple[Curve, Numbers]:
    """Return a curve in a style, and its width at each point, over ``width``, that of its line."""
    style = prepared.style
    pieces, widths = [], []
    whole = [(plain, constraints, 0.0, plain.end)] if style.shape else parted(plain, constraints)
    for number, (part, own, first, last) in enumerate(whole):
        parameters, levels = prepared.room(part, coarse)
        made = analogy(levels, part, parameters, seed + number, style.rotation, style.shape, own)
        pieces.append((without_kinks(made.curve, part, levels[-1], own), first, last))
        widths.append(prepared.widths(levels, made.sources))
    curve = joined(plain, [(_smooth(one), first, last) for one, first, last in pieces])
    return curve, _fitting(curve, pieces, widths, width)


def _smooth(curve: Curve) -> Curve:
    """Return a curve whose points lie close together, as those of a large texture do not."""
    dense = curve.resampled(_CLOSE)
    if 2 * len(dense.points) < 3 * len(curve.points):
        return curve
    return replace(dense, points=curve.smoothly(dense.parameters))


def _fitting(
    curve: Curve,
    pieces: Sequence[tuple[Curve, float, float]],
    widths: Sequence[Numbers],
    width: float,
) -> Numbers:
    """Return the widths of a curve's parts at its own points, over ``width``, smoothed."""
    at = np.concatenate([first + one.parameters * (last - first) for one, first, last in pieces])
    found = np.concatenate(widths)
    order = np.argsort(np.mod(at, curve.end) if curve.closed else at, kind="stable")
    at = np.mod(at, curve.end)[order] if curve.closed else at[order]
    own = np.interp(curve.parameters, at, found[order])
    return smoothed(own, curve, width)


def _line(line: Line, curve: Curve, widths: Numbers, turned: bool) -> Line:
    """Return what a line has become; it runs as it did, if its curve was ``turned`` before."""
    points, found = curve.points, _own_widths(line, curve.parameters, turned) * widths
    if turned:
        points, found = points[::-1], found[::-1]
    row = np.stack([points.real, points.imag], axis=1)
    if line.closed and not line.width and len(row) > 3:
        row = one_piece(row, _NECK)
    varied = line.width > 0 and np.ptp(found) > 1e-6
    return replace(
        line,
        points=tuple((x, y) for x, y in row.tolist()),
        widths=tuple(found.tolist()) if varied else (),
    )


def _own_widths(line: Line, at: Numbers, turned: bool) -> Numbers:
    """Return the width of a line at parameters, which run the other way if it is ``turned``."""
    if not line.widths:
        return np.full(len(at), line.width)
    last = len(line.points) - 1
    around = slice(0, int(line.closed))
    points = np.array((*line.points, *line.points[around])) @ [1, 1j]
    along = np.append(0.0, np.cumsum(abs(np.diff(points))))
    along /= along[-1]
    widths = (*line.widths, *line.widths[around])
    return np.interp(
        along[last] - at if turned else at, along, widths, period=1.0 if line.closed else None
    )


def _ring(line: Line) -> Line:
    """Return a line that ends where it begins as a closed one."""
    ends = complex(*line.points[0]) - complex(*line.points[-1])
    meets = abs(ends) < _MEETS and length(line) > LONGEST
    return replace(line, closed=True) if meets else line


def _is_anticlockwise(curve: Curve) -> bool:
    """Whether a curve has what it encloses on its left: examples are drawn the other way."""
    around = np.append(curve.points, curve.points[:1])
    area = float((around[:-1].conj() * around[1:]).imag.sum() / 2)
    whole = curve.length**2 / (4 * np.pi)
    return area < -(_SLIM if curve.closed else _ROUND) * whole
