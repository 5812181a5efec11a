"""The search for the example's neighbourhood that fits best, and for where it puts the point
(equations 3 to 6).

Compiled: all neighbourhoods of the example are scored at once for each point. With
``S = sum w conj(a) b`` of two centred neighbourhoods, the best rotation is S / |S|, and their
distance is ``E_a + E_b - 2 Re(conj(R) S)``. The plain loop is the oracle in the tests.
"""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from iconstudio.algorithms.compiled import part
from iconstudio.algorithms.curves.sampling import EXACT

_SENSELESS = 100.0
"""How many times as much a jump costs after which the same jump would follow."""

Floats = NDArray[np.float64]
Complexes = NDArray[np.complex128]
Integers = NDArray[np.int64]


class Columns(NamedTuple):
    """One curve of the example at n candidates.

    ``real`` and ``imag``, (2K - 1, n), are K samples, relative to the middle one, and the K - 1
    directions from each to the next. ``centre`` and ``energy``, (n,), are the weighted mean of the
    samples and ``sum w |a - mean|²``, of all, or of all but the middle one.
    """

    real: Floats
    imag: Floats
    middles: Complexes
    centre: Complexes
    energy: Floats


class Rows(NamedTuple):
    """One curve of the result's side at N points: samples (N, K), directions (N, K - 1).

    Samples ``first`` to ``last`` (N,) of a row lie on the curve.
    """

    samples: Complexes
    ways: Complexes
    first: Integers
    last: Integers


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
def _products(columns, rows, factors, count, sr, si):  # type: ignore[no-untyped-def]
    """Fill S, the sum of ``conj(a) factor`` over rows of the columns, for all candidates.

    Four rows at a time, so that the sums are read and written less often.
    """
    n = len(sr)
    sr[:] = 0.0
    si[:] = 0.0
    for first in range(0, count, 4):
        a0 = columns.real[rows[first]]
        b0 = columns.imag[rows[first]]
        a1 = columns.real[rows[first + 1]]
        b1 = columns.imag[rows[first + 1]]
        a2 = columns.real[rows[first + 2]]
        b2 = columns.imag[rows[first + 2]]
        a3 = columns.real[rows[first + 3]]
        b3 = columns.imag[rows[first + 3]]
        x0, y0 = factors[first].real, factors[first].imag
        x1, y1 = factors[first + 1].real, factors[first + 1].imag
        x2, y2 = factors[first + 2].real, factors[first + 2].imag
        x3, y3 = factors[first + 3].real, factors[first + 3].imag
        for j in range(n):  # one sum a loop: the compiler gives up on more arrays
            sr[j] += (
                (a0[j] * x0 + b0[j] * y0)
                + (a1[j] * x1 + b1[j] * y1)
                + (a2[j] * x2 + b2[j] * y2)
                + (a3[j] * x3 + b3[j] * y3)
            )
        for j in range(n):
            si[j] += (
                (a0[j] * y0 - b0[j] * x0)
                + (a1[j] * y1 - b1[j] * x1)
                + (a2[j] * y2 - b2[j] * x2)
                + (a3[j] * y3 - b3[j] * x3)
            )


@part
def _compare(  # type: ignore[no-untyped-def]
    columns, w, wt, b, ways, first, last, hole, rows, factors, sr, si, cr, ci, energy
):
    """Compare one neighbourhood with all candidates: fill S, their centres and energies.

    Samples first to last count, without the middle one if ``hole``. Returns the centre of b, the
    energy of b and of the directions, and the sum of the weights.
    """
    width = len(w)
    middle = width // 2
    total = 0.0
    centre = 0.0j
    for k in range(first, last + 1):
        if not (hole and k == middle):
            total += w[k]
            centre += w[k] * b[k]
    if total == 0.0:
        return centre, 0.0, 0.0
    centre /= total
    own = 0.0
    count = 0
    for k in range(first, last + 1):
        if not (hole and k == middle):
            rows[count] = k
            factors[count] = w[k] * (b[k] - centre)
            own += (factors[count] * (b[k] - centre).conjugate()).real
            count += 1
    samples = count
    for k in range(first, last):
        if not (hole and (k == middle or k == middle - 1)):
            rows[count] = width + k
            factors[count] = wt[k] * ways[k]
            own += 2.0 * wt[k]
            count += 1
    for k in range(count, count + 3):
        rows[k] = 0
        factors[k] = 0.0j
    _products(columns, rows, factors, count, sr, si)
    n = len(sr)
    if first == 0 and last == width - 1:
        for j in range(n):
            cr[j] = columns.centre[j].real
            ci[j] = columns.centre[j].imag
            energy[j] = columns.energy[j]
        return centre, own, total
    cr[:] = 0.0
    ci[:] = 0.0
    energy[:] = 0.0
    for k in rows[:samples]:
        ar = columns.real[k]
        ai = columns.imag[k]
        for j in range(n):
            cr[j] += w[k] * ar[j]
            ci[j] += w[k] * ai[j]
            energy[j] += w[k] * (ar[j] * ar[j] + ai[j] * ai[j])
    for j in range(n):
        cr[j] /= total
        ci[j] /= total
        energy[j] -= total * (cr[j] * cr[j] + ci[j] * ci[j])
    return centre, own, total


@part
def choose(  # type: ignore[no-untyped-def]
    styled, plain, coarser, order, costs, b, ways, first, last, has_plain, row_b, ways_b, first_b,
    last_b, has_coarse, row_c, ways_c, first_c, last_c, source, previous, pull, pull_weight, state,
    work,
):  # fmt: skip
    """Return where the best candidate puts the point, and which it is."""
    w = costs.samples
    wt = costs.ways
    n = styled.real.shape[1]
    middle = len(w) // 2
    # Of the sum of all pairs: S, what tells the rotation, cost, place; of the pair at hand, S and
    # the energy; the centres of A', A and the coarser A'.
    tr, ti, rr, ri, cost = work[0], work[1], work[2], work[3], work[4]
    pr, pi, sr, si, energy = work[5], work[6], work[7], work[8], work[9]
    hr, hi, br, bi, kr, ki = work[10], work[11], work[12], work[13], work[14], work[15]
    rows = np.empty(2 * len(w) + 3, np.int64)
    factors = np.empty(2 * len(w) + 3, np.complex128)
    constant = 0.0
    centre, own, mass = _compare(
        styled, w, wt, b, ways, first, last, True, rows, factors, sr, si, hr, hi, energy
    )
    known = mass > 0.0
    if known:
        constant += own
        for j in range(n):
            tr[j] = sr[j]
            ti[j] = si[j]
            cost[j] = energy[j]
    else:
        tr[:] = 0.0
        ti[:] = 0.0
        cost[:] = 0.0
        hr[:] = 0.0
        hi[:] = 0.0
    coarse_centre = 0.0j
    if has_coarse:
        coarse_centre, own, _ = _compare(
            coarser,
            w,
            wt,
            row_c,
            ways_c,
            first_c,
            last_c,
            False,
            rows,
            factors,
            sr,
            si,
            kr,
            ki,
            energy,
        )
        constant += costs.coarse * own
        for j in range(n):
            tr[j] += costs.coarse * sr[j]
            ti[j] += costs.coarse * si[j]
            cost[j] += costs.coarse * energy[j]
    for j in range(n):
        rr[j] = tr[j]
        ri[j] = ti[j]
    plain_centre = 0.0j
    if has_plain:
        plain_centre, own, _ = _compare(
            plain,
            w,
            wt,
            row_b,
            ways_b,
            first_b,
            last_b,
            False,
            rows,
            factors,
            sr,
            si,
            br,
            bi,
            energy,
        )
        for j in range(n):
            rr[j] += costs.alignment * sr[j]
            ri[j] += costs.alignment * si[j]
        if costs.shape > 0.0:
            constant += costs.shape * own
            for j in range(n):
                tr[j] += costs.shape * sr[j]
                ti[j] += costs.shape * si[j]
                cost[j] += costs.shape * energy[j]
    # the rotation of each
    if costs.rotation:
        for j in range(n):
            size = np.sqrt(rr[j] * rr[j] + ri[j] * ri[j])
            if size > 1e-12:
                rr[j] /= size
                ri[j] /= size
            else:
                rr[j] = 1.0
                ri[j] = 0.0
    else:
        rr[:] = 1.0
        ri[:] = 0.0
    for j in range(n):
        cost[j] += constant - 2.0 * (rr[j] * tr[j] + ri[j] * ti[j])
    # the masses of the new point and of its neighbours
    total = mass + w[middle]
    share = w[middle] / total
    rest = centre * (mass / total)
    # virtual constraints: where the neighbourhood, the offsets and the user put the point
    spring = costs.offset * share * share if has_plain else 0.0
    spring_c = costs.coarse_offset * share * share if has_coarse else 0.0
    match = 1.0 if known else 0.0
    weight = match + spring + spring_c + pull_weight
    # the whole neighbourhood of A', with its middle: hr, hi are centres of the others
    for j in range(n):
        mr = hr[j] * (mass / total)
        mi = hi[j] * (mass / total)
        sumr = 0.0
        sumi = 0.0
        square = 0.0
        if known:
            qr = centre.real - (rr[j] * hr[j] - ri[j] * hi[j])
            qi = centre.imag - (rr[j] * hi[j] + ri[j] * hr[j])
            sumr += qr
            sumi += qi
            square += qr * qr + qi * qi
        if spring > 0.0:
            er = mr + styled.middles[j].real - br[j] - plain.middles[j].real
            ei = mi + styled.middles[j].imag - bi[j] - plain.middles[j].imag
            qr = (plain_centre.real + rr[j] * er - ri[j] * ei - rest.real) / share
            qi = (plain_centre.imag + rr[j] * ei + ri[j] * er - rest.imag) / share
            sumr += spring * qr
            sumi += spring * qi
            square += spring * (qr * qr + qi * qi)
        if spring_c > 0.0:
            er = mr + styled.middles[j].real - kr[j] - coarser.middles[j].real
            ei = mi + styled.middles[j].imag - ki[j] - coarser.middles[j].imag
            qr = (coarse_centre.real + rr[j] * er - ri[j] * ei - rest.real) / share
            qi = (coarse_centre.imag + rr[j] * ei + ri[j] * er - rest.imag) / share
            sumr += spring_c * qr
            sumi += spring_c * qi
            square += spring_c * (qr * qr + qi * qi)
        sumr += pull_weight * pull.real
        sumi += pull_weight * pull.imag
        square += pull_weight * (pull.real * pull.real + pull.imag * pull.imag)
        pr[j] = sumr / weight
        pi[j] = sumi / weight
        cost[j] += square - weight * (pr[j] * pr[j] + pi[j] * pi[j])
        if cost[j] < 0.0:
            cost[j] = 0.0
    if source >= 0:
        for j in range(n):
            step = order.arc[j] - order.arc[source]
            if order.period[j] > 0.0 and step < -0.5 * order.period[j]:
                step += order.period[j]
            gap = (1.5 + EXACT) * np.sqrt(
                (pr[j] - previous.real) ** 2 + (pi[j] - previous.imag) ** 2
            )
            same = order.curve[j] == order.curve[source]
            if not (same and EXACT < step < gap):
                cost[j] *= costs.incoherent * (1.0 + costs.late * order.lateness[j])
                # A jump back by a little, or to the end, would come again and again.
                if order.ending[j] or (same and -costs.stride < step <= EXACT):
                    cost[j] *= _SENSELESS
    least = np.inf
    for j in range(n):
        if cost[j] < least:
            least = cost[j]
    # Where several fit, rounding must not tell which: the same result, however B is turned.
    bound = least * (1.0 + costs.epsilon) + EXACT * costs.ways[middle]
    good = 0
    for j in range(n):
        if cost[j] <= bound:
            good += 1
    nth = int(random_number(state) * good)
    best = 0
    for j in range(n):
        if cost[j] <= bound:
            if nth == 0:
                best = j
                break
            nth -= 1
    return pr[best] + 1j * pi[best], best
