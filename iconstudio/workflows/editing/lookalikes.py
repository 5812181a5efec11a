"""Other files of the drawing that is edited."""

from iconstudio.algorithms.iconification.matching import Matcher
from iconstudio.algorithms.raster import overlap
from iconstudio.model import Exemplar

SAME = 0.97
"""Overlap of ink from which two icons on the canvas are one drawing."""


def lookalikes(icon: Exemplar, matcher: Matcher) -> frozenset[str]:
    """Return the identifiers of an icon, and of the exemplars that are the same drawing.

    They would put back what is to be removed.
    """
    found = (one.exemplar for one in matcher.exemplars)
    same = (one.id for one in found if overlap(one.ink, icon.ink) > SAME)
    return frozenset({icon.id, *same})
