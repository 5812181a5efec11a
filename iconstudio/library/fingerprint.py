"""A small picture of an icon's shape, to tell near-identical drawings from different ones.

The tight bounding box of the ink is scaled to a square of ``SIDE`` cells, proportions kept, and
a cell is set if it is dark enough. Two drawings are alike if few cells differ, in
proportion to those that either has set.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

SIDE = 16
"""Cells along each side of the fingerprint."""
WORDS = SIDE * SIDE // 64

_DARK = 0.35
"""A cell is set from this part of its area on."""


@dataclass(frozen=True, slots=True)
class Fingerprint:
    """What a drawing looks like from afar."""

    cells: bytes
    """SIDE * SIDE bits, row by row, the most significant bit first."""
    blackness: int
    """Percentage of ink within the convex hull (section 3.5), 0 to 100."""


def fingerprint(coverage: NDArray[np.uint8]) -> Fingerprint | None:
    """Return the fingerprint of a picture, (n, n) uint8, 255 = ink; None if it is empty.

    Also None if the drawing is mostly paler than ink (a duotone that has no dark layer).
    """
    from PIL import Image

    from iconstudio.algorithms.iconification.style import blackness

    ink = coverage > 127
    if not ink.any():
        return None
    rows, columns = np.flatnonzero(ink.any(axis=1)), np.flatnonzero(ink.any(axis=0))
    box = (int(columns[0]), int(rows[0]), int(columns[-1]) + 1, int(rows[-1]) + 1)
    width, height = box[2] - box[0], box[3] - box[1]
    side = max(width, height)
    square = Image.new("L", (side, side))
    tight = Image.fromarray(np.where(ink, coverage, 0).astype(np.uint8)).crop(box)
    square.paste(tight, ((side - width) // 2, (side - height) // 2))
    small = np.asarray(square.resize((SIDE, SIDE), Image.Resampling.BOX))
    cells = np.packbits(small > 255 * _DARK).tobytes()
    return Fingerprint(cells, round(100 * blackness(ink)))


def stack(cells: list[bytes]) -> NDArray[np.uint64]:
    """Return fingerprints' cells as (n, WORDS) uint64."""
    return np.frombuffer(b"".join(cells), dtype=np.uint64).reshape(-1, WORDS)


def unlikeness(some: NDArray[np.uint64], others: NDArray[np.uint64]) -> NDArray[np.float64]:
    """Return how far each of some drawings (m, WORDS) is from each other one (n, WORDS), as (m, n).

    0 = the same cells, 1 = none in common: the Jaccard distance.
    """
    common = np.zeros((len(some), len(others)), dtype=np.intp)
    for word in range(WORDS):
        common += np.bitwise_count(some[:, word, None] & others[:, word])
    sizes = (np.bitwise_count(cells).sum(axis=1, dtype=np.intp) for cells in (some, others))
    union = np.add.outer(*sizes) - common
    distances: NDArray[np.float64] = (union - common) / np.maximum(union, 1)
    return distances
