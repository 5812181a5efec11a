"""What is small or faint on a photo of a drawing is kept, as far as its pen made it."""

import numpy as np
import pytest
from scipy import ndimage

from iconstudio.algorithms.scanning.binarisation import ink_of, recognised

pytestmark = pytest.mark.thorough


def face(side: int, pen: float, eye: float) -> np.ndarray:
    """Return how much ink there is of a face in lines, (side, side), with dots as its eyes.

    ``pen`` and ``eye`` are the width of its lines and the radius of its eyes, in pixels.
    """
    y, x = np.mgrid[:side, :side] / side
    smile = abs(np.hypot(y - 0.45, x - 0.5) - 0.17) * side
    away = np.minimum(
        abs(np.hypot(y - 0.5, x - 0.5) - 0.3) * side, np.where(y > 0.5, smile, np.inf)
    )
    ink = np.clip(pen / 2 + 0.5 - away, 0, 1)
    for at in EYES:
        ink = np.maximum(ink, np.clip(eye + 0.5 - np.hypot(y - 0.4, x - at) * side, 0, 1))
    return ink


EYES = 0.42, 0.58


def seen(ink: np.ndarray, y: float, x: float) -> bool:
    """Whether there is ink near a point of a face, which fills the picture but for its margin."""
    box = [np.flatnonzero(ink.any(axis=axis)) for axis in (1, 0)]
    at = [
        round(some[0] + (some[-1] - some[0]) * (place - 0.2) / 0.6)
        for some, place in zip(box, (y, x), strict=True)
    ]
    near = [slice(one - 12, one + 13) for one in at]
    return bool(ink[near[0], near[1]].any())


def photo(ink: np.ndarray, pen: tuple[int, int, int], dust: int = 0) -> np.ndarray:
    random = np.random.default_rng(1)
    paper = np.array([225, 218, 200.0])
    for y, x in random.integers(0, len(ink), (dust, 2)):
        ink[y : y + 2, x] = 1
    drawn = paper * (1 - ink)[..., None] + np.array(pen) * ink[..., None]
    drawn *= np.linspace(1, 0.7, len(ink))[:, None]
    return np.clip(random.normal(drawn, 4), 0, 255).astype(np.uint8)


@pytest.mark.parametrize(("pen", "eye"), [(6, 4.0), (4, 3.0)])
def test_dots_that_are_as_wide_and_dark_as_the_lines_are_kept(pen, eye):
    scan = recognised(photo(face(800, pen, eye), (40, 45, 90), dust=40))
    ink = ink_of(scan)
    assert all(seen(ink, 0.4, at) for at in EYES)
    assert not scan.faint  # whatever is left out is no fainter line
    assert ndimage.label(ink, np.ones((3, 3)))[1] == 4  # the dust is gone


def test_lines_of_a_faint_pencil_are_the_drawing_and_not_its_dots_alone():
    ink = ndimage.gaussian_filter(face(1200, 1.5, 20), 1.2)
    scan = recognised(photo(ink, (150, 150, 150)))
    found = ink_of(scan)
    assert min(found.any(axis=0).sum(), found.any(axis=1).sum()) > 400  # the outline
    assert all(seen(found, 0.4, at) for at in EYES)
    assert ndimage.label(found, np.ones((3, 3)))[1] == 4  # the mouth, and no grain


def test_faint_rules_behind_dots_are_no_drawing():
    ink = face(600, -1, 16)
    ink[20::40] = np.maximum(ink[20::40], 0.2)
    found = ink_of(recognised(photo(ink, (40, 45, 90))))
    assert ndimage.label(found)[1] == 2


def test_a_coloured_picture_that_is_no_square_may_have_small_spots():
    picture = np.full((150, 220, 3), 255, np.uint8)
    picture[20:130, 20:100] = 220, 30, 40
    picture[20:130, 120:200] = 30, 60, 200
    picture[71:74, 108:111] = 30, 60, 200
    scan = recognised(picture)
    assert scan.coloured is not None and ink_of(scan).any()


def with_whiskers(darkness: float) -> np.ndarray:
    ink = ndimage.gaussian_filter(face(700, 5, 16), 1)
    y, x = np.mgrid[:700, :700]
    for row in (330, 370, 410):
        whisker = (abs(y - row) < 1.5) & (abs(x - 350) > 170) & (abs(x - 350) < 300)
        ink = np.maximum(ink, darkness * ndimage.gaussian_filter(whisker.astype(float), 1))
    return ink


@pytest.mark.parametrize("pen", [(40, 45, 60), (150, 150, 150)])
@pytest.mark.parametrize(("darkness", "told"), [(0.3, True), (0, False)])
def test_whiskers_that_are_much_fainter_than_the_rest_are_told(pen, darkness, told):
    """Also those of a pencil that is faint itself, and beyond what is inked."""
    scan = recognised(photo(with_whiskers(darkness), pen))
    assert scan.found and scan.faint == told


@pytest.mark.parametrize("paper", [(242, 232, 204), (238, 234, 225), (250, 250, 248)])
def test_of_ink_on_evenly_lit_paper_nothing_is_left_out(paper):
    """Paper goes without saying, be it cream; and the soft edge of a thick pen is no shadow."""
    ink = ndimage.gaussian_filter(face(640, 22, 20), 1.2)[..., None]
    drawn = np.array(paper) * (1 - ink) + np.array((35, 38, 60)) * ink
    noise = np.random.default_rng(2).normal(0, 4, (640, 640, 1))
    scan = recognised(np.clip(drawn + noise, 0, 255).astype(np.uint8))
    assert scan.found and not scan.omissions


@pytest.mark.parametrize(("dimmer", "seed"), [(0.45, 0), (0.45, 2), (0.55, 1)])
def test_paper_on_which_the_light_falls_steeply_towards_a_corner_is_whole(dimmer, seed):
    y, x = np.mgrid[:640, :700]
    light = 1 - dimmer * (x / 700) * (y / 640) - 0.1 * (y / 640)
    ink = ndimage.gaussian_filter(np.pad(face(640, 2, 16), ((0, 0), (30, 30))), 1.2)[..., None]
    drawn = (np.array((238, 234, 225)) * (1 - ink) + 40 * ink) * light[..., None]
    noise = np.random.default_rng(seed).normal(0, 4, (640, 700, 1))
    scan = recognised(np.clip(drawn + noise, 0, 255).astype(np.uint8))
    assert scan.found and not scan.omissions
