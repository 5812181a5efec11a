"""How plausible a remix is: a logistic regression over standardised features.

An addition to the paper, whose authors judge results by eye (section 5.1). ``building``
fits the weights; ``features`` says what they are of.
"""

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

VERSION = 2
"""That of the features: weights fitted to others fit no more."""
FEATURES = (
    "unlike_ink",
    "unlike_filled",
    "holes_of_nearest",
    "symmetry",
    "placed_filled",
    "gap",
    "foreign",
    "foreign_length",
    "foreign_worst",
    "seam",
    "smoothness_cost",
    "loose",
    "more_pieces",
    "fewer_pieces",
    "more_holes",
    "fewer_holes",
    "new_ends",
    "width_spread",
    "widths_mixed",
    "sources",
    "shown",
    "moves",
    "missing",
    "missing_depth",
    "iou",
    "lopsided",
)
"""What is measured, by ``features``."""
OF_OUTLINE = "missing", "missing_depth", "iou", "lopsided"
"""Of these what is known only where an outline is wanted."""
FARTHEST = 4.0
"""Values further from the mean than so many standard deviations count as if they were there."""


@dataclass(frozen=True, slots=True)
class Weight:
    """What a feature counts for."""

    feature: str
    mean: float
    deviation: float
    weight: float
    """Of the standardised value: what it adds to the logarithm of the odds."""


@dataclass(frozen=True, slots=True)
class Plausibility:
    """The weights of all features, and what is added for none."""

    weights: tuple[Weight, ...]
    bias: float

    def of(self, features: Mapping[str, float]) -> float:
        """Return the probability that a picture with these features is plausible.

        A feature that is not known, NaN, counts for nothing.

        >>> model = Plausibility((Weight("loose", 0.5, 0.5, -1.0),), 0.0)
        >>> [round(model.of({"loose": value}), 2) for value in (0.0, 0.5, 1.0, float("nan"))]
        [0.73, 0.5, 0.27, 0.5]
        """
        values = np.array([features[one.feature] for one in self.weights])
        mean = np.array([one.mean for one in self.weights])
        deviation = np.array([one.deviation for one in self.weights])
        standard = np.nan_to_num((values - mean) / deviation)
        terms = np.clip(standard, -FARTHEST, FARTHEST) * [one.weight for one in self.weights]
        return float(1 / (1 + np.exp(-self.bias - terms.sum())))
