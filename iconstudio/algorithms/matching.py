"""Sliding-window matching (section 3.3, equation 4; Appendix A).

Every exemplar is tried at every scale, mirrored or not, at every translation, against every salient
region. ``sliding`` estimates the errors of all of them; the best are then followed to the exact
place, so that the errors that rank them are equation 4 to the letter.
"""

import hashlib
import math
import threading
from collections import OrderedDict
from collections.abc import Generator, Iterable, Sequence
from dataclasses import dataclass
from dataclasses import field as made_by
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from iconstudio.algorithms.raster import scaled_ink, solid
from iconstudio.algorithms.saliency import Region
from iconstudio.algorithms.sliding import REACH, STEP, SlidingWindow, Waves, told
from iconstudio.algorithms.style import blackness
from iconstudio.algorithms.tsdf import D_MAX, distances, squared_distances
from iconstudio.model import CANVAS, MARGIN, Exemplar, Placement, Source

MATCHES = 3
"""How many different pictograms each region keeps."""
SCALES = (0.9, 1.0, 1.1)
FAR = np.float32(D_MAX / CANVAS)
"""The field's value far outside: fields are matched less this, so that they vanish there."""
DOUBT = 0.02, 0.025
"""By how much an estimate may exceed the exact error: a part of it, and an amount. With these, 396
of 396 regions of 44 sketches keep the pictograms of the exhaustive search."""
CHUNK = 32
"""How many exemplars are estimated at once; always the same together, so that rounding is too."""
REMEMBERED = 64
"""How many regions a ``Matcher`` remembers."""
ESTIMATE = np.dtype([("error", "f4"), ("dx", "i2"), ("dy", "i2")])
"""Least error of an exemplar at one scale, mirrored or not, and the translation it is at."""


@dataclass(frozen=True, eq=False)
class PreparedExemplar:
    """All that matching needs of an exemplar and that no sketch changes.

    Attributes
    ----------
    squared
        (scales, n, n) int8: for each scale its TSDF as ``squared_distances``, on a canvas large
        enough to keep it whole.
    spectra
        (x waves, scales, 2 y waves) complex64: see ``sliding.told``.
    """

    exemplar: Exemplar
    blackness: float
    scales: tuple[float, ...]
    squared: NDArray[np.int8]
    spectra: NDArray[np.complex64]

    def field(self, scale: int) -> NDArray[np.float32]:
        """Return the TSDF at the scale of this number, less ``FAR``, (n, n)."""
        return distances(self.squared[scale]) - FAR


@dataclass(frozen=True, slots=True)
class Match:
    """The best placement of one exemplar in one region, and its error (equation 4)."""

    index: int
    """Position in the list of exemplars."""
    placement: Placement
    error: float


def padding(scales: Iterable[float]) -> int:
    """Return the border that keeps an exemplar whole, band included, at the largest scale."""
    reach = (CANVAS / 2 - MARGIN) * max(scales) + D_MAX
    return max(0, math.ceil(reach - CANVAS / 2))


def prepare(exemplar: Exemplar, scales: Sequence[float] = SCALES) -> PreparedExemplar:
    """Compute an exemplar's blackness, and its distance field and spectra at all scales."""
    pad = padding(scales)
    inks = [scaled_ink(exemplar, scale, pad) for scale in scales]
    squared = squared_distances(np.stack([solid(ink) for ink in inks]))
    spectra = told(Waves(squared.shape[-1]), distances(squared) - FAR)
    return PreparedExemplar(exemplar, blackness(exemplar.ink), tuple(scales), squared, spectra)


class Matcher:
    """The exemplars of a keyword, and what was found in regions that have not changed since.

    It may be used from several threads at once. What it answers does not depend on what it
    remembers.
    """

    def __init__(self, exemplars: Sequence[PreparedExemplar]) -> None:
        self.exemplars = tuple(exemplars)
        self._chunks = [
            np.concatenate([one.spectra for one in self.exemplars[start : start + CHUNK]], axis=1)
            for start in range(0, len(self.exemplars), CHUNK)
        ]
        self._waves = Waves(self.exemplars[0].squared.shape[-1] if self.exemplars else CANVAS)
        self._memory: OrderedDict[bytes, _Found] = OrderedDict()
        self._lock = threading.Lock()

    def match(
        self, field: NDArray[np.float32], regions: Sequence[Region], admitted: Sequence[int]
    ) -> Generator[float, None, list[list[Match]]]:
        """Find the ``MATCHES`` best exemplars of each region; yield the part that is done.

        Parameters
        ----------
        field
            The sketch's TSDF, (CANVAS, CANVAS) float32.
        admitted
            Numbers of the exemplars that may be used.

        Returns
        -------
        list
            ``matches[region]``: the best placements of different exemplars, by rising error.
        """
        chosen = np.array(sorted(set(admitted)), dtype=int)
        fields: dict[tuple[int, int], NDArray[np.float32]] = {}
        matches: list[list[Match]] = []
        for number, region in enumerate(regions):
            target = Target(field - FAR, region, self._waves)
            found = self._recall(target.key)
            for part in self._estimate(target, found, chosen):
                yield (number + part) / len(regions)
            matches.append(self._best(target, found, chosen, fields))
            yield (number + 1) / len(regions)
        return matches

    def _recall(self, key: bytes) -> "_Found":
        """Return what is known of a region: at first nothing."""
        with self._lock:
            found = self._memory.pop(key, None)
            if found is None:
                variants = 2 * len(self.exemplars[0].scales) if self.exemplars else 0
                found = _Found(np.zeros((len(self.exemplars), variants), ESTIMATE))
            self._memory[key] = found
            while len(self._memory) > REMEMBERED:
                self._memory.popitem(last=False)
        return found

    def _estimate(
        self, target: "Target", found: "_Found", chosen: NDArray[np.int64]
    ) -> Generator[float, None, None]:
        """Estimate the errors of all chunks that hold a chosen exemplar; yield the part done."""
        needed = sorted({int(index) // CHUNK for index in chosen})
        for done, chunk in enumerate(needed, start=1):
            if chunk not in found.chunks:
                hits = found.hits[chunk * CHUNK : (chunk + 1) * CHUNK]
                hits[:] = target.estimates(self._chunks[chunk]).reshape(hits.shape)
                found.chunks.add(chunk)
                yield done / (len(needed) + 1)

    def _best(
        self,
        target: "Target",
        found: "_Found",
        chosen: NDArray[np.int64],
        fields: dict[tuple[int, int], NDArray[np.float32]],
    ) -> list[Match]:
        """Follow the most promising estimates until no other can be among the best.

        ``fields`` keeps the exemplars' distance fields at the scales that were needed.
        """
        hits = found.hits[chosen]
        best: dict[int, Match] = {}
        for nth, variant in _by_rising_error(hits):
            index, hit = int(chosen[nth]), hits[nth, variant]
            if hit["error"] > _hopeless(best.values()):
                break
            match = found.followed.get((index, variant))
            if match is None:
                (scale, flip), one = divmod(variant, 2), self.exemplars[index]
                if (index, scale) not in fields:
                    fields[index, scale] = one.field(scale)
                error, dx, dy = target.follow(
                    fields[index, scale], bool(flip), int(hit["dx"]), int(hit["dy"])
                )
                match = Match(index, Placement(one.scales[scale], bool(flip), dx, dy), error)
                found.followed[index, variant] = match
            known = best.get(index, match)
            best[index] = min(known, match, key=lambda m: (m.error, m.placement))
        return sorted(best.values(), key=lambda m: (m.error, m.index))[:MATCHES]


def _by_rising_error(hits: NDArray[np.void]) -> list[tuple[int, int]]:
    """Return the positions in ``hits`` (n, variants), the least error first."""
    order = np.argsort(hits["error"], axis=None, kind="stable")
    rows, columns = np.unravel_index(order, hits.shape)
    return list(zip(rows.tolist(), columns.tolist(), strict=True))


def _hopeless(best: Iterable[Match]) -> float:
    """Return the estimate beyond which no exemplar can come before the last of the best."""
    errors = sorted(match.error for match in best)
    return errors[MATCHES - 1] * (1 + DOUBT[0]) + DOUBT[1] if len(errors) >= MATCHES else math.inf


@dataclass(frozen=True, eq=False)
class _Found:
    """What was found in one region. Threads may write the same at the same time."""

    hits: NDArray[np.void]
    """(exemplars, variants) of ``ESTIMATE``; a variant is a scale, mirrored or not."""
    chunks: set[int] = made_by(default_factory=set)
    """Which chunks of ``hits`` are there."""
    followed: dict[tuple[int, int], Match] = made_by(default_factory=dict)
    """Exact matches by exemplar and variant."""


class Target:
    """A region of the sketch: what exemplars are compared with.

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
        return hashlib.blake2b(b"".join(part.tobytes() for part in parts)).digest()

    @cached_property
    def _window(self) -> SlidingWindow:
        return SlidingWindow(self._waves, self._field, np.outer(self._down, self._across))

    def estimates(self, spectra: NDArray[np.complex64]) -> NDArray[np.void]:
        """Return the least errors of exemplars, as ``told``: (v, 2) of ``ESTIMATE``."""
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
        return surfaces[nth, middle + dy * width + dx]

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


def sources_of(
    matches: Sequence[Sequence[Match]], exemplars: Sequence[PreparedExemplar], count: int = MATCHES
) -> tuple[tuple[Source, ...], ...]:
    """Return the ``count`` best matches of each region as sources (section 3.3)."""
    return tuple(
        tuple(
            Source(exemplars[m.index].exemplar, m.placement, m.error, region) for m in row[:count]
        )
        for region, row in enumerate(matches)
    )
