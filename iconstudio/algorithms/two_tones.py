"""A coloured drawing in ink and paper: what lies on something of another colour shows against it.

Not how dark a colour is tells ink from paper, as in drawings of others (``tones``), but what it
lies on: white sails on a blue sea are ink, and so are blue ones on a white ground.
"""

from collections.abc import Iterable
from dataclasses import replace

from iconstudio.algorithms.areas import beneath, filled
from iconstudio.algorithms.flattening import flattened
from iconstudio.model import Fill

INK, PAPER = "#000000", "#ffffff"
_STRAY = 1.0
_MOST = 0.5
"""What covers more than that of a shape is what it lies on."""


def in_two_tones(fills: Iterable[Fill]) -> tuple[Fill, ...]:
    """Return shapes, from back to front, in ink or in the colour of paper.

    What lies on the ground is ink. What lies on another shape is as that is if it has its colour,
    and else the opposite.
    """
    given = list(fills)
    areas = [filled(row for row, _ in flattened(one.path, _STRAY)) for one in given]
    found: list[Fill] = []
    for fill, on in zip(given, beneath(areas, _MOST), strict=True):
        if on is None:
            tone = INK
        elif given[on].colour == fill.colour:
            tone = found[on].colour
        else:
            tone = PAPER if found[on].colour == INK else INK
        found.append(replace(fill, colour=tone))
    return tuple(found)
