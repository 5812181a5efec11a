"""What is saved is what was drawn: icons of the collection, joined, traced and drawn again."""

import numpy as np
import pytest
from scipy import ndimage

from iconstudio.algorithms.iconification.redraw import SCALE, binarised, redraw
from iconstudio.algorithms.tracing.vectorize import trace
from iconstudio.model import CANVAS, Frame, Placement
from iconstudio.svg.placed import render_placed
from iconstudio.svg.resvg import render_coverage

pytestmark = pytest.mark.thorough(but=1)

N = SCALE * CANVAS


def joined(exemplars) -> np.ndarray:
    """Four icons at once, each in parts of the canvas that have nothing to do with it."""
    noise = np.random.default_rng(5).normal(size=(len(exemplars), CANVAS, CANVAS))
    labels = ndimage.gaussian_filter(noise, (0, 15, 15)).argmax(axis=0).astype(np.uint8)
    coverages = {}
    for label, one in enumerate(exemplars):
        drawn = render_placed(one.pictogram.svg, one.frame, Placement(dx=3 * label), N)
        coverages[label] = binarised(drawn)
    return redraw(labels, coverages)


@pytest.mark.parametrize("word", ["house", "cat", "bicycle", "flower", "music"])
@pytest.mark.parametrize("thin", [True, False], ids=["thin", "bold"])
def test_the_traced_outline_covers_what_was_drawn(session, word, thin):
    found = [session.exemplar(pictogram) for pictogram in session.search(word)[:40]]
    by_ink = sorted(found, key=lambda one: one.ink.sum())
    coverage = joined(by_ink[:4] if thin else by_ink[-4:])
    path = trace(coverage).svg()
    svg = f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 256 256"><path d="{path}"/></svg>'
    again = render_coverage(svg, Frame(0, 0, CANVAS), N) > 127
    truth = coverage > 127
    assert (again & truth).sum() >= 0.99 * (again | truth).sum()
