"""Samples of a curve that is being made: compiled, as they change with each of its points."""

import numpy as np

from iconstudio.algorithms.compiled import part

EXACT = 1e-7
"""What differs by less is the same, but for rounding."""


@part
def _between(points, count, closed, k, following, at):  # type: ignore[no-untyped-def]
    """Return the place of a point of a side, on Catmull and Rom's cubic instead of the side."""
    p = points[k]
    q = points[following]
    way = following - k
    if way > 1 or way < -1:  # around the start of a closed curve
        way = -1 if way > 0 else 1
    before = k - way
    after = following + way
    if closed:
        before %= count
        after %= count
    elif before < 0 or before >= count or after < 0 or after >= count:
        return at
    u = np.abs(at - p) / np.abs(q - p)
    m = 0.5 * (q - points[before])
    n = 0.5 * (points[after] - p)
    return p + u * m + u * u * (3.0 * (q - p) - 2.0 * m - n) + u * u * u * (2.0 * (p - q) + m + n)


@part
def samples_around(points, arcs, count, i, around, closed, spacing, samples, places):  # type: ignore[no-untyped-def]
    """Sample the first ``count`` points' polyline around the i-th, ``spacing`` apart by arc length.

    ``places`` tells where along the sweep samples are, relative to the middle one; points are at
    ``arcs``, and a closed sweep is ``around`` long. Returns the first and the last sample that lie
    on the polyline.
    """
    middle = len(samples) // 2
    samples[middle] = points[i]
    places[middle] = 0.0
    first = middle
    last = middle
    for way in (-1, 1):
        at = points[i]
        k = i
        left = spacing
        sample = middle + way
        swept = 0.0
        walked = 0
        while 0 <= sample < len(samples) and walked <= count:
            following = k + way
            if closed:
                following %= count
            elif following < 0 or following >= count:
                break
            gap = points[following] - at
            far = np.abs(gap)
            onward = arcs[following] - arcs[i] - swept
            if closed:
                onward -= around * np.rint((onward - way * left) / around) if around > 0.0 else 0.0
            if far >= left * (1.0 - EXACT) and far > 0.0:
                at += gap * (left / far)
                swept += onward * (left / far)
                samples[sample] = _between(points, count, closed, k, following, at)
                places[sample] = swept
                sample += way
                left = spacing
            else:
                left -= far
                at = points[following]
                swept += onward
                k = following
                walked += 1
        if way < 0:
            first = sample + 1
        else:
            last = sample - 1
    return first, last


@part
def unbend(samples, places, first, last, bends, spacing):  # type: ignore[no-untyped-def]
    """Take the bend of the sweep, given ``spacing`` apart, out of samples at these places of it."""
    middle = len(samples) // 2
    for k in range(first, last + 1):
        at = min(max(places[k] / spacing + middle, 0.0), len(samples) - 1.000001)
        low = int(at)
        samples[k] -= bends[low] + (at - low) * (bends[low + 1] - bends[low])


@part
def point_out(samples, first, last, ways):  # type: ignore[no-untyped-def]
    """Fill the directions between samples that lie on a curve."""
    for k in range(first, last):
        gap = samples[k + 1] - samples[k]
        far = np.abs(gap)
        ways[k] = gap / far if far > 0.0 else 0.0j
