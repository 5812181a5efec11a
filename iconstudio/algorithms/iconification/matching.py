"""Sliding-window matching (section 3.3, equation 4; Appendix A).

Every exemplar is tried at every scale, mirrored or not, at every translation, against every salient
region. ``sliding`` estimates the errors of all of them; the best are then followed to the exact
place, so that the errors that rank them are equation 4 to the letter.
"""

import math
import os
import threading
from collections import OrderedDict
from collections.abc import Generator, Iterable, Sequence
from concurrent.futures import FIRST_COMPLETED, ThreadPoolExecutor, wait
from dataclasses import dataclass
from dataclasses import field as made_by

import numpy as np
from numpy.typing import NDArray

from iconstudio.algorithms.iconification.region_error import ESTIMATE, RegionError
from iconstudio.algorithms.iconification.saliency import Region
from iconstudio.algorithms.iconification.sliding import Waves, spectra_of
from iconstudio.algorithms.iconification.style import blackness
from iconstudio.algorithms.iconification.tsdf import D_MAX, distances, squared_distances
from iconstudio.algorithms.raster import scaled_ink, solid
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
_TICK = 0.02
"""At least so often a run says how far it is, in seconds."""


@dataclass(frozen=True, eq=False)
class PreparedExemplar:
    """All that matching needs of an exemplar and that no sketch changes.

    Attributes
    ----------
    squared
        (scales, n, n) int8: for each scale its TSDF as ``squared_distances``, on a canvas large
        enough to keep it whole.
    spectra
        (x waves, scales, 2 y waves) complex64: see ``sliding.spectra_of``.
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
    inks = [scaled_ink(exemplar.coverage, scale, pad) for scale in scales]
    fields = squared_distances(np.stack([solid(ink) for ink in inks]))
    squared = fields.astype(np.int8, copy=False)  # as it is, up to D_MAX
    spectra = spectra_of(Waves(squared.shape[-1]), distances(squared) - FAR)
    return PreparedExemplar(exemplar, blackness(exemplar.ink), tuple(scales), squared, spectra)


class Matcher:
    """The exemplars of a keyword, and what was found in regions that have not changed since.

    It may be used from several threads at once. What it answers does not depend on what it
    remembers.

    Parameters
    ----------
    strangers
        Identifiers of exemplars that are to serve only where there are too few others.
    """

    def __init__(
        self,
        exemplars: Sequence[PreparedExemplar],
        threads: int = os.cpu_count() or 1,
        strangers: frozenset[str] = frozenset(),
    ) -> None:
        self.exemplars = tuple(exemplars)
        self.strangers = strangers
        self._threads = threads
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

        Closing the generator ends its threads.

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
        run = _Search(np.array(sorted(set(admitted)), dtype=int))
        region_errors = [RegionError(field - FAR, region, self._waves) for region in regions]
        with ThreadPoolExecutor(self._threads, "match") as threads:
            futures = [
                threads.submit(self._matches, region_error, run) for region_error in region_errors
            ]
            pending = set(futures)
            try:
                while pending:
                    _, pending = wait(pending, _TICK, FIRST_COMPLETED)
                    yield 1 - len(pending) / len(futures)
            finally:
                run.stopped = True
                threads.shutdown(wait=False, cancel_futures=True)
        return [future.result() for future in futures]

    def _matches(self, region_error: RegionError, run: "_Search") -> list[Match]:
        """Return the best matches of one region; nothing once the run is stopped."""
        found = self._recall(region_error.key)
        for chunk in sorted({int(index) // CHUNK for index in run.chosen} - found.chunks):
            if run.stopped:
                return []
            hits = found.hits[chunk * CHUNK : (chunk + 1) * CHUNK]
            hits[:] = region_error.estimates(self._chunks[chunk]).reshape(hits.shape)
            found.chunks.add(chunk)
        return self._best(region_error, found, run)

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

    def _best(self, region_error: RegionError, found: "_Found", run: "_Search") -> list[Match]:
        """Follow the most promising estimates until no other can be among the best."""
        hits = found.hits[run.chosen]
        best: dict[int, Match] = {}
        for nth, variant in _by_rising_error(hits):
            index, hit = int(run.chosen[nth]), hits[nth, variant]
            if run.stopped or hit["error"] > _hopeless(best.values()):
                break
            match = found.followed.get((index, variant))
            if match is None:
                match = self._followed(region_error, index, variant, hit, run.fields)
                found.followed[index, variant] = match
            known = best.get(index, match)
            best[index] = min(known, match, key=lambda m: (m.error, m.placement))
        return sorted(best.values(), key=lambda m: (m.error, m.index))[:MATCHES]

    def _followed(
        self, region_error: RegionError, index: int, variant: int, hit: np.void, fields: "_Fields"
    ) -> Match:
        """Return the exact match of an estimate."""
        (scale, flip), one = divmod(variant, 2), self.exemplars[index]
        if (index, scale) not in fields:
            fields[index, scale] = one.field(scale)
        error, dx, dy = region_error.follow(
            fields[index, scale], bool(flip), int(hit["dx"]), int(hit["dy"])
        )
        return Match(index, Placement(one.scales[scale], bool(flip), dx, dy), error)


def _by_rising_error(hits: NDArray[np.void]) -> list[tuple[int, int]]:
    """Return the positions in ``hits`` (n, variants), the least error first."""
    order = np.argsort(hits["error"], axis=None, kind="stable")
    rows, columns = np.unravel_index(order, hits.shape)
    return list(zip(rows.tolist(), columns.tolist(), strict=True))


def _hopeless(best: Iterable[Match]) -> float:
    """Return the estimate beyond which no exemplar can come before the last of the best."""
    errors = sorted(match.error for match in best)
    return errors[MATCHES - 1] * (1 + DOUBT[0]) + DOUBT[1] if len(errors) >= MATCHES else math.inf


_Fields = dict[tuple[int, int], NDArray[np.float32]]
"""Distance fields by exemplar and scale."""


@dataclass(eq=False)
class _Search:
    """What the threads of one run share."""

    chosen: NDArray[np.int64]
    """Numbers of the exemplars that may be used."""
    fields: _Fields = made_by(default_factory=dict)
    """Those that were needed so far."""
    stopped: bool = False


@dataclass(frozen=True, eq=False)
class _Found:
    """What was found in one region. Threads may write the same at the same time."""

    hits: NDArray[np.void]
    """(exemplars, variants) of ``ESTIMATE``; a variant is a scale, mirrored or not."""
    chunks: set[int] = made_by(default_factory=set)
    """Which chunks of ``hits`` are there."""
    followed: dict[tuple[int, int], Match] = made_by(default_factory=dict)
    """Exact matches by exemplar and variant."""


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
