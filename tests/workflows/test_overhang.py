"""What reaches past the canvas is drawn whole, and everything agrees on where it is."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from iconstudio.algorithms.iconification.energy import placed_sources
from iconstudio.algorithms.iconification.overhang import overhang, seen
from iconstudio.model import CANVAS, MARGIN, Frame, Placement, Source
from iconstudio.svg.placed import render_placed
from iconstudio.svg.resvg import render_coverage
from iconstudio.workflows.drawing import PREVIEW, SCALE, draw
from tests.shapes import exemplar

YS, XS = np.mgrid[:CANVAS, :CANVAS] + 0.5
RING = exemplar(abs(np.hypot(XS - 128, YS - 128) - 90) < 18, "ring")
CROSS = exemplar((abs(XS - 128) < 14) & (abs(YS - 128) < 100) | (abs(YS - 70) < 12)
                 & (abs(XS - 128) < 90), "cross")  # fmt: skip


def drawn(sources, labels, scale=SCALE, side=CANVAS):
    ink, _ = placed_sources(sources, side)
    return draw(labels.repeat(side // CANVAS, 0).repeat(side // CANVAS, 1), ink, sources,
                render_placed, scale)  # fmt: skip


def expected(source, frame, size=512):
    """A source as the frame shows it, by the renderer alone."""
    unit = CANVAS / frame.size
    placement = source.placement
    shift = frame.x + frame.size / 2 - CANVAS / 2, frame.y + frame.size / 2 - CANVAS / 2
    inside = Placement(placement.scale, placement.flip, placement.dx, placement.dy)
    shown = inside.frame(source.exemplar.frame)
    k = shown.size / CANVAS  # user units to a canvas unit
    dx = -shift[0] if placement.flip else shift[0]
    centre = shown.x + shown.size / 2 + dx * k, shown.y + shown.size / 2 + shift[1] * k
    side = shown.size / unit
    square = Frame(centre[0] - side / 2, centre[1] - side / 2, side)
    picture = render_coverage(source.exemplar.pictogram.svg, square, size)
    return picture[:, ::-1] if placement.flip else picture


def likeness(one, other):
    a, b = one > 127, other > 127
    return (a & b).sum() / (a | b).sum()


def again(path, size=512):
    body = f'<path d="{path.svg()}"/>'
    svg = f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 256 256">{body}</svg>'
    return render_coverage(svg, Frame(0, 0, CANVAS), size)


placements = st.builds(
    Placement, st.sampled_from([0.7, 1.0, 1.1, 1.7, 2.5]), st.booleans(),
    st.integers(-120, 120), st.integers(-120, 120),
)  # fmt: skip


@pytest.mark.thorough
@settings(max_examples=12)
@given(placements, st.sampled_from([(CANVAS, SCALE), (CANVAS, PREVIEW), (2 * CANVAS, SCALE)]))
def test_a_source_that_owns_all_is_drawn_whole(placement, quality):
    side, scale = quality
    source = Source(RING, placement)
    one = drawn([source], np.zeros((CANVAS, CANVAS), np.uint8), scale, side)
    assert likeness(one.coverage, expected(source, one.frame)) > 0.97
    assert likeness(one.coverage, again(one.path)) > 0.97
    ys, xs = np.nonzero(one.coverage > 127)
    if one.frame != Frame(0, 0, CANVAS):  # the margin is that of any icon
        spread = max(np.ptp(xs), np.ptp(ys)) + 1
        assert spread / 2 == pytest.approx(CANVAS - 2 * MARGIN, abs=2)
    else:
        assert overhang(np.zeros((CANVAS, CANVAS), np.uint8),
                        placed_sources([source])[0], [source]) == 0  # fmt: skip


def test_owners_and_drawing_agree():
    sources = [Source(CROSS, Placement(1.0, False, 0, -70)), Source(RING, Placement(dx=40))]
    labels = np.where(YS < 120, 0, 1).astype(np.uint8)
    one = drawn(sources, labels)
    assert one.frame.y < 0 and one.frame.x + one.frame.size > CANVAS
    finer = seen(np.arange(CANVAS)[None].repeat(CANVAS, 0), one.frame, len(one.owners), -1)
    inside = finer >= 0
    assert np.array_equal(one.owners[inside], seen(labels, one.frame, len(one.owners), 0)[inside])
    wide = np.stack([expected(source, one.frame, 512) for source in sources])
    owners = seen_at(one.owners, 512)
    joined = np.take_along_axis(wide, owners[None].astype(int), 0)[0]
    assert likeness(one.coverage, joined) > 0.95


def seen_at(owners, size):
    at = (np.arange(size) + 0.5) * len(owners) / size
    return owners[at.astype(int)[:, None], at.astype(int)]


def test_what_hangs_over_widens_beyond_the_columns_that_its_source_owns():
    """A mushroom: the stem crosses the border, its cap lies beyond and belongs to it."""
    cap = (abs(XS - 128) < 90) & (YS > 40) & (YS < 80)
    stem = (abs(XS - 128) < 12) & (YS >= 80) & (YS < 230)
    sources = [
        Source(exemplar(cap | stem, "mushroom"), Placement(dy=-100)),
        Source(exemplar((abs(XS - 128) < 100) & (YS > 60) & (YS < 200), "block"), Placement()),
    ]
    labels = np.where((abs(XS - 128) < 30) & (YS < 60), 0, 1).astype(np.uint8)
    one = drawn(sources, labels)
    rows = np.flatnonzero((one.coverage > 127).any(axis=1))
    top = one.coverage[rows[0] + 20] > 127
    assert top.sum() * one.frame.size / 512 == pytest.approx(180, abs=3)


def test_ink_that_nobody_took_beyond_the_border_stays_away():
    two = (abs(YS - 128) < 100) & ((abs(XS - 60) < 20) | (abs(XS - 190) < 20))
    sources = [Source(exemplar(two, "two"), Placement(dy=-90)), Source(RING, Placement(0.5))]
    labels = np.where((XS < 128) & (YS < 150), 0, 1).astype(np.uint8)
    one = drawn(sources, labels)
    assert one.frame.y < 0
    ys, xs = np.nonzero(seen(np.ones((CANVAS, CANVAS), bool), one.frame, 512, False) == 0)
    assert not ((one.coverage[ys, xs] > 127) & (xs > 300)).any()
