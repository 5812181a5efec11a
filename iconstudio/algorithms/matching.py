"""Sliding-window matching (section 3.3, equation 4; Appendix A, equations 12 to 16).

Every exemplar is tried at every translation, mirrored or not, at every scale, against every salient
region. The exhaustive search runs on fields reduced by ``COARSEN``; its best exemplars are then
followed up to full resolution, so that the errors that rank them are equation 4 to the letter.
"""

import math
from collections.abc import Callable, Generator, Iterable, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from iconstudio.algorithms import fft
from iconstudio.algorithms.raster import scaled_ink, shifted, solid
from iconstudio.algorithms.saliency import Region
from iconstudio.algorithms.style import blackness
from iconstudio.algorithms.tsdf import D_MAX, tsdf
from iconstudio.model import CANVAS, MARGIN, Exemplar, Placement, Source

MATCHES = 3
"""How many different pictograms each region keeps."""
SCALES = (0.9, 1.0, 1.1)
COARSEN = 4
"""The exhaustive search sees every 4 x 4 pixels as one."""
SHORTLIST = 24
"""How many variants of exemplars are followed up to full resolution in each region."""
REACH = 2
"""How far around a coarse match the next finer resolution looks, in its pixels."""
HIT = np.dtype([("error", "f4"), ("dx", "i2"), ("dy", "i2")])
"""The best coarse match of one variant in one region: its error and translation."""
FAR = np.float32(D_MAX / CANVAS)
"""The field's value far outside: fields are stored less this, so that zero padding is exact."""


@dataclass(frozen=True, eq=False)
class Variant:
    """An exemplar at one scale, mirrored or not, before translation.

    ``field`` is its TSDF less ``FAR``, (CANVAS + 2 pad,) * 2 float32; ``coarse`` is the same,
    averaged over blocks of ``COARSEN`` pixels.
    """

    scale: float
    flip: bool
    field: NDArray[np.float32]
    coarse: NDArray[np.float32]


@dataclass(frozen=True, eq=False)
class PreparedExemplar:
    """All that matching needs of an exemplar and that no sketch changes."""

    exemplar: Exemplar
    blackness: float
    variants: tuple[Variant, ...]


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
    return COARSEN * max(1, math.ceil((reach - CANVAS / 2) / COARSEN))


def prepare(exemplar: Exemplar, scales: Sequence[float] = SCALES) -> PreparedExemplar:
    """Compute an exemplar's blackness and the distance fields of all its variants."""
    pad = padding(scales)
    inks = np.stack([scaled_ink(exemplar, scale, pad) for scale in scales])
    fields = tsdf(np.stack([solid(ink) for ink in inks])) - FAR
    variants = []
    for scale, field in zip(scales, fields, strict=True):
        coarse = reduced(field)
        variants.append(Variant(scale, False, field, coarse))
        variants.append(Variant(scale, True, field[:, ::-1], coarse[:, ::-1]))
    return PreparedExemplar(exemplar, blackness(exemplar.ink), tuple(variants))


def reduced(field: NDArray[np.float32], factor: int = COARSEN) -> NDArray[np.float32]:
    """Return the means of blocks of ``factor`` x ``factor`` pixels."""
    n = field.shape[0] // factor
    return field.reshape(n, factor, n, factor).mean(axis=(1, 3))


class SlidingWindow:
    """Equation 4 for one field of the sketch and several masks, by the Fourier transform.

    With A the exemplar's and B the sketch's field, both less ``FAR`` so that they vanish far
    outside, equation 12 reads sum M A^2 - 2 sum M B A + sum M B^2: two correlations, joined in one
    inverse transform, and a constant.

    Parameters
    ----------
    field
        (n, n) float32, the sketch's TSDF less ``FAR``.
    masks
        (r, n, n) float32, the regions' masks.
    side
        Side of the exemplars' fields, in the same pixels; at least n.
    """

    def __init__(self, field: NDArray[np.float32], masks: NDArray[np.float32], side: int) -> None:
        self.count = len(masks)
        self.side = side
        self.offset = (side - field.shape[0]) // 2
        self.size = fft.fast_size(field.shape[0] + side - 1)
        self._mask = fft.forward(masks, self.size)
        self._mask_field = -2 * fft.forward(masks * field, self.size)
        self._constant = (masks * field**2).sum(axis=(1, 2))

    def errors(self, exemplar: NDArray[np.float32]) -> NDArray[np.float32]:
        """Return the error at every translation, (r, size, size) float32.

        ``errors[k, y, x]`` belongs to the translation that ``translation(y, x)`` names.
        """
        both = fft.forward(np.stack([exemplar, exemplar**2]), self.size)
        both = both.conj()
        spectra = self._mask * both[1]
        spectra += self._mask_field * both[0]
        return fft.inverse(spectra, self.size) + self._constant[:, None, None]

    def translation(self, y: int, x: int) -> tuple[int, int]:
        """Return (dx, dy), in the field's pixels, for a position in ``errors``."""

        def signed(position: int) -> int:
            # Positions count the shift of the exemplar's corner, modulo the transform's size.
            shift = position if position < self.size - self.side + 1 else position - self.size
            return shift + self.offset

        return signed(x), signed(y)


def direct_error(
    field: NDArray[np.float32],
    mask: NDArray[np.float32],
    exemplar: NDArray[np.float32],
    dx: int,
    dy: int,
) -> float:
    """Return equation 4 for one translation, summed as it is written."""
    moved = shifted(exemplar, dx, dy, field.shape[0], np.float32(0))
    difference = moved - field
    return float(np.einsum("ij,ij,ij->", mask, difference, difference))


def coarse_search(
    sketch_field: NDArray[np.float32],
    regions: Sequence[Region],
    exemplars: Sequence[PreparedExemplar],
) -> Generator[float, None, NDArray[np.void]]:
    """Try every exemplar at every translation, on reduced fields; yield the part that is done.

    Parameters
    ----------
    sketch_field
        The sketch's TSDF, (CANVAS, CANVAS) float32.

    Returns
    -------
    (regions, exemplars, variants) records of ``HIT``, translations in blocks of ``COARSEN`` pixels
    """
    count = len(exemplars[0].variants) if exemplars else 0
    hits = np.zeros((len(regions), len(exemplars), count), dtype=HIT)
    if not exemplars:
        return hits
    masks = np.stack([reduced(region.mask) for region in regions])
    window = SlidingWindow(
        reduced(sketch_field - FAR), masks, exemplars[0].variants[0].coarse.shape[0]
    )
    for index, prepared in enumerate(exemplars):
        for number, variant in enumerate(prepared.variants):
            hits[:, index, number] = _least_errors(window, variant.coarse)
        yield (index + 1) / len(exemplars)
    return hits


def refine(
    sketch_field: NDArray[np.float32],
    regions: Sequence[Region],
    exemplars: Sequence[PreparedExemplar],
    hits: NDArray[np.void],
    admitted: Sequence[int],
    *,
    keep: int = SHORTLIST,
) -> list[list[Match]]:
    """Return the best matches of every region among the ``admitted`` exemplars.

    The ``keep`` best variants of the coarse search are followed up to full resolution.

    Returns
    -------
    list
        ``matches[region]``: matches of different exemplars by rising error.
    """
    field = sketch_field - FAR
    chosen = np.array(admitted, dtype=int)
    matches = []
    for region, row in zip(regions, hits, strict=True):
        errors = row["error"][chosen]
        best: dict[int, Match] = {}
        for position in np.argsort(errors, axis=None, kind="stable")[:keep]:
            nth, number = divmod(int(position), errors.shape[1])
            index = int(chosen[nth])
            variant = exemplars[index].variants[number]
            match = _follow(field, region.mask, variant, index, row[index, number])
            if index not in best or match.error < best[index].error:
                best[index] = match
        matches.append(sorted(best.values(), key=lambda m: (m.error, m.index)))
    return matches


def _least_errors(window: SlidingWindow, coarse: NDArray[np.float32]) -> NDArray[np.void]:
    """Return for each region the least error of one variant, as records of ``HIT``."""
    flat = window.errors(coarse).reshape(window.count, -1)
    at = flat.argmin(axis=1)
    hits = np.zeros(len(flat), dtype=HIT)
    hits["error"] = flat[np.arange(len(flat)), at]
    for hit, position in zip(hits, at, strict=True):
        hit["dx"], hit["dy"] = window.translation(*divmod(int(position), window.size))
    return hits


def _follow(
    field: NDArray[np.float32],
    mask: NDArray[np.float32],
    variant: Variant,
    index: int,
    hit: np.void,
) -> Match:
    """Follow a coarse match to full resolution: halve the pixels, go downhill, twice."""
    error, dx, dy = math.inf, int(hit["dx"]), int(hit["dy"])
    factor = COARSEN
    while factor > 1:
        factor //= 2
        small = [reduced(a, factor) if factor > 1 else a for a in (field, mask, variant.field)]
        error, dx, dy = _downhill(lambda x, y, s=small: direct_error(*s, x, y), 2 * dx, 2 * dy)
    return Match(index, Placement(variant.scale, variant.flip, dx, dy), error)


def _downhill(error_at: Callable[[int, int], float], dx: int, dy: int) -> tuple[float, int, int]:
    """Return the least error and its translation: look around, go to the best, until at home."""
    known: dict[tuple[int, int], float] = {}
    while True:
        around = [
            (x, y)
            for y in range(dy - REACH, dy + REACH + 1)
            for x in range(dx - REACH, dx + REACH + 1)
        ]
        for at in around:
            if at not in known:
                known[at] = error_at(*at)
        best = min(around, key=lambda at: (known[at], at))
        if known[best] == known[dx, dy]:
            return known[dx, dy], dx, dy
        dx, dy = best


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
