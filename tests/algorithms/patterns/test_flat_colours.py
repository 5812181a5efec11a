"""Images in flat colours: which there are, and where."""

import io

import numpy as np
import pytest
from PIL import Image, ImageDraw

from iconstudio.algorithms.patterns.flat_colours import flat_colours, is_noisy
from iconstudio.model import IconstudioError

SIDE, FINE = 96, 4
PALETTE = np.array(
    [
        (253, 246, 227), (194, 24, 91), (47, 125, 79), (240, 162, 2), (23, 97, 140),
        (32, 36, 44), (140, 74, 140), (120, 190, 200), (230, 130, 110),
    ],
    np.uint8,
)  # fmt: skip


def drawn(*shapes, ground=PALETTE[0], side=SIDE):
    """Draw ellipses (x0, y0, x1, y1), and lines (x0, y0, x1, y1, width), with soft edges."""
    image = Image.new("RGB", (side * FINE, side * FINE), tuple(ground))
    draw = ImageDraw.Draw(image)
    for colour, *at in shapes:
        at, width = [FINE * one for one in at[:4]], at[4:]
        if width:
            draw.line(at, tuple(colour), round(FINE * width[0]))
        else:
            draw.ellipse(at, tuple(colour))
    return np.asarray(image.reduce(FINE))


def discs(count):
    """So many discs of different colours, in rows."""
    places = [(8 + 30 * (n % 3), 8 + 30 * (n // 3)) for n in range(count)]
    return [(PALETTE[n + 1], x, y, x + 20, y + 20) for n, (x, y) in enumerate(places)]


def as_jpeg(pixels, quality=75):
    file = io.BytesIO()
    Image.fromarray(pixels).save(file, "JPEG", quality=quality)
    return np.asarray(Image.open(file))


def recomposed(flat):
    share = flat.share[..., None]
    return share * flat.colours[flat.first] + (1 - share) * flat.colours[flat.second]


@pytest.mark.parametrize("count", range(2, 10))
def test_as_many_colours_as_there_are(count):
    pixels = drawn(*discs(count - 1))
    flat = flat_colours(pixels)
    assert sorted(map(tuple, flat.colours)) == sorted(map(tuple, PALETTE[:count]))
    assert (flat.colours[0] == PALETTE[0]).all()
    assert np.abs(recomposed(flat) - pixels).mean() < 0.3


def test_an_edge_is_no_third_colour():
    """The edge of red on white is pink, and there is a pink disc, too."""
    white, red, pink = np.array([(255, 255, 255), (220, 20, 40), (238, 138, 148)], np.uint8)
    pixels = drawn((red, 5, 5, 55, 55), (pink, 64, 64, 92, 92), ground=white)
    flat = flat_colours(pixels)
    assert len(flat.colours) == 3
    third = int(np.flatnonzero((flat.colours == pink).all(axis=1))[0])
    rows, columns = np.nonzero(flat.first == third)
    assert len(rows) and rows.min() > 58 and columns.min() > 58


def test_coverage_tells_edges_finer_than_pixels():
    pixels = drawn((PALETTE[1], 10.3, 20.6, 70.1, 80.9))
    flat = flat_colours(pixels)
    covered = flat.coverage(np.array([False, True]))
    truth = np.asarray(
        Image.fromarray(drawn(((255,) * 3, 10.3, 20.6, 70.1, 80.9), ground=(0, 0, 0))).convert("L")
    )
    assert np.abs(covered - truth / 255).max() < 0.03
    assert np.allclose(covered + flat.coverage(np.array([True, False])), 1, atol=1e-5)


@pytest.mark.parametrize("ground, ink", [((250, 250, 245), (20, 20, 30)), ((15, 20, 40),
                                         (250, 230, 120))])  # fmt: skip
@pytest.mark.parametrize("width", [1.0, 1.6, 2.4])
def test_thin_lines_are_found(ground, ink, width):
    lines = [(ink, 4, 10 + 14 * n, 92, 4 + 15 * n, width) for n in range(6)]
    pixels = drawn(*lines, ground=ground)
    flat = flat_colours(pixels)
    assert len(flat.colours) == 2
    assert np.abs(flat.colours[1].astype(int) - ink).max() < 70
    covered = flat.coverage(np.array([False, True])).sum()
    contrast = np.abs(np.subtract(ground, flat.colours[1].astype(float))).sum()
    true = np.abs(pixels.astype(float) - ground).sum() / contrast
    assert 0.8 < covered / true < 1.25


def test_a_gradient_is_one_colour():
    ramp = np.linspace(0, 1, SIDE)[:, None, None]
    ground = (np.array([60, 90, 200]) * (1 - ramp) + np.array([210, 120, 220]) * ramp) + np.zeros(
        (SIDE, SIDE, 3)
    )
    disc = drawn(((255,) * 3, 20, 20, 60, 60), ground=(0, 0, 0)) / 255
    pixels = np.rint(ground * (1 - disc) + np.array([250, 240, 90]) * disc).astype(np.uint8)
    flat = flat_colours(pixels)
    assert len(flat.colours) == 2
    assert np.abs((flat.first == 1).sum() - disc[..., 0].sum()) < 0.02 * disc[..., 0].sum()


def test_the_noise_of_lossy_compression_is_no_colour():
    shapes = [(PALETTE[n + 1], 10 + 58 * (n % 2), 10 + 58 * (n // 2),
               56 + 58 * (n % 2), 56 + 58 * (n // 2)) for n in range(4)]  # fmt: skip
    clean = drawn(*shapes, side=128)
    pixels = as_jpeg(clean)
    assert is_noisy(pixels) and not is_noisy(clean)
    flat, exact = flat_colours(pixels), flat_colours(clean)
    assert len(flat.colours) == len(exact.colours) == 5
    shown = [one.colours[one.first].astype(int) for one in (flat, exact)]
    assert (np.abs(shown[0] - shown[1]).max(axis=2) > 40).mean() < 0.02


def test_as_many_colours_as_are_wanted():
    pixels = drawn(*discs(6))
    for count in (2, 3, 5):
        assert len(flat_colours(pixels, count).colours) == count


def test_specks_are_none():
    pixels = drawn(*discs(2)).copy()
    pixels[80, 80] = PALETTE[5]
    flat = flat_colours(pixels)
    assert len(flat.colours) == 3 and flat.first[80, 80] == 0


def test_what_has_no_flat_colours_is_told():
    random = np.random.default_rng(0)
    noise = random.integers(0, 256, (SIDE, SIDE, 3)).astype(np.uint8)
    blurred = np.asarray(Image.fromarray(noise[:24, :24]).resize((SIDE, SIDE), 3))
    for pixels in (noise, blurred):
        with pytest.raises(IconstudioError, match="a photograph, or noise"):
            flat_colours(pixels)


def test_one_colour_is_told():
    for pixels in (np.full((SIDE, SIDE, 3), 200, np.uint8), np.zeros((16, 16, 3), np.uint8)):
        with pytest.raises(IconstudioError, match="only one colour"):
            flat_colours(pixels)
