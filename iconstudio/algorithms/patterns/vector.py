"""Patterns as curves: their zero level sets traced, layer by layer (beyond the paper).

An element of the exemplar whose own shapes are known is drawn with those. Layers that abut are
trapped, and what crosses the border of a tile is drawn at both of its sides.
"""

from collections.abc import Callable, Iterator, Sequence
from itertools import chain

import numpy as np
from numpy.typing import NDArray
from scipy import ndimage
from scipy.sparse import coo_array
from scipy.sparse.csgraph import connected_components

from iconstudio.algorithms.patterns.distance import CLAMP, Field, coverage
from iconstudio.algorithms.patterns.exemplar import Pattern, Placed
from iconstudio.algorithms.patterns.outlines import LevelSet, finer, level_sets
from iconstudio.algorithms.patterns.tiling import bounded, moved, repeated
from iconstudio.algorithms.patterns.trapping import run_on
from iconstudio.algorithms.tracing.pieces import Outline
from iconstudio.algorithms.tracing.vectorize import contour_along
from iconstudio.model import ColouredLayer, Contour, Fill, Path, Transform, hex_colour

Shapes = Sequence[Sequence[Sequence[Fill]]]
"""Of each layer of an exemplar, the elements by their labels, from 1; each from back to front, in
pixels of the exemplar."""
Labels = NDArray[np.int32]
Mask = NDArray[np.bool_]

_SCALE = 2
"""Samples to a pixel, a side, in which contours are followed."""
SPACING = 0.25
"""Pixels between the points that are traced."""
_BLUR = 2
"""How many times as much pixels blunt corners as in a drawing of many more."""
TOLERANCE = 0.06
"""Pixels by which curves may be off the zero level set."""
_SPECK = 0.25
"""Square pixels of ink that is too small to be a shape, and of holes."""
_PURE = 0.99
"""So much of a pixel is covered where it has a layer's own colour."""
_ALIKE = 12
"""Levels, of 255, by which components of one colour may differ."""
_UNSEEN = "#000000"
"""The colour of what has no pixel of its own."""


def vectorise(
    pattern: Pattern,
    shapes: Shapes | None = None,
    ask: Callable[[], None] = lambda: None,
    curves: bool = True,
) -> tuple[ColouredLayer, ...]:
    """Return the layers of a pattern as shapes in flat colours, from back to front, in pixels.

    Each fill is a component of its layer, with its copies across the borders of a tile; or one of
    the shapes of an element.

    Parameters
    ----------
    shapes
        Those of the exemplar's elements. An element that has none is traced.
    ask
        Called for each contour and each element; what it raises ends the work.
    curves
        Whether curves are fitted to contours; else these are polygons, made in a tenth of the time.
    """
    tracer = _Tracer(pattern, shapes, ask, curves)
    count = len(pattern.distances)
    return tuple(
        ColouredLayer(f"layer-{count - m}", tuple(tracer.fills(m))) for m in reversed(range(count))
    )


class _Tracer:
    """What all layers of a pattern have in common."""

    def __init__(
        self, pattern: Pattern, shapes: Shapes | None, ask: Callable[[], None], curves: bool
    ) -> None:
        self._pattern, self._shapes, self._ask = pattern, shapes, ask
        self._curves = curves
        self._size = pattern.distances.shape[1], pattern.distances.shape[2]
        self._traces: dict[tuple[bytes, complex], Contour] = {}
        """What is alike is traced once,"""
        self._elements: dict[tuple[int, int], Path] = {}
        """and so are the elements of the exemplar, by layer and number."""

    def fills(self, m: int) -> Iterator[Fill]:
        """Give the shapes of a layer."""
        pattern = self._pattern
        distance = pattern.distances[m]
        placed = {n: one for n, one in enumerate(pattern.placed, 1) if one.layer == m}
        drawn: dict[int, Sequence[Fill]] = {}
        if placed and pattern.owners is not None:
            owner = pattern.owners[m]
            colours = self._colours(m, owner)
            grown = ndimage.binary_dilation((self._run_on(m, distance) < 0) & (distance >= 0))
            trapped = set(np.unique(owner[grown]).tolist())
            for number, one in placed.items():
                self._ask()
                if own := self._own_shapes(one):
                    drawn[number] = own
                elif pattern.elements and number not in trapped:
                    drawn[number] = (Fill(self._element(one), colours.get(number, _UNSEEN)),)
            distance = _without(distance, np.isin(owner, list(drawn)), pattern.tile)
        if (distance < 0).any():
            yield from self._traced(m, distance)
        for number, own in drawn.items():
            self._ask()
            yield from self._laid(placed[number], own)

    def _run_on(self, m: int, distance: Field) -> Field:
        if not m:
            return distance
        return run_on(distance, self._pattern.distances[:m].min(axis=0), self._pattern.tile)

    def _own_shapes(self, one: Placed) -> Sequence[Fill]:
        return self._shapes[one.layer][one.label - 1] if self._shapes else ()

    def _element(self, one: Placed) -> Path:
        """Return the outline of an element, where it is in the exemplar; traced once."""
        key = one.layer, one.element
        if key not in self._elements:
            element = self._pattern.elements[one.layer].whole[one.element]
            corner = element.left + 1j * element.top
            sets = level_sets(finer(element.distance, _SCALE, False), False, _SCALE, self._ask)
            self._elements[key] = Path(
                tuple(
                    moved(self._trace(level_set.outline), level_set.place + corner)
                    for level_set in sets
                    if abs(level_set.area) >= _SPECK
                )
            )
        return self._elements[key]

    def _laid(self, one: Placed, own: Sequence[Fill]) -> Iterator[Fill]:
        there = Transform().translate(one.right, one.down)
        for fill in own:
            path = fill.path.transformed(there)
            yield Fill(repeated(path, self._size) if self._pattern.tile else path, fill.colour)

    def _traced(self, m: int, distance: Field) -> Iterator[Fill]:
        """Give the components of what is negative in a layer, each in its own flat colour."""
        tile = self._pattern.tile
        field = self._run_on(m, distance)
        self._ask()
        fine = finer(field, _SCALE, tile)
        labels = components(fine < 0, tile)
        self._ask()
        contours: dict[int, list[LevelSet]] = {}
        for one in level_sets(fine, tile, _SCALE, self._ask):
            contours.setdefault(int(labels[one.inside]), []).append(one)
        colours = self._colours(m, labels[_SCALE // 2 :: _SCALE, _SCALE // 2 :: _SCALE])
        for label in range(1, labels.max() + 1):
            if path := self._path(contours.get(label, [])):
                yield Fill(path, colours.get(label, _UNSEEN))

    def _path(self, level_sets: Sequence[LevelSet]) -> Path:
        """Return what the contours of a component bound."""
        closed: list[Contour] = []
        endless: list[tuple[Contour, complex]] = []
        if all(one.area < 0 for one in level_sets):  # nothing but holes: it goes on everywhere
            closed.append(self._everywhere())
        for one in level_sets:
            self._ask()
            contour = moved(self._trace(one.outline), one.place)
            if one.outline.step:
                endless.append((contour, one.outline.step))
            elif abs(one.area) >= _SPECK:
                closed.append(contour)
        if not self._pattern.tile:
            return Path(tuple(closed))
        strips = bounded(endless, self._size).contours if endless else ()
        # Each by itself: their places may be periods apart.
        copies = (repeated(Path((one,)), self._size).contours for one in closed)
        return Path((*strips, *chain.from_iterable(copies)))

    def _everywhere(self) -> Contour:
        rows, columns = self._size
        return Contour((0, 0), (((columns, 0),), ((columns, rows),), ((0, rows),)))

    def _trace(self, outline: Outline) -> Contour:
        if not self._curves:
            return _polygon(outline)
        key = outline.points.tobytes(), outline.step
        if key not in self._traces:
            finer = Outline(outline.points / SPACING, outline.step / SPACING)
            self._traces[key] = contour_along(finer, SPACING, TOLERANCE, _BLUR)
        return self._traces[key]

    def _colours(self, m: int, labels: Labels) -> dict[int, str]:
        """Return the colours of parts of a layer, by their labels (H, W), from 1.

        They are those of pixels that are wholly covered, or most, and seen; of parts that are
        alike, that of the largest.
        """
        pattern = self._pattern
        own = coverage(pattern.distances[m])
        for distance in pattern.distances[:m]:
            own = own * (distance >= 0.5)
        most = np.zeros(labels.max() + 1, np.float32)
        np.maximum.at(most, labels, own)
        pure = (labels > 0) & (own >= np.minimum(_PURE, most[labels]))
        order = np.argsort(labels[pure], kind="stable")
        numbers, begins = np.unique(labels[pure][order], return_index=True)
        parts = np.split(pattern.colours[pure][order], begins[1:]) if len(numbers) else []
        found: dict[int, str] = {}
        palette: list[NDArray[np.float32]] = []
        for k in sorted(range(len(numbers)), key=lambda k: -len(parts[k])):
            colour = np.median(parts[k], axis=0)
            alike = [one for one in palette if abs(one - colour).max() * 255 <= _ALIKE]
            if not alike:
                palette.append(colour)
            found[int(numbers[k])] = _written(alike[0] if alike else colour)
        return found


def _without(distance: Field, known: Mask, tile: bool) -> Field:
    """Return the field of the ink that is not that of known elements."""
    margin = int(CLAMP) if tile else 0
    rows, columns = distance.shape
    inside = np.s_[margin : margin + rows, margin : margin + columns]
    away, near = (
        ndimage.distance_transform_edt(np.pad(~ink, margin, mode="wrap"))[inside]
        for ink in ((distance < 0) & ~known, known)
    )
    outside = np.clip(away - 0.5, 0.5, CLAMP).astype(np.float32)
    rest: Field = np.where(near < away, outside, distance)
    return rest


def components(ink: Mask, tile: bool) -> Labels:
    """Return the components of ink (H, W), from 1; on a tile they go on across its borders."""
    labels, count = ndimage.label(ink)
    if not tile:
        return np.asarray(labels, np.int32)
    ends = np.concatenate([labels[[0, -1]].T, labels[:, [0, -1]]])
    ends = ends[ends.all(axis=1)]
    meeting = coo_array((np.ones(len(ends)), ends.T), (count + 1, count + 1))
    _, groups = connected_components(meeting, directed=False)
    return np.asarray(groups[labels], np.int32)


def _written(colour: NDArray[np.float32]) -> str:
    return hex_colour(np.rint(np.clip(colour, 0, 1) * 255))


def _polygon(outline: Outline) -> Contour:
    """Return an outline as it is; what does not close is one turn of it."""
    points = [(float(one.real), float(one.imag)) for one in outline.points]
    end = outline.points[0] + outline.step
    last = [(float(end.real), float(end.imag))] if outline.step else []
    segments = tuple((point,) for point in (*points[1:], *last))
    return Contour(points[0], segments, closed=not outline.step)
