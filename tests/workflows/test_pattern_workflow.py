"""Patterns as a run of events, on real icons."""

from contextlib import closing
from dataclasses import replace
from itertools import islice

import numpy as np
import pytest

from iconstudio.inputs.examples import examples
from iconstudio.model import IconstudioError, Motif, Patterned, Patterning, Transform
from iconstudio.output.png import icon_pixels
from iconstudio.output.svg import svg_document
from iconstudio.reading import returned
from iconstudio.workflows.events import Progress, Result
from iconstudio.workflows.files import read_file
from iconstudio.workflows.pattern.patterning import PatternSettings, run, samples
from iconstudio.workflows.pattern.scattering import scattered
from iconstudio.workflows.pattern.spec import PATTERN

SIDE = 192


@pytest.fixture(scope="module")
def work(session):
    icons = [session.icon(name) for name in ("lucide:cat", "mdi:fish")]
    return Patterning(scattered(icons), width=SIDE, height=SIDE, ground="#102030")


@pytest.fixture(scope="module")
def events(session, work):
    return list(run(session, work, PatternSettings(seeds=2, previews=True)))


@pytest.fixture(scope="module")
def pattern(events):
    return next(one.icon for one in events if isinstance(one, Result) and not one.preview)


def test_a_pattern_for_each_seed_and_a_preview_first(events):
    results = [one for one in events if isinstance(one, Result)]
    finished = [one.icon for one in results if not one.preview]
    assert len(finished) == 2 and not finished[0].looks_like(finished[1])
    assert all(one is results[0] for one in results if one.preview)
    assert isinstance(events[0], Progress) and events[-1].done == 1


def test_it_is_as_large_as_wanted_and_thanks_all(pattern):
    assert isinstance(pattern, Patterned) and pattern.size == (SIDE, SIDE) and pattern.tile
    assert {one.id for one in pattern.credits} == {"lucide:cat", "mdi:fish"}
    assert pattern.title == "pattern of cat, fish"
    assert pattern.ground == "#102030"


def test_its_shapes_are_those_of_the_icons_in_their_colours(pattern, work):
    fills = pattern.fills[1:]
    assert {one.colour for one in fills} <= {one.colour for one in work.motifs}
    pixels = icon_pixels(pattern, SIDE)
    assert pixels.shape == (SIDE, SIDE, 4) and (pixels[..., 3] == 255).all()
    given = np.median([motif.size for motif in work.motifs])
    assert len(fills) >= 0.5 * (SIDE / given) ** 2 * 0.4


def test_all_its_numbers_are_plain(pattern):
    contours = [contour for fill in pattern.fills for contour in fill.path.contours]
    points = [point for contour in contours for point in contour.points]
    assert points and {type(value) for point in points for value in point} == {float}


def test_opposite_borders_match_to_the_pixel(pattern):
    once = icon_pixels(pattern, SIDE)
    corners = [(x, y) for x in (-SIDE / 2, SIDE / 2) for y in (-SIDE / 2, SIDE / 2)]
    beside = [
        replace(layer, fills=tuple(
            replace(one, path=one.path.transformed(Transform().translate(*at)))
            for at in corners for one in layer.fills
        )) for layer in pattern.layers
    ]  # fmt: skip
    seen = icon_pixels(replace(pattern, layers=tuple(beside)), SIDE)
    rolled = np.roll(once, (SIDE // 2, SIDE // 2), (0, 1))
    differ = abs(seen.astype(int) - rolled).max(axis=2)
    assert (differ > 64).mean() < 0.0005  # the edges of what is drawn twice cover a little more


def test_the_same_work_gives_the_same_bytes(session, work, pattern):
    (again,) = [one.icon for one in run(session, work) if isinstance(one, Result)]
    assert svg_document(again) == svg_document(pattern)


def test_it_can_be_stopped(session, work):
    with closing(run(session, replace(work, width=2048, height=2048, seed=9))) as events:
        assert list(islice(events, 3))
    (after,) = [one.icon for one in run(session, work) if isinstance(one, Result)]
    assert after.size == (SIDE, SIDE)  # the workers are free again


def test_a_shape_is_filled_and_is_no_tile(session, work):
    filled = replace(work, fill=session.icon("lucide:heart"), width=256, height=256)
    (icon,) = [one.icon for one in run(session, filled) if isinstance(one, Result)]
    assert not icon.tile and not icon.ground
    alpha = icon_pixels(icon, 256)[..., 3]
    assert alpha[:8].max() == 0 and alpha.max() == 255
    assert "lucide:heart" in {one.id for one in icon.credits}


def test_what_to_do_is_said_where_nothing_fits(session):
    star = Motif(session.icon("mdi:star-half-full"), 128, 128, 60)
    wanted = Patterning((star,), width=120, height=120, fill=session.icon("lucide:heart"))
    with pytest.raises(IconstudioError, match=r"of 120 x 120\. Make the pattern larger .*smaller"):
        list(run(session, wanted))


def test_too_much_is_refused_with_what_it_would_take():
    work = Patterning(width=10_000, height=10_000)
    with pytest.raises(IconstudioError, match=r"about \d+ minutes and \d+ GiB"):
        samples(work)
    assert samples(replace(work, scale=4)) == (1250, 1250)


def test_without_an_exemplar_there_is_none(session):
    with pytest.raises(IconstudioError, match="no exemplar yet"):
        list(run(session, Patterning()))


@pytest.mark.parametrize("example", examples("patterns"), ids=lambda one: one.path.stem)
def test_examples_open(example, session):
    work = returned(read_file(example.path, PATTERN, session))
    assert len(work.motifs) >= 9 or work.image is not None
