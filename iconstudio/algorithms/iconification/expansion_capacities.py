"""The network whose minimum cut is the best alpha-expansion of a label, compiled (section 3.4).

Importing this module loads numba, so only the process that cuts should do so. The functions let go
of the interpreter lock.

**The network.** In an expansion each node of a grid keeps its label or takes alpha. Nodes on the
source's side take it: the excess of a node is what it gains by that, were it alone, and the
capacity to a neighbour is what it costs if the neighbour does not. What two neighbours with labels
a and b cost, V(a, b) if both keep, V(a, alpha) or V(alpha, b) if one moves, 0 if both do, is shared
among these exactly; as V is a metric no capacity is negative.

**Whole numbers.** Costs are multiples of 1 / ``UNIT``, rounded up before they are added: a metric
rounded up is a metric, so the energy never rises, not even by rounding. Against the real energy the
rounding is some 1e-5.

**Nothing is done twice.** The network of each label is kept with its flow. When labels or lambda_S
have changed since its last cut, the old flow cut off at the new capacities is feasible, so it is a
start; the excess is counted anew. Only a box around the changes is looked at: elsewhere nothing has
changed. If no excess is positive then, no cut is needed: alpha gains nothing.

**Inks are binary**, so a patch is a word of 49 bits, and the patch distance is the root of the
number of ones in an exclusive or.

**Blocks and symmetry.** A node is a block of ``block`` x ``block`` sites; an edge of the grid
stands for all pairs of sites that face each other across it. If positions must be symmetric
(equation 9), only one of two mirrored nodes is in the grid, and the words of the sites' mirror
images are a second plane: each pair of sites stands for its mirror image too. Either way a node
has four neighbours, and the energy is exactly that of ``energy.RemixProblem`` on such labellings.
"""

import numpy as np
from numpy.typing import NDArray

from iconstudio.algorithms.compiled import entry, inner, ones, part
from iconstudio.algorithms.iconification.expansion_network import (
    FREE,
    HELD,
    Box,
    Grid,
    Network,
    Scratch,
    Smoothness,
)
from iconstudio.algorithms.mincut.trees import SOURCE, Integers

UNIT = 1 << 16
"""Whole numbers are energies times this."""

_BOUND = -(1 << 29)
"""The excess of a node that keeps its label: no flow outweighs it."""

_PATCH_BITS = np.uint64((1 << 49) - 1)
_LAST_BIT = np.uint64(63)


@entry
def update(
    grid: Grid,
    smoothness: Smoothness,
    network: Network,
    scratch: Scratch,
    labels: NDArray[np.uint8],
    alpha: int,
    box: Box,
) -> bool:
    """Bring the network of an expansion up to date in a box.

    Parameters
    ----------
    network
        That of ``alpha``, from its last cut; new at first.
    labels
        (N,) uint8.
    box
        Where labels, or neighbours' labels, have changed since then; all if lambda_S has.

    Returns
    -------
    bool
        Whether any node there has positive excess; if not, the expansion gains nothing.
    """
    words, data, kept, _, side, block = grid
    root, through, least = smoothness
    capacity, whole, excess = network
    site, row, there, back = scratch
    _compare(words, root, through, kept, site, labels, alpha, side, block, box)
    _meet(site, row, least, kept, there, back, side, block, box)
    top, bottom, left, right = box
    for y in range(top, bottom):
        for i in range((y + 1) * (side + 2) + left + 1, (y + 1) * (side + 2) + right + 1):
            excess[i] = 0
            if kept[i] == FREE:
                excess[i] = data[labels[i], i] - data[alpha, i]
            elif kept[i] == HELD:
                excess[i] = _BOUND
    _seams(words, root, through, least, kept, labels, alpha, there, back, excess, side, block, box)
    _carry(capacity, whole, there, back, excess, side, box)
    wanted = False
    for y in range(top, bottom):
        for i in range((y + 1) * (side + 2) + left + 1, (y + 1) * (side + 2) + right + 1):
            if labels[i] == alpha:
                excess[i] = 0
            wanted = wanted or excess[i] > 0
    return wanted


@entry
def move(
    side: int, excess: Integers, tree: NDArray[np.int8], labels: NDArray[np.uint8], alpha: int
) -> tuple[int, Box]:
    """Give alpha to the source's side, in place; return the gain and the box of what changed.

    ``tree`` is that of the cut; the gain is in units.
    """
    gain = 0
    top, bottom, left, right = side, 0, side, 0
    for y in range(side):
        for x in range(side):
            i = (y + 1) * (side + 2) + x + 1
            if tree[i] == SOURCE:
                labels[i] = alpha
                gain += excess[i]
                top, bottom = min(top, y - 1), max(bottom, y + 2)
                left, right = min(left, x - 1), max(right, x + 2)
    return gain, (max(top, 0), min(bottom, side), max(left, 0), min(right, side))


@inner
def _compare(
    words: NDArray[np.uint64],
    root: Integers,
    through: int,
    kept: NDArray[np.int8],
    out: Integers,
    labels: NDArray[np.uint8],
    alpha: int,
    side: int,
    block: int,
    box: Box,
) -> None:
    """Set ``Scratch.site`` in and around a box."""
    top, bottom, left, right = box
    for plane in range(words.shape[0]):
        for y in range(max(top - 1, 0), min(bottom + 1, side)):
            for x in range(max(left - 1, 0), min(right + 1, side)):
                i = (y + 1) * (side + 2) + x + 1
                if not kept[i]:
                    continue
                label = labels[i]
                for k in range(block):
                    first = ((y * block + k) * side + x) * block
                    for s in range(first, first + block):
                        one, other = words[plane, label, s], words[plane, alpha, s]
                        out[0, plane, s] = root[_bits(one, other)]
                        out[1, plane, s] = through if one >> _LAST_BIT else 0
                        out[2, plane, s] = through if other >> _LAST_BIT else 0


@inner
def _meet(
    site: Integers,
    row: Integers,
    least: int,
    kept: NDArray[np.int8],
    there: Integers,
    back: Integers,
    side: int,
    block: int,
    box: Box,
) -> None:
    """Set the capacities of all edges of a box as if both nodes had one label, but not alpha."""
    top, bottom, left, right = box
    top, left = max(top - 1, 0), max(left - 1, 0)
    sites = side * block
    for y in range(top, bottom):
        for axis in range(2):
            start, count, step = (y + 1) * (side + 2) + left + 1, right - left, 1
            forth, back_ = there[axis, start : start + count], back[axis, start : start + count]
            forth[:] = 0
            back_[:] = 0
            lines = block
            if axis == 1:
                step, lines = side + 2, 1 if y + 1 < side else 0
            for plane in range(site.shape[1]):
                for k in range(lines):
                    if axis == 0:
                        _face(site, row, plane, (y * block + k) * sites, 1, sites - 1, least)
                        for x in range(min(count, side - 1 - left)):
                            forth[x] += row[0, (x + left) * block + block - 1]
                            back_[x] += row[1, (x + left) * block + block - 1]
                    else:
                        _face(site, row, plane, ((y + 1) * block - 1) * sites, sites, sites, least)
                        for x in range(count):
                            for s in range((x + left) * block, (x + left + 1) * block):
                                forth[x] += row[0, s]
                                back_[x] += row[1, s]
            one, other = kept[start : start + count], kept[start + step : start + step + count]
            for x in range(count):
                if one[x] + other[x] <= FREE:
                    forth[x] = back_[x] = 0


@part
def _face(
    site: Integers, row: Integers, plane: int, first: int, across: int, count: int, least: int
) -> None:
    """Set ``Scratch.row``: what ``count`` sites from the first and those across them cost."""
    # A view for each row, so that the loop becomes a few wide instructions.
    second = first + across
    differ, differ_across = site[0, plane, first : first + count], site[0, plane, second:]
    label, label_across = site[1, plane, first : first + count], site[1, plane, second:]
    alpha, alpha_across = site[2, plane, first : first + count], site[2, plane, second:]
    there, back = row[0], row[1]
    for s in range(count):
        both = differ[s] + differ_across[s]
        there[s] = max(both + max(alpha[s], label_across[s]), least)
        back[s] = max(both + max(label[s], alpha_across[s]), least)


@inner
def _seams(
    words: NDArray[np.uint64],
    root: Integers,
    through: int,
    least: int,
    kept: NDArray[np.int8],
    labels: NDArray[np.uint8],
    alpha: int,
    there: Integers,
    back: Integers,
    excess: Integers,
    side: int,
    block: int,
    box: Box,
) -> None:
    """Correct the capacities where labels meet, or both are alpha; add to the excess."""
    top, bottom, left, right = box
    for axis in range(2):
        step, across, along = _layout(axis, side, block)
        for y in range(max(top - 1, 0), bottom):
            for x in range(max(left - 1, 0), right):
                i = (y + 1) * (side + 2) + x + 1
                a, b = labels[i], labels[i + step]
                if (a == b and a != alpha) or kept[i] + kept[i + step] <= FREE:
                    continue
                there[axis, i] = back[axis, i] = 0
                if a == b:
                    continue
                first = _first(y, x, axis, side, block)
                edge = (first, across, along, block)
                keep, i_moves, j_moves = _costs(words, root, through, least, a, b, alpha, edge)
                to_i, to_j = keep, keep
                if a != alpha and b != alpha:
                    either = i_moves + j_moves - keep
                    there[axis, i] = min(max(i_moves - (keep >> 1), 0), either)
                    back[axis, i] = either - there[axis, i]
                    to_i += there[axis, i] - i_moves
                    to_j += back[axis, i] - j_moves
                if y >= top and x >= left:
                    excess[i] += to_i
                if (y >= top and x + 1 < right) if axis == 0 else (x >= left and y + 1 < bottom):
                    excess[i + step] += to_j


@inner
def _carry(
    capacity: Integers,
    whole: Integers,
    there: Integers,
    back: Integers,
    excess: Integers,
    side: int,
    box: Box,
) -> None:
    """Cut the old flow off at the new capacities and count it as excess.

    An edge across the border of the box is as it was, but its flow counts in the box.
    """
    top, bottom, left, right = box
    for y in range(max(top - 1, 0), bottom):
        for x in range(max(left - 1, 0), right):
            i = (y + 1) * (side + 2) + x + 1
            inside = y >= top and x >= left
            for axis in range(2):
                j = i + (1 if axis == 0 else side + 2)
                beyond = (
                    (y >= top and x + 1 < right) if axis == 0 else (x >= left and y + 1 < bottom)
                )
                if not (inside or beyond):
                    continue
                flow = whole[i, axis] - capacity[i, 2 * axis]
                flow = min(max(flow, -back[axis, i]), there[axis, i])
                whole[i, axis] = there[axis, i]
                capacity[i, 2 * axis] = there[axis, i] - flow
                capacity[j, 2 * axis + 1] = back[axis, i] + flow
                if inside:
                    excess[i] -= flow
                if beyond:
                    excess[j] += flow


@inner
def _layout(axis: int, side: int, block: int) -> tuple[int, int, int]:
    """Return the steps from a node to its neighbour, from a site across and along their edge."""
    if axis == 0:
        return 1, 1, side * block
    return side + 2, side * block, 1


@inner
def _first(y: int, x: int, axis: int, side: int, block: int) -> int:
    """Return the first of the sites of a node along its edge to the right or down."""
    row = side * block
    if axis == 0:
        return y * block * row + (x + 1) * block - 1
    return ((y + 1) * block - 1) * row + x * block


@part
def _costs(
    words: NDArray[np.uint64],
    root: Integers,
    through: int,
    least: int,
    a: int,
    b: int,
    alpha: int,
    edge: tuple[int, int, int, int],
) -> tuple[int, int, int]:
    """Return F_S of an edge where a meets b, alpha meets b, and a meets alpha."""
    first, across, along, count = edge
    keep, i_moves, j_moves = 0, 0, 0
    for plane in range(words.shape[0]):
        for s in range(first, first + along * count, along):
            t = s + across
            a_s, b_s, alpha_s = words[plane, a, s], words[plane, b, s], words[plane, alpha, s]
            a_t, b_t, alpha_t = words[plane, a, t], words[plane, b, t], words[plane, alpha, t]
            differ = root[_bits(a_s, b_s)] + root[_bits(a_t, b_t)]
            keep += max(differ + through * _inside(a_s, b_t), least)
            differ = root[_bits(alpha_s, b_s)] + root[_bits(alpha_t, b_t)]
            i_moves += max(differ + through * _inside(alpha_s, b_t), least)
            differ = root[_bits(a_s, alpha_s)] + root[_bits(a_t, alpha_t)]
            j_moves += max(differ + through * _inside(a_s, alpha_t), least)
    return keep, i_moves, j_moves


@inner
def _bits(one: np.uint64, other: np.uint64) -> np.uint64:
    """Return in how many pixels two patches differ."""
    return ones((one ^ other) & _PATCH_BITS)


@inner
def _inside(one: np.uint64, other: np.uint64) -> np.int64:
    """Return 1 if either word says interior structure, else 0."""
    return np.int64((one | other) >> _LAST_BIT)
