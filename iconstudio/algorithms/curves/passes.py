"""Passes over the points of a curve: compiled (SYNTHESIZEANALOGY, REFINEANALOGY)."""

import numpy as np

from iconstudio.algorithms.compiled import entry
from iconstudio.algorithms.curves.comparison import Row, row_of
from iconstudio.algorithms.curves.sampling import point_out, samples_around, unbend
from iconstudio.algorithms.curves.search import WORK, choose, random_number


@entry
def begin(  # type: ignore[no-untyped-def]
    styled, plain, order, costs, spacing, has_plain, rows, pulls, pull_weights, bends, arcs, state,
    points, sources, done,
):  # fmt: skip
    """Fill points and sources from the ``done``-th on, each from the neighbourhood before it."""
    width = len(costs.samples)
    middle = width // 2
    work = np.empty((WORK, styled.real.shape[1]))
    back = np.zeros(width, np.complex128)
    places = np.zeros(width)
    samples = np.zeros(width, np.complex128)
    ways = np.zeros(width - 1, np.complex128)
    for i in range(done, len(points)):
        first = middle + 1
        source = -1
        previous = 0.0j
        if i > 0:
            # The sample before the new point is the point before it, and so on back from there.
            found, _ = samples_around(points, arcs, i, i - 1, 0.0, False, spacing, back, places)
            first = max(found - 1, 0)
            for k in range(first, middle):
                samples[k] = back[k + 1]
                places[k] = places[k + 1] + arcs[i - 1] - arcs[i]
            unbend(samples, places, first, middle - 1, bends[i], spacing)
            point_out(samples, first, middle - 1, ways)
            source = sources[i - 1]
            previous = points[i - 1]
        row = Row(samples, ways, first, middle)
        points[i], sources[i] = choose(
            styled, plain, plain, order, costs, row, has_plain, row_of(rows, i), False, row,
            source, previous, pulls[i], pull_weights[i], state, work,
        )  # fmt: skip


@entry
def refine(  # type: ignore[no-untyped-def]
    styled, plain, coarser, order, costs, spacing, closed, has_plain, rows, has_coarse,
    coarse_rows, pulls, pull_weights, bends, arcs, around, state, points, sources,
):  # fmt: skip
    """Go once over all points, each from the whole neighbourhood around it.

    A closed curve is gone over from a random point on.
    """
    width = len(costs.samples)
    count = len(points)
    work = np.empty((WORK, styled.real.shape[1]))
    samples = np.zeros(width, np.complex128)
    places = np.zeros(width)
    ways = np.zeros(width - 1, np.complex128)
    start = int(random_number(state) * count) if closed else 0
    for nth in range(count):
        i = (start + nth) % count
        hard = pull_weights[i] == np.inf
        if hard:
            points[i] = pulls[i]
        first, last = samples_around(
            points, arcs, count, i, around, closed, spacing, samples, places
        )
        unbend(samples, places, first, last, bends[i], spacing)
        point_out(samples, first, last, ways)
        source = -1
        previous = 0.0j
        if i > 0 or closed:
            source = sources[(i - 1) % count]
            previous = points[(i - 1) % count]
        place, sources[i] = choose(
            styled, plain, coarser, order, costs, Row(samples, ways, first, last), has_plain,
            row_of(rows, i), has_coarse, row_of(coarse_rows, i), source, previous, pulls[i],
            0.0 if hard else pull_weights[i], state, work,
        )  # fmt: skip
        if not hard:
            points[i] = place
