"""What an edit takes out of an icon exactly, without a cut (section 4.2).

An addition to the paper. Parts inside an icon that are wholly enclosed by what is marked to go, a
hub or a window, are no matter of a cut: their contours are left out of the icon, which stays as it
is elsewhere; what was around them goes on. Nor is a hole in plain ink: what was drawn is its
contour, whether another icon has one there or not. Nor is a part that sticks out, an antenna, if
nothing comes in its place: the outline closes where it was, as if it had never been there.
"""

from collections.abc import Sequence
from concurrent.futures import Future
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray
from scipy.ndimage import binary_erosion, distance_transform_edt

from iconstudio.algorithms.flattening import flattened
from iconstudio.algorithms.geometry import crosses_itself
from iconstudio.algorithms.iconification.detaching import detached
from iconstudio.algorithms.iconification.guide import filled_polygons
from iconstudio.algorithms.raster import Bitmap, fill_polygon, placed_ink
from iconstudio.model import CANVAS, Edit, Exemplar, Placement, Polygon
from iconstudio.model.composite import WHOLE
from iconstudio.model.path import Contour, Path
from iconstudio.workers import Workers
from iconstudio.workflows.drawing import MEMORY, SECONDS, Render, svg_of

_FINE = 4 * CANVAS
_BESIDE = 24
"""Canvas units around an area in which what is done to it shows."""
_RIM = 0.6
"""So much of what is marked may stay at most: the rim of the wall that a handle is taken off."""
_SPILT = 0.02
"""So much ink, of as much as goes, may come beside the area: a line goes on without an ear."""
_CRUMBS = 8
"""So few pixels are no change: those of soft edges."""


@dataclass(frozen=True, eq=False)
class Emptied:
    """An icon without the parts that marked areas enclose, and with the holes that it could get."""

    icon: Exemplar
    areas: tuple[Polygon, ...]
    """Those in which nothing is left to be done: of what goes, and of holes."""


def begin_emptying(
    edit: Edit, icon: Exemplar, workers: Workers, render: Render
) -> "Future[Emptied | None]":
    """Begin to take what an edit marks out of an icon; None if all of it is a matter of the cut."""
    given = edit.remove, edit.inner.holes, icon, render, _alone(edit)
    return workers.submit(emptied, *given, timeout=SECONDS, memory=MEMORY)


def emptied(
    areas: Sequence[Polygon],
    holes: Sequence[Polygon],
    icon: Exemplar,
    render: Render,
    alone: Sequence[Polygon] = (),
) -> Emptied | None:
    """Return an icon without what areas within its outline enclose, and with holes in plain ink.

    An area that encloses nothing but ink is such a hole, too. A hole that a contour runs through,
    or that overlaps another one, is a matter of the cut. So is what areas reach beyond the outline,
    unless they are ``alone``, with nothing to come there, and the outline closes well without it.

    All are in canvas units. Runs in a worker process.
    """
    outline = render.outline(icon.pictogram.svg, icon.frame)
    rows = [points for points, _ in flattened(outline)]
    _, filled = placed_ink(icon, Placement(), CANVAS)
    inside = [_Mark.on(one, rows) for one in areas if not (fill_polygon(one) & ~filled).any()]
    parts = [one for one in inside if one.enclosed]
    plain: list[_Mark] = []
    for one in (*(one for one in inside if not one.met), *(_Mark.on(one, rows) for one in holes)):
        if one.lies_in(icon.ink) and not any((one.mask & other.mask).any() for other in plain):
            plain.append(one)
    gone = frozenset().union(*(one.enclosed for one in (*parts, *plain)))
    left, done = outline, list[Polygon]()
    if plain or 0 < len(gone) < len(rows):
        contours = (one for number, one in enumerate(outline.contours) if number not in gone)
        left = Path((*contours, *(_hole(one.area) for one in plain)))
        done = [one.area for one in (*parts, *plain) if one.met <= gone]
    for area in alone:
        closed = _closed(left, area, icon, render) if area not in done else None
        if closed is not None:
            left = closed
            done.append(area)
    return None if left is outline else Emptied(_drawn(left, icon, render), tuple(done))


def _alone(edit: Edit) -> tuple[Polygon, ...]:
    """Return the areas of what only goes: those beside which nothing is added.

    None if the halves shall mirror each other: the cut takes off the mirror image, too.
    """
    if edit.symmetry is not None:
        return ()
    added = filled_polygons(edit.add, CANVAS)
    near = distance_transform_edt(~added) <= _BESIDE if added.any() else added
    return tuple(one for one in edit.remove if not (near & fill_polygon(one)).any())


def _closed(outline: Path, area: Polygon, icon: Exemplar, render: Render) -> Path | None:
    """Return an outline closed without what an area marks, if that and no more is gone then."""
    found = detached(outline, area)
    if not found:
        return None
    before, after = (_drawn(one, icon, render).ink for one in (outline, found))
    whole = fill_polygon(area)
    gone, new, marked = before & ~after, after & ~before, before & whole
    elsewhere = distance_transform_edt(~whole) > _BESIDE
    clean = (
        (marked & after).sum() <= _RIM * marked.sum()
        and (new & ~whole).sum() <= _SPILT * gone.sum()
        and ((gone | new) & elsewhere).sum() <= _CRUMBS
    )
    return found if clean else None


@dataclass(frozen=True, eq=False)
class _Mark:
    """An area that is marked on an icon, and which of its contours it meets."""

    area: Polygon
    mask: Bitmap
    """(_FINE, _FINE): what it encloses."""
    met: frozenset[int]
    enclosed: frozenset[int]
    """Those that lie in it from end to end."""

    @classmethod
    def on(cls, area: Polygon, rows: Sequence[NDArray[np.float64]]) -> "_Mark":
        """Return an area on the contours ``rows``, points (n, 2) each."""
        mask = fill_polygon(area, _FINE)
        hits = [_hits(row, mask) for row in rows]
        met, enclosed = (
            frozenset(number for number, hit in enumerate(hits) if some(hit))
            for some in (np.any, np.all)
        )
        return cls(area, mask, met, enclosed)

    def lies_in(self, ink: Bitmap) -> bool:
        """Whether it could be a hole in ink (CANVAS, CANVAS): nothing else is at its rim."""
        whole = fill_polygon(self.area)
        rim = whole & ~binary_erosion(whole)
        simple = self.met == self.enclosed and not crosses_itself(self.area)
        return simple and bool(rim.any() and ink[rim].all())


def _hole(area: Polygon) -> Contour:
    """Return the contour of an area, in the direction of holes."""
    start, *others = area.vertices
    contour = Contour(start, tuple((point,) for point in others))
    if Path((contour,)).area < 0:
        return contour
    *before, last = area.vertices
    return Contour(last, tuple((point,) for point in reversed(before)))


def _hits(points: NDArray[np.float64], mask: Bitmap) -> NDArray[np.bool_]:
    """Return which points (n, 2) of a contour lie in a mask."""
    x, y = np.clip((points.T * _FINE / CANVAS).astype(int), 0, _FINE - 1)
    hit: NDArray[np.bool_] = mask[y, x]
    return hit


def _drawn(outline: Path, icon: Exemplar, render: Render) -> Exemplar:
    """Return an icon that has an outline, with the name and the credit of another."""
    svg = svg_of(outline)
    coverage = render(svg, WHOLE, Placement(), CANVAS)
    return Exemplar(replace(icon.pictogram, svg=svg), WHOLE, coverage)
