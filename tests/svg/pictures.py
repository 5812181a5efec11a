"""Documents by the whole way in, as pictures."""

from functools import cache

import numpy as np

from iconstudio.model import Pictogram
from iconstudio.svg.rasterise import rasterise
from iconstudio.svg.reading import own_svg

HOUSE = "M3 21V10L12 2l9 8v11zM9 12h6v5H9zM17 2h4v3h-4z"
"""A house with a window and a chimney, by the even-odd rule; no mirroring maps it to itself."""
BODY = "M3 21V10L12 2l9 8v11zM17 2h4v3h-4z"
WINDOW = "M9 12h6v5H9z"
PATH = f'<path fill-rule="evenodd" d="{HOUSE}"/>'
ROOF = "M3 21V10L12 3l9 7v11z"
OUTLINE = f'<path fill="none" stroke="#000" stroke-width="2" d="{ROOF}"/>'


def svg(body="", attributes='viewBox="0 0 24 24"'):
    return f'<svg xmlns="http://www.w3.org/2000/svg" {attributes}>{body}</svg>'


def read(document, name="drawing.svg") -> Pictogram:
    return own_svg(document if isinstance(document, bytes) else document.encode(), name)


@cache
def ink(document):
    """(256, 256) bool: the ink of a document's drawing on the canvas; many are asked for often."""
    _, coverage = rasterise(read(document).svg)
    drawn = coverage > 127
    drawn.flags.writeable = False
    return drawn


def overlap(one, other):
    """Intersection over union."""
    return np.logical_and(one, other).sum() / np.logical_or(one, other).sum()


def assert_shows(document, expected, least=0.985, remarks=()):
    """Compare a document's picture with that of a plain one, and its remarks with words of them."""
    pictogram = read(document)
    _, coverage = rasterise(pictogram.svg)
    assert overlap(coverage > 127, ink(svg(expected))) >= least
    assert len(pictogram.remarks) == len(remarks), pictogram.remarks
    for remark, words in zip(pictogram.remarks, remarks, strict=True):
        assert words in remark
        assert remark.endswith(".")
