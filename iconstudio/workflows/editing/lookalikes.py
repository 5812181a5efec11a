"""Other files of the drawing that is edited, and other drawings of the same thing."""

from iconstudio.algorithms.iconification.matching import Matcher
from iconstudio.algorithms.raster import overlap
from iconstudio.model import Exemplar

SAME = 0.97
"""Overlap of ink from which two icons on the canvas are one drawing."""


_FEW = 0.1
"""So many of the drawings of a hat may have a cat in their names."""


def lookalikes(icon: Exemplar, matcher: Matcher) -> frozenset[str]:
    """Return the identifiers of an icon, and of the exemplars that are the same drawing.

    They would put back what is to be removed.
    """
    found = (one.exemplar for one in matcher.exemplars)
    same = (one.id for one in found if overlap(one.ink, icon.ink) > SAME)
    return frozenset({icon.id, *same})


def names_part(icon: Exemplar, matcher: Matcher) -> bool:
    """Whether exemplars are drawings of another thing than an icon: of what is added to it.

    Their keyword does not find the icon, nor others whose names begin as its does.
    """
    found = [one.exemplar for one in matcher.exemplars]
    called = sum(_first_word(one) == _first_word(icon) for one in found)
    same = lookalikes(icon, matcher).intersection(one.id for one in found)
    return not same and called <= _FEW * len(found)


def _first_word(icon: Exemplar) -> str:
    return icon.id.rpartition(":")[2].partition("-")[0]
