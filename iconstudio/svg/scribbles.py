"""Outlines that run across the page without end: a renderer takes minutes for one.

It follows, on every row of the picture, all the sides of an outline that cross it; what that takes
grows with their square.
"""

import math
import xml.etree.ElementTree as ET
from collections.abc import Iterable
from itertools import pairwise

from iconstudio.model import IconstudioError
from iconstudio.svg.geometry import corners

MOST_CROSSINGS = 6_000
"""How often outlines may cross rows or columns, on average: it takes the renderer a second."""
_LONG = 20_000
"""Letters of outlines that are counted: shorter ones cross less often."""


def refuse_scribbles(elements: Iterable[ET.Element]) -> None:
    """Return if outlines cross the page no more than ``MOST_CROSSINGS`` times.

    Raises
    ------
    IconstudioError
        If they do.
    """
    work = 0.0
    for element in elements:
        data = element.get("d", element.get("points", ""))
        if len(data) > _LONG:
            points = corners(data if "d" in element.attrib else f"M{data}")
            work += max(map(_crossings, zip(*points, strict=True)), default=0.0) ** 2
        if work > MOST_CROSSINGS**2:
            raise IconstudioError(
                f"Its lines cross the page more than {MOST_CROSSINGS:,} times. Simplify the "
                "drawing, or save it as a PNG and open that."
            )


def _crossings(places: tuple[float, ...]) -> float:
    """Return how often a line that goes through places crosses one between them, on average."""
    extent = max(places) - min(places)
    way = math.fsum(abs(after - before) for before, after in pairwise(places))
    return way / extent if 0 < extent < math.inf else 0.0
