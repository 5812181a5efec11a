"""A part of a result is exchanged, and the rest stays."""

from dataclasses import replace

import numpy as np
import pytest

from iconstudio.algorithms.iconification.symmetry import likeness, mirrored_halves
from iconstudio.algorithms.raster import overlap
from iconstudio.model import CANVAS, Axis, Layer, Placement, Stroke
from iconstudio.svg.placed import render_placed
from iconstudio.workflows.montage.exchanging import exchanged
from iconstudio.workflows.montage.montage import check, montage_icons
from tests.output.made import DISC, RING, SOURCES, made, quarters
from tests.shapes import icons

TOP, LEFT = (Stroke(30.0, ((x, 60.0), (x, 70.0))) for x in (190.0, 60.0))
ROWS, COLUMNS = np.mgrid[:CANVAS, :CANVAS]
DRAWN = {one.exemplar.id: one.exemplar for one in SOURCES}


def joined(montage, workers):
    """What a montage looks like."""
    shapes = [DRAWN[layer.icon.id] for layer in montage.layers]
    (icon,) = icons(list(montage_icons(montage, shapes, workers, render_placed)))
    return icon.drawing.coverage > 127


def test_a_part_is_exchanged_and_the_rest_stays(workers):
    icon = made(quarters())
    before = icon.drawing.coverage > 127
    hole = Stroke(30.0, ((150.0, 95.0), (150.0, 105.0)))  # of the ring; the disc has ink there
    montage = exchanged(icon.composite, Layer(DISC.pictogram, Placement(0.9), (hole,)))
    after = joined(montage, workers)
    scale = len(after) // CANVAS
    near = np.hypot(COLUMNS - 150, ROWS - 100).repeat(scale, 0).repeat(scale, 1) < 12
    assert after[near].all() and not before[near].any()
    below = (ROWS > 160).repeat(scale, 0).repeat(scale, 1)
    assert overlap(before & below, after & below) > 0.9


@pytest.mark.parametrize("stroke", [TOP, LEFT])
@pytest.mark.parametrize("aside", [0, 4])
def test_of_a_symmetric_result_both_sides_are_exchanged(workers, stroke, aside):
    ring = replace(SOURCES[0], placement=Placement(1.0, False, 9, 4))
    twin = replace(ring, placement=Placement(1.0, True, aside - 9, 4))
    labels = next(
        mirrored_halves(np.zeros((CANVAS, CANVAS), np.uint8), np.array([1, 0], np.uint8), aside)
    )
    icon = made(labels, sources=(ring, twin))
    composite = replace(icon.composite, symmetry=Axis.HORIZONTAL)
    montage = exchanged(composite, Layer(DISC.pictogram, Placement(0.9, False, 12, 0), (stroke,)))
    check(montage)  # no two strokes share a pixel
    places = [layer.placement for layer in montage.layers if layer.icon is DISC.pictogram]
    assert places == [Placement(0.9, True, aside - 12, 0), Placement(0.9, False, 12, 0)]
    ink = joined(montage, workers)
    shift = aside * len(ink) // CANVAS
    assert likeness(ink[:, shift:] if shift else ink, Axis.HORIZONTAL) > 0.97


def test_what_crosses_the_axis_is_taken_from_one_half(workers):
    icon = made(0 * quarters(), sources=(SOURCES[0], SOURCES[2]))
    composite = replace(icon.composite, symmetry=Axis.HORIZONTAL)
    across = Stroke(20.0, ((100.0, 60.0), (200.0, 60.0)))
    montage = exchanged(composite, Layer(RING.pictogram, Placement(1.1, False, 7, 0), (across,)))
    check(montage)
    new = [layer for layer in montage.layers if layer.placement.scale == 1.1]
    left, right = ([x for stroke in one.strokes for x, _ in stroke.points] for one in new)
    assert min(right) > CANVAS / 2 > max(left)
    assert sorted(left) == pytest.approx(sorted(CANVAS - x for x in right))


def test_about_another_axis_one_source_takes_both_places():
    composite = replace(made(0 * quarters()).composite, symmetry=Axis.VERTICAL)
    montage = exchanged(composite, Layer(DISC.pictogram, Placement(), (TOP,)))
    (new,) = [layer for layer in montage.layers if layer.icon is DISC.pictogram]
    assert {stroke.points for stroke in new.strokes} == {
        ((190.0, 60.0), (190.0, 70.0)), ((190.0, 196.0), (190.0, 186.0))
    }  # fmt: skip
