"""The E-step for distances: the level set method (section 2, equations 3 to 5).

The zero level set moves along its normal. With negative distances inside, equations 4 and 5 are

    phi_t = -2 lambda (phi - mean of the matches' phi) |grad phi| + mu kappa |grad phi|,

where kappa is the divergence of grad phi / |grad phi|. So the velocity pulls phi to the mean, and
curvature shortens contours: a circle of radius r shrinks by mu / r in a unit of time. (As printed,
under phi_t + V . grad phi = 0, equation 5 has the unstable sign.)

Where we depart from the paper:

- The mean instead of the sum over all neighbourhoods that cover a pixel, of which there are 16, and
  mu divided by 16: it is the same balance, whatever the number.
- |grad phi| is taken upwind, but counts as at least ``LEAST_SLOPE``, and at most 1. At the
  middle of a thin line it vanishes, so that a line that ever came too close to another could never
  return.
- Curvature acts within the narrow band only; what is farther is pulled to the mean alone.
"""

import numpy as np
from numpy.typing import NDArray

from iconstudio.algorithms.compiled import entry
from iconstudio.algorithms.patterns.distance import bordered

Field = NDArray[np.float32]

STEPS = 5
"""Of time, in an E-step."""
TIME = 0.5
BAND = 2.0
"""Pixels on either side of the zero level set in which its curvature acts."""
LEAST_SLOPE = 0.5
COVERING = 16
"""Neighbourhoods that cover a pixel."""


def evolved(distance: Field, mean: Field, attraction: float, smoothing: float, tile: bool) -> Field:
    """Return a distance function (h, w) after ``STEPS`` of time.

    Parameters
    ----------
    mean
        (h, w), of the matches' distance functions.
    attraction, smoothing
        lambda and mu of equation 5.
    """
    for _ in range(STEPS):
        distance = step(distance, mean, attraction, smoothing / COVERING, TIME, tile)
    return distance


def step(
    distance: Field, mean: Field, attraction: float, smoothing: float, time: float, tile: bool
) -> Field:
    """Return a distance function (h, w) a while later; ``smoothing`` is in square pixels."""
    after = np.empty_like(distance)
    _step(bordered(distance, 1, tile), mean, attraction, smoothing, time, after)
    return after


@entry
def _step(phi, mean, attraction, smoothing, time, after):  # type: ignore[no-untyped-def]
    """Fill in ``after`` (h, w) from ``phi`` (h + 2, w + 2)."""
    height, width = after.shape
    for i in range(height):
        for j in range(width):
            y, x = i + 1, j + 1
            here = phi[y, x]
            speed = 2 * attraction * (here - mean[i, j])
            left, right = here - phi[y, x - 1], phi[y, x + 1] - here
            above, below = here - phi[y - 1, x], phi[y + 1, x] - here
            if speed > 0:  # outward: phi sinks, and what is known comes from inside
                a = max(left, 0.0) ** 2 + min(right, 0.0) ** 2
                b = max(above, 0.0) ** 2 + min(below, 0.0) ** 2
            else:
                a = min(left, 0.0) ** 2 + max(right, 0.0) ** 2
                b = min(above, 0.0) ** 2 + max(below, 0.0) ** 2
            slope = max(np.sqrt(a + b), LEAST_SLOPE)
            change = -speed * min(slope, 1.0)
            if abs(here) < BAND:
                dx, dy = (left + right) / 2, (above + below) / 2
                square = dx * dx + dy * dy
                if square > 1e-6:
                    xx, yy = right - left, below - above
                    xy = (phi[y + 1, x + 1] - phi[y + 1, x - 1]
                          - phi[y - 1, x + 1] + phi[y - 1, x - 1]) / 4  # fmt: skip
                    curved = (xx * dy * dy - 2 * dx * dy * xy + yy * dx * dx) / square
                    change += smoothing * curved
            after[i, j] = here + time * change
