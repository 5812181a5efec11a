"""The error of exemplars in a salient region of the sketch (section 3.3, equation 4)."""

import hashlib
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from iconstudio.algorithms.iconification.saliency import Region
from iconstudio.algorithms.iconification.sliding import REACH, STEP, SlidingWindow, Waves
from iconstudio.model import CANVAS

ESTIMATE = np.dtype([("error", "f4"), ("dx", "i2"), ("dy", "i2")])
"""Least error of an exemplar at one scale, mirrored or not, and the translation it is at."""


class RegionError:
    """How far exemplars differ from the sketch in one region.

    Parameters
    ----------
    field
        The sketch's TSDF less ``FAR``.
    waves
        Those of the exemplars' spectra.
    """

    def __init__(self, field: NDArray[np.float32], region: Region, waves: Waves) -> None:
        self._waves = waves
        self._field = field
        self._mirrored = np.ascontiguousarray(field[:, ::-1])
        self._down, self._across = region.down, region.across

    @cached_property
    def key(self) -> bytes:
        """Equal for equal masks and equal fields, as far as the mask is above 0."""
        seen = self._field[self._down > 0][:, self._across > 0]
        parts = self._down, self._across, seen
        return hashlib.sha256(b"".join(part.tobytes() for part in parts)).digest()

    @cached_property
    def _window(self) -> SlidingWindow:
        return SlidingWindow(self._waves, self._field, np.outer(self._down, self._across))

    def estimates(self, spectra: NDArray[np.complex64]) -> NDArray[np.void]:
        """Return the least error of each exemplar, by its spectra: (v, 2) of ``ESTIMATE``."""
        error, dy, dx = least(self._window.errors(spectra))
        hits = np.zeros(error.shape, ESTIMATE)
        hits["error"] = error
        hits["dy"] = np.rint(dy * STEP - REACH)
        hits["dx"] = np.rint(dx * STEP - REACH)
        hits["dx"][:, 1] *= -1
        return hits

    def error(self, exemplar: NDArray[np.float32], flip: bool, dx: int, dy: int) -> float:
        """Return equation 4 for a placement of an exemplar's field (n, n) less ``FAR``."""
        field, across = self._field, self._across
        if flip:  # the sketch instead, which is the same
            field, across, dx = self._mirrored, across[::-1], -dx
        difference = field.copy()
        border = (exemplar.shape[0] - CANVAS) // 2
        (here_y, there_y), (here_x, there_x) = (_common(border, d) for d in (dy, dx))
        difference[here_y, here_x] -= exemplar[there_y, there_x]
        difference *= difference
        return float(self._down @ difference @ across)

    def follow(
        self, exemplar: NDArray[np.float32], flip: bool, dx: int, dy: int
    ) -> tuple[float, int, int]:
        """Return the least error near a translation, and where it is: go downhill until at home."""
        known: dict[tuple[int, int], float] = {}
        while True:
            around = [(x, y) for y in (dy - 1, dy, dy + 1) for x in (dx - 1, dx, dx + 1)]
            for x, y in around:
                if (x, y) not in known:
                    known[x, y] = self.error(exemplar, flip, x, y)
            best = min(around, key=lambda at: (known[at], at))
            if known[best] == known[dx, dy]:
                return known[dx, dy], dx, dy
            dx, dy = best


def _common(border: int, shift: int) -> tuple[slice, slice]:
    """Return where the canvas meets a field moved by ``shift``: in the canvas, in the field."""
    first = max(0, shift - border)
    last = max(first, min(CANVAS, CANVAS + border + shift))
    return slice(first, last), slice(first + border - shift, last + border - shift)


def least(
    errors: NDArray[np.float32],
) -> tuple[NDArray[np.float32], NDArray[np.float32], NDArray[np.float32]]:
    """Return the least values of surfaces (..., h, w), and where they are: value, y, x.

    Between the samples a surface is taken for a paraboloid.
    """
    *shape, height, width = errors.shape
    surfaces = errors.reshape(-1, height * width)
    nth, at = np.arange(len(surfaces)), surfaces.argmin(axis=1)
    y, x = at // width, at % width
    middle = np.clip(y, 1, height - 2) * width + np.clip(x, 1, width - 2)

    def value(dy: int, dx: int) -> NDArray[np.float32]:
        there: NDArray[np.float32] = surfaces[nth, middle + dy * width + dx]
        return there

    centre = value(0, 0)
    slope_x, slope_y = (value(0, 1) - value(0, -1)) / 2, (value(1, 0) - value(-1, 0)) / 2
    bend_x = value(0, 1) + value(0, -1) - 2 * centre
    bend_y = value(1, 0) + value(-1, 0) - 2 * centre
    twist = (value(1, 1) + value(-1, -1) - value(1, -1) - value(-1, 1)) / 4
    bowl = bend_x * bend_y - twist**2
    sound = (middle == at) & (bend_x > 0) & (bowl > 0)
    bowl = np.where(sound, bowl, 1)
    off_x = np.where(sound, (twist * slope_y - bend_y * slope_x) / bowl, 0).clip(-1, 1)
    off_y = np.where(sound, (twist * slope_x - bend_x * slope_y) / bowl, 0).clip(-1, 1)
    lowest = surfaces[nth, at] + (slope_x * off_x + slope_y * off_y) / 2
    return lowest.reshape(shape), (y + off_y).reshape(shape), (x + off_x).reshape(shape)
