"""Elements move apart, towards the wider gaps around them (beyond the paper).

As in Lloyd's relaxation, one after another goes, within a few pixels, to where what is nearest to
it is farthest away, until none gains by it.
"""

from collections.abc import Callable, Sequence

import numpy as np
from numpy.typing import NDArray
from scipy import ndimage

Bitmap = NDArray[np.bool_]
Integers = NDArray[np.int64]

_SWEEPS = 6
"""So often each element is looked at, at most."""
_STEP, _FARTHEST = 3, 14
"""Pixels that an element moves at once, and in all, at most."""
_GAIN = 0.2
"""Pixels by which a move widens the gap, at least."""


def spread(
    inks: Sequence[Bitmap],
    places: Integers,
    fixed: Bitmap,
    enough: float,
    allowed: Callable[[int, Integers], bool] = lambda number, place: True,
    ask: Callable[[], None] = lambda: None,
) -> Integers:
    """Return (k, 2) where elements lie once they have moved apart.

    No gap between an element and what is nearest to it gets narrower.

    Parameters
    ----------
    inks
        (n, m) each, of the elements.
    places
        (k, 2), row and column of their rectangles, on a sheet whose opposite borders meet.
    fixed
        (H, W), where nothing may lie.
    enough
        Pixels of a gap that need not get wider.
    allowed
        Whether an element, by its number, may lie in a place.
    """
    sheet = _Sheet(inks, places, fixed, enough)
    resting: set[int] = set()
    for _ in range(_SWEEPS):
        for number in range(len(inks)):
            if number in resting:
                continue
            ask()
            step = sheet.step(number, allowed)
            if step is None:
                resting.add(number)
            else:
                resting -= sheet.move(number, step)
    return sheet.places


class _Sheet:
    """Elements on a sheet."""

    def __init__(
        self, inks: Sequence[Bitmap], places: Integers, fixed: Bitmap, most: float
    ) -> None:
        self.places = places.copy()
        self._begun, self._inks, self._most = places, inks, most
        self._contours = [np.argwhere(ink & ~ndimage.binary_erosion(ink)) for ink in inks]
        self._owner = np.where(fixed, -1, 0).astype(np.int32)
        for number in range(len(inks)):
            self._lay(number)
        self._margin = _STEP + int(np.ceil(most)) + 1

    def step(self, number: int, allowed: Callable[[int, Integers], bool]) -> Integers | None:
        """Return by how much (2,) to move an element; None if it lies well."""
        owner = self._owner[self._around(number, self._margin)]
        others = (owner != 0) & (owner != number + 1)
        if not others.any():
            return None
        away = np.minimum(ndimage.distance_transform_edt(~others), self._most)
        reached = self._contours[number][:, None] + _STEPS + self._margin
        gaps = away[reached[..., 0], reached[..., 1]].min(axis=0)
        there = self.places[number] + _STEPS
        far = ((there - self._begun[number]) ** 2).sum(axis=1) > _FARTHEST**2
        better = np.flatnonzero((gaps >= gaps[0] + _GAIN) & ~far)
        for one in better[np.argsort(-gaps[better], kind="stable")]:
            if allowed(number, there[one]):
                step: Integers = _STEPS[one]
                return step
        return None

    def move(self, number: int, step: Integers) -> set[int]:
        """Move an element; return which ones that concerns."""
        here = self._around(number, 0)
        self._owner[here] = np.where(self._owner[here] == number + 1, 0, self._owner[here])
        self.places[number] += step
        self._lay(number)
        near = np.unique(self._owner[self._around(number, self._margin)])
        return {int(one) - 1 for one in near if one > 0}

    def _lay(self, number: int) -> None:
        at = self._around(number, 0)
        self._owner[at] = np.where(self._inks[number], number + 1, self._owner[at])

    def _around(self, number: int, margin: int) -> tuple[Integers, ...]:
        """Return the index of an element's rectangle, and a margin."""
        sides = zip(
            self.places[number], self._inks[number].shape, self._owner.shape, strict=True
        )  # fmt: skip
        return np.ix_(*(
            np.arange(begin - margin, begin + length + margin) % n for begin, length, n in sides
        ))  # fmt: skip


def _disk() -> Integers:
    """Return the steps (n, 2) that an element may make, the shortest first."""
    steps = np.argwhere(np.ones((2 * _STEP + 1,) * 2)) - _STEP
    length = (steps**2).sum(axis=1)
    order = np.argsort(length, kind="stable")
    short: Integers = steps[order[length[order] <= _STEP**2]]
    return short


_STEPS = _disk()
