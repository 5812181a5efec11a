"""Whole patterns: what every one must be, on small exemplars."""

from itertools import pairwise

import numpy as np
import pytest

from iconstudio.algorithms.patterns import selection, synthesis
from iconstudio.algorithms.patterns.distance import coverage
from iconstudio.algorithms.patterns.elements import emptiness
from iconstudio.algorithms.patterns.exemplar import Exemplar, Pattern
from iconstudio.algorithms.patterns.prepared import Prepared
from iconstudio.algorithms.patterns.selection import best
from iconstudio.algorithms.patterns.synthesis import Settings, synthesised
from iconstudio.algorithms.patterns.torn import torn_ink
from iconstudio.model import IconstudioError
from tests.algorithms.patterns.ornaments import (
    SIDE,
    X,
    black_on_white,
    checks,
    disc,
    shapes,
    soft,
    stripes,
    two_layers,
)

SIZE = (96, 112)


def made(exemplar, **settings):
    settings = {"size": SIZE, "iterations": 4, **settings}
    *_, pattern = synthesised(Prepared.of(exemplar), Settings(**settings))
    return pattern


@pytest.fixture(scope="module")
def tile():
    return made(shapes(), tile=True)


def test_elements_are_whole_and_are_the_exemplars_own(tile):
    exemplar = shapes()
    assert torn_ink(tile.distances[0] < 0, exemplar.masks[0] > 0.5, True) == 0 == tile.torn
    elements = Prepared.of(exemplar).elements[0].whole
    assert len(elements) == 5 and len(tile.placed) > 5
    covered = np.zeros(SIZE, bool)
    for one in tile.placed:
        element = elements[one.element]
        rows, columns = np.nonzero(element.ink)
        covered[(rows + element.top + one.down) % SIZE[0],
                (columns + element.left + one.right) % SIZE[1]] = True  # fmt: skip
    assert np.array_equal(covered, tile.distances[0] < 0)


@pytest.mark.parametrize("tile", [False, True])
def test_as_much_ink_as_in_the_exemplar(tile):
    exemplar = shapes()
    for seed in range(2):
        ink = made(exemplar, tile=tile, seed=seed).distances[0] < 0
        assert 0.88 < ink.mean() / Prepared.of(exemplar).elements[0].share < 1.1


@pytest.mark.thorough
def test_there_are_hardly_emptier_places_than_in_the_exemplar():
    exemplar = shapes()
    most = Prepared.of(exemplar).elements[0].emptiness
    empty = [
        emptiness(made(exemplar, tile=True, seed=seed).distances[0] < 0) for seed in range(4)
    ]  # 1.5 times as empty before elements moved apart
    assert np.median(empty) < 1.25 * most


def test_a_blank_frame_makes_a_pattern_hardly_denser():
    framed = black_on_white(np.pad(shapes().masks[0][:56], ((16, 8), (16, 0))))
    for seed in range(2):
        ink = made(framed, tile=True, seed=seed).distances[0] < 0
        assert 0.88 < ink.mean() / (framed.masks[0] > 0.5).mean() < 1.1


def test_without_mending_ink_does_not_vanish_either():
    exemplar = shapes()
    ink = made(exemplar, tile=True, mend=False).distances[0] < 0
    assert 0.8 < ink.mean() / exemplar.masks[0].mean() < 1.3


@pytest.mark.parametrize("tile", [False, True])
@pytest.mark.parametrize("exemplar", [shapes(), stripes()])
def test_a_shape_is_filled_and_nothing_lies_outside(exemplar, tile):
    y, x = np.indices(SIZE)
    guidance = np.hypot(y - 48, x - 60) < 42
    ink = made(exemplar, tile=tile, guidance=guidance.astype(np.float32)).distances[0] < 0
    assert not (ink & ~guidance).any()
    assert ink.sum() > 0.6 * exemplar.masks[0].mean() * guidance.sum()


def test_an_empty_shape_is_refused():
    with pytest.raises(IconstudioError, match="shape to fill"):
        made(shapes(), guidance=np.zeros(SIZE, np.float32))


def test_opposite_borders_of_a_tile_match(tile):
    for axis in (0, 1):
        distance = np.moveaxis(tile.distances[0], axis, 0)
        inside = np.abs(np.diff(distance, axis=0)).max()
        assert np.abs(distance[0] - distance[-1]).max() <= max(inside, 1.5)
    twice = np.tile(tile.distances[0] < 0, (2, 2))
    assert torn_ink(twice, shapes().masks[0] > 0.5) == 0


@pytest.mark.parametrize(
    ("exemplar", "peak", "share"),
    [(stripes(), (6, 0), 8 / np.pi**2), (checks(), (6, 7), (8 / np.pi**2) ** 2)],  # of square waves
)
def test_what_is_regular_comes_back_with_its_period(exemplar, peak, share):
    ink = coverage(made(exemplar, tile=True).distances[0])
    spectrum = np.abs(np.fft.rfft2(ink - ink.mean())) ** 2
    found = np.unravel_index(spectrum.argmax(), spectrum.shape)
    assert (min(found[0], SIZE[0] - found[0]), found[1]) == peak
    both = spectrum[peak] + spectrum[SIZE[0] - peak[0], peak[1]]
    assert both > 0.95 * share * spectrum.sum()


def test_the_first_layer_occludes_the_second_in_every_pixel():
    pattern = made(two_layers(), tile=True)
    above, below = coverage(pattern.distances)
    assert 0.1 < above.mean() < 0.3 and 0.1 < below.mean() < 0.5
    red, blue, yellow = np.float32([[1, 0, 0], [0, 0, 1], [1, 1, 0]])
    under = yellow + below[..., None] * (blue - yellow)
    assert np.allclose(pattern.colours, under + above[..., None] * (red - under), atol=0.02)


def test_energy_does_not_rise_within_a_resolution(monkeypatch):
    energies, improve = [], synthesis.matched

    def watched(picture, exemplar, where, matches, *rest):
        before = synthesis.differences(picture, exemplar, where, matches)
        found = improve(picture, exemplar, where, matches, *rest)
        energies.append((len(picture), where.window, before.sum(), found[1].sum()))
        return found

    monkeypatch.setattr(synthesis, "matched", watched)
    monkeypatch.setattr(synthesis._Synthesis, "_energy", lambda *_: 0.0)  # of the mended picture
    made(shapes(), iterations=6)
    made(two_layers(), iterations=6)
    assert len(energies) > 15
    for (*stage, _, after), (*following, before, finally_) in pairwise(energies):
        assert finally_ <= before
        assert stage != following or before <= after


def test_the_same_seed_makes_the_same_bytes():
    first, again, other = (made(two_layers(), seed=seed) for seed in (1, 1, 2))
    assert first.colours.tobytes() == again.colours.tobytes()
    assert first.distances.tobytes() == again.distances.tobytes()
    assert first.placed == again.placed
    assert first.colours.tobytes() != other.colours.tobytes()


@pytest.mark.parametrize(
    ("torn", "energies", "tried", "chosen"),
    [
        ((0.4, 0.1, 0.3), (1, 2, 0), 3, 1),
        ((0.1, 0.1, 0.1), (3, 1, 2), 3, 1),
        ((0.4, 0.0, 0.0), (1, 5, 1), 2, 1),
        ((0.01, 0.0, 0.0), (9, 1, 1), 1, 0),
    ],
)
def test_the_best_of_several_seeds_is_torn_least_and_has_the_lowest_energy(
    monkeypatch, torn, energies, tried, chosen
):
    seeds = []

    def scripted(prepared, settings, ask):
        seeds.append(settings.seed)
        yield Pattern(None, None, energies[len(seeds) - 1], torn[len(seeds) - 1], False)

    monkeypatch.setattr(selection, "synthesised", scripted)
    *_, found = best(None, Settings((64, 64), seed=7), 3)
    assert (found.torn, found.energy) == (torn[chosen], energies[chosen])
    assert len(set(seeds)) == tried and seeds[0] == 7


def test_previews_come_first_and_are_as_large():
    prepared = Prepared.of(shapes())
    *previews, last = synthesised(prepared, Settings(SIZE, iterations=2))
    assert previews and not any(one.finished for one in previews) and last.finished
    assert all(one.colours.shape == (*SIZE, 3) for one in (*previews, last))


def test_a_synthesis_can_be_stopped():
    class StoppedError(Exception):
        pass

    def ask():
        nonlocal left
        left -= 1
        if not left:
            raise StoppedError

    for left in (1, 5, 40):  # noqa: B007
        with pytest.raises(StoppedError):
            list(synthesised(Prepared.of(shapes()), Settings(SIZE), ask))


WHITE = np.ones((SIDE, SIDE), np.float32)
SPOT = np.pad(np.ones((8, 8), np.float32), 28)


@pytest.mark.parametrize(
    ("colours", "masks", "message"),
    [
        (WHITE, WHITE[None], "no contours"),
        (WHITE[:9, :9], SPOT[None, :9, :9], "too small"),
        (np.ones((1025, 64)), np.ones((1, 1025, 64)), "too large"),
        (WHITE * np.nan, SPOT[None], "no numbers"),
        (WHITE, np.stack([SPOT] * 9), "1 to 8 layers"),
        (WHITE, SPOT[None, :-1], "of its own size"),
    ],
)
def test_what_cannot_be_an_exemplar_is_refused(colours, masks, message):
    with pytest.raises(IconstudioError, match=message):
        Exemplar(np.repeat(colours[..., None], 3, axis=2), masks)


def test_a_tiny_pattern_is_refused():
    with pytest.raises(IconstudioError, match="at least 16"):
        next(synthesised(Prepared.of(shapes()), Settings((12, 64))))


def test_noise_is_an_exemplar_like_any_other():
    noise = np.random.default_rng(0).random((SIDE, SIDE)).astype(np.float32)
    assert np.isfinite(made(black_on_white(noise), iterations=2, size=(64, 64)).colours).all()


def test_elements_of_one_shape_in_two_colours_come_equally_often():
    mask = soft(np.minimum.reduce([disc(y, x, 6) for y in (12, 32, 52) for x in (12, 32, 52)]))
    colours = np.where(mask[..., None] > 0, np.where(X < 22, 1, 0)[..., None] * [1, 0, 0], 1)
    exemplar = Exemplar(colours.astype(np.float32), mask[None])
    pattern = made(exemplar, size=(128, 128), tile=True)
    kinds = [one.element % 3 == 0 for one in pattern.placed]  # those of the first column are red
    assert len(kinds) >= 16 and 0.2 < np.mean(kinds) < 0.5


def test_every_element_of_an_exemplar_lies_in_its_pattern():
    whole = Prepared.of(shapes()).elements[0].whole
    for seed in range(3):
        placed = made(shapes(), tile=True, seed=seed).placed
        assert {one.element for one in placed} == set(range(len(whole)))


def test_a_preview_shows_whole_elements():
    settings = Settings(SIZE, tile=True)
    preview = next(synthesised(Prepared.of(shapes()), settings))
    assert not preview.finished and len(preview.placed) > 3
    assert torn_ink(preview.distances[0] < 0, shapes().masks[0] > 0.5, True) == 0
