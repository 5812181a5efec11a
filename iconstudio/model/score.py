"""How good a remix looks, in terms that each lie between 0 and 1; 1 is best."""

import math
from dataclasses import dataclass

FAITHFUL = 0.7
"""What overlaps the outline that was wanted by less is of another shape."""


@dataclass(frozen=True, slots=True)
class Score:
    """The terms of a rank score."""

    seam: float
    """Low cost of the visible seams for the length of what is drawn."""
    whole: float
    """No pieces that float free where no source has them."""
    symmetry: float
    """As symmetric as the sources are; 1 without a constraint."""
    sharing: float
    """Ink that comes from several sources; 1 where that is not asked for."""
    likeness: float
    """Overlap with the outline that was wanted; 1 if none was."""
    inside: float = 1.0
    """How much of the holes and lines that were drawn inside is there; 1 if none were."""
    plausible: float | None = None
    """The learned probability that the picture is plausible; None if it was not asked."""

    @property
    def total(self) -> float:
        """The rank score: the product of the terms; that of ``likeness`` falls soon below 0.7.

        What is plausible was told by ``seam`` and ``whole``, too: then these count by their roots.
        It counts twice, as a good picture matters more than a near fit: so more of the first ones
        are fit to be handed over, of those that were judged by eye.
        """
        looks = self.seam * self.whole
        if self.plausible is not None:
            looks = math.sqrt(looks) * self.plausible**2
        fit = self.likeness * min(1.0, self.likeness / FAITHFUL) ** 2
        return looks * self.symmetry * self.sharing * fit * self.inside
