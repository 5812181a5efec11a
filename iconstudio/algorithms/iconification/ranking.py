"""How good a remix looks: what ranks hybrids, and recommends a cell of the grid.

The paper's authors picked the hybrids of their figures by hand (section 4.3). These terms stand for
what the eye objects to; each lies between 0 and 1, and 1 is best.
"""

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from iconstudio.algorithms.extremes import maximum_filter
from iconstudio.algorithms.iconification.energy import (
    Labels,
    RemixProblem,
    joined_ink,
    lattice_edges,
)
from iconstudio.algorithms.iconification.fragments import fragments
from iconstudio.algorithms.iconification.symmetry import likeness
from iconstudio.model import CANVAS, Score

HARSH = 0.8
"""Cost of the visible seams, for each pixel of the contour, at which the term ``seam`` is 1/e."""
EVEN = 0.35
"""Part of the ink that the other sources must own, beside the largest, to share truly."""
SAME, STRAY = 3, 0.02
"""Two pictures repeat each other if at most the part STRAY of their ink lies further than SAME
canvas pixels from the other's ink."""


def score(
    problem: RemixProblem,
    labels: Labels,
    *,
    sharing: bool = False,
    marked: NDArray[np.bool_] | None = None,
) -> Score:
    """Return the terms of a labelling (m, m) for which no outline was wanted.

    Parameters
    ----------
    sharing
        Whether the ink should come from several sources.
    marked
        (m, m) bool: what the user wants to keep, however free it floats.
    """
    ink = joined_ink(problem.ink, labels)
    return Score(
        seam=float(np.exp(-seam_cost(problem, labels) / HARSH)),
        whole=_whole(problem, labels, ink, marked),
        symmetry=_symmetry(problem, labels, ink),
        sharing=evenness(shares(problem, labels)) if sharing else 1.0,
        likeness=1.0,
    )


def seam_cost(problem: RemixProblem, labels: Labels) -> float:
    """Return the smoothness cost of the seams that can be seen, for each pixel of the contour.

    A seam can be seen where the ink of its two sources meets or differs; through white that both
    share it costs next to nothing and shows nowhere.
    """
    flat = labels.ravel().astype(np.intp)
    dark = problem.ink.reshape(len(problem.ink), -1)
    drawn = joined_ink(problem.ink, labels).ravel()
    cost, contour = 0.0, 0
    for first, second in lattice_edges(len(labels)):
        contour += int((drawn[first] != drawn[second]).sum())
        seam = flat[first] != flat[second]
        a, b = first[seam], second[seam]
        la, lb = flat[a], flat[b]
        seen = dark[la, a] | dark[lb, a] | dark[la, b] | dark[lb, b]
        cost += float(problem.smoothness(a[seen], b[seen], la[seen], lb[seen]).sum())
    return cost / max(1, contour)


class Gallery:
    """Pictures that have been seen, to know repeats by their looks."""

    def __init__(self) -> None:
        self._seen: list[tuple[NDArray[np.bool_], NDArray[np.bool_]]] = []

    def add(self, ink: NDArray[np.bool_]) -> bool:
        """Note a picture (m, m) bool; return whether it is new."""
        wide = _widened(ink)
        new = self._is_new(ink, wide)
        if new:
            self._seen.append((ink, wide))
        return new

    def is_new(self, ink: NDArray[np.bool_]) -> bool:
        """Whether a picture (m, m) bool is unlike all that were noted."""
        return self._is_new(ink, _widened(ink))

    def _is_new(self, ink: NDArray[np.bool_], wide: NDArray[np.bool_]) -> bool:
        return not any(_repeats(ink, wide, *other) for other in self._seen)


def _widened(ink: NDArray[np.bool_]) -> NDArray[np.bool_]:
    around = 2 * (SAME * len(ink) // CANVAS) + 1
    return maximum_filter(ink, around)


def _repeats(
    ink: NDArray[np.bool_],
    wide: NDArray[np.bool_],
    other: NDArray[np.bool_],
    other_wide: NDArray[np.bool_],
) -> bool:
    stray = int((ink & ~other_wide).sum()) + int((other & ~wide).sum())
    return stray <= STRAY * (int(ink.sum()) + int(other.sum()))


def _whole(
    problem: RemixProblem,
    labels: Labels,
    ink: NDArray[np.bool_],
    marked: NDArray[np.bool_] | None,
) -> float:
    loose = fragments(labels, problem.ink, small=1.0, marked=marked)
    return max(0.0, 1 - 3 * float(loose.sum()) / max(1, int(ink.sum())))


def _symmetry(problem: RemixProblem, labels: Labels, ink: NDArray[np.bool_]) -> float:
    if problem.symmetry is None:
        return 1.0
    expected = np.mean([likeness(problem.ink[k], problem.symmetry) for k in np.unique(labels)])
    return min(1.0, likeness(ink, problem.symmetry) / max(float(expected), 1e-9))


def shares(problem: RemixProblem, labels: Labels) -> list[float]:
    """Return which part of the ink of a labelling (m, m) each source owns."""
    owned = np.bincount(labels[joined_ink(problem.ink, labels)], minlength=len(problem.ink))
    parts: list[float] = (owned / max(1, owned.sum())).tolist()
    return parts


def evenness(parts: Sequence[float]) -> float:
    """Return how far the ink comes from several sources, given each one's part of it."""
    return min(1.0, (1 - max(parts)) / EVEN)
