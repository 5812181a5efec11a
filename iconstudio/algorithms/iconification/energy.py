"""The costs of a remix: data and smoothness (section 3.4, equations 6 to 8).

Their sum for a lambda_S, F(L) of equation 5, is ``alpha_expansion.Found.energy``.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property, lru_cache

import numpy as np
from numpy.typing import NDArray

from iconstudio.algorithms.iconification.tsdf import D_MAX, tsdf
from iconstudio.algorithms.raster import interior, placed_ink
from iconstudio.model import CANVAS, Axis, Source

PATCH = 7
"""Side of the neighbourhoods N_k(i) that the smoothness cost compares."""
F_INT = 0.5
"""Penalty for a cut through interior structure."""
EPSILON = 0.01
"""Least smoothness cost where two labels meet."""

Labels = NDArray[np.uint8]

_ROOT = np.sqrt(np.arange(PATCH * PATCH + 1, dtype=np.float32))


@dataclass(frozen=True, eq=False)
class RemixProblem:
    """A graph cut to solve: K sources and what each costs at each site.

    The canvas has m x m sites, m a multiple of 8; they are numbered row by row, site = y * m + x.
    The paper's m is CANVAS. The data cost grows with the area, m ** 2, but seams with the length,
    m: so lambda_S must be ``m / CANVAS`` times the paper's for the same trade-off.
    """

    data: NDArray[np.float32]
    """(K, m, m): data cost F_D."""
    ink: NDArray[np.bool_]
    """(K, m, m): the images I_k, True = black."""
    solid: NDArray[np.bool_]
    """(K, m, m): the same with holes filled."""
    symmetry: Axis | None = None
    """Sites that mirror each other must have one label (equation 9)."""

    @property
    def side(self) -> int:
        """Sites in a row, m."""
        side: int = self.data.shape[-1]
        return side

    @cached_property
    def interior(self) -> NDArray[np.bool_]:
        """(K, m, m): interior structure, white inside the contour."""
        return interior(self.ink, self.solid)

    @cached_property
    def patches(self) -> NDArray[np.uint64]:
        """(K, sites): the neighbourhoods, 49 bits each; the canvas is white around."""
        return patch_words(self.ink).reshape(len(self.ink), -1)

    @cached_property
    def penalty(self) -> NDArray[np.float32]:
        """(K, sites): f_int where the source shows interior structure, else 0."""
        inside = self.interior.reshape(len(self.ink), -1)
        return np.where(inside, np.float32(F_INT), np.float32(0))

    def smoothness(
        self,
        first: NDArray[np.int64],
        second: NDArray[np.int64],
        label_first: NDArray[np.uint8],
        label_second: NDArray[np.uint8],
    ) -> NDArray[np.float32]:
        """Return F_S of edges between sites ``first`` and ``second`` (equations 7 and 8).

        All arguments broadcast.
        """
        w = self.patches
        here = np.bitwise_count(w[label_first, first] ^ w[label_second, first])
        there = np.bitwise_count(w[label_first, second] ^ w[label_second, second])
        cut = np.maximum(self.penalty[label_first, first], self.penalty[label_second, second])
        cost = np.maximum(_ROOT[here] + _ROOT[there] + cut, np.float32(EPSILON))
        return np.where(label_first == label_second, np.float32(0), cost)

    def costs(self, labels: Labels) -> tuple[float, float]:
        """Return the data cost and the smoothness cost (without lambda_S) of a labelling."""
        flat = labels.ravel()
        data = np.take_along_axis(self.data.reshape(-1, flat.size), flat[None].astype(int), axis=0)
        smooth = 0.0
        for first, second in lattice_edges(self.side):
            seam = flat[first] != flat[second]
            a, b = first[seam], second[seam]
            smooth += float(self.smoothness(a, b, flat[a], flat[b]).sum(dtype=np.float64))
        return float(data.sum(dtype=np.float64)), smooth


def joined_ink(ink: NDArray[np.bool_], labels: Labels) -> NDArray[np.bool_]:
    """Return the ink of a labelling (h, w); ``ink`` is that of the sources, (K, h, w)."""
    joined: NDArray[np.bool_] = np.take_along_axis(ink, labels[None].astype(np.intp), axis=0)[0]
    return joined


def canvas_ink(ink: NDArray[np.bool_], labels: Labels) -> NDArray[np.bool_]:
    """Return the ink of a labelling (m, m) at the canvas's resolution; ``ink`` is (K, m, m)."""
    finer = len(labels) // CANVAS
    return joined_ink(ink, labels)[::finer, ::finer]


@lru_cache(maxsize=2)
def lattice_edges(
    side: int = CANVAS,
) -> tuple[tuple[NDArray[np.int64], NDArray[np.int64]], ...]:
    """Return the edges of the 4-connected lattice: (left, right) and (upper, lower) sites.

    >>> [(first.tolist(), second.tolist()) for first, second in lattice_edges(2)]
    [([0, 2], [1, 3]), ([0, 1], [2, 3])]
    """
    site = np.arange(side * side).reshape(side, side)
    ends = site[:, :-1].ravel(), site[:, 1:].ravel(), site[:-1].ravel(), site[1:].ravel()
    for one in ends:
        one.flags.writeable = False
    return ends[:2], ends[2:]


def patch_words(ink: NDArray[np.bool_]) -> NDArray[np.uint64]:
    """Return each pixel's 7 x 7 neighbourhood as the bits of one word, (..., h, w) uint64.

    Inks are binary, so the squared distance of two neighbourhoods is the number of bits in which
    their words differ.
    """
    words = np.empty(ink.shape, np.uint64)
    h, w = ink.shape[-2:]
    # One picture after another, in the smallest integers that hold so many rows: they stay in the
    # processor's cache.
    for one, out in zip(ink.reshape(-1, h, w), words.reshape(-1, h, w), strict=True):
        padded = np.pad(one, PATCH // 2).astype(np.uint8)
        row = np.zeros((h + PATCH - 1, w), np.uint8)
        for k in range(PATCH):
            row |= padded[:, k : k + w] << np.uint8(k)
        wide = row.astype(np.uint32)
        three = wide[:-2] | wide[1:-1] << np.uint32(PATCH) | wide[2:] << np.uint32(2 * PATCH)
        four = three[:-1] | wide[3:] << np.uint32(3 * PATCH)
        np.left_shift(three[4:], np.uint64(4 * PATCH), out=out, dtype=np.uint64)
        out |= four[:h]
    return words


def distance_field(filled: NDArray[np.bool_], outside_only: bool = False) -> NDArray[np.float32]:
    """Return the TSDF of filled shapes (..., m, m) bool on a canvas of any side m.

    Distances are clamped at the same part of the canvas, and counted in canvases, whatever m is.
    ``outside_only``: inside they are 0.
    """
    side = filled.shape[-1]
    unit = np.float32(CANVAS / side)
    return tsdf(filled, max(1, round(D_MAX / unit)), outside_only) * unit


def data_cost(sketch_field: NDArray[np.float32], filled: NDArray[np.bool_]) -> NDArray[np.float32]:
    """Return F_D of solid shapes (K, m, m) bool, (K, m, m) float32 (equation 6).

    ``sketch_field`` is the sketch's ``distance_field``, (m, m).
    """
    cost: NDArray[np.float32] = np.abs(sketch_field - distance_field(filled))
    return cost


def placed_sources(
    sources: Sequence[Source], side: int = CANVAS, pad: int = 0
) -> tuple[NDArray[np.bool_], NDArray[np.bool_]]:
    """Return ink and solid of sources at their placements, both (K, side, side) bool.

    ``pad`` is by how many pixels the canvas is enlarged on each side. On a canvas that is not of
    the paper's side, the exemplars' pictures are enlarged or reduced.
    """
    placed = [placed_ink(source.exemplar, source.placement, side, pad) for source in sources]
    return np.stack([pair[0] for pair in placed]), np.stack([pair[1] for pair in placed])


def remix_problem(
    sketch_field: NDArray[np.float32], sources: Sequence[Source], symmetry: Axis | None = None
) -> RemixProblem:
    """Return the problem of joining ``sources`` in the shape of a sketch.

    ``sketch_field`` is the sketch's TSDF D_P, its ``distance_field``, (m, m) float32; its side is
    that of the problem.
    """
    return joining(sketch_field, *placed_sources(sources, len(sketch_field)), symmetry)


def joining(
    sketch_field: NDArray[np.float32],
    ink: NDArray[np.bool_],
    filled: NDArray[np.bool_],
    symmetry: Axis | None = None,
) -> RemixProblem:
    """Return the problem of joining drawn sources, ink and solid both (K, m, m) bool."""
    return RemixProblem(data_cost(sketch_field, filled), ink, filled, symmetry)
