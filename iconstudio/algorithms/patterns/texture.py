"""The E-step for appearance: texture optimisation (section 2; Kwatra et al. 2005).

Given their matches, the pixels that minimise the energy are the means of all that the matches
have at them. With robust weights it is the energy to the power of 0.4 that is minimised, step by
step: what does not fit counts for less, so less is blurred.
"""

import numpy as np
from numpy.typing import NDArray

from iconstudio.algorithms.compiled import entry
from iconstudio.algorithms.patterns.energy import UNIT, Channels
from iconstudio.algorithms.patterns.exemplar import Places
from iconstudio.algorithms.patterns.matching import Integers, Neighbourhoods, flat

_POWER = 0.8
"""r of texture optimisation: differences count by their norm to the power of r."""


def robust_weights(costs: Integers, window: int) -> NDArray[np.float64]:
    """Return the weights of matches with these squared differences (n, m): d ** (r - 2)."""
    per_pixel = costs / (window**2 * UNIT**2)
    weights: NDArray[np.float64] = (per_pixel + 1e-4) ** ((_POWER - 2) / 2)
    return weights


def means(
    exemplar: Channels, where: Neighbourhoods, matches: Places, weights: NDArray[np.float64]
) -> Channels:
    """Return the weighted means of what the matches have, (H, W, C), for each pixel."""
    count = exemplar.shape[2]
    height, width = where.shape
    more = where.window if where.tile else 0
    sums = np.zeros((height + more, (width + more) * count))
    masses = np.zeros((height + more, width + more))
    _add_up(
        flat(exemplar), count, where.window, where.rows, where.columns,
        matches, weights, sums, masses,
    )  # fmt: skip
    sums = _folded(sums.reshape(*masses.shape, count), where.shape)
    mean = sums / _folded(masses[..., None], where.shape)
    rounded: Channels = np.rint(mean).astype(np.int16)
    return rounded


def _folded(sums: NDArray[np.float64], shape: tuple[int, int]) -> NDArray[np.float64]:
    """Return sums (h, w, C) of that shape: what is beyond the border is added opposite."""
    height, width = shape
    sums[: len(sums) - height] += sums[height:]
    sums[:, : sums.shape[1] - width] += sums[:, width:]
    return sums[:height, :width]


@entry
def _add_up(exemplar, count, window, rows, columns, matches, weights, sums, masses):  # type: ignore[no-untyped-def]
    """Add each match, times its weight, to the sums (H, W C), and its weight to the masses."""
    for a in range(len(rows)):
        for b in range(len(columns)):
            y, x = rows[a], columns[b]
            v, u, weight = matches[a, b, 0], matches[a, b, 1] * count, weights[a, b]
            for i in range(window):
                mass = masses[y + i, x : x + window]
                for j in range(window):
                    mass[j] += weight
                total = sums[y + i, x * count : (x + window) * count]
                values = exemplar[v + i, u : u + window * count]
                for k in range(window * count):
                    total[k] += weight * values[k]


def sources(
    picture: Channels, exemplar: Channels, where: Neighbourhoods, matches: Places, costs: Integers
) -> Places:
    """Return where in the exemplar each pixel comes from (H, W, 2).

    Of all matches that cover it, that one which has most nearly its value, and whose own
    neighbourhood fits well.
    """
    found = np.zeros((*where.shape, 2), np.int32)
    least = np.full(where.shape, np.inf)
    _choose(
        flat(picture), flat(exemplar), picture.shape[2], where.window, where.rows, where.columns,
        matches, costs / where.window**2, found, least,
    )  # fmt: skip
    return found


@entry
def _choose(  # type: ignore[no-untyped-def]
    picture, exemplar, count, window, rows, columns, matches, costs, found, least
):
    """Fill in the sources, with the least cost of each pixel."""
    height, width = least.shape
    for a in range(len(rows)):
        for b in range(len(columns)):
            v, u = matches[a, b, 0], matches[a, b, 1]
            for i in range(window):
                y = (rows[a] + i) % height
                for j in range(window):
                    x = (columns[b] + j) % width
                    cost = costs[a, b]
                    for k in range(count):
                        d = np.float64(picture[y, x * count + k])
                        d -= exemplar[v + i, (u + j) * count + k]
                        cost += d * d
                    if cost < least[y, x]:
                        least[y, x] = cost
                        found[y, x, 0], found[y, x, 1] = v + i, u + j
