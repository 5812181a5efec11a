"""Sliding-window matching (section 3.3, equation 4; Appendix A).

Every exemplar is tried at every scale, mirrored or not, at every translation, against every salient
region. ``sliding`` estimates the errors of all of them; the best are then followed to the exact
place, so that the errors that rank them are equation 4 to the letter.
"""

import math
import os
import threading
from collections import OrderedDict, defaultdict
from collections.abc import Generator, Iterable, Sequence
from concurrent.futures import FIRST_COMPLETED, ThreadPoolExecutor, wait
from dataclasses import dataclass
from dataclasses import field as made_by

import numpy as np
from numpy.typing import NDArray

from iconstudio.algorithms.iconification.guide import UNGUIDED, Channel, Guide
from iconstudio.algorithms.iconification.region_error import ESTIMATE, RegionError, Term
from iconstudio.algorithms.iconification.saliency import Region
from iconstudio.algorithms.iconification.sliding import Waves, spectra_of
from iconstudio.algorithms.iconification.style import blackness
from iconstudio.algorithms.iconification.tsdf import D_MAX, distances, squared_distances, tsdf
from iconstudio.algorithms.raster import Bitmap, scaled_ink, solid
from iconstudio.model import CANVAS, MARGIN, Exemplar, Placement, Source

MATCHES = 3
"""How many different pictograms each region keeps."""
SCALES = (0.9, 1.0, 1.1)
LARGER_SCALES = (0.8, *SCALES, 1.25)
"""Those of the tandem bicycle (section 6), which sometimes yield implausible results."""
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


class InnerFields:
    """The fields of a channel, of exemplars of which the outlines are prepared.

    Few sketches need any, so they are made when they are asked for: the spectra of whole chunks at
    a time. These are kept, and the pictures of which the fields hold the distances.
    """

    def __init__(self, channel: Channel, exemplars: Sequence[PreparedExemplar]) -> None:
        self._channel, self._exemplars = channel, exemplars
        self._pictures: dict[int, list[Bitmap]] = {}
        self._spectra: dict[int, NDArray[np.complex64]] = {}
        self._locks: defaultdict[int, threading.Lock] = defaultdict(threading.Lock)

    def field(self, number: int, scale: int) -> NDArray[np.float32]:
        """Return the field of an exemplar at the scale of this number, less ``FAR``, (n, n)."""
        return self._field(self._scaled(number)[scale])

    def spectra(self, chunk: int) -> NDArray[np.complex64]:
        """Return the spectra of a chunk of exemplars, as those of ``PreparedExemplar``."""
        with self._locks[chunk]:
            if chunk not in self._spectra:
                numbers = range(len(self._exemplars))[chunk * CHUNK : (chunk + 1) * CHUNK]
                self._spectra[chunk] = np.concatenate(list(map(self._spectra_of, numbers)), axis=1)
            return self._spectra[chunk]

    def _field(self, pictures: Bitmap) -> NDArray[np.float32]:
        return tsdf(pictures, outside_only=self._channel.outside_only) - FAR

    def _spectra_of(self, number: int) -> NDArray[np.complex64]:
        fields = self._field(np.stack(self._scaled(number)))
        return spectra_of(Waves(fields.shape[-1]), fields)

    def _scaled(self, number: int) -> list[Bitmap]:
        if number not in self._pictures:
            one = self._exemplars[number]
            picture = np.where(self._channel.pictures(one.exemplar.ink), np.uint8(255), np.uint8(0))
            pad = padding(one.scales)
            self._pictures[number] = [scaled_ink(picture, scale, pad) for scale in one.scales]
        return self._pictures[number]


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
        self._inner: dict[Channel, InnerFields] = {}

    def match(
        self,
        field: NDArray[np.float32],
        regions: Sequence[Region],
        admitted: Sequence[int],
        guide: Guide = UNGUIDED,
    ) -> Generator[float, None, list[list[Match]]]:
        """Find the ``MATCHES`` best exemplars of each region; yield the part that is done.

        Closing the generator ends its threads.

        Parameters
        ----------
        field
            The sketch's TSDF, (CANVAS, CANVAS) float32.
        admitted
            Numbers of the exemplars that may be used.
        guide
            What counts beside the outline.

        Returns
        -------
        list
            ``matches[region]``: the best placements of different exemplars, by rising error.
        """
        channels = tuple(aim.channel for aim in guide.aims)
        run = _Search(np.array(sorted(set(admitted)), dtype=int), channels)
        terms = [
            Term(field - FAR, guide.weight),
            *(Term(aim.field - FAR, aim.weight) for aim in guide.aims),
        ]
        region_errors = [RegionError(terms, region, self._waves) for region in regions]
        with ThreadPoolExecutor(self._threads, "match") as threads:
            for channel in run.channels:  # each region needs all chunks
                for chunk in run.chunks:
                    threads.submit(self._inner_fields(channel).spectra, chunk)
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
        for chunk in sorted(run.chunks - found.chunks):
            if run.stopped:
                return []
            hits = found.hits[chunk * CHUNK : (chunk + 1) * CHUNK]
            spectra = [self._chunks[chunk]]
            spectra += [self._inner_fields(one).spectra(chunk) for one in run.channels]
            hits[:] = region_error.estimates(spectra).reshape(hits.shape)
            found.chunks.add(chunk)
        return self._best(region_error, found, run)

    def _inner_fields(self, channel: Channel) -> "InnerFields":
        with self._lock:
            return self._inner.setdefault(channel, InnerFields(channel, self.exemplars))

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
                match = self._followed(region_error, index, variant, hit, run)
                found.followed[index, variant] = match
            known = best.get(index, match)
            best[index] = min(known, match, key=lambda m: (m.error, m.placement))
        return sorted(best.values(), key=lambda m: (m.error, m.index))[:MATCHES]

    def _followed(
        self, region_error: RegionError, index: int, variant: int, hit: np.void, run: "_Search"
    ) -> Match:
        """Return the exact match of an estimate."""
        fields = run.fields
        (scale, flip), one = divmod(variant, 2), self.exemplars[index]
        if (index, scale) not in fields:
            inner = (self._inner_fields(channel) for channel in run.channels)
            fields[index, scale] = [one.field(scale), *(some.field(index, scale) for some in inner)]
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


_Fields = dict[tuple[int, int], list[NDArray[np.float32]]]
"""Distance fields by exemplar and scale: the outline's, and those of the channels of the guide."""


@dataclass(eq=False)
class _Search:
    """What the threads of one run share."""

    chosen: NDArray[np.int64]
    """Numbers of the exemplars that may be used."""
    channels: tuple[Channel, ...]
    """What counts beside the outline."""
    fields: _Fields = made_by(default_factory=dict)
    """Those that were needed so far."""
    stopped: bool = False

    @property
    def chunks(self) -> set[int]:
        """Which chunks these exemplars are in."""
        return {int(index) // CHUNK for index in self.chosen}


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
