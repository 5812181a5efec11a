"""Motifs on a canvas as an exemplar: layers, elements, densities."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from iconstudio.model import CANVAS, Credit, IconstudioError, Motif, Patterning, Pictogram
from iconstudio.workflows.pattern.layout import Arrangement, rasterised
from iconstudio.workflows.pattern.scattering import FEWEST, scattered
from tests.shapes import outline

ICON = Pictogram("a:disc", "", Credit("disc", "", "", "", ""))
ANGLES = np.linspace(0, 2 * np.pi, 90, endpoint=False)
DISC = outline([(128 + 100 * np.cos(a), 128 + 100 * np.sin(a)) for a in ANGLES])
SQUARE = outline([(28, 28), (228, 28), (228, 228), (28, 228)])


def layout(*motifs, path=DISC, samples=0.5, **work):
    arrangement = Arrangement.of(Patterning(motifs, **work), [path] * len(motifs))
    return arrangement.layout(samples)


def disc(x, y, size=64.0, colour="#ff0000", **options):
    return Motif(ICON, x, y, size, colour=colour, **options)


def test_a_motif_lies_where_it_was_put():
    found = layout(disc(64, 192, 128), ground="#0000ff")
    (mask,) = found.exemplar.masks
    y, x = np.indices(mask.shape) + 0.5
    assert abs(mask - (np.hypot(x - 32, y - 96) < 25)).mean() < 0.01
    assert found.exemplar.colours[96, 32] == pytest.approx([1, 0, 0])
    assert found.exemplar.colours[2, 2] == pytest.approx([0, 0, 1])


def test_motifs_apart_share_a_layer_and_are_elements_of_their_own():
    found = layout(disc(64, 64), disc(192, 64), disc(128, 192))
    assert len(found.exemplar.masks) == 1
    assert sorted(np.unique(found.exemplar.labels)) == [0, 1, 2, 3]
    assert [len(one) for one in found.elements[0]] == [1, 1, 1]


def test_an_overlapping_motif_is_in_a_layer_above():
    found = layout(disc(100, 128, colour="#00ff00"), disc(140, 128))
    upper, lower = found.exemplar.masks
    assert upper[64, 70] > 0.99 and upper[64, 40] == 0 and lower[64, 40] > 0.99
    assert [[fill.colour for fill in element] for (element,) in found.elements] == [
        ["#ff0000"],
        ["#00ff00"],
    ]
    assert found.exemplar.colours[64, 60] == pytest.approx([1, 0, 0])  # the upper one is seen


def test_a_motif_on_another_is_a_detail_of_it():
    found = layout(disc(128, 128, 200, "#00ff00"), disc(128, 128, 60), disc(30, 30, 40))
    assert len(found.exemplar.masks) == 1
    assert [len(element) for element in found.elements[0]] == [2, 1]


def test_shapes_of_elements_are_those_of_the_picture():
    found = layout(disc(60, 60, 90, turn=30), disc(180, 170, 120, flip=True), path=SQUARE)
    labels = found.exemplar.labels[0]
    for number, ((fill,),) in enumerate(zip(found.elements[0], strict=True), 1):
        drawn = rasterised(fill.path, len(labels))
        assert ((drawn > 0) == (labels == number)).mean() > 0.998


@pytest.mark.parametrize(
    ("motifs", "work", "said"),
    [
        ([disc(90, 90)], {}, ""),
        ([disc(90, 90, colour="#ffffff")], {}, "Nothing of the pattern can be seen: it has"),
        ([disc(90, 90, colour="#fefefe")], {}, "Nothing of the pattern can be seen"),
        ([disc(90, 90, colour="#ffffff")], {"ground": "#202020"}, ""),
        ([disc(90, 90, colour="#202020")] * 2, {"ground": "#202020"}, "Nothing of the pattern"),
        ([disc(90, 90, colour="#ffffff")], {"ground": ""}, ""),
        ([disc(90, 90), disc(90, 90, 20, colour="#ffffff")], {}, ""),
        ([disc(90, 90), disc(90, 90, 20)], {}, "1 of the 2 icons cannot be seen: it has the"),
        (
            [disc(90, 90), *(disc(x, 200, colour="#ffffff") for x in (60, 180))],
            {},
            "2 of the 3 icons cannot be seen: they have the colour of what lies behind them.",
        ),
    ],
)
def test_icons_of_the_colour_of_what_lies_behind_them_are_told(motifs, work, said):
    remark = layout(*motifs, **work).remark
    assert remark.startswith(said) and bool(remark) == bool(said)


def test_the_denser_the_nearer_and_none_is_cut():
    motifs = [disc(x, y, 60) for x in (32, 128, 224) for y in (32, 128, 224)]
    areas = []
    for density in (0.5, 1.0, 1.6):
        found = layout(*motifs, density=density)
        (mask,) = found.exemplar.masks
        assert len(mask) == round(CANVAS / 2 / density**0.5)
        assert len(found.elements[0]) == 9
        areas.append(mask.sum())
        assert not mask[[0, -1]].any() and not mask[:, [0, -1]].any()
    assert np.ptp(areas) < 0.01 * areas[0]


def test_what_cannot_be_an_exemplar_is_told():
    with pytest.raises(IconstudioError, match="No ink of the icons"):
        layout(disc(-500, -500))
    with pytest.raises(IconstudioError, match="overlap in 9 layers"):
        layout(*(disc(60 + 12 * n, 128, 80) for n in range(9)))


@given(st.integers(1, 40), st.integers(0, 50))
@settings(max_examples=25)
def test_icons_are_scattered_over_the_canvas_apart_from_each_other(count, seed):
    icons = [Pictogram(f"a:{n}", "", ICON.credit) for n in range(count)]
    motifs = scattered(icons, seed)
    assert len(motifs) >= max(count, FEWEST) and {one.icon for one in motifs} == set(icons)
    assert motifs == scattered(icons, seed)
    for n, one in enumerate(motifs):
        assert one.size / 2 <= one.x + 4 and one.x <= CANVAS + 4 - one.size / 2
        assert one.size / 2 <= one.y + 4 and one.y <= CANVAS + 4 - one.size / 2
        apart = [np.hypot(one.x - other.x, one.y - other.y) for other in motifs[:n]]
        assert min(apart, default=CANVAS) > 0.9 * one.size
