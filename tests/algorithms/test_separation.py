"""Lines between neighbours against the same drawn in SVG: what is in front has a pale stroke."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from iconstudio.algorithms.tones.resolution import SIDE
from iconstudio.algorithms.tones.separation import LINE
from iconstudio.algorithms.tones.tone import pictogram
from tests.algorithms.test_tone import rgba

WIDTH = 2 * LINE * 24 / SIDE
RED, BLUE, YELLOW = "#c22", "#22c", "#fd0"
ROOF = '<path d="M2 12 12 3l10 9z" {}/>'
WALL = '<path d="M5 12h14v9H5z" {}/>'
DISC = '<circle cx="{}" cy="{}" r="{}" {{}}/>'
LEFT, RIGHT = '<path d="M3 3h9v18H3z" {}/>', '<path d="M12 6h9v9h-9z" {}/>'


def coloured(*shapes: str) -> np.ndarray:
    fills = (f'fill="{colour}"' for colour in (RED, BLUE, YELLOW))
    body = "".join(shape.format(fill) for shape, fill in zip(shapes, fills, strict=False))
    return pictogram(rgba(body)).coverage / 255


def layered(*shapes: str) -> np.ndarray:
    """Each shape in black, with a pale stroke over those behind."""
    pale = f'fill="#fff" stroke="#fff" stroke-width="{WIDTH}" stroke-linejoin="round"'
    body = "".join(shape.format(pale) + shape.format('fill="#000"') for shape in shapes)
    drawn = rgba(body)
    return drawn[..., 3] / 255 * (1 - drawn[..., 0] / 255)


def assert_alike(found: np.ndarray, right: np.ndarray) -> None:
    assert abs(found - right).sum() < 0.005 * right.sum()
    assert abs(found - right).max() < 0.9  # no specks in a line, no bites at its ends


@pytest.mark.parametrize("shapes", [(WALL, ROOF), (RIGHT, LEFT)], ids=["roof", "beside"])
def test_the_contour_that_goes_straight_on_stays_whole(shapes):
    right = layered(*shapes)
    assert_alike(coloured(*shapes), right)
    assert_alike(coloured(*reversed(shapes)), right)  # the order of painting shows nowhere


def test_where_three_meet_there_are_no_specks():
    left, right = '<path d="M3.75 3.75h7.5v16.5h-7.5z" {}/>', '<path d="M11.25 7.5h9V15h-9z" {}/>'
    shapes = right, left, DISC.format(11.25, 16.875, 2.625)
    assert_alike(coloured(*shapes), layered(*shapes))


@pytest.mark.thorough
@settings(max_examples=15)
@given(st.floats(5, 19), st.floats(2.5, 5), st.floats(-0.7, 0.7))
def test_a_disc_in_front_stays_a_disc(y, radius, aside):
    disc = DISC.format(12 + aside * radius, y, radius)
    square = '<path d="M2 1h10v22H2z" {}/>'
    at = rgba(disc.format("fill='#000'"))[..., 3] / 255
    assert abs(coloured(square, disc) - at)[at > 0].sum() < 0.01 * at.sum()


def test_neither_of_two_halves_is_in_front():
    halves = '<path d="M2 12a10 10 0 0 1 20 0z" {}/>', '<path d="M2 12a10 10 0 0 0 20 0z" {}/>'
    found = coloured(*halves)
    assert found[:, SIDE // 2].min() == 0
    np.testing.assert_allclose(found, found[::-1], atol=0.1)
