"""How the drawings that answer a keyword are put in order, and made different from one another."""

import numpy as np
from numpy.typing import NDArray

from iconstudio.library.fingerprint import unlikeness
from iconstudio.library.words.query import SILENT

ALIKE = 0.25
"""Drawings that differ by less look the same to somebody who looks for parts."""

NEARLY_EQUAL = 0.18
"""The same, where there are not ``PLENTY`` drawings: a thin and a bold one are then both shown,
because every style (section 3.5) needs its own."""

RELEVANT = 8
"""Drawings that score higher only mention the thing, or carry a badge of another."""

ITSELF = 2
"""Drawings that score higher are of a kind of the thing, or show more than it."""

MORE = 6
"""Drawings that score as much or higher show more than the thing, or only mention it, or are of
what is broader."""

PLENTY = 120
"""With so many relevant drawings, those that differ little are left out."""

LINES, SOLID = 41, 60
"""Drawings of less ink than the first, in percent, are of lines; from the second on, solid."""

_BLOCK = 64
"""So many drawings are compared at once."""

ENOUGH = 60
"""With so many relevant drawings, the others are left out."""


def in_order(
    icons: NDArray[np.int64], scores: NDArray[np.int64], blackness: NDArray[np.uint8]
) -> NDArray[np.int64]:
    """Return the numbers of ``icons``, the best score first.

    Among equal scores, line drawings and solid ones take turns, so that every style (section 3.5)
    has its part of what is shown; the sets are shuffled, always the same way.
    """
    shade = np.minimum(blackness[icons] // 20, 4).astype(np.int64)
    shuffled = (icons * 2654435761) % (1 << 32)
    order = np.lexsort((shuffled, shade, scores))
    groups = np.stack([scores[order], shade[order]], axis=1)
    starts = np.r_[True, (groups[1:] != groups[:-1]).any(axis=1)]
    firsts = np.flatnonzero(starts)
    turn = np.arange(len(order)) - firsts[np.cumsum(starts) - 1]
    return icons[order[np.lexsort((shade[order], turn, scores[order]))]]


def nearest_style(
    icons: NDArray[np.int64],
    scores: NDArray[np.int64],
    said: NDArray[np.int64],
    seen: NDArray[np.int64],
    strange: NDArray[np.int64],
    adds: NDArray[np.bool_],
) -> NDArray[np.int64]:
    """Return ``icons`` in the same order but those of the nearest style first.

    How far each is from it, its name has ``said``; where that is ``SILENT``, it is ``seen``.
    Of equals, the less ``strange`` names come first: a heart before a cracked one, or several. What
    is no drawing of the thing itself stays behind what is, whatever its style; and what ``adds``
    others to it, behind what may be of the style: a rounded star is no moon with rounded stars.
    """
    distances = np.where(said == SILENT, seen, said)
    far = 2 * distances + 3 * adds
    return icons[np.lexsort((said, strange, scores, far, scores > ITSELF))]


def seen_style(blackness: NDArray[np.uint8], solid: bool | None) -> NDArray[np.int64]:
    """Return 0 for drawings that are solid as is asked for, or of lines; 2 for others; 1 between.

    ``blackness`` is in percent. What is between may be either: section 3.5 counts it to both.
    """
    if solid is None:
        return np.ones(len(blackness), dtype=np.int64)
    lines = np.digitize(blackness, (LINES, SOLID))
    return 2 - lines if solid else lines


def different(cells: NDArray[np.uint64], limit: int, alike: float = ALIKE) -> list[int]:
    """Return at most ``limit`` indices of ``cells`` (n, WORDS), the first of those alike.

    They are in rising order, and no two of them differ by less than ``alike``.
    """
    kept: list[int] = []
    for start in range(0, len(cells), _BLOCK):
        block = np.arange(start, min(start + _BLOCK, len(cells)))
        far = unlikeness(cells[kept], cells[block]) >= alike
        block = block[far.all(axis=0)]
        far = unlikeness(cells[block], cells[block]) >= alike
        open_ = np.ones(len(block), dtype=bool)
        for place, index in enumerate(block.tolist()):
            if len(kept) == limit:
                return kept
            if open_[place]:
                kept.append(index)
                open_ &= far[place]
    return kept


def with_called(found: list[int], called: dict[int, bool], excluded: list[int]) -> list[int]:
    """Return ``found`` with icons that are called as the keyword is, unless one of them is there.

    Of those that are called just so, one comes first; those that are but for hyphens come last.
    """
    if not set(called).isdisjoint(found):
        return found
    left = [(number, exactly) for number, exactly in called.items() if number not in excluded]
    first = [number for number, exactly in left if exactly][:1]
    return [*first, *found, *(number for number, exactly in left if not exactly)]
