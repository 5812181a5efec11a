"""Fits the weights to examples, and measures them on keywords that they were not fitted to."""

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from iconstudio.algorithms.iconification.plausibility import (
    FARTHEST,
    FEATURES,
    Plausibility,
    Weight,
)
from iconstudio.building.plausibility.judged import Example

STRENGTH = 0.003
"""The inverse of how strongly weights are held to zero."""
JUDGED = 40.0
"""How much more an example counts that was judged by eye: what was made is easily told."""
OUTLINE = ("missing", "missing_depth", "iou")
"""Features that are known only where an outline is wanted."""


def fit(examples: Sequence[Example]) -> Plausibility:
    """Return the weights that tell examples apart best, as many plausible ones as others.

    Every example counts twice, once as if no outline were wanted. Strongly held weights tell too
    little apart: they are made larger until the probabilities fit what was judged (Platt 1999).
    """
    from sklearn.linear_model import LogisticRegression

    values, plausible = _table(examples)
    weight = np.array([JUDGED if one.kind == "judged" else 1.0 for one in examples])
    for side in (plausible, ~plausible):
        weight[side] /= weight[side].sum()
    mean, deviation = np.nanmean(values, axis=0), np.nanstd(values, axis=0)
    deviation[deviation == 0] = 1
    blind = values.copy()
    blind[:, [FEATURES.index(name) for name in OUTLINE]] = np.nan
    both = np.nan_to_num((np.concatenate([values, blind]) - mean) / deviation)
    model = LogisticRegression(C=STRENGTH, max_iter=1000)
    model.fit(
        np.clip(both, -FARTHEST, FARTHEST),
        np.tile(plausible, 2),
        np.tile(weight * len(examples) / 4, 2),
    )
    judged = np.array([one.kind == "judged" for one in examples])
    logits = model.decision_function(np.clip(both[: len(examples)], -FARTHEST, FARTHEST))[:, None]
    odds = LogisticRegression(C=1e6).fit(logits[judged], plausible[judged])
    slope, bias = float(odds.coef_[0, 0]), float(odds.intercept_[0])
    rows = zip(FEATURES, mean, deviation, slope * model.coef_[0], strict=True)
    return Plausibility(
        tuple(Weight(name, *(round(float(v), 4) for v in some)) for name, *some in rows),
        round(slope * float(model.intercept_[0]) + bias, 4),
    )


def area_under_curve(model: Plausibility, examples: Sequence[Example]) -> float:
    """Return how often a plausible example gets more than an implausible one."""
    from sklearn.metrics import roc_auc_score

    scores = [model.of(one.features) for one in examples]
    return float(roc_auc_score([one.plausible for one in examples], scores))


def agreement(model: Plausibility, examples: Sequence[Example]) -> float:
    """Return for which part of the examples the model says what is so, at a probability of 0.5."""
    return float(np.mean([(model.of(one.features) > 0.5) == one.plausible for one in examples]))


def _table(examples: Sequence[Example]) -> tuple[NDArray[np.float64], NDArray[np.bool_]]:
    values = np.array([[one.features[name] for name in FEATURES] for one in examples])
    return values, np.array([one.plausible for one in examples])
