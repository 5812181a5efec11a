"""Comparing a neighbourhood with all of the example's at once, compiled (section 3.1).

In the plane, with complex numbers, the best rotation of two centred neighbourhoods is S / |S| of
``S = sum w conj(a) b``, and their distance is ``E_a + E_b - 2 Re(conj(R) S)``.
"""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from iconstudio.algorithms.compiled import part

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


class Row(NamedTuple):
    """One of the rows: samples (K,), directions (K - 1,), the first and last on the curve."""

    samples: Complexes
    ways: Complexes
    first: int
    last: int


@part
def row_of(rows, i):  # type: ignore[no-untyped-def]
    """Return the i-th row."""
    return Row(rows.samples[i], rows.ways[i], rows.first[i], rows.last[i])


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
def compare(columns, row, costs, hole, sr, si, cr, ci, energy):  # type: ignore[no-untyped-def]
    """Compare one neighbourhood with all candidates: fill S, their centres and energies.

    The row's samples on its curve count, without the middle one if ``hole``. Returns their centre,
    the energy of them and of both directions, and the sum of the weights.
    """
    b, ways, first, last = row
    w, wt = costs.samples, costs.ways
    rows = np.empty(2 * len(w) + 3, np.int64)
    factors = np.empty(2 * len(w) + 3, np.complex128)
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
