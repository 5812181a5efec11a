"""Lines that end, but nowhere in the exemplar, are joined or taken out (beyond the paper).

Vines and the like go on beyond the exemplar, so that no element of theirs is known whole. Where
patches of it meet that do not fit, a line ends. Ends that face each other are joined by a curve
along both; one that points to something of a layer above runs on beneath it; what is left of short
lines is taken out.
"""

from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray
from scipy import ndimage
from scipy.spatial import cKDTree
from skimage.morphology import skeletonize

from iconstudio.algorithms.patterns.distance import CLAMP, Field, bordered

Bitmap = NDArray[np.bool_]
Points = NDArray[np.complex128]
"""Pixels of a picture, x + iy."""

_MARGIN = 100
"""Pixels beyond the border of a tile that are looked at, too."""
_WIDEST = 7.0
"""Half the width of a line, in pixels, at most."""
_SPUR = 1.6
"""What is shorter, in halves of the width of what it is on, is no line."""
_LOOK = 7
"""Pixels along a line that tell which way it goes."""
_FARTHEST, _BENEATH = 44.0, 22.0
"""Pixels of a gap between two ends, and from an end to what it goes on beneath, at most."""
_BEND = np.radians(80)
"""By how much a line turns at most where it is joined."""
_STUB = 96
"""Pixels of a line that is taken out, at most."""
_AROUND = np.array([-1 - 1j, -1j, 1 - 1j, -1, 1, -1 + 1j, 1j, 1 + 1j])


@dataclass(frozen=True, slots=True, eq=False)
class End:
    """Where a line ends in sight."""

    at: complex
    way: complex
    """The way that it would go on, of length 1."""
    half: float
    """Half its width."""
    line: Points
    """Its middle from the end to where it is hidden or meets others, or for ``_STUB`` pixels."""
    short: bool
    """Whether it is hidden, or meets others, within ``_STUB`` pixels."""


def loose_ends(distance: Field, over: Bitmap, tile: bool) -> list[End]:
    """Return where lines of a layer end in sight.

    Parameters
    ----------
    distance
        (H, W), of the layer.
    over
        (H, W), where it is not seen.
    tile
        Whether opposite borders meet. Else what is near the border does not end there.
    """
    margin = _MARGIN if tile else 0
    field, hidden = (
        bordered(distance, margin, tile),
        bordered(over.astype(np.float32), margin, tile) > 0,
    )
    middle = skeletonize(field < 0)
    beside = ndimage.convolve(middle.astype(np.uint8), np.ones((3, 3), np.uint8), mode="constant")
    tips = np.argwhere(middle & (beside == 2) & ~hidden)
    low, high = np.array([margin, margin]), margin + np.array(distance.shape)
    if not tile:
        low, high = low + _LOOK, high - _LOOK
    found = []
    for y, x in tips[((tips >= low) & (tips < high)).all(axis=1)].tolist():
        line, short = _followed(middle, beside, hidden, complex(x, y))
        halves = -field[line.imag.astype(int), line.real.astype(int)]
        half = float(np.percentile(halves, 75))
        if half > _WIDEST or (short and len(line) <= _SPUR * halves.max()):
            continue
        back = line[min(len(line) - 1, _LOOK)]
        way = line[0] - back
        if way:
            offset = complex(margin, margin)
            found.append(End(line[0] - offset, way / abs(way), half, line - offset, short))
    return found


def _followed(
    middle: Bitmap, beside: NDArray[np.uint8], hidden: Bitmap, start: complex
) -> tuple[Points, bool]:
    """Return the middle of a line from its end on, and whether it is over before ``_STUB``."""
    line = [start]
    seen = {start}
    while len(line) < _STUB:
        near = [
            one
            for one in (line[-1] + _AROUND).tolist()
            if one not in seen
            and 0 <= one.imag < middle.shape[0]
            and 0 <= one.real < middle.shape[1]
            and middle[int(one.imag), int(one.real)]
        ]
        if not near:
            return np.array(line), True
        following = min(near, key=lambda one: abs(one - line[-1]))
        seen.update(near)
        line.append(following)
        y, x = int(following.imag), int(following.real)
        if hidden[y, x] or beside[y, x] > 3:
            return np.array(line), True
    return np.array(line), False


def joined(
    distance: Field,
    over: Bitmap | None,
    tile: bool,
    ask: Callable[[], None] = lambda: None,
) -> Field:
    """Return a layer (H, W) in which lines end in sight as seldom as may be.

    Parameters
    ----------
    distance, over, tile
        See ``loose_ends``; nothing may lie over it.
    ask
        Called now and then; what it raises ends the work.
    """
    over = np.zeros(distance.shape, np.bool_) if over is None else over
    ends = loose_ends(distance, over, tile)
    if not ends:
        return distance
    ask()
    sheet = _Sheet(distance, over, tile)
    left = set(range(len(ends)))
    for _, numbers, curve in sorted(sheet.curves(ends), key=lambda one: one[0]):
        its = [ends[k] for k in numbers]
        if left.issuperset(numbers) and sheet.clear(curve, its):
            sheet.draw(curve, min(one.half for one in its))
            for one in its:  # which may be thinner towards its end
                sheet.draw(one.line[:_LOOK], one.half)
            left.difference_update(numbers)
        ask()
    sheet.take_out(ends[k].line for k in left if ends[k].short)
    return sheet.distance


class _Sheet:
    """A layer on which lines are drawn and taken out."""

    def __init__(self, distance: Field, over: Bitmap, tile: bool) -> None:
        self.distance = distance.copy()
        self._over, self._tile = over, tile
        self._size = distance.shape[1], distance.shape[0]

    def curves(self, ends: Sequence[End]) -> Iterable[tuple[float, tuple[int, ...], Points]]:
        """Give curves that might be drawn: how dear, from which ends, and their points."""
        for k, one in enumerate(ends):
            if (beneath := self._beneath(one)) is not None:
                yield abs(beneath[-1] - beneath[0]), (k,), beneath
            for n, other in enumerate(ends[k + 1 :], k + 1):
                step = self._between(one.at, other.at)
                gap = abs(step)
                if not 0 < gap <= _FARTHEST:
                    continue
                bends = [abs(np.angle(step / one.way)), abs(np.angle(-step / other.way))]
                if max(bends) <= _BEND:
                    curve = _hermite(one.at, gap * one.way, one.at + step, -gap * other.way)
                    yield gap * (1 + sum(bends)), (k, n), curve

    def _between(self, one: complex, other: complex) -> complex:
        step = other - one
        if self._tile:
            width, height = self._size
            across, down = round(step.real / width), round(step.imag / height)
            step -= complex(across * width, down * height)
        return step

    def _beneath(self, end: End) -> Points | None:
        """Return a line from an end on to what hides it, if anything is near that way."""
        line: Points = end.at + np.arange(_BENEATH + end.half + 2) * np.complex128(end.way)
        hit = np.flatnonzero(self._at(self._over, line))
        if not len(hit):
            return None
        return line[: int(hit[0]) + round(end.half) + 2]

    def _at(self, field: NDArray[Any], points: Points) -> NDArray[Any]:
        x, y = np.rint(points.real).astype(int), np.rint(points.imag).astype(int)
        width, height = self._size
        if self._tile:
            y, x = y % height, x % width
        found: NDArray[Any] = field[np.clip(y, 0, height - 1), np.clip(x, 0, width - 1)]
        return found

    def clear(self, curve: Points, ends: Sequence[End]) -> bool:
        """Return whether a curve keeps clear of all but the lines that it goes on."""
        half = max(one.half for one in ends)
        own = np.min([abs(self._apart(curve, one.at)) for one in ends], axis=0) <= 2 * half + 3
        near = self._at(self.distance, curve) < half + 1.5
        return not bool((near & ~own).any())

    def _apart(self, curve: Points, at: complex) -> Points:
        return np.array([self._between(at, one) for one in curve.tolist()])

    def draw(self, curve: Points, half: float) -> None:
        """Draw a curve, so thick."""
        reach = half + CLAMP
        rows, columns = self.distance.shape
        x0, y0 = int(curve.real.min() - reach), int(curve.imag.min() - reach)
        x1, y1 = int(curve.real.max() + reach) + 2, int(curve.imag.max() + reach) + 2
        if not self._tile:
            x0, y0, x1, y1 = max(x0, 0), max(y0, 0), min(x1, columns), min(y1, rows)
        y, x = np.mgrid[y0:y1, x0:x1]
        tree = cKDTree(np.column_stack([curve.real, curve.imag]))
        away, _ = tree.query(np.stack([x, y], axis=2))
        here = y % rows, x % columns
        thick = np.clip(away - half, -CLAMP, CLAMP).astype(np.float32)
        np.minimum.at(self.distance, here, thick)

    def take_out(self, lines: Iterable[Points]) -> None:
        """Take lines out."""
        gone = np.zeros(self.distance.shape, np.bool_)
        width, height = self._size
        for line in lines:
            x, y = line.real.astype(int), line.imag.astype(int)
            gone[y % height, x % width] = True
        if not gone.any():
            return
        margin = int(CLAMP) if self._tile else 0
        ink = np.pad(self.distance < 0, margin, mode="wrap")
        middle, out = skeletonize(ink), np.pad(gone, margin, mode="wrap")
        nearest = ndimage.distance_transform_edt(
            ~(middle | out), return_distances=False, return_indices=True
        )
        stub = ink & out[tuple(nearest)]
        away = np.minimum(ndimage.distance_transform_edt(~(ink & ~stub)) - 0.5, CLAMP)
        stays = np.s_[margin : margin + height, margin : margin + width]
        around = ndimage.binary_dilation(stub, iterations=int(CLAMP))
        gap = np.where(around, away, -CLAMP)[stays]
        self.distance = np.maximum(self.distance, gap).astype(np.float32)


def _hermite(start: complex, leaves: complex, end: complex, arrives: complex) -> Points:
    """Return a cubic from one place to another with these derivatives, a point each half pixel."""
    t = np.linspace(0, 1, max(3, int(2.5 * abs(end - start))))
    u = 1 - t
    curve: Points = (
        u * u * (1 + 2 * t) * start
        + u * u * t * leaves
        + t * t * (1 + 2 * u) * end
        - t * t * u * arrives
    )
    return curve
