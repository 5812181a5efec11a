"""Images separated into layers, and their elements as shapes."""

import numpy as np
import pytest
from scipy import ndimage

from iconstudio.algorithms.patterns.elements import components
from iconstudio.algorithms.patterns.exemplar import MOST_LAYERS
from iconstudio.algorithms.patterns.separation import separated
from iconstudio.algorithms.patterns.shapes import element_shapes
from iconstudio.algorithms.raster import overlap
from iconstudio.model import CANVAS, Frame
from iconstudio.svg.resvg import render_coverage
from tests.algorithms.patterns.ornaments import soft

SIDE = 160
Y, X = np.mgrid[:SIDE, :SIDE].astype(float)
WHITE, RED, GREEN, YELLOW, BLUE, BLACK = np.array(
    [(253, 246, 227), (194, 24, 91), (47, 125, 79), (240, 162, 2), (23, 97, 140), (20, 20, 24)],
    float,
)
PLACES = [(y + 7 * (n % 2), x) for n, y in enumerate((28, 80, 132)) for x in (26, 78, 130)]


def painted(*layers, ground=WHITE):
    """Paint distance functions in their colours, the last over all others."""
    picture = np.zeros((SIDE, SIDE, 3)) + ground
    for colour, distance in layers:
        over = soft(distance)[..., None]
        picture = over * colour + (1 - over) * picture
    return np.rint(picture).astype(np.uint8)


def discs(radius, places=PLACES, dy=0.0, dx=0.0):
    return np.minimum.reduce([np.hypot(Y - y - dy, X - x - dx) - radius for y, x in places])


VINE = np.minimum.reduce([np.abs(Y - y - 9 * np.sin(X / 20)) - 3.4 for y in (34, 86, 138)])


def layer_of(found, colour):
    away = np.abs(found.flat.colours - colour).max(axis=1)
    assert away.min() < 3
    return int(found.layer[away.argmin()])


def test_flowers_with_centres_lie_over_a_vine_that_is_completed():
    flowers = discs(13)
    found = separated(painted((GREEN, VINE), (RED, flowers), (YELLOW, discs(5))))
    assert found.count == 2
    assert layer_of(found, YELLOW) == layer_of(found, RED) == 2
    assert layer_of(found, GREEN) == 1 and layer_of(found, WHITE) == 0
    assert found.hides[2, 1] and not found.hides[1, 2]
    upper, lower = found.masks()
    assert overlap(upper > 0.5, flowers < 0) > 0.97
    assert overlap(lower > 0.5, VINE < 0) > 0.93
    assert np.array_equal(np.unique(found.seen), [0, 1, 2])


def test_the_size_of_layers_does_not_say_which_is_above():
    stripes = np.abs(Y % 40 - 20) - 8.3
    leaves = discs(10, [(y, x + 6) for y, x in PLACES], 14)
    found = separated(painted((BLUE, stripes), (GREEN, leaves)))
    assert layer_of(found, GREEN) == 2 and found.hides[2, 1]
    assert overlap(found.masks()[1] > 0.5, stripes < 0) > 0.97
    broad = np.abs(Y % 54 - 27) - 6
    found = separated(painted((GREEN, discs(20)), (BLUE, broad)))
    assert layer_of(found, BLUE) == 2 and found.hides[2, 1]


def test_what_does_not_touch_shares_a_layer():
    found = separated(painted((RED, discs(12, PLACES[::2])), (BLUE, discs(12, PLACES[1::2]))))
    assert found.count == 1


def test_a_pupil_on_an_eye_on_a_face_and_a_shaded_side_are_details():
    faces = [(YELLOW, discs(18)), (RED, np.maximum(discs(18), -discs(18, dx=-5)))]
    eyes = [(WHITE * 0 + 255, discs(6, dx=-4)), (BLACK, discs(2.6, dx=-3))]
    found = separated(painted(*faces, *eyes, ground=GREEN))
    assert found.count == 1 and len(found.flat.colours) == 5


def test_the_ground_of_a_mosaic_is_what_is_between():
    cell = np.floor(Y / 20) * 3 + np.floor(X / 20) * 5
    tiles = np.maximum(np.abs(Y % 20 - 10), np.abs(X % 20 - 10)) - 8.5
    colours = [RED, GREEN, BLUE]
    found = separated(
        painted(*((one, np.where(cell % 3 == n, tiles, 9)) for n, one in enumerate(colours)))
    )
    assert layer_of(found, WHITE) == 0 and found.count == 1


def test_rings_that_go_over_and_under_each_other_are_whole():
    rings = [np.abs(np.hypot(Y - y, X - x) - 26) - 3.6
             for y in (12, 58, 104, 150) for x in (12, 58, 104, 150)]  # fmt: skip
    colours = [(RED, YELLOW, BLUE)[(2 * (n // 4) + n % 4) % 3] for n in range(16)]
    found = separated(painted(*zip(colours, rings, strict=True)))
    assert found.count == 3
    masks = found.masks()
    for colour in (RED, YELLOW, BLUE):
        true = np.minimum.reduce(
            [ring for ring, one in zip(rings, colours, strict=True) if one is colour]
        )
        whole = masks[found.count - layer_of(found, colour)]
        seen = overlap(found.seen == layer_of(found, colour), true < 0)
        assert overlap(whole > 0.5, true < 0) > max(0.85, seen + 0.1)
    pixels = painted(*zip(colours, rings, strict=True))
    again = found.repainted(pixels, masks)
    order = sorted((RED, YELLOW, BLUE), key=lambda one: layer_of(found, one))
    paired = list(zip(rings, colours, strict=True))
    wanted = painted(*((one, ring) for one in order for ring, its in paired if its is one))
    inner = np.s_[10:-10, 10:-10]
    wrong = (np.abs(again.astype(int) - wanted).max(axis=2) > 60)[inner].mean()
    assert wrong < 0.5 * (np.abs(pixels.astype(int) - wanted).max(axis=2) > 60)[inner].mean()


def test_tiles_side_by_side_hide_nothing():
    third = np.floor((X + Y) / 23) % 3
    found = separated(painted((RED, 0.5 - (third == 1)), (BLUE, 0.5 - (third == 2))))
    masks = found.masks()
    assert (masks.sum(axis=0) < 1.01).all()


def test_too_many_layers_are_joined_and_counted():
    hues = [(20 * n, 255 - 22 * n, (95 * n) % 256) for n in range(11)]
    bands = [(np.array(hue, float), np.maximum(np.abs(X - 8 - 14 * n) - 6, 0) - 0.5)
             for n, hue in enumerate(hues)]  # fmt: skip
    found = separated(painted(*bands))
    assert found.count == MOST_LAYERS < found.found == 11
    assert len(found.flat.colours) == 12


def test_corrections_say_what_is_seen():
    found = separated(painted((GREEN, VINE), (RED, discs(13))))
    seen = found.seen.copy()
    seen[:60] = np.where(seen[:60] == 2, 0, seen[:60])
    upper, _ = found.corrected(seen).masks()
    assert not (upper[:58] > 0.5).any() and (upper[70:] == found.masks()[0][70:]).all()


@pytest.fixture(scope="module")
def flowers():
    found = separated(
        painted((GREEN, VINE), (RED, discs(13)), (YELLOW, discs(5)), (BLUE, discs(2)))
    )
    masks = found.masks()
    labels = np.stack([components(mask > 0.5)[0] for mask in masks])
    return found, masks, labels


def covered(fill):
    side = f'viewBox="0 0 {SIDE} {SIDE}"'
    svg = f'<svg xmlns="http://www.w3.org/2000/svg" {side}><path d="{fill.path.svg()}"/></svg>'
    return render_coverage(svg, Frame(0, 0, SIDE), SIDE) > 127


def test_each_element_has_its_shapes_from_back_to_front(flowers):
    found, masks, labels = flowers
    upper, lower = element_shapes(found, masks, labels)
    assert len(upper) == len(PLACES) and len(lower) == 3
    for number, element in enumerate(upper, start=1):
        shown = ["".join(f"{round(level):02x}" for level in one) for one in (RED, YELLOW, BLUE)]
        assert [one.colour for one in element] == [f"#{one}" for one in shown]
        outer, middle, dot = map(covered, element)
        assert overlap(outer, labels[0] == number) > 0.97
        assert (middle <= outer).all() and (dot <= middle).all()
    assert all(len(element) == 1 for element in lower)
    vine = np.any([covered(element[0]) for element in lower], axis=0)
    assert overlap(vine, VINE < 0) > 0.93


def test_shapes_are_in_pixels_of_the_labels(flowers):
    found, masks, labels = flowers
    small = labels[:, 1::4, 1::4]
    upper, _ = element_shapes(found, masks, small)
    points = np.array([point for element in upper for fill in element
                       for contour in fill.path.contours for point in contour.points])  # fmt: skip
    assert points.max() < SIDE / 4 + 1 < CANVAS
    centre = ndimage.center_of_mass(small[0] == 1)
    first = np.array(list(upper[0][0].path.contours[0].points)).mean(axis=0)
    assert np.abs(first[::-1] - np.array(centre) - 0.5).max() < 1
