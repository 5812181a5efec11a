"""The weights that come with the program, by which it tells plausible results from others."""

from pathlib import Path
from typing import Annotated, Self

from msgspec import Meta

from iconstudio.algorithms.iconification.plausibility import (
    FEATURES,
    VERSION,
    Plausibility,
    Weight,
)
from iconstudio.inputs import json
from iconstudio.inputs.formats import Coordinate, Many, Record, Text
from iconstudio.model import IconstudioError
from iconstudio.resources import resource

BUNDLED = resource("plausibility.json")


class StoredWeight(Record, frozen=True):
    """What a feature counts for."""

    feature: Text
    mean: Coordinate
    deviation: Annotated[float, Meta(gt=0, le=1e9)]
    weight: Coordinate


class PlausibilityFile(Record, frozen=True, kw_only=True):
    """A table of weights, for the features of one version of the program."""

    version: int
    bias: Coordinate
    weights: Many[StoredWeight]

    @classmethod
    def of(cls, model: Plausibility) -> Self:
        """Return weights as they are written."""
        rows = (StoredWeight(w.feature, w.mean, w.deviation, w.weight) for w in model.weights)
        return cls(version=VERSION, bias=model.bias, weights=tuple(rows))

    @property
    def model(self) -> Plausibility:
        """The value."""
        rows = (Weight(w.feature, w.mean, w.deviation, w.weight) for w in self.weights)
        return Plausibility(tuple(rows), self.bias)

    def check(self) -> None:
        """Refuse weights for other features."""
        if self.version != VERSION:
            raise IconstudioError(
                f"Its version is {self.version}, and this program needs version {VERSION}."
            )
        names = {one.feature for one in self.weights}
        if names != set(FEATURES):
            odd = ", ".join(sorted(names ^ set(FEATURES)))
            raise IconstudioError(f"It does not have the features that are needed: {odd}.")


def read_plausibility(path: Path = BUNDLED) -> Plausibility:
    """Return the weights in a file.

    Raises
    ------
    IconstudioError
        If it cannot be read, or fits another version of the program.
    """
    try:
        return json.read(path, PlausibilityFile).model
    except IconstudioError as error:
        raise IconstudioError(
            f"Results are ranked by simple rules, not by what was learned. {error} "
            "Install the program again to mend this."
        ) from None
