from dataclasses import replace

import numpy as np
import pytest

from iconstudio.algorithms.iconification.matching import Matcher, prepare
from iconstudio.algorithms.iconification.style import STYLES
from iconstudio.model import CANVAS, Axis, Edit, IconstudioError, Inner, Polygon
from iconstudio.svg.placed import render_placed
from iconstudio.workflows.editing.editing import (
    edit_icon,
    own_styles,
)
from iconstudio.workflows.editing.lookalikes import SAME, lookalikes
from iconstudio.workflows.editing.placing import place_edit, place_edited
from iconstudio.workflows.events import Recommended, Remark, StyleMatched
from iconstudio.workflows.grid import SHOWN, GridSettings
from tests.shapes import blob, exemplar, icons

YS, XS = np.mgrid[:CANVAS, :CANVAS] + 0.5


def box(left, top, right, bottom):
    return (left < XS) & (right > XS) & (top < YS) & (bottom > YS)


def rectangle(left, top, right, bottom):
    return Polygon.of([(left, top), (right, top), (right, bottom), (left, bottom)])


BODY = box(16, 100, 240, 200)
KNOB = box(60, 60, 110, 100)
ICON = exemplar(BODY, "body")
WITH_KNOB = exemplar(BODY | KNOB, "body-with-knob")
BLOBS = [exemplar(blob(seed), f"blob-{seed}") for seed in range(3)]
EDIT = Edit(ICON.pictogram, "body", add=(rectangle(60, 60, 110, 100),))


@pytest.fixture(scope="module")
def events(workers):
    prepared = Matcher([prepare(one) for one in (ICON, WITH_KNOB, *BLOBS)])
    settings = GridSettings(styles=("dark",), lambdas=(0.05, 0.3))
    change = place_edit(EDIT, ICON)
    return list(edit_icon(change, prepared, settings, workers, render_placed))


def inked(result):
    return result.drawing.coverage.reshape(CANVAS, 2, CANVAS, 2).mean(axis=(1, 3)) > 127


def of(kind, events):
    return [event for event in events if isinstance(event, kind)]


def test_a_part_that_another_icon_has_is_added(events):
    for result in icons(events):
        assert (inked(result) ^ (BODY | KNOB)).sum() < 0.01 * BODY.sum()
        assert result.composite.iou > 0.98
        assert result.score.likeness > 0.9


def test_the_icon_is_label_0_and_keeps_what_lies_beyond_the_change(events):
    (matched,) = of(StyleMatched, events)
    assert ICON.id not in {one.id for one in matched.exemplars}
    assert all(source.exemplar.id != ICON.id for row in matched.matches for source in row)
    far = place_edit(EDIT, ICON).mask >= 1
    for result in icons(events):
        assert result.composite.sources[0].exemplar is ICON
        assert result.unchanged >= 0.995
        assert (result.composite.labels[far] == 0).mean() > 0.95


def test_another_file_of_the_same_drawing_is_left_out_too():
    """It would put back what is to be removed."""
    twin = BODY.copy()
    twin[100:200, 238:240] = False
    assert (twin & BODY).sum() / BODY.sum() > SAME
    names = ("body", "twin", "body-with-knob", "blob")
    inks = (BODY, twin, BODY | KNOB, blob(1))
    ready = [prepare(exemplar(ink, name), (1.0,)) for name, ink in zip(names, inks, strict=True)]
    assert lookalikes(ICON, Matcher(ready)) == {"test:body", "test:twin"}
    assert lookalikes(exemplar(BODY, "own"), Matcher(ready)) == {
        "test:own",
        "test:body",
        "test:twin",
    }


def test_a_hole_is_cut_where_another_icon_has_one(workers):
    """In the window of the edit the icon itself has ink, and its outline stays."""
    window = box(90, 130, 150, 170)
    other = exemplar(BODY & ~window, "body-with-window")
    prepared = Matcher([prepare(exemplar(blob(seed), f"blob-{seed}")) for seed in (0, 1)])
    prepared = Matcher([prepare(other), *prepared.exemplars])
    edit = Edit(ICON.pictogram, "body", inner=Inner((rectangle(90, 130, 150, 170),)))
    settings = GridSettings(styles=("dark",), lambdas=(0.1,))
    change = place_edit(edit, ICON)
    (result,) = icons(edit_icon(change, prepared, settings, workers, render_placed))
    ink = result.drawing.coverage.reshape(CANVAS, 2, CANVAS, 2).mean(axis=(1, 3)) > 127
    assert (ink ^ (BODY & ~window)).sum() < 0.01 * BODY.sum()
    assert result.score.inside > 0.9


@pytest.mark.thorough
def test_it_is_told_if_no_icon_has_a_hole_where_one_is_drawn(workers):
    matcher = Matcher([prepare(one) for one in (WITH_KNOB, *BLOBS)])
    edit = Edit(ICON.pictogram, "body", inner=Inner((rectangle(90, 130, 150, 170),)))
    settings = GridSettings(styles=("dark",), lambdas=(0.3,))
    events = list(edit_icon(place_edit(edit, ICON), matcher, settings, workers, render_placed))
    (result,) = icons(events)
    (remark,) = of(Remark, events)
    assert result.score.inside < SHOWN
    assert f"{result.score.inside:.0%} at most" in remark.sentence
    assert "rows" not in remark.sentence and "the icon stays" in remark.sentence


def test_it_is_told_which_additions_lie_inside_the_outline():
    """What is taken off makes room for one."""
    inside, beyond = rectangle(100, 120, 150, 180), rectangle(60, 60, 110, 110)
    edit = Edit(ICON.pictogram, "body", add=(inside, beyond))
    assert place_edit(edit, ICON).enclosed == (1,)
    edit = replace(edit, remove=(rectangle(0, 90, 256, 210),), add=(beyond, inside))
    with_knob = exemplar(BODY | box(200, 40, 230, 100), "with-knob")
    assert place_edit(edit, with_knob).enclosed == ()


def test_a_hole_in_a_part_that_is_removed_is_told_so():
    red, hole = rectangle(190, 90, 250, 210), rectangle(205, 120, 230, 180)
    edit = Edit(ICON.pictogram, "body", (red,), inner=Inner((hole,)))
    with pytest.raises(IconstudioError, match="Hole 1 lies in what is removed"):
        place_edit(edit, ICON)
    place_edit(replace(edit, add=(rectangle(195, 90, 250, 210),)), ICON)  # something comes there


def test_holes_and_lines_move_with_an_icon_that_is_made_smaller():
    edit = replace(EDIT, add=(rectangle(60, -100, 110, 100),))
    edit = replace(edit, inner=Inner(lines=(((60, -90), (110, -90)),)))
    place_edit(edit, ICON)  # inside of what is added, which lies beyond the canvas
    outside = replace(edit, inner=Inner(lines=(((160, -90), (200, -90)),)))
    with pytest.raises(IconstudioError, match="Line 1 lies outside the outline"):
        place_edit(outside, ICON)


def test_the_row_ends_with_the_recommended_result(events):
    (recommended,) = of(Recommended, events)
    best = max(icons(events), key=lambda one: one.score.total)
    assert recommended == Recommended("dark", best.composite.lambda_s)
    assert isinstance(events[-1], Recommended) or isinstance(events[-2], Recommended)


def test_the_outline_that_is_wanted_is_less_red_plus_green():
    remove, add = rectangle(16, 100, 60, 200), rectangle(100, 50, 140, 110)
    change = place_edit(Edit(ICON.pictogram, "x", (remove,), (add,)), ICON)
    wanted = (BODY & ~box(16, 100, 60, 200)) | box(100, 50, 140, 110)
    assert np.array_equal(change.silhouette, wanted)
    changed = box(16, 100, 60, 200) | box(100, 50, 140, 110)
    assert np.array_equal(change.mask == 0, changed)


def test_what_is_taken_out_of_the_middle_leaves_the_outline():
    change = place_edit(Edit(ICON.pictogram, "x", (rectangle(100, 120, 150, 180),)), ICON)
    assert np.array_equal(change.silhouette, BODY)


CUP = box(30, 60, 170, 220) & ~box(46, 76, 154, 204)
HANDLE = box(170, 90, 226, 190) & ~box(170, 106, 210, 174)


def test_a_handle_goes_with_its_hole_and_no_stubs_are_left():
    cup = exemplar(CUP | HANDLE, "cup")
    rough = Polygon.of([(174, 80), (240, 82), (238, 200), (175, 196)])
    change = place_edit(Edit(cup.pictogram, "x", (rough,)), cup)
    assert (change.silhouette ^ box(30, 60, 170, 220)).sum() < 40  # of 1,200


def test_a_corner_that_is_removed_does_not_open_the_body():
    cup = exemplar(CUP, "cup")
    corner = rectangle(130, 180, 180, 230)
    change = place_edit(Edit(cup.pictogram, "x", (corner,)), cup)
    assert np.array_equal(change.silhouette, box(30, 60, 170, 220) & ~box(130, 180, 180, 230))


def without(removed, own, other, styles, workers):
    """The inks of an icon without a part, where another icon, and blobs, have some."""
    prepared = Matcher([prepare(one) for one in (other, *BLOBS)])
    edit = Edit(own.pictogram, "x", (removed,))
    settings = GridSettings(styles=styles, lambdas=(0.05, 0.3))
    change = place_edit(edit, own)
    events = list(edit_icon(change, prepared, settings, workers, render_placed))
    found = [inked(result) for result in icons(events)]
    assert found
    return found


def test_where_something_is_only_taken_off_the_icon_itself_stays(workers):
    """Another icon's wall would leave a bulge."""
    cup = exemplar(CUP | HANDLE, "cup")
    thick = box(24, 60, 178, 220) & ~box(46, 76, 150, 204)
    rough = Polygon.of([(172, 80), (240, 82), (238, 200), (173, 196)])
    for ink in without(rough, cup, exemplar(thick, "thick"), ("light",), workers):
        assert (ink ^ CUP).sum() < 0.01 * CUP.sum()


def test_what_is_taken_out_of_the_middle_stays_out(workers):
    """Other icons have something there, too."""
    dot = box(110, 130, 130, 150)
    shell = box(30, 60, 210, 220) & ~box(50, 80, 190, 200)
    own = exemplar(shell | dot, "own")
    bars = exemplar(shell | box(90, 110, 150, 170), "bars")
    dotted = rectangle(104, 124, 138, 157)
    for ink in without(dotted, own, bars, ("light", "medium"), workers):
        assert (ink ^ shell).sum() < 0.01 * shell.sum()


def test_the_unchanged_part_by_hand():
    change = place_edit(EDIT, ICON)
    own = of_drawing(BODY)
    assert change.unchanged(own, own) == 1
    edited = BODY.copy()
    edited[190:200, 200:240] = False  # 400 pixels far from the change
    far = (change.mask >= 1).sum()
    assert change.unchanged(of_drawing(edited), own) == pytest.approx(1 - 400 / far)
    near = BODY | KNOB
    assert change.unchanged(of_drawing(near), own) == 1


def of_drawing(ink):
    from iconstudio.model import Drawing, Path

    large = np.where(ink, 255, 0).astype(np.uint8).repeat(2, axis=0).repeat(2, axis=1)
    return Drawing(Path(), large)


@pytest.mark.thorough(but=1)
@pytest.mark.parametrize("right", [249, 256])
def test_nothing_goes_on_beyond_what_is_added_at_the_border(workers, right):
    bar = exemplar(box(10, 110, 246, 146), "bar")
    found = Matcher([prepare(one) for one in (bar, *BLOBS)])
    icon = exemplar(box(60, 60, 200, 200), "square")
    edit = Edit(icon.pictogram, "bar", add=(rectangle(180, 112, right, 148),))
    chosen = GridSettings(styles=tuple(style.name for style in STYLES), lambdas=(0.05, 0.3))
    results = icons(edit_icon(place_edit(edit, icon), found, chosen, workers, render_placed))
    assert results
    for result in results:
        assert result.drawing.frame.size == CANVAS
        assert result.unchanged > 0.99


def test_what_is_added_beyond_the_canvas_makes_room_for_itself():
    tall = exemplar(box(100, 16, 156, 240), "tall")
    edit = Edit(tall.pictogram, "x", add=(rectangle(110, -60, 146, 30),))
    change = place_edit(edit, tall)
    assert change.base.placement.scale < 1
    ys, xs = np.nonzero(change.silhouette)
    assert ys.min() >= 15
    assert ys.max() <= CANVAS - 15
    # The proportions are those of the icon with its addition.
    assert (ys.max() - ys.min() + 1) / (xs.max() - xs.min() + 1) == pytest.approx(300 / 56, rel=0.1)


def test_styles_are_those_of_the_icon():
    assert own_styles(ICON) == ("dark",)
    half = exemplar(box(16, 100, 240, 200) & (XS % 20 < 10), "stripes")
    assert own_styles(half) == ("light", "medium")


def test_under_symmetry_what_mirrors_a_mark_is_free_to_change_with_it():
    edit = replace(EDIT, symmetry=Axis.HORIZONTAL)
    assert not place_edit(edit, ICON).unmarked.paper[70, 256 - 100 : 256 - 70].any()
    assert place_edit(EDIT, ICON).unmarked.paper[70, 256 - 100 : 256 - 70].all()


FRAME = box(40, 60, 216, 216) & ~box(56, 76, 200, 200)


def edited(edit, own, *others, workers, styles=("light", "medium")):
    """The inks of an icon after an edit, for which other icons are at hand."""
    prepared = Matcher([prepare(one) for one in (*others, *BLOBS)])
    settings = GridSettings(styles=styles, lambdas=(0.05, 0.3, 0.75))
    change = place_edited(edit, own, workers, render_placed)
    found = icons(edit_icon(change, prepared, settings, workers, render_placed))
    assert found
    return [inked(result) for result in found]


@pytest.mark.thorough
def test_lines_that_are_not_marked_stay_and_nothing_new_lies_beyond_the_marks(workers):
    """The other icon's knob has a brim, and its lines lie elsewhere."""
    own = exemplar(FRAME, "frame")
    shell = box(36, 48, 220, 226) & ~box(64, 88, 192, 190)
    knob = box(100, 16, 156, 60) & ~box(116, 32, 140, 60) | box(70, 44, 186, 60)
    edit = Edit(own.pictogram, "x", add=(rectangle(100, 16, 156, 72),))
    near = box(94, 10, 162, 78)
    for ink in edited(edit, own, exemplar(shell | knob, "knob"), workers=workers):
        assert ink[FRAME].mean() > 0.995
        assert (ink & ~FRAME & ~near).sum() < 10
        assert (ink & ~FRAME & near).sum() > 200


def test_no_other_icon_puts_back_what_was_taken_off(workers):
    """The door is one contour with the wall; other houses have one, too."""
    door = box(100, 120, 156, 216) & ~box(116, 136, 140, 216)
    own = exemplar(FRAME | door, "own")
    wide = exemplar(FRAME | box(90, 110, 166, 216) & ~box(110, 130, 146, 216), "wide")
    edit = Edit(own.pictogram, "x", (rectangle(90, 110, 166, 200),))
    for ink in edited(edit, own, wide, workers=workers):
        assert (ink ^ FRAME).sum() < 0.01 * FRAME.sum()


@pytest.mark.thorough
def test_a_wall_of_which_a_rough_mark_covers_the_rim_stays_as_it_is(workers):
    cup = exemplar(CUP | HANDLE, "cup")
    edit = Edit(cup.pictogram, "x", (rectangle(164, 80, 240, 200),))
    thick = box(24, 60, 178, 220) & ~box(46, 76, 150, 204)
    for ink in edited(edit, cup, exemplar(thick, "thick"), workers=workers):
        assert (ink ^ CUP).sum() < 0.01 * CUP.sum()


@pytest.mark.thorough(but=1)
@pytest.mark.parametrize("marked", ["drawn", "taken out"])
def test_a_hole_in_plain_ink_comes_though_no_other_icon_has_one(marked, workers):
    area = rectangle(90, 130, 150, 170)
    hole = {"inner": Inner((area,))} if marked == "drawn" else {"remove": (area,)}
    edit = Edit(ICON.pictogram, "body", **hole)
    right = BODY & ~box(90, 130, 150, 170)
    for ink in edited(edit, ICON, WITH_KNOB, workers=workers, styles=("dark",)):
        assert (ink ^ right).sum() < 0.005 * BODY.sum()


@pytest.mark.parametrize(
    ("remove", "add", "words"),
    [
        ((), (), "Nothing is changed"),
        ((rectangle(16, 10, 60, 50),), (), "beside the icon"),
        ((), (rectangle(300, 300, 340, 340),), "beside the canvas"),
        ((), (rectangle(10.6, 10.6, 11.4, 11.4),), "too small"),
        ((rectangle(0, 0, 256, 256),), (), "Nothing of the icon would be left"),
        ((Polygon.of([(10, 10), (50, 50)]),), (), "at least 3"),
        ((Polygon.of([(10, 10), (50, 50), (90, 90)]),), (), "no area"),
    ],
)
def test_bad_edits_are_refused(remove, add, words):
    with pytest.raises(IconstudioError, match=words):
        place_edit(replace(EDIT, remove=remove, add=add), ICON)
