"""What makes a remix look right or wrong, in numbers: the features of learned plausibility.

The best ones tell how far the picture is from the nearest real drawing; most others compare it
with its sources, each counting by its part of the ink, and some with the outline that was wanted.
What is not known, such as the latter where there is none, is NaN.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np
import scipy
from numpy.typing import NDArray

from iconstudio.algorithms.iconification.energy import Labels, RemixProblem
from iconstudio.algorithms.iconification.looks import STRIDE, Looks, foreignness, unlikeness
from iconstudio.algorithms.iconification.plausibility import OF_OUTLINE
from iconstudio.algorithms.iconification.symmetry import ROUGHLY
from iconstudio.algorithms.raster import Bitmap, overlap
from iconstudio.model import CANVAS, Score, Source

FOREIGN = 0.35
"""From this distance on, in canvas pixels, a stretch of contour is like none of its sources'."""
WORST = 4.0
"""Stretches that are more unlike than this, in canvas pixels, are all equally wrong."""
SMALL = 0.01
"""What owns less of the ink is no source to speak of."""
NEAR = 6.0
"""Ends of lines so near to each other, in canvas pixels, are the same."""
SEVERAL = 5
"""How many of the nearest drawings are asked."""


@dataclass(frozen=True, eq=False)
class Remixed:
    """A remix as it is judged.

    Attributes
    ----------
    labels
        (m, m): owners.
    drawn
        (CANVAS, CANVAS) bool: the picture.
    score
        Of its terms, those for seams and loose pieces are features, too.
    looks
        Those of all sources.
    outline
        Those of the filled outline that was wanted, if one was.
    """

    problem: RemixProblem
    labels: Labels
    drawn: Bitmap
    score: Score
    sources: Sequence[Source]
    looks: Sequence[Looks]
    outline: Looks | None = None

    @cached_property
    def own(self) -> Looks:
        """How the picture looks."""
        return Looks(self.drawn)

    @cached_property
    def owners(self) -> Labels:
        """(CANVAS, CANVAS): owners of the canvas's pixels."""
        finer = len(self.labels) // CANVAS
        return self.labels[::finer, ::finer]

    @cached_property
    def shares(self) -> NDArray[np.float64]:
        """(K,): each source's part of the ink; of next to none, nothing."""
        owned = np.bincount(self.owners[self.drawn], minlength=len(self.sources)).astype(float)
        owned[owned < SMALL * owned.sum()] = 0
        if not owned.any():
            owned[np.bincount(self.owners.ravel()).argmax()] = 1
        shares: NDArray[np.float64] = owned / owned.sum()
        return shares

    @cached_property
    def used(self) -> tuple[int, ...]:
        """The sources to speak of."""
        return tuple(map(int, np.flatnonzero(self.shares)))

    def expected(self, values: Sequence[float]) -> float:
        """Return the mean of a value of each used source, each by its share."""
        return float(self.shares[list(self.used)] @ np.array(values))

    def spread(self, values: Sequence[float]) -> float:
        """Return the standard deviation of a value of each used source."""
        middle = self.expected(values)
        return float(np.sqrt(self.expected([(value - middle) ** 2 for value in values])))


def features(remixed: Remixed) -> dict[str, float]:
    """Return the features by name; NaN where one is not known."""
    return {
        **_nearest(remixed),
        **_placed(remixed),
        **_contour(remixed),
        **_parts(remixed),
        **_sharing(remixed),
        **_misfit(remixed),
    }


def _nearest(remixed: Remixed) -> dict[str, float]:
    """Return how unlike the picture is to the nearest real drawings, stretched onto each other."""
    own, looks = remixed.own, remixed.looks
    ink = np.array([unlikeness(own.thumb, one.thumb) for one in looks])
    filled = np.array([unlikeness(own.filled_thumb, one.filled_thumb) for one in looks])
    near = looks[int((ink + 2 * filled).argmin())]
    holes = np.log1p([len(own.holes), len(near.holes)])
    return {
        "unlike_ink": float(ink.min()),
        "unlike_filled": float(filled.min()),
        "holes_of_nearest": float(abs(holes[0] - holes[1])),
        "symmetry": max(0.0, max(one.symmetry for one in looks) - own.symmetry),
    }


def _placed(remixed: Remixed) -> dict[str, float]:
    """Return how unlike the filled picture is to single sources as they lie, and what it lacks."""
    own = remixed.own
    filled = np.stack([one.filled for one in remixed.looks])
    outside = (filled ^ own.filled).sum(axis=(1, 2)) / np.maximum(
        1, (filled | own.filled).sum(axis=(1, 2))
    )
    nearest = filled[int(outside.argmin())]
    return {
        "placed_filled": float(np.sort(outside)[:SEVERAL].mean()),
        "gap": _depth(nearest & ~own.filled) / CANVAS,
    }


def _contour(remixed: Remixed) -> dict[str, float]:
    """Return what is wrong with the contour where sources meet."""
    own, looks = remixed.own, remixed.looks
    some = own.stretches
    foreign = np.zeros(len(some), np.float32)
    y, x = (np.clip(some[..., i].astype(int), 0, CANVAS - 1) for i in (1, 0))
    owners = remixed.owners[y, x]
    mixed = (owners != owners[:, :1]).any(axis=1)
    foreign[mixed] = WORST
    for k in remixed.used:
        rows = np.flatnonzero(mixed & (owners == k).any(axis=1))
        if len(rows):
            foreign[rows] = np.minimum(foreign[rows], foreignness(some[rows], looks[k].stretches))
    unlike = foreign > FOREIGN
    worst = np.sort(foreign)[-max(1, len(foreign) // 20) :]
    smoothness = remixed.problem.costs(remixed.labels)[1] * CANVAS / remixed.problem.side
    return {
        "foreign": float(unlike.mean()) if len(unlike) else 0.0,
        "foreign_length": float(np.log1p(STRIDE * unlike.sum() / CANVAS)),
        "foreign_worst": float(worst.mean()) if len(worst) else 0.0,
        "seam": 1 - remixed.score.seam,
        "smoothness_cost": float(np.log1p(smoothness / max(1, own.length))),
    }


def _parts(remixed: Remixed) -> dict[str, float]:
    """Return what pieces, holes and ends there are too many or too few, and what widths."""
    own, looks, used = remixed.own, remixed.looks, remixed.used
    found = {"loose": 1 - remixed.score.whole}
    for name in ("pieces", "holes"):
        usual = remixed.expected([float(np.log1p(len(getattr(looks[k], name)))) for k in used])
        more = float(np.log1p(len(getattr(own, name)))) - usual
        found[f"more_{name}"], found[f"fewer_{name}"] = max(0.0, more), max(0.0, -more)
    ends = own.ends
    nearest = np.full(len(ends), np.inf)
    for k in used:
        if len(ends) and len(looks[k].ends):
            away = scipy.spatial.distance.cdist(ends, looks[k].ends).min(axis=1)
            nearest = np.minimum(nearest, away)
    return found | {
        "new_ends": float(np.log1p((nearest > NEAR).sum())),
        "width_spread": own.width_spread - remixed.expected([looks[k].width_spread for k in used]),
        "widths_mixed": remixed.spread([float(np.log(looks[k].width)) for k in used]),
    }


def _sharing(remixed: Remixed) -> dict[str, float]:
    """Return among how many sources the picture is divided, and how far these were moved."""
    used = remixed.used
    some = remixed.shares[list(used)]
    placed = [remixed.sources[k].placement for k in used]
    shown = [
        float((remixed.drawn & remixed.looks[k].ink & (remixed.owners == k)).sum())
        / max(1, remixed.looks[k].area)
        for k in used
    ]
    dx, dy = remixed.spread([one.dx for one in placed]), remixed.spread([one.dy for one in placed])
    return {
        "sources": float(-(some * np.log(some)).sum()),  # entropy: of n equal ones log n
        "shown": remixed.expected(shown),
        "moves": float(np.hypot(dx, dy)) / CANVAS,
    }


def _misfit(remixed: Remixed) -> dict[str, float]:
    """Return what of the outline is missing, and of its symmetry."""
    own, outline = remixed.own, remixed.outline
    if outline is None:
        return dict.fromkeys(OF_OUTLINE, float("nan"))
    missing, size = outline.ink & ~own.filled, max(1, outline.area)
    symmetric = outline.symmetry >= ROUGHLY
    return {
        "missing": float(missing.sum() / size),
        "missing_depth": float(_depth(missing) / np.sqrt(size)),
        "iou": overlap(own.filled, outline.ink),
        "lopsided": max(0.0, outline.symmetry - own.ink_symmetry) if symmetric else 0.0,
    }


def _depth(shape: Bitmap) -> float:
    """Return the radius of the largest disc in a shape, in canvas pixels, at half resolution."""
    half = np.pad(shape[::2, ::2], 1)
    if not half.any():
        return 0.0
    return 2 * float(scipy.ndimage.distance_transform_edt(half).max())
