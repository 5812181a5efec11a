"""The search for the example's neighbourhood that fits best, and for where it puts the point
(equations 3 to 6).

Compiled: all candidates are scored at once for each point. The plain loop is the oracle in the
tests.
"""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from iconstudio.algorithms.compiled import part
from iconstudio.algorithms.curves.comparison import Floats, Integers, compare
from iconstudio.algorithms.curves.sampling import EXACT

_SENSELESS = 100.0
"""How many times as much a jump costs after which the same jump would follow."""

WORK = 17
"""Rows of numbers, one for each candidate, that a search works with."""


class Costs(NamedTuple):
    """The weights of the terms of equation 6, at one level."""

    samples: Floats
    """w_k (K,)"""
    ways: Floats
    """w_delta w_k (K - 1,)"""
    shape: float
    """w_B: how much the neighbourhoods of A and B count for the cost ..."""
    alignment: float
    """... and for the rotation."""
    coarse: float
    """The same of the next coarser level; 0 at the coarsest."""
    offset: float
    """w_offset of A and B; 0 without them."""
    coarse_offset: float
    incoherent: float
    stride: float
    """No jump goes back by less than that much arc length."""
    late: float
    epsilon: float
    rotation: bool


class Order(NamedTuple):
    """Where candidates lie, (n,)."""

    arc: Floats
    """The arc length along their curve,"""
    curve: Integers
    """which curve that is,"""
    period: Floats
    """and its length if it is closed, else 0."""
    lateness: Floats
    """From 0 at the start of an open curve to 1 at its end; 0 on a closed one."""
    ending: NDArray[np.bool_]
    """Those near the end of an open curve, where a jump would lead nowhere."""


@part
def random_number(state):  # type: ignore[no-untyped-def]
    """Return a number from 0 to 1, and the next state (xorshift64*)."""
    x = state[0]
    x ^= x >> np.uint64(12)
    x ^= x << np.uint64(25)
    x ^= x >> np.uint64(27)
    state[0] = x
    return ((x * np.uint64(2685821657736338717)) >> np.uint64(11)) * (1.0 / 9007199254740992.0)


@part
def choose(  # type: ignore[no-untyped-def]
    styled, plain, coarser, order, costs, row, has_plain, plain_row, has_coarse, coarse_row,
    source, previous, pull, pull_weight, state, work,
):  # fmt: skip
    """Return where the best candidate puts the point, and which it is.

    ``work`` is (WORK, n). A' is compared without the point that is looked for, and all of it is
    new if it has no neighbour yet.
    """
    # Of the sum of all pairs: S, R, the cost; of the pair at hand: S and the energy.
    tr, ti, rr, ri, cost, sr, si, energy = work[0], work[1], work[2], work[3], work[4], work[5], \
        work[6], work[7]  # fmt: skip
    # Where the candidates put the point, and the centres of A', A and the coarser A'.
    pr, pi, square, hr, hi, br, bi, kr, ki = work[8], work[9], work[10], work[11], work[12], \
        work[13], work[14], work[15], work[16]  # fmt: skip
    for row_of_work in (tr, ti, cost, hr, hi):
        row_of_work[:] = 0.0
    constant = 0.0
    centre, own, mass = compare(styled, row, costs, True, sr, si, hr, hi, energy)
    if mass > 0.0:
        constant += own
        _add(1.0, sr, si, energy, tr, ti, cost)
    coarse_centre = 0.0j
    if has_coarse:
        coarse_centre, own, _ = compare(coarser, coarse_row, costs, False, sr, si, kr, ki, energy)
        constant += costs.coarse * own
        _add(costs.coarse, sr, si, energy, tr, ti, cost)
    rr[:] = tr
    ri[:] = ti
    plain_centre = 0.0j
    if has_plain:
        plain_centre, own, _ = compare(plain, plain_row, costs, False, sr, si, br, bi, energy)
        for j in range(len(sr)):
            rr[j] += costs.alignment * sr[j]
            ri[j] += costs.alignment * si[j]
        if costs.shape > 0.0:
            constant += costs.shape * own
            _add(costs.shape, sr, si, energy, tr, ti, cost)
    _rotate(costs.rotation, rr, ri)
    for j in range(len(cost)):
        cost[j] += constant - 2.0 * (rr[j] * tr[j] + ri[j] * ti[j])
    # The masses of the new point and of its neighbours.
    total = mass + costs.samples[len(costs.samples) // 2]
    share = costs.samples[len(costs.samples) // 2] / total
    rest = centre * (mass / total)
    others = mass / total
    pr[:] = 0.0
    pi[:] = 0.0
    square[:] = 0.0
    weight = 0.0
    if mass > 0.0:
        weight += 1.0
        for j in range(len(pr)):
            qr = centre.real - (rr[j] * hr[j] - ri[j] * hi[j])
            qi = centre.imag - (rr[j] * hi[j] + ri[j] * hr[j])
            _pull(1.0, qr, qi, j, pr, pi, square)
    if has_plain:
        spring = costs.offset * share * share
        weight += spring
        _offset(spring, styled, plain, plain_centre, rest, share, others, rr, ri, hr, hi, br, bi,
                pr, pi, square)  # fmt: skip
    if has_coarse:
        spring = costs.coarse_offset * share * share
        weight += spring
        _offset(spring, styled, coarser, coarse_centre, rest, share, others, rr, ri, hr, hi, kr,
                ki, pr, pi, square)  # fmt: skip
    weight += pull_weight
    for j in range(len(pr)):
        _pull(pull_weight, pull.real, pull.imag, j, pr, pi, square)
        pr[j] /= weight
        pi[j] /= weight
        cost[j] += square[j] - weight * (pr[j] * pr[j] + pi[j] * pi[j])
        cost[j] = max(cost[j], 0.0)
    if source >= 0:
        _penalise(order, costs, source, previous, pr, pi, cost)
    best = _one_of_the_best(costs, cost, state)
    return pr[best] + 1j * pi[best], best


@part
def _add(weight, sr, si, energy, tr, ti, cost):  # type: ignore[no-untyped-def]
    """Add one pair of curves to the sum of all."""
    for j in range(len(sr)):
        tr[j] += weight * sr[j]
        ti[j] += weight * si[j]
        cost[j] += weight * energy[j]


@part
def _rotate(rotation, rr, ri):  # type: ignore[no-untyped-def]
    """Make the best rotations of the sums S; none if curves are only moved."""
    for j in range(len(rr)):
        size = np.sqrt(rr[j] * rr[j] + ri[j] * ri[j])
        if rotation and size > 1e-12:
            rr[j] /= size
            ri[j] /= size
        else:
            rr[j] = 1.0
            ri[j] = 0.0


@part
def _pull(weight, qr, qi, j, pr, pi, square):  # type: ignore[no-untyped-def]
    """Add a virtual constraint of candidate j: the point is to be at q (section 3.2)."""
    pr[j] += weight * qr
    pi[j] += weight * qi
    square[j] += weight * (qr * qr + qi * qi)


@part
def _offset(  # type: ignore[no-untyped-def]
    weight, styled, other, centre, rest, share, others, rr, ri, hr, hi, or_, oi, pr, pi, square
):  # fmt: skip
    """Add what the offset between A' and another curve asks of the point (section 3.3).

    ``centre`` is that of the result's neighbourhood of the other curve, or_ + i oi that of the
    example's; ``rest`` is what the neighbours add to the centre of B', ``share`` the point's part.
    """
    for j in range(len(pr)):
        er = hr[j] * others + styled.middles[j].real - or_[j] - other.middles[j].real
        ei = hi[j] * others + styled.middles[j].imag - oi[j] - other.middles[j].imag
        qr = (centre.real + rr[j] * er - ri[j] * ei - rest.real) / share
        qi = (centre.imag + rr[j] * ei + ri[j] * er - rest.imag) / share
        _pull(weight, qr, qi, j, pr, pi, square)


@part
def _penalise(order, costs, source, previous, pr, pi, cost):  # type: ignore[no-untyped-def]
    """Make candidates dearer that do not go on where the one before was (section 3.1)."""
    for j in range(len(cost)):
        step = order.arc[j] - order.arc[source]
        if order.period[j] > 0.0 and step < -0.5 * order.period[j]:
            step += order.period[j]
        same = order.curve[j] == order.curve[source]
        if same and step > EXACT:
            off = (pr[j] - previous.real) ** 2 + (pi[j] - previous.imag) ** 2
            follows = step < (1.5 + EXACT) * np.sqrt(off)
        else:
            follows = False
        if not follows:
            cost[j] *= costs.incoherent * (1.0 + costs.late * order.lateness[j])
            # A jump back by a little, or to the end, would come again and again.
            if order.ending[j] or (same and -costs.stride < step <= EXACT):
                cost[j] *= _SENSELESS


@part
def _one_of_the_best(costs, cost, state):  # type: ignore[no-untyped-def]
    """Return any of the candidates that cost at most 1 + epsilon times the least."""
    # Where several fit, rounding must not tell which: the same result, however B is turned.
    least = cost.min()
    bound = least * (1.0 + costs.epsilon) + EXACT * costs.ways[len(costs.samples) // 2]
    good = np.flatnonzero(cost <= bound)
    return good[int(random_number(state) * len(good))]
