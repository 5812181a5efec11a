"""Style consistency (section 3.5): blackness, and the four overlapping intervals."""

from dataclasses import dataclass

import numpy as np
import scipy
from numpy.typing import NDArray


@dataclass(frozen=True, slots=True)
class Style:
    """A closed interval of blackness."""

    name: str
    low: float
    high: float

    def admits(self, blackness: float) -> bool:
        """Whether a pictogram of this blackness belongs to the style.

        >>> [style.name for style in STYLES if style.admits(0.5)]
        ['light', 'medium']
        """
        return self.low <= blackness <= self.high


STYLES = (
    Style("lightest", 0.0, 0.4),
    Style("light", 0.2, 0.6),
    Style("medium", 0.4, 0.8),
    Style("dark", 0.6, 1.0),
)
"""The table of section 3.5."""


def has_pale_areas(coverage: NDArray[np.uint8], low: int = 30, high: int = 225) -> bool:
    """Whether a drawing (h, w) uint8 has pale areas, between two levels, not only soft edges.

    A pale layer is no ink (section 3.1: black and white), so what is left of such an icon may be a
    part of it only.
    """
    pale = (coverage > low) & (coverage < high)
    columns = pale[:-2] & pale[1:-1] & pale[2:]
    return bool((columns[:, :-2] & columns[:, 1:-1] & columns[:, 2:]).any())  # 3 x 3 pixels


def blackness(ink: NDArray[np.bool_]) -> float:
    """Return the proportion of black pixels in the convex hull of a pictogram.

    ``ink`` is (h, w) bool. Pixels are unit squares, so a filled rectangle measures exactly 1.
    Without ink the answer is 0.

    >>> round(blackness(np.array([[True, False, True]])), 3)
    0.667
    """
    ys, xs = np.nonzero(ink)
    if len(ys) == 0:
        return 0.0
    # Only the ends of each row can be corners of the hull.
    rows, first = np.unique(ys, return_index=True)
    last = np.append(first[1:], len(ys)) - 1
    left, right = xs[first], xs[last] + 1
    corners = np.concatenate(
        [np.stack([x, rows + dy], axis=1) for x in (left, right) for dy in (0, 1)]
    )
    try:
        area = float(scipy.spatial.ConvexHull(corners).volume)
    except scipy.spatial.QhullError:  # pragma: no cover - unit squares always span an area
        return 0.0
    return min(1.0, len(ys) / area)
