"""The error of exemplars in a salient region of the sketch (section 3.3, equation 4)."""

import hashlib
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property, reduce

import numpy as np
from numpy.typing import NDArray

from iconstudio.algorithms.iconification.saliency import Region
from iconstudio.algorithms.iconification.sliding import REACH, STEP, SlidingWindow, Waves
from iconstudio.model import CANVAS

ESTIMATE = np.dtype([("error", "f4"), ("dx", "i2"), ("dy", "i2")])
"""Least error of an exemplar at one scale, mirrored or not, and the translation it is at."""


@dataclass(frozen=True, eq=False)
class Term:
    """A field of the sketch that exemplars are compared with, and how much it counts where."""

    field: NDArray[np.float32]
    """(CANVAS, CANVAS), less ``FAR``."""
    weight: NDArray[np.float32] | None = None
    """(CANVAS, CANVAS); 1 everywhere if None."""

    @cached_property
    def mirrored(self) -> "Term":
        """The mirror image."""
        weight = None if self.weight is None else np.ascontiguousarray(self.weight[:, ::-1])
        return Term(np.ascontiguousarray(self.field[:, ::-1]), weight)


class RegionError:
    """How far exemplars differ from the sketch in one region.

    Parameters
    ----------
    terms
        What is compared: the outline, and what counts beside it. Errors are added up.
    waves
        Those of the exemplars' spectra.
    """

    def __init__(self, terms: Sequence[Term], region: Region, waves: Waves) -> None:
        self._waves = waves
        self._terms = tuple(terms)
        self._down, self._across = region.down, region.across

    @cached_property
    def key(self) -> bytes:
        """Equal for equal masks, and equal fields and weights as far as the mask is above 0."""
        pictures = (one for term in self._terms for one in (term.field, term.weight))
        seen = (
            one[self._down > 0][:, self._across > 0].tobytes() if one is not None else b""
            for one in pictures
        )
        parts = self._down.tobytes(), self._across.tobytes(), *seen
        return hashlib.sha256(b"".join(parts)).digest()

    @cached_property
    def _windows(self) -> list[SlidingWindow]:
        mask = np.outer(self._down, self._across)
        return [
            SlidingWindow(
                self._waves, term.field, mask if term.weight is None else mask * term.weight
            )
            for term in self._terms
        ]

    def estimates(self, spectra: Sequence[NDArray[np.complex64]]) -> NDArray[np.void]:
        """Return the least error of each exemplar, (v, 2) of ``ESTIMATE``.

        ``spectra`` are those of each term's fields.
        """
        errors = (window.errors(one) for window, one in zip(self._windows, spectra, strict=True))
        error, dy, dx = least(reduce(np.add, errors))
        hits = np.zeros(error.shape, ESTIMATE)
        hits["error"] = error
        hits["dy"] = np.rint(dy * STEP - REACH)
        hits["dx"] = np.rint(dx * STEP - REACH)
        hits["dx"][:, 1] *= -1
        return hits

    def error(self, exemplar: Sequence[NDArray[np.float32]], flip: bool, dx: int, dy: int) -> float:
        """Return equation 4 for a placement of an exemplar's fields (n, n) less ``FAR``."""
        total, across = 0.0, self._across[::-1] if flip else self._across
        for term, theirs in zip(self._terms, exemplar, strict=True):
            ours = term.mirrored if flip else term  # instead of the exemplar, which is the same
            difference = ours.field.copy()
            border = (theirs.shape[0] - CANVAS) // 2
            shifts = dy, -dx if flip else dx
            (here_y, there_y), (here_x, there_x) = (_common(border, d) for d in shifts)
            difference[here_y, here_x] -= theirs[there_y, there_x]
            difference *= difference
            if ours.weight is not None:
                difference *= ours.weight
            total += float(self._down @ difference @ across)
        return total

    def follow(
        self, exemplar: Sequence[NDArray[np.float32]], flip: bool, dx: int, dy: int
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
