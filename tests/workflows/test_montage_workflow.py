from dataclasses import replace

import numpy as np
import pytest

from iconstudio.algorithms.iconification.guidance import carried, scribble
from iconstudio.algorithms.iconification.overhang import seen
from iconstudio.algorithms.raster import placed_ink
from iconstudio.model import CANVAS, IconstudioError, Layer, Montage, Placement, Stroke
from iconstudio.svg.placed import render_placed
from iconstudio.workflows.events import Progress, Remark
from iconstudio.workflows.montage.montage import montage_icons
from tests.shapes import exemplar, icons

YS, XS = np.mgrid[:CANVAS, :CANVAS] + 0.5
DISC = exemplar(np.hypot(XS - 128, YS - 128) < 80, "disc")
RING = exemplar((np.hypot(XS - 128, YS - 128) < 80) & (np.hypot(XS - 128, YS - 128) > 50), "ring")


def stroke(*points, width=12.0):
    return Stroke(width, points)


def result(montage, exemplars, workers):
    events = list(montage_icons(montage, exemplars, workers, render_placed))
    assert [e.done for e in events if isinstance(e, Progress)][-1] == 1
    (one,) = icons(events)
    return one


def two(left, right, **placement):
    return Montage(
        (
            Layer(DISC.pictogram, Placement(**placement), left),
            Layer(RING.pictogram, Placement(), right),
        )
    )


def test_two_halves_are_cut_where_they_agree(workers):
    """A dark gap of two bars lies between the strokes: the only seam that costs next to nothing
    runs through it."""
    bars = (abs(XS - 90) < 20) | (abs(XS - 170) < 20)
    stripes = (abs(XS - 90) < 20) & (YS % 24 < 12) | (abs(XS - 170) < 20) & (YS % 24 < 12)
    tall = (YS > 40) & (YS < 216)
    solid_bars, striped = exemplar(bars & tall, "bars"), exemplar(stripes & tall, "stripes")
    montage = Montage(
        (
            Layer(solid_bars.pictogram, strokes=(stroke((90, 80), (90, 170)),)),
            Layer(striped.pictogram, strokes=(stroke((170, 80), (170, 170)),)),
        )
    )
    one = result(montage, [solid_bars, striped], workers)
    labels = one.composite.labels
    assert (labels[40:216, 70:111] == 0).all()
    assert (labels[40:216, 149:191] == 1).all()
    ink = one.drawing.coverage.reshape(CANVAS, 2, CANVAS, 2).mean(axis=(1, 3)) > 127
    wanted = np.where(XS < 128, bars & tall, stripes & tall)
    assert (ink ^ wanted).sum() < 0.02 * wanted.sum()
    assert one.composite.style == "montage"


def test_the_marked_parts_are_kept(workers):
    montage = two((stroke((90, 90), (90, 160)),), (stroke((170, 100), (170, 150)),))
    one = result(montage, [DISC, RING], workers)
    labels = one.composite.labels
    assert (labels[90:160, 90] == 0).all()
    assert (labels[100:150, 170] == 1).all()
    assert one.composite.lambda_s == 3.0


def test_an_icon_without_a_stroke_is_not_forced_in(workers):
    one = result(two((stroke((128, 60), (128, 190)),), ()), [DISC, RING], workers)
    assert one.composite.shares == (1.0, 0.0)


def test_a_layer_is_used_where_it_lies(workers):
    small = Placement(0.5, True, 40, -30)
    montage = Montage((Layer(DISC.pictogram, small, (stroke((168, 98), (170, 100)),)),))
    one = result(montage, [DISC], workers)
    ys, xs = np.nonzero(one.drawing.coverage > 127)
    assert xs.mean() / 2 == pytest.approx(168, abs=0.6)
    assert ys.mean() / 2 == pytest.approx(98, abs=0.6)
    assert len(xs) / 4 == pytest.approx(np.pi * 40**2, rel=0.02)


GOOD = two((stroke((90, 90), (90, 160)),), (stroke((170, 100), (170, 150)),))


@pytest.mark.parametrize(
    ("montage", "words"),
    [
        (Montage(()), "needs 1 to 30 icons"),
        (Montage(GOOD.layers * 16), "has 32"),
        (two((), ()), "Nothing is marked"),
        (two((stroke((400, 400), (500, 500)),), ()), "outside the canvas"),
        (
            two((stroke((90, 90), (90, 160)),), (stroke((60, 120), (150, 120)),)),
            r"overlap near \(90, 120\)",
        ),
        (two(GOOD.layers[0].strokes, (), scale=0.0), "scaled to 0"),
        (two(GOOD.layers[0].strokes, (), scale=1e9), "scaled to 1e"),
    ],
)
def test_bad_montages_are_refused(montage, words, workers):
    with pytest.raises(IconstudioError, match=words):
        list(montage_icons(montage, [DISC, RING], workers, render_placed))


def test_a_dot_is_a_stroke(workers):
    montage = replace(GOOD, layers=(replace(GOOD.layers[0], strokes=(stroke((90, 90)),)),))
    assert result(montage, [DISC], workers).composite.shares == (1.0,)


def test_a_marked_crumb_is_kept(workers):
    """A small ring in a great one: marked, it stays, though it is a small part of its source."""
    r = np.hypot(XS - 128, YS - 128)
    small = abs(np.hypot(XS - 128, YS - 128) - 6) < 2
    arms = (abs(YS - 128) < 2) & (XS > 134) & (XS < 235)
    tool = exemplar(small | arms | (abs(r - 100) < 8), "tool")
    frame = exemplar((abs(r - 100) < 12), "frame")
    bars = (((128, 22), (128, 38)), ((228, 110), (228, 150)), ((160, 100), (160, 160)))
    montage = Montage(
        (
            Layer(tool.pictogram, strokes=(stroke((124, 128), (132, 128), width=20),)),
            Layer(frame.pictogram, strokes=tuple(stroke(*bar) for bar in bars)),
        )
    )
    one = result(montage, [tool, frame], workers)
    ink = one.drawing.coverage.reshape(CANVAS, 2, CANVAS, 2).mean(axis=(1, 3)) > 127
    assert (ink & small).sum() > 0.95 * small.sum()


@pytest.mark.parametrize(("dx", "dy"), [(150, 0), (0, -130), (-110, 120)])
def test_all_that_is_marked_past_the_frame_is_drawn(dx, dy, workers):
    """A disc that is scribbled all over hangs out of the canvas; the result has it whole."""
    placement = Placement(0.7, False, dx, dy)
    across = stroke((128 + dx - 50, 128 + dy), (128 + dx + 50, 128 + dy), width=30)
    far = Layer(DISC.pictogram, placement, (across,))
    near = Layer(RING.pictogram, Placement(0.5), (stroke((128, 90), (128, 100), width=8),))
    one = result(Montage((far, near)), [DISC, RING], workers)
    source = one.composite.sources[0]
    marked = scribble([carried(across, placement, source.placement)])
    whole = placed_ink(source.exemplar, source.placement, pad=CANVAS)[0]
    own = marked & whole[CANVAS:-CANVAS, CANVAS:-CANVAS]
    wide = 30 * source.placement.scale / 0.7
    length = min(130, 160 * 0.7) * source.placement.scale / 0.7
    assert own.sum() == pytest.approx(wide * length, rel=0.1)
    drawn = one.drawing.coverage > 127
    shown = seen(own, one.drawing.frame, 512, False)
    assert (drawn & shown).sum() >= 0.99 * shown.sum()
    assert not drawn[[0, -1]].any() and not drawn[:, [0, -1]].any()


BESIDE = (stroke((10, 10), (30, 10)),)


def test_strokes_that_touch_nothing_of_their_icon_are_told(workers):
    montage = two((stroke((128, 128)),), BESIDE)
    events = list(montage_icons(montage, [DISC, RING], workers, render_placed))
    sentence = "No stroke over “test:ring” touches it. Draw over what is to be kept of it."
    assert [one.sentence for one in events if isinstance(one, Remark)] == [sentence]
    montage = two((stroke((128, 128)),), (stroke((128, 60)),))
    events = list(montage_icons(montage, [DISC, RING], workers, render_placed))
    assert not [one for one in events if isinstance(one, Remark)]


def test_a_montage_of_which_no_ink_is_marked_is_refused(workers):
    with pytest.raises(IconstudioError, match="No stroke touches ink"):
        list(montage_icons(two(BESIDE, ()), [DISC, RING], workers, render_placed))
