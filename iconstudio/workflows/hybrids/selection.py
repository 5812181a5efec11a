"""Selecting icons that mix well (section 4.3): one style, similar outlines, different drawings.

The paper's users choose them by hand; its figures show what makes a good choice.
"""

from collections.abc import Generator, Sequence

import numpy as np
from numpy.typing import NDArray

from iconstudio.algorithms.iconification.style import STYLES, blackness
from iconstudio.algorithms.iconification.symmetry import likeness
from iconstudio.algorithms.raster import solid
from iconstudio.grammar import counted
from iconstudio.model import CANVAS, Axis, Exemplar, IconstudioError, Pictogram
from iconstudio.workflows.events import Event
from iconstudio.workflows.hybrids.hybrids import FEWEST, MOST
from iconstudio.workflows.workflow import Resources

SYMMETRIC = 0.85
"""Least overlap with the own mirror image, under a symmetry constraint."""
DIFFERENT = 0.35
"""Least part of the ink of both in which two chosen icons must differ."""
THICKER = 1.6
"""Greatest ratio of the stroke widths of two chosen icons."""
CANDIDATES = 120
"""How many of the best exemplars of a keyword are considered."""


def select(
    resources: Resources, keyword: str, count: int, symmetry: Axis | None = None, seed: int = 0
) -> Generator[Event, None, tuple[Pictogram, ...]]:
    """Choose icons of a keyword that mix well: see ``select_icons``."""
    exemplars = yield from resources.retrieve(keyword)
    chosen = select_icons(exemplars, count, symmetry, seed)
    return tuple(one.pictogram for one in chosen)


def select_icons(
    exemplars: Sequence[Exemplar], count: int, symmetry: Axis | None = None, seed: int = 0
) -> tuple[Exemplar, ...]:
    """Return ``count`` icons of one style with similar outlines and different drawings.

    Each icon in turn gathers its nearest neighbours by outline; the group whose outlines agree
    best wins. ``seed`` n gives the n-th best group.

    Parameters
    ----------
    exemplars
        What a keyword retrieves, best first.

    Raises
    ------
    IconstudioError
        If the count is out of range, or there are too few icons that suit each other.
    """
    if not FEWEST <= count <= MOST:
        raise IconstudioError(
            f"{counted(count, 'icon')} cannot be mixed: ask for {FEWEST} to {MOST}."
        )
    shapes = [(one, solid(one.ink)) for one in exemplars[:CANDIDATES]]
    if symmetry is not None:
        shapes = [pair for pair in shapes if likeness(pair[1], symmetry) >= SYMMETRIC]
    groups: dict[frozenset[int], float] = {}
    inks = np.array([one.ink for one, _ in shapes], bool).reshape(-1, CANVAS**2)
    alike = _overlaps(np.array([shape for _, shape in shapes], bool).reshape(-1, CANVAS**2))
    widths = np.array([stroke_width(one.ink) for one, _ in shapes])
    for style in STYLES:
        members = [k for k, (one, _) in enumerate(shapes) if style.admits(blackness(one.ink))]
        for first in members:
            near = [k for k in members if abs(np.log(widths[k] / widths[first])) < np.log(THICKER)]
            group = _gather(first, near, alike, inks, count)
            if len(group) == count:
                within = alike[np.ix_(group, group)]
                groups[frozenset(group)] = float(within.sum() - count) / (count * (count - 1))
    if not groups:
        raise IconstudioError(
            f"The collection has no {count} icons of this keyword that are alike enough to mix. "
            "Ask for fewer, choose them yourself, or try another word."
        )
    ranked = sorted(groups, key=lambda group: (-groups[group], sorted(group)))
    return tuple(shapes[k][0] for k in sorted(ranked[seed % len(ranked)]))


def _gather(
    first: int,
    members: Sequence[int],
    alike: NDArray[np.float64],
    inks: NDArray[np.bool_],
    count: int,
) -> list[int]:
    """Return ``first`` and those whose outlines are most like its own, all drawn differently."""
    group = [first]
    for k in sorted(members, key=lambda k: -alike[first, k]):
        if len(group) < count and k not in group:
            either = (inks[group] | inks[k]).sum(axis=1)
            if ((inks[group] ^ inks[k]).sum(axis=1) > DIFFERENT * either).all():
                group.append(k)
    return group


def stroke_width(ink: NDArray[np.bool_]) -> float:
    """Return the mean width of the strokes of an ink (h, w) bool, in pixels."""
    rim = sum(int((ink ^ np.roll(ink, 1, axis=axis)).sum()) for axis in (0, 1))
    return 2 * float(ink.sum()) / max(1, rim)


def _overlaps(shapes: NDArray[np.bool_]) -> NDArray[np.float64]:
    """Return intersection over union of all pairs of shapes (K, pixels), (K, K)."""
    flat = shapes.astype(np.float32)
    common = flat @ flat.T
    area = flat.sum(axis=1)
    either: NDArray[np.float32] = area[:, None] + area[None] - common
    return (common / np.maximum(either, 1)).astype(np.float64)
