"""Fits the weights to examples, and measures them on keywords that they were not fitted to."""

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from iconstudio.algorithms.iconification.plausibility import (
    FARTHEST,
    FEATURES,
    OF_OUTLINE,
    Plausibility,
    Weight,
)
from iconstudio.building.plausibility.judged import FIT, PLAUSIBLE, Example

STRENGTH = 0.003
"""The inverse of how strongly weights are held to zero."""
JUDGED = 40.0
"""How much more an example counts that was judged by eye: what was made is easily told."""


def fit(examples: Sequence[Example]) -> Plausibility:
    """Return the weights that tell examples apart best, as many plausible ones as others.

    Every example counts four times: as if no outline were wanted, too, and whether it is plausible
    and whether it is fit to be handed over. Strongly held weights tell too little apart: they are
    made larger until the probabilities fit which of the judged ones are plausible (Platt 1999).
    """
    from sklearn.linear_model import LogisticRegression

    values, grades = _table(examples)
    judged = np.array([one.kind == "judged" for one in examples])
    grades[~judged & (grades >= PLAUSIBLE)] = FIT  # of whole icons and the like
    mean, deviation = np.nanmean(values[judged], axis=0), np.nanstd(values[judged], axis=0)
    deviation[deviation == 0] = 1
    blind = values.copy()
    blind[:, [FEATURES.index(name) for name in OF_OUTLINE]] = np.nan
    both = np.nan_to_num((np.concatenate([values, blind]) - mean) / deviation)
    both = np.clip(both, -FARTHEST, FARTHEST)
    good = np.concatenate([np.tile(grades >= grade, 2) for grade in (PLAUSIBLE, FIT)])
    weight = np.tile(np.where(judged, JUDGED, 1.0), 4)
    for side in (good, ~good):
        weight[side] /= weight[side].sum()
    model = LogisticRegression(C=STRENGTH, max_iter=1000)
    model.fit(np.tile(both, (2, 1)), good, weight * len(examples) / 2)
    logits = model.decision_function(both[: len(examples)])[:, None]
    odds = LogisticRegression(C=1e6).fit(logits[judged], grades[judged] >= PLAUSIBLE)
    slope, bias = float(odds.coef_[0, 0]), float(odds.intercept_[0])
    rows = zip(FEATURES, mean, deviation, slope * model.coef_[0], strict=True)
    return Plausibility(
        tuple(Weight(name, *(round(float(v), 4) for v in some)) for name, *some in rows),
        round(slope * float(model.intercept_[0]) + bias, 4),
    )


def area_under_curve(
    model: Plausibility, examples: Sequence[Example], least: int = PLAUSIBLE
) -> float:
    """Return how often an example of at least a grade gets more than one below it."""
    from sklearn.metrics import roc_auc_score

    scores = [model.of(one.features) for one in examples]
    return float(roc_auc_score([one.grade >= least for one in examples], scores))


def agreement(model: Plausibility, examples: Sequence[Example]) -> float:
    """Return for which part of the examples the model says what is so, at a probability of 0.5."""
    return float(np.mean([(model.of(one.features) > 0.5) == one.plausible for one in examples]))


def _table(examples: Sequence[Example]) -> tuple[NDArray[np.float64], NDArray[np.int64]]:
    values = np.array([[one.features[name] for name in FEATURES] for one in examples])
    return values, np.array([one.grade for one in examples])
