"""The energy of a remix (section 3.4, equations 5 to 8)."""

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from iconstudio.algorithms.raster import interior, placed_ink
from iconstudio.algorithms.tsdf import tsdf
from iconstudio.model import CANVAS, Axis, Source

PATCH = 7
"""Side of the neighbourhoods N_k(i) that the smoothness cost compares."""
F_INT = 0.5
"""Penalty for a cut through interior structure."""
EPSILON = 0.01
"""Least smoothness cost where two labels meet."""
SITES = CANVAS * CANVAS

Labels = NDArray[np.uint8]

_ROOT = np.sqrt(np.arange(PATCH * PATCH + 1, dtype=np.float32))


@dataclass(frozen=True, eq=False)
class RemixProblem:
    """A graph cut to solve: K sources and what each costs at each site.

    Sites are numbered row by row, site = y * CANVAS + x.
    """

    data: NDArray[np.float32]
    """(K, CANVAS, CANVAS): data cost F_D."""
    ink: NDArray[np.bool_]
    """(K, CANVAS, CANVAS): the images I_k, True = black."""
    solid: NDArray[np.bool_]
    """(K, CANVAS, CANVAS): the same with holes filled."""
    symmetry: Axis | None = None
    """Sites that mirror each other must have one label (equation 9)."""

    @cached_property
    def interior(self) -> NDArray[np.bool_]:
        """(K, CANVAS, CANVAS): interior structure, white inside the contour."""
        return interior(self.ink, self.solid)

    @cached_property
    def patches(self) -> NDArray[np.uint64]:
        """(K, SITES): the neighbourhoods, 49 bits each; the canvas is white around."""
        return patch_words(self.ink).reshape(len(self.ink), SITES)

    @cached_property
    def penalty(self) -> NDArray[np.float32]:
        """(K, SITES): f_int where the source shows interior structure, else 0."""
        return np.where(self.interior, np.float32(F_INT), np.float32(0)).reshape(-1, SITES)

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
        data = np.take_along_axis(self.data.reshape(-1, SITES), flat[None].astype(int), axis=0)
        smooth = 0.0
        for first, second in lattice_edges():
            seam = flat[first] != flat[second]
            a, b = first[seam], second[seam]
            smooth += float(self.smoothness(a, b, flat[a], flat[b]).sum(dtype=np.float64))
        return float(data.sum(dtype=np.float64)), smooth


def joined_ink(ink: NDArray[np.bool_], labels: Labels) -> NDArray[np.bool_]:
    """Return the ink of a labelling (h, w); ``ink`` is that of the sources, (K, h, w)."""
    return np.take_along_axis(ink, labels[None].astype(np.intp), axis=0)[0]


def lattice_edges() -> tuple[tuple[NDArray[np.int64], NDArray[np.int64]], ...]:
    """Return the edges of the 4-connected lattice: (left, right) and (upper, lower) sites."""
    site = np.arange(SITES).reshape(CANVAS, CANVAS)
    return (
        (site[:, :-1].ravel(), site[:, 1:].ravel()),
        (site[:-1].ravel(), site[1:].ravel()),
    )


def patch_words(ink: NDArray[np.bool_]) -> NDArray[np.uint64]:
    """Return each pixel's 7 x 7 neighbourhood as the bits of one word, (..., h, w) uint64.

    Inks are binary, so the squared distance of two neighbourhoods is the number of bits in which
    their words differ.
    """
    r = PATCH // 2
    h, w = ink.shape[-2:]
    padded = np.pad(ink, [(0, 0)] * (ink.ndim - 2) + [(r, r), (r, r)]).astype(np.uint64)
    rows = np.zeros((*ink.shape[:-2], h + 2 * r, w), dtype=np.uint64)
    for k in range(PATCH):
        rows |= padded[..., k : k + w] << np.uint64(k)
    words = np.zeros(ink.shape, dtype=np.uint64)
    for k in range(PATCH):
        words |= rows[..., k : k + h, :] << np.uint64(k * PATCH)
    return words


def data_cost(sketch_field: NDArray[np.float32], filled: NDArray[np.bool_]) -> NDArray[np.float32]:
    """Return F_D of solid shapes, (K, CANVAS, CANVAS) float32 (equation 6)."""
    return np.abs(sketch_field - tsdf(filled))


def placed_sources(
    sources: Sequence[Source],
) -> tuple[NDArray[np.bool_], NDArray[np.bool_]]:
    """Return ink and solid of sources at their placements, both (K, CANVAS, CANVAS) bool."""
    placed = [placed_ink(source.exemplar, source.placement) for source in sources]
    return np.stack([pair[0] for pair in placed]), np.stack([pair[1] for pair in placed])


def remix_problem(
    sketch_field: NDArray[np.float32], sources: Sequence[Source], symmetry: Axis | None = None
) -> RemixProblem:
    """Return the problem of joining ``sources`` in the shape of a sketch.

    ``sketch_field`` is the sketch's TSDF D_P, (CANVAS, CANVAS) float32.
    """
    ink, filled = placed_sources(sources)
    return RemixProblem(data_cost(sketch_field, filled), ink, filled, symmetry)
