"""Drawing a labelling at high resolution, without visible seams.

The label map says who owns each pixel of the canvas; the owners are drawn anew from their SVG at
a multiple of its resolution. Where two sources meet and disagree, their signed distance fields are
cross-faded over a few canvas pixels, so that the contour of one runs smoothly into the other's.
The paper (section 3.4, post-processing) traces the 256-pixel bitmap instead, which shows its
staircases.

Most pixels are their owner's: distances are found where owners disagree, and only where the faded
contour may run.
"""

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
import scipy
from numpy.typing import NDArray

from iconstudio.algorithms.iconification.blending import (
    Blocks,
    SoftRegion,
    at,
    enlarged,
    in_blocks,
    regions,
    soft_regions,
    spread,
)
from iconstudio.algorithms.iconification.energy import Labels
from iconstudio.model import CANVAS

SCALE = 4
"""Drawn pixels to a canvas pixel, in finished drawings."""
FADE = 2.0
"""Standard deviation, in canvas pixels, of the cross-fade across a seam."""
REACH = 7
"""How far, in canvas pixels, an owner's share reaches beyond its region."""
FAR = 8
"""Contours further away, in canvas pixels, are as good as so far."""
_AGREED = 1e-3
_ROUGH = 1.5
"""Drawn pixels by which a signed distance may differ between two pixels beyond how far these are
apart: contours are known where they cross between pixels."""


@dataclass(frozen=True, eq=False)
class _Contribution:
    """What one owner contributes to the pixels in doubt."""

    coverage: NDArray[np.uint8]
    rows: NDArray[np.intp]
    """(b,): the numbers of the blocks that it has a share of."""
    weights: NDArray[np.float32]
    """(b, s, s): its share of each of their pixels."""


def redraw(labels: Labels, coverages: Mapping[int, NDArray[np.uint8]]) -> NDArray[np.uint8]:
    """Join the sources as the labelling says.

    Parameters
    ----------
    labels
        (m, m): index of each pixel's owner.
    coverages
        For every label that occurs: its source drawn at its placement, (n, n) uint8, 255 = ink,
        with n one, two, four or eight times m. An owner's drawing counts within
        ``REACH + FAR`` canvas pixels of its region.

    Returns
    -------
    (n, n) uint8, 255 = ink
    """
    joined = _plain(labels, coverages)
    found = list(soft_regions(labels, FADE, REACH))
    if len(found) == 1:
        return joined
    blocks = np.argwhere(_doubtful(labels, coverages, found))
    s = len(joined) // len(labels)
    contributions = []
    for region in found:
        rows = region.rows(blocks)
        if len(rows):
            weights = region.weights(blocks[rows], s)
            contributions.append(_Contribution(coverages[region.label], rows, weights))
    mean, inked = np.zeros((2, len(blocks), s, s), dtype=np.float32)
    for one in contributions:
        own = in_blocks(one.coverage, s)[at(blocks[one.rows])]
        mean[one.rows] += one.weights * own
        inked[one.rows] += one.weights * (own > 127)
    # Where all owners agree, so does any mean of their distance fields: only the rest needs them.
    disagreed = (inked > _AGREED) & (inked < 1 - _AGREED)
    distance = _faded(blocks, contributions, disagreed)
    mean[disagreed] = 255 * np.clip(0.5 - distance[disagreed], 0, 1)
    in_blocks(joined, s)[at(blocks)] = mean.round()
    return joined


def _plain(labels: Labels, coverages: Mapping[int, NDArray[np.uint8]]) -> NDArray[np.uint8]:
    """Give every pixel what its owner draws there."""
    n = len(next(iter(coverages.values())))
    s = n // len(labels)
    joined = np.zeros((n, n), dtype=np.uint8)
    for label, region in regions(labels).items():
        large = enlarged(region, s)
        own = (labels[region] == label).repeat(s, axis=0).repeat(s, axis=1)
        np.copyto(joined[large], coverages[label][large], where=own)
    return joined


def _doubtful(
    labels: Labels, coverages: Mapping[int, NDArray[np.uint8]], found: list[SoftRegion]
) -> NDArray[np.bool_]:
    """Find the blocks, (m, m) bool, whose owners are not all white there, nor all black."""
    owners = np.zeros(labels.shape, dtype=np.uint8)
    some, every = np.zeros(labels.shape, dtype=bool), np.ones(labels.shape, dtype=bool)
    for region in found:
        coverage = coverages[region.label]
        s = len(coverage) // len(labels)
        # The s pixels of a row of a block as one number.
        rows = np.ascontiguousarray(coverage[enlarged(region.window, s)]).view(f"u{s}")
        rows = rows.reshape(-1, s, rows.shape[1])
        touched = region.touched
        owners[region.window] += touched
        some[region.window] |= touched & (np.bitwise_or.reduce(rows, axis=1) != 0)
        black = np.bitwise_and.reduce(rows, axis=1) == np.iinfo(rows.dtype).max
        every[region.window] &= black | ~touched
    return (owners > 1) & some & ~every


def _faded(
    blocks: Blocks, contributions: list[_Contribution], disagreed: NDArray[np.bool_]
) -> NDArray[np.float32]:
    """Return the mean of the owners' signed distances at the pixels of blocks, (b, s, s).

    It is exact wherever it is within a pixel of 0. Elsewhere it has the right sign: it is estimated
    from the distance of one pixel of each block.
    """
    from iconstudio.algorithms.iconification.signed_distance import SignedDistance

    s = disagreed.shape[1]
    middle = s // 2
    mean = np.zeros(disagreed.shape, dtype=np.float32)
    concerned: NDArray[np.bool_] = np.logical_or.reduce(disagreed, axis=(1, 2))
    fields = []
    for one in contributions:
        here = concerned[one.rows]
        rows, weights = one.rows[here], one.weights[here]
        if len(rows):
            corners = blocks[rows] * s
            field = SignedDistance(one.coverage, corners, s, FAR * len(one.coverage) / CANVAS)
            mean[rows] += weights * field.at(corners + middle)[:, None, None]
            fields.append((field, rows, weights))
    close = disagreed & (abs(mean) < 1 + _ROUGH + np.sqrt(2) * middle)
    mean[close] = 0
    for field, rows, weights in fields:
        exact = close[rows] & (weights > 0)
        block, y, x = np.nonzero(exact)
        own = np.zeros_like(weights)
        own[exact] = weights[exact] * field.at(blocks[rows[block]] * s + np.column_stack([y, x]))
        mean[rows] += own
    return mean


def binarised(coverage: NDArray[np.uint8]) -> NDArray[np.uint8]:
    """Make a drawing (h, w) uint8 ink or paper, but for the soft edge between the two.

    A duotone's pale layer is no ink, and its dark one is all ink (section 3.1: black and white).
    """
    ink = coverage > 127
    edge = spread(ink) & spread(~ink)
    return np.where(edge, coverage, np.where(ink, np.uint8(255), np.uint8(0)))


def erase(
    coverage: NDArray[np.uint8],
    fragments: NDArray[np.bool_],
    marked: NDArray[np.bool_] | None = None,
) -> None:
    """Take pieces off a drawing (n, n), in place.

    ``fragments`` is (m, m) bool; what lies within two of its pixels and touches it goes too, but
    nothing that is ``marked``, (m, m) bool.
    """
    if fragments.any():
        s = len(coverage) // len(fragments)
        reach = 2 * len(fragments) // CANVAS or 1
        near = scipy.ndimage.binary_dilation(fragments, iterations=reach)
        if marked is not None:
            near &= ~spread(marked)
        coverage[near.repeat(s, axis=0).repeat(s, axis=1)] = 0


def restore(
    coverage: NDArray[np.uint8],
    labels: Labels,
    coverages: Mapping[int, NDArray[np.uint8]],
    marked: NDArray[np.bool_],
) -> None:
    """Draw what is marked as its owner alone draws it, in place: no cross-fade may thin it.

    ``coverage`` is (n, n), ``labels`` and ``marked`` are (m, m).
    """
    s = len(coverage) // len(labels)
    for owner in np.unique(labels[marked]):
        blocks = np.argwhere(marked & (labels == owner))
        own = in_blocks(coverages[int(owner)], s)[at(blocks)]
        in_blocks(coverage, s)[at(blocks)] = own
