"""Places on polylines, compiled: curves are evaluated thousands of times for an icon."""

import numpy as np

from iconstudio.algorithms.compiled import entry


@entry
def interpolated(places, knots, points):  # type: ignore[no-untyped-def]
    """Return the points (n,) at ``places`` between knots; beyond them, straight on.

    There are two ``points`` or more, complex, at knots that increase or are the same.
    """
    last = len(knots) - 2
    found = np.empty(len(places), np.complex128)
    index = 0
    for i in range(len(places)):
        place = places[i]
        # Places mostly follow one another.
        if not (knots[index] <= place < knots[index + 1]):
            index = min(max(np.searchsorted(knots, place, "right") - 1, 0), last)
        gap = knots[index + 1] - knots[index]
        part = (place - knots[index]) / (gap if gap > 0.0 else 1.0)
        found[i] = points[index] + part * (points[index + 1] - points[index])
    return found
