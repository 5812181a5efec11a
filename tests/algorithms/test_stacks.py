"""Layers of different colours: nothing between two others vanishes."""

import numpy as np
import pytest
import scipy

from iconstudio.algorithms.tones import tone
from iconstudio.algorithms.tones.alternation import Omission
from iconstudio.algorithms.tones.layers import flattened, left_out
from tests.algorithms.test_tone import path, pictogram, rgba

BUN = "M3 9a9 6 0 0 1 18 0z"
STACKS = {
    "burger": [
        (BUN, "#e0a050"),
        ("M2 9h20v2H2z", "#58b030"),
        ("M3 11h18v3H3z", "#6b3a1e"),
        ("M3 14h18v6H3z", "#e0a050"),
    ],
    "three slabs": [
        ("M2 4h20l-2 5H4z", "#e53935"),
        ("M4 9h16l-2 5H6z", "#43a047"),
        ("M6 14h12l-2 5H8z", "#1e3cc8"),
    ],
    "pencil": [
        ("M2 12l5-3v6z", "#f5d6a0"),
        ("M7 9h9v6H7z", "#ffb300"),
        ("M16 9h2v6h-2z", "#90a4ae"),
        ("M18 9h3a2 2 0 0 1 2 2v2a2 2 0 0 1-2 2h-3z", "#ff77aa"),
    ],
    "dessert": [
        (BUN, "#f8c0d8"),
        ("M3 9h18v4H3z", "#7b4a2a"),
        ("M4 13h16v4H4z", "#f0dc90"),
        ("M3 17h18v5H3z", "#c0392b"),
    ],
}


@pytest.mark.thorough(but=1)
@pytest.mark.parametrize("kind", STACKS)
def test_each_layer_is_ink_between_lines_of_paper(kind):
    layers = STACKS[kind]
    drawn = pictogram(rgba("".join(path(*layer) for layer in layers))) > 127
    pieces, count = scipy.ndimage.label(drawn)
    assert count == len(layers)
    for number, (outline, _) in enumerate(layers):
        own = rgba(path(outline))[..., 3] > 127
        assert (drawn & own).sum() > 0.6 * own.sum(), number
        assert len(np.unique(pieces[drawn & own])) == 1, number


def test_the_overlap_of_discs_is_no_layer_and_is_not_left_out():
    """It touches what surrounds the drawing at single points, and is darker than the discs."""
    discs = [(9, 8.4, "#00f"), (15, 8.4, "#f00"), (12, 13.6, "#0c0")]
    circles = "".join(f'<circle cx="{x}" cy="{y}" r="6.4" fill="{c}"/>' for x, y, c in discs)
    drawn = rgba(f'<g style="mix-blend-mode:multiply" fill-opacity=".6">{circles}</g>')
    flat = flattened(drawn)
    found = tone.pictogram(flat)
    row = found.coverage[len(drawn) * 10 // 24]
    assert row[len(drawn) // 2] <= 127 < row[len(drawn) // 4]
    assert Omission.DECORATION not in found.omissions
    assert not left_out(drawn, flat, found.coverage)


def test_the_bands_of_a_rainbow_alternate():
    colours = ["#e81123", "#f7941d", "#ffd400", "#3fa34d", "#1e6fd9", "#7b3fa0"]
    bands = "".join(
        f'<circle cx="22" cy="22" r="{20 - 2 * number}" fill="none" stroke="{colour}"'
        ' stroke-width="2"/>'
        for number, colour in enumerate(colours)
    )
    drawn = pictogram(rgba(bands)) > 127
    along = drawn[:, -20:].mean(axis=1) > 0.5
    assert np.count_nonzero(np.diff(along.astype(int)) == 1) <= 4


def test_paper_between_alike_layers_is_closed_by_a_line():
    mug = path("M4 2h14v20H4z", "#2a6fdb") + path("M4 9h14v5H4z", "#fd5")
    drawn = pictogram(rgba(mug)) > 127
    _, count = scipy.ndimage.label(drawn)
    assert count == 1
    filled = scipy.ndimage.binary_fill_holes(drawn)
    assert (filled != (rgba(path("M4 2h14v20H4z"))[..., 3] > 127)).mean() < 0.005
    assert not drawn[240:250, 250:260].any()


def test_ink_and_the_line_along_the_contour_of_paper_are_joined_without_a_seam():
    flag = path("M2 5h7v14H2z", "#0055a4") + path("M9 5h6v14H9z", "#fff")
    drawn = pictogram(rgba(flag + path("M15 5h7v14h-7z", "#ef4135"), 1024)) > 127
    assert scipy.ndimage.label(drawn)[1] == 1
    rows = np.flatnonzero(drawn.any(axis=1))
    assert drawn[rows[2], 130:890].all()


MOUNTAIN = "M2 21L12 4l10 17z"
SNOW = "M12 4l-4 6.8 2.500-1 1.500 1.500 1.500-1.500 2.500 1z"


def test_snow_on_a_mountain_is_within_an_outline():
    drawn = pictogram(rgba(path(MOUNTAIN, "#6b7f8c") + path(SNOW, "#fff"))) > 127
    filled = scipy.ndimage.binary_fill_holes(drawn)
    whole = rgba(path(MOUNTAIN))[..., 3] > 127
    assert (filled != whole).sum() < 0.02 * whole.sum()
    assert (filled & ~drawn).sum() > 300


def test_neighbours_that_are_paper_are_parted_by_ink():
    scene = path("M0 0h24v24H0z", "#9bd3f5") + path(MOUNTAIN, "#6b7f8c")
    scene += path(SNOW, "#fff") + path("M0 19h24v5H0z", "#5aa845")
    drawn = pictogram(rgba(scene)) > 127
    paper, _ = scipy.ndimage.label(~drawn)
    sizes = np.bincount(paper.ravel())[1:]
    assert (sizes > 1000).sum() == 2


def test_two_walls_of_one_house_are_alike():
    body = path("M5 16L18 3l13 13v17H5z", "#ffe8b6") + path("M18 16h1v16h-1z", "#ffcc4d")
    body += (
        '<path d="M5 16L18 3.700l13 12.300M18 16l6.500-6.500" fill="none" stroke="#66757f"'
        ' stroke-width="2" stroke-linecap="round"/>'
    )
    body += path("M10 17h4v4h-4zm12.500 0h4v4h-4zm0 9h4v4h-4z", "#55acee")
    body += path("M10 26h4v6h-4z", "#c1694f") + path("M2.500 32h31v3h-31z", "#5c913b")
    drawn = pictogram(rgba(body, box="0 0 36 36")) > 127
    left, right = drawn[330:360, 215:245], drawn[330:360, 280:310]
    assert left.mean() == right.mean()


def test_the_sole_of_a_shoe_is_within_an_outline():
    shoe, sole = "M2 10l6-1 5 5 7 2q2 1 1 3H2z", "M1.500 19h20v2.500h-20z"
    drawn = pictogram(rgba(path(shoe, "#36c") + path(sole, "#fff"))) > 127
    filled = scipy.ndimage.binary_fill_holes(drawn)
    whole = rgba(path(sole))[..., 3] > 127
    assert filled[whole].mean() > 0.98
    assert not drawn[430, 100:400].any()


@pytest.mark.thorough(but=1)
@pytest.mark.parametrize("colours", ["#222222 #cc3333", "#b58863 #f0d9b5", "#ffffff #1e6fd9"])
def test_the_darker_squares_of_a_board_are_ink_within_a_frame(colours):
    one, other = colours.split()
    squares = "".join(
        path(f"M{2 + 5 * x} {2 + 5 * y}h5v5h-5z", one if (x + y) % 2 else other)
        for x in range(4)
        for y in range(4)
    )
    inked, omissions = tone.pictogram(rgba(squares))
    dark = one if one < other else other
    for x in range(4):
        for y in range(4):
            row, column = (round((4.500 + 5 * at) * 512 / 24) for at in (y, x))
            assert (inked[row, column] > 127) == ((one if (x + y) % 2 else other) == dark)
    filled = scipy.ndimage.binary_fill_holes(inked > 127)
    assert filled[50:460, 50:460].all()
    assert not omissions


@pytest.mark.thorough(but=1)
@pytest.mark.parametrize("pole", ["#555", "#a67c52"])
def test_a_chequered_flag_on_a_pole_is_a_board(pole):
    squares = "".join(
        path(
            f"M{4 + 3.100 * x} {2 + 3.100 * y}h3.100v3.100h-3.100z",
            "#fff" if (x + y) % 2 else "#111",
        )
        for x in range(6)
        for y in range(4)
    )
    inked = pictogram(rgba(path("M2.500 1H4v22H2.500z", pole) + squares))
    for x in range(6):
        for y in range(4):
            row, column = (round(at * 512 / 24) for at in (3.550 + 3.100 * y, 5.550 + 3.100 * x))
            assert (inked[row, column] > 127) == ((x + y) % 2 == 0)
    assert inked[450, round(3.250 * 512 / 24)] > 127
    assert scipy.ndimage.binary_fill_holes(inked > 127)[50:300, 95:475].all()
