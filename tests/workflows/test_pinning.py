"""Pinned parts of a sketch's results, and what could stand in their place."""

from dataclasses import replace
from types import SimpleNamespace

import numpy as np
import pytest

from iconstudio.algorithms.iconification.energy import joined_ink, placed_sources
from iconstudio.algorithms.iconification.guidance import scribble
from iconstudio.algorithms.iconification.matching import Matcher, prepare
from iconstudio.algorithms.raster import placed_ink
from iconstudio.model import CANVAS, Axis, Layer, Placement, Polygon, Sketch, Stroke
from iconstudio.svg.placed import render_placed
from iconstudio.workflows.events import Remark
from iconstudio.workflows.grid import GridSettings
from iconstudio.workflows.modelling.alternatives import Tried, alternatives, trying
from iconstudio.workflows.modelling.modelling import run
from iconstudio.workflows.parts import Parts
from iconstudio.workflows.pinning import with_pin, without_pins
from tests.shapes import blob, exemplar, icons

YS, XS = np.mgrid[:CANVAS, :CANVAS] + 0.5
SQUARE = exemplar((abs(XS - 128) < 88) & (abs(YS - 128) < 88), "square")
DISC = exemplar(np.hypot(XS - 128, YS - 128) < 88, "disc")
DIAMOND = exemplar(abs(XS - 128) + abs(YS - 128) < 100, "diamond")
SHAPES = [SQUARE, DISC, DIAMOND, *(exemplar(blob(seed), f"blob-{seed}") for seed in range(2))]
OUTLINE = Polygon.of(
    [(40, 40), (128, 40), (190, 66), (216, 128), (190, 190), (128, 216), (40, 216)]
)
SKETCH = Sketch(OUTLINE, "shape")
SETTINGS = GridSettings(styles=("dark",), lambdas=(0.1,))
CORNER = Stroke(30.0, ((60.0, 60.0), (60.0, 100.0)))


@pytest.fixture(scope="module")
def resources(workers):
    """What a run works with: five dark shapes, whatever the keyword."""
    matcher = Matcher([prepare(shape) for shape in SHAPES])

    def retrieve(keyword, exclude, scales):
        yield from ()
        return matcher

    known = {shape.id: shape for shape in SHAPES}
    return SimpleNamespace(
        workers=workers,
        render=render_placed,
        earlier={},
        plausibility=None,
        prepare=retrieve,
        exemplar=lambda pictogram: known[pictogram.id],
    )


@pytest.fixture(scope="module")
def result(resources):
    """The remix without a pin."""
    (made,) = icons(list(run(resources, SKETCH, SETTINGS)))
    return made


def owned_by(icon, shape):
    """Where the placed shape owns the canvas, and the ink that is drawn there."""
    composite = icon.composite
    own = [one.exemplar.id == shape.id for one in composite.sources]
    return np.array(own)[composite.labels]


@pytest.mark.thorough
def test_a_pinned_place_is_drawn_as_its_source(resources):
    pin = Layer(DIAMOND.pictogram, Placement(), (CORNER,))
    (icon,) = icons(list(run(resources, replace(SKETCH, pins=(pin,)), SETTINGS)))
    place = scribble(pin.strokes)
    assert owned_by(icon, DIAMOND)[place].all()
    drawn = icon.drawing.coverage.reshape(CANVAS, 2, CANVAS, 2).mean(axis=(1, 3)) > 127
    ink, _ = placed_ink(DIAMOND, Placement())
    assert 0 < (ink & place).sum() < place.sum()  # some of it is ink, some paper
    assert (drawn[place] == ink[place]).mean() > 0.99


def test_a_symmetric_result_has_the_pin_on_both_sides(resources):
    pin = Layer(DIAMOND.pictogram, Placement(), (CORNER,))
    sketch = replace(SKETCH, pins=(pin,), symmetry=Axis.VERTICAL)
    (icon,) = icons(list(run(resources, sketch, SETTINGS)))
    place = scribble(pin.strokes)
    assert owned_by(icon, DIAMOND)[place | place[::-1]].all()


@pytest.mark.thorough
def test_a_pin_of_an_icon_that_is_left_out_is_told_and_not_heeded(resources, result):
    pin = Layer(DIAMOND.pictogram, Placement(), (CORNER,))
    sketch = replace(SKETCH, pins=(pin,), exclude=frozenset({DIAMOND.id}))
    events = list(run(resources, sketch, SETTINGS))
    (remark,) = [one for one in events if isinstance(one, Remark)]
    assert "test:diamond" in remark.sentence and "left out" in remark.sentence
    (icon,) = icons(events)
    assert (icon.composite.labels == result.composite.labels).all()


def test_a_pin_does_nothing_in_a_style_to_which_its_icon_does_not_belong_and_that_is_told(
    resources, result
):
    ring = exemplar(abs(np.hypot(XS - 128, YS - 128) - 85) < 4, "ring")
    pin = Layer(ring.pictogram, Placement(), (CORNER,))
    known = SimpleNamespace(**vars(resources) | {"exemplar": lambda pictogram: ring})
    events = list(run(known, replace(SKETCH, pins=(pin,)), SETTINGS))
    (icon,) = icons(events)
    assert (icon.composite.labels == result.composite.labels).all()
    (remark,) = [one for one in events if isinstance(one, Remark)]
    assert "“test:ring” (lightest)" in remark.sentence and "not heeded" in remark.sentence


def test_a_part_is_the_piece_of_ink_under_the_pointer(result):
    labels = result.composite.labels
    ink = joined_ink(placed_sources(result.composite.sources)[0], labels)
    part = Parts(result).at((60, 128))
    assert part.source is result.composite.sources[labels[128, 60]]
    assert part.ink[128, 60]
    assert (labels[part.ink] == part.label).all()
    assert (part.ink & ~ink).sum() < 0.02 * part.ink.sum()
    assert Parts(result).at((3, 3)) is None
    assert Parts(result).at((38, 128)).label == part.label  # near enough


def test_alternatives_are_other_sources_that_look_different_there(result):
    part = Parts(result).at((60, 128))
    offered = alternatives(part)
    assert offered
    shown = [part.ink]
    for one in offered:
        assert one.source is not part.source
        ink = placed_ink(one.source.exemplar, one.source.placement)[0]
        assert (ink & scribble(one.strokes)).any()
        here = scribble(one.strokes)
        for other in shown:
            assert ((ink & here) != (other & here)).any()
        shown.append(ink)


@pytest.mark.thorough
def test_each_alternative_is_tried_with_the_part_pinned(result, resources):
    part = Parts(result).at((60, 128))
    offered = alternatives(part)[:2]
    events = trying(resources, SKETCH, result.composite, offered)
    tried = {one.number: one.icon for one in events if isinstance(one, Tried)}
    assert sorted(tried) == [0, 1]
    for number, icon in tried.items():
        label = result.composite.sources.index(offered[number].source)
        assert (icon.composite.labels[scribble(offered[number].strokes)] == label).all()


def test_a_pin_takes_its_place_from_others_and_can_be_removed():
    first = Layer(SQUARE.pictogram, strokes=(Stroke(20.0, ((40.0, 128.0), (200.0, 128.0))),))
    second = Layer(DISC.pictogram, strokes=(Stroke(20.0, ((128.0, 60.0), (128.0, 200.0))),))
    pins = with_pin((first,), second)
    one, other = (scribble(pin.strokes) for pin in pins)
    assert pins[1] == second
    assert not (one & other).any() and one.sum() > 0.6 * scribble(first.strokes).sum()
    assert with_pin((first,), replace(first, icon=DISC.pictogram)) == (
        replace(first, icon=DISC.pictogram),
    )
    place = np.zeros((CANVAS, CANVAS), bool)
    place[70, 128] = True
    assert without_pins(pins, place) == pins[:1]
    assert without_pins(pins, place[::-1]) == pins[:1]  # it reaches there
    assert without_pins(pins, np.roll(place, 100, axis=1)) == pins
    left = replace(first, strokes=(Stroke(20.0, ((40.0, 128.0), (60.0, 128.0))),))
    assert with_pin((left,), replace(left, strokes=(Stroke(40.0, ((206.0, 128.0),)),)), None)[
        0
    ] == (left)
    mirrored = replace(left, strokes=(Stroke(60.0, ((206.0, 128.0),)),))
    assert with_pin((left,), mirrored, Axis.HORIZONTAL) == (mirrored,)
