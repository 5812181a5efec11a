"""Parts inside an icon that marked areas enclose."""

from dataclasses import replace

import pytest

from iconstudio.algorithms.iconification.matching import Matcher, prepare
from iconstudio.model import CANVAS, Axis, Edit, Exemplar, Frame, Pictogram, Placement, Polygon
from iconstudio.svg.placed import render_placed
from iconstudio.workflows.editing.editing import edit_icon
from iconstudio.workflows.editing.emptying import emptied
from iconstudio.workflows.editing.placing import place_edited
from iconstudio.workflows.events import Recommended
from iconstudio.workflows.grid import GridSettings
from tests.shapes import CREDIT, blob, exemplar, icons

DISC = '<circle cx="128" cy="128" r="{}"/>'
RING = '<circle cx="128" cy="128" r="{}" fill="none" stroke="#000" stroke-width="{}"/>'
WHOLE = Frame(0, 0, CANVAS)


def square(reach):
    low, high = 128 - reach, 128 + reach
    return Polygon.of([(low, low), (high, low), (high, high), (low, high)])


def drawn(*shapes):
    svg = f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 256 256">{"".join(shapes)}</svg>'
    coverage = render_placed(svg, WHOLE, Placement(), CANVAS)
    return Exemplar(Pictogram("test:gear", svg, CREDIT), WHOLE, coverage)


def same(one, other):
    """Whether two pictures differ by a step of the renderer's soft edges at most, a quarter."""
    return (abs(one.coverage.astype(int) - other.coverage) <= 64).all()


GEAR = drawn(RING.format(100, 20), RING.format(40, 20))
DONUT = drawn(RING.format(70, 80))
ONLY_RING, ONLY_DISC = drawn(RING.format(100, 20)), drawn(DISC.format(110))


@pytest.mark.parametrize(
    ("icon", "reach", "right"),
    [(GEAR, 60, ONLY_RING), (DONUT, 40, ONLY_DISC), (DONUT, 70, ONLY_DISC)],
)
def test_what_is_enclosed_goes_and_what_is_around_it_goes_on(icon, reach, right):
    found = emptied((square(reach),), (), icon, render_placed)
    assert same(found.icon, right)
    assert found.areas == (square(reach),)
    assert found.icon.pictogram.credit == icon.pictogram.credit
    assert found.icon.id == icon.id


def test_a_window_goes_alone_where_a_hub_is_around_it():
    found = emptied((square(35),), (), GEAR, render_placed)
    right = drawn(RING.format(100, 20), DISC.format(50))
    assert same(found.icon, right)


@pytest.mark.parametrize("area", [square(20), square(120), Polygon.of([(0, 0), (9, 0), (9, 9)])])
def test_what_encloses_nothing_or_reaches_beyond_the_outline_is_left_to_the_cut(area):
    assert emptied((area,), (), GEAR, render_placed) is None


def test_where_something_runs_through_there_is_still_to_do():
    spokes = drawn(
        RING.format(100, 20), RING.format(40, 20), '<path d="M120 20h16v70h-16z"/>',
        '<circle cx="60" cy="128" r="8"/>',
    )  # fmt: skip
    dot = Polygon.of([(45, 113), (75, 113), (75, 143), (45, 143)])
    found = emptied((square(60), dot), (), spokes, render_placed)
    assert found.areas == (dot,)
    assert found.icon.ink[128, 80:110].any(), "the hub holds to a spoke"
    assert not found.icon.ink[128, 60]


def test_every_result_is_the_icon_without_its_hub(workers):
    """Other icons have a hub of another kind there."""
    hub = drawn(RING.format(100, 20), DISC.format(35)).ink
    others = [exemplar(hub, "hub"), *(exemplar(blob(seed), f"blob-{seed}") for seed in range(3))]
    edit = Edit(GEAR.pictogram, "gear", (square(60),))
    change = place_edited(edit, GEAR, workers, render_placed)
    settings = GridSettings(styles=("light", "medium"), lambdas=(0.05, 0.5))
    matcher = Matcher([prepare(one) for one in (GEAR, *others)])
    results = icons(edit_icon(change, matcher, settings, workers, render_placed))
    assert results
    for result in results:
        ink = result.drawing.coverage.reshape(CANVAS, 2, CANVAS, 2).mean(axis=(1, 3)) > 127
        assert (ink ^ ONLY_RING.ink).sum() < 0.01 * ink.sum()
        assert result.unchanged > 0.995
        assert [one.id for one in result.credits] == ["test:gear"]


BODY = '<rect x="40" y="90" width="176" height="120" rx="30"/>'
ANTENNA = '<path d="M122 40h12v60h-12z"/><circle cx="128" cy="36" r="16"/>'
ROBOT, HEADLESS = drawn(BODY, ANTENNA), drawn(BODY)
AROUND = Polygon.of([(100, 10), (156, 10), (156, 92), (100, 92)])


def test_what_sticks_out_goes_and_the_outline_closes(workers):
    found = emptied((AROUND,), (), ROBOT, render_placed, alone=(AROUND,))
    assert same(found.icon, HEADLESS)
    assert found.areas == (AROUND,)
    change = place_edited(Edit(ROBOT.pictogram, "x", (AROUND,)), ROBOT, workers, render_placed)
    assert not change.left.any()
    assert change.removed.any()
    assert (change.silhouette == HEADLESS.ink).all()
    assert not change.wanted.any()


@pytest.mark.parametrize(
    ("add", "symmetry", "closed"),
    [
        ((), None, True),
        ((Polygon.of([(180, 200), (210, 200), (210, 230), (180, 230)]),), None, True),
        ((Polygon.of([(100, 60), (156, 60), (156, 92), (100, 92)]),), None, False),
        ((), Axis.HORIZONTAL, False),
    ],
)
def test_where_something_comes_instead_or_in_a_mirror_the_cut_takes_it_off(
    add, symmetry, closed, workers
):
    edit = Edit(ROBOT.pictogram, "x", (AROUND,), add, symmetry)
    change = place_edited(edit, ROBOT, workers, render_placed)
    assert (not change.left.any()) is closed


@pytest.mark.parametrize("right", [150, 175])
def test_half_a_ring_is_not_filled(right):
    """Though more than half of its hole is marked."""
    ring = drawn(RING.format(70, 20))
    area = Polygon.of([(30, 30), (right, 30), (right, 226), (30, 226)])
    found = emptied((area,), (), ring, render_placed, alone=(area,))
    assert found is None or not (found.icon.ink & ~ring.ink)[:, right:].any()


def test_an_icon_without_its_part_is_recommended_in_every_style(workers):
    """Other icons have a bump there."""
    bump = drawn(BODY, '<circle cx="128" cy="90" r="20"/>')
    others = [
        exemplar(bump.ink, "bump"),
        *(exemplar(blob(seed), f"blob-{seed}") for seed in range(3)),
    ]
    change = place_edited(Edit(ROBOT.pictogram, "x", (AROUND,)), ROBOT, workers, render_placed)
    settings = GridSettings(styles=("medium", "dark"), lambdas=(0.05, 0.5))
    matcher = Matcher([prepare(one) for one in (ROBOT, *others)])
    events = list(edit_icon(change, matcher, settings, workers, render_placed))
    results = icons(events)
    for result in results:
        ink = result.drawing.coverage.reshape(CANVAS, 2, CANVAS, 2).mean(axis=(1, 3)) > 127
        assert (ink ^ HEADLESS.ink).sum() < 0.002 * ink.sum()
    named = [one for one in events if isinstance(one, Recommended)]
    assert len(named) == len(results) // 2
    assert all(one.lambda_s is not None for one in named)


def test_what_is_added_counts_beside_what_is_emptied(workers):
    bar = Polygon.of([(120, 0), (136, 0), (136, 30), (120, 30)])
    edit = Edit(GEAR.pictogram, "gear", (square(60),), (bar,))
    change = place_edited(edit, GEAR, workers, render_placed)
    assert not change.left.any()
    assert change.removed.any()
    assert (change.at(2 * CANVAS).left.shape, change.at(2 * CANVAS).left.any()) == ((512, 512), 0)
    assert same(change.base.exemplar, ONLY_RING)
    assert replace(change, emptied=None).at(CANVAS).left.any()
