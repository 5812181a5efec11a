from dataclasses import replace

import numpy as np
import pytest

from iconstudio.algorithms.iconification.symmetry import reflected
from iconstudio.model import CANVAS, Axis, IconstudioError, Mix
from iconstudio.svg.placed import render_placed
from iconstudio.workflows.events import Progress
from iconstudio.workflows.hybrids.hybrids import check, draw_seeds, mix_icons, pinned
from iconstudio.workflows.hybrids.selection import select_icons, stroke_width
from tests.shapes import blob, exemplar, icons

YS, XS = np.mgrid[:CANVAS, :CANVAS] - CANVAS / 2 + 0.5


def vase(neck, foot, belly):
    """An upright shape, symmetric from left to right."""
    width = np.where(YS < -30, neck, np.where(YS > 50, foot, belly))
    return (abs(XS) < width) & (abs(YS) < 110)


VASES = [exemplar(vase(*sizes), f"vase-{n}") for n, sizes in enumerate(
    [(20, 60, 40), (50, 30, 70), (35, 90, 80)]
)]  # fmt: skip
MIX = Mix(tuple(one.pictogram for one in VASES), draws=8, seed=3, symmetry=Axis.HORIZONTAL)


def results(mix, workers, exemplars=VASES):
    return icons(mix_icons(mix, exemplars, workers, render_placed))


@pytest.fixture(scope="module")
def hybrids(workers):
    return results(MIX, workers)


def test_hybrids_are_symmetric_and_differ_from_each_other_and_the_sources(hybrids):
    assert 2 <= len(hybrids) <= 8
    pictures = [one.drawing.coverage > 127 for one in hybrids]
    sources = [one.ink.repeat(2, axis=0).repeat(2, axis=1) for one in VASES]
    for number, picture in enumerate(pictures):
        for other in (*pictures[:number], *sources):
            assert (picture ^ other).sum() > 0.02 * picture.sum()
    for one in hybrids:
        labels = one.composite.labels
        assert np.array_equal(labels, reflected(labels, Axis.HORIZONTAL))
        assert one.composite.style == "hybrid"
        assert one.composite.iou is None
        assert 0 < one.score.total <= 1


def test_results_come_in_the_order_of_the_draws_and_repeat_to_the_byte(hybrids, workers):
    assert [one.draw for one in hybrids] == sorted(one.draw for one in hybrids)
    again = results(MIX, workers)
    assert [one.path for one in again] == [one.path for one in hybrids]
    assert [one.seeds for one in again] == [one.seeds for one in hybrids]
    other = results(replace(MIX, seed=4), workers)
    assert [one.seeds for one in other] != [one.seeds for one in hybrids]


def test_a_source_is_kept_around_its_seeds(hybrids):
    for one in hybrids:
        for label, points in enumerate(one.seeds):
            assert len(points) == 2
            (x, y), (u, v) = points
            assert (u, v) == (CANVAS - x, y)
            shape = VASES[label].ink
            assert shape[int(y), int(x)]
    # Not every seed must win, but most should.
    won = [
        one.composite.labels[int(y), int(x)] == label
        for one in hybrids
        for label, ((x, y), _) in enumerate(one.seeds)
    ]
    assert np.mean(won) > 0.6


def test_draws_can_be_had_in_several_goes(workers):
    first = draw_seeds(replace(MIX, first=5), 5, np.stack([one.ink for one in VASES]))
    assert first == draw_seeds(MIX, 5, np.stack([one.ink for one in VASES]))


def test_pins_are_in_every_draw_and_likeness_keeps_the_seeds_of_some():
    shapes = np.stack([one.ink for one in VASES])
    pinned = replace(MIX, pins=(((128.5, 60.5),), (), ()))
    like = draw_seeds(MIX, 0, shapes)
    for number in range(6):
        seeds = draw_seeds(pinned, number, shapes)
        assert seeds[0][0] == (128.5, 60.5)
        assert len(seeds[0]) >= 2
        alike = draw_seeds(replace(MIX, like=like), 100 + number, shapes)
        kept = sum(a == b for a, b in zip(alike, like, strict=True))
        assert kept == 2  # half of three, rounded up


def test_what_is_pinned_is_kept(workers):
    # The foot of the first, in every draw.
    pinned = replace(MIX, pins=(((100.5, 220.5),), (), ()), draws=4)
    for one in results(pinned, workers):
        assert (one.composite.labels[216:226, 96:106] == 0).all()
        assert (one.composite.labels[216:226, 151:160] == 0).all()


@pytest.mark.parametrize(
    ("change", "words"),
    [
        ({"icons": MIX.icons[:1]}, "1 icon cannot be mixed"),
        ({"icons": MIX.icons * 67}, "201 icons cannot be mixed"),
        ({"icons": (MIX.icons[0], MIX.icons[0])}, "chosen twice"),
        ({"draws": 0}, "0 draws"),
        ({"draws": 10**6}, "1,000,000 draws"),
        ({"pins": ((),)}, "pins for 1 icon, but 3 icons are mixed"),
    ],
)
def test_bad_mixes_are_refused(change, words, workers):
    with pytest.raises(IconstudioError, match=words):
        results(replace(MIX, **change), workers)


def test_icons_that_look_the_same_are_refused(workers):
    twin = exemplar(VASES[0].ink, "twin")
    mix = Mix((VASES[0].pictogram, twin.pictogram))
    with pytest.raises(IconstudioError, match="looks the same"):
        results(mix, workers, [VASES[0], twin])


def test_progress_ends_at_one(workers):
    events = list(mix_icons(replace(MIX, draws=2), VASES, workers, render_placed))
    assert [e.done for e in events if isinstance(e, Progress)][-1] == 1


def test_icons_that_are_chosen_are_alike_in_outline_style_and_stroke():
    rings = [
        exemplar((np.hypot(XS, YS) < r) & (np.hypot(XS, YS) > r - 14), f"ring-{r}")
        for r in (70, 80, 90, 100, 110)
    ]
    solids = [exemplar((abs(XS) < a) & (abs(YS) < 110), f"slab-{a}") for a in (20, 45, 100)]
    chosen = select_icons([*solids, *rings], 3)
    assert len({one.id.split("-")[0] for one in chosen}) == 1
    assert select_icons([*solids, *rings], 3) == chosen
    assert select_icons([*solids, *rings], 3, seed=1) != chosen
    with pytest.raises(IconstudioError, match="no 7 icons"):
        select_icons([*solids, *rings], 7)
    with pytest.raises(IconstudioError, match="ask for 2 to 12"):
        select_icons(rings, 13)


def test_chosen_icons_hold_to_the_symmetry():
    crooked = [
        exemplar((abs(XS) < a) & (abs(YS) < 110) & (XS < YS + 40), f"crooked-{a}")
        for a in (60, 90, 110)
    ]
    vases = [exemplar(vase(30 + 30 * n, 110 - 40 * n, 40), f"v-{n}") for n in range(3)]
    chosen = select_icons([*crooked, *vases], 2, Axis.HORIZONTAL)
    assert all(one.id.startswith("test:v-") for one in chosen)


def test_the_width_of_strokes():
    bars = (abs(YS) < 5) & (abs(XS) < 100)
    assert stroke_width(bars) == pytest.approx(10, rel=0.1)


def test_a_pinned_detail_is_held_whole_and_drawn(workers):
    """A filament longer than a pin's disc, of one icon, in another's outline."""
    ys, xs = np.mgrid[:CANVAS, :CANVAS] + 0.5
    ring = abs(np.hypot(xs - 128, ys - 128) - 96) < 8
    filament = (abs(xs - 128) < 40) & (abs(ys - 128) < 3)
    cross = (abs(xs - 128) < 4) & (abs(ys - 128) < 70)
    lamps = [exemplar(ring | filament, "filament"), exemplar(ring | cross, "cross")]
    pins = (((128.0, 128.0),), ())
    held = pinned(pins, np.stack([one.ink for one in lamps]), None)
    assert held[0][filament].all() and not held[0][ring].any() and not held[1].any()
    mix = Mix(tuple(one.pictogram for one in lamps), draws=6, pins=pins)
    run = mix_icons(mix, lamps, workers, render_placed)
    for result in icons(run):
        ink = result.drawing.coverage.reshape(CANVAS, 2, CANVAS, 2).mean(axis=(1, 3)) > 127
        assert ink[filament].all()


def test_pins_that_contradict_are_refused():
    icons = tuple(exemplar(blob(seed), f"pin-{seed}").pictogram for seed in range(2))
    with pytest.raises(IconstudioError, match="hold the same place"):
        check(Mix(icons, pins=(((100.0, 100.0),), ((110.0, 100.0),))))
