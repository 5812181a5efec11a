"""A sheet on a desk is told from a sheet in the shadow, whatever its colour."""

import numpy as np
import pytest

from iconstudio.algorithms.scanning.sheet import sheet_on_desk
from tests.algorithms.test_tone import rgba

YELLOW, RED, WHITE = (1.0, 0.9, 0.0), (1.0, 0.0, 0.0), (0.95, 0.95, 0.93)


def paper(colour, beside):
    """A paper with drawings on it, (240, 320, 3); what lies on the right of it, and beneath them.

    ``beside`` is by how much each channel is darker there.
    """
    picture = np.empty((240, 320, 3), np.float32)
    picture[:] = colour
    picture[:, 210:] = np.array(colour) * beside
    for left in (40, 230):
        picture[80:160, left : left + 60] *= 0.1
    return picture


@pytest.mark.parametrize("colour", [YELLOW, RED, WHITE])
def test_paper_in_the_shadow_is_no_desk(colour):
    assert sheet_on_desk(paper(colour, 0.6)) is None


@pytest.mark.parametrize("colour", [YELLOW, WHITE])
def test_what_is_of_another_colour_is_a_desk(colour):
    picture = paper(colour, 0.6)
    picture[:, 210:] = (0.15, 0.35, 0.01)
    picture += np.random.default_rng(0).normal(0, 0.02, picture.shape)  # else it is a card
    sheet = sheet_on_desk(np.clip(picture, 0, 1))
    assert sheet is not None
    assert sheet[:, :200].mean() > 0.99 and not sheet[:, 220:].any()


def test_a_dot_near_a_corner_is_no_desk():
    """It does not reach the edge."""
    badge = '<circle cx="19.5" cy="4.5" r="3.5"/>'
    square = (
        '<path d="M19.5 10A5.5 5.5 0 0 1 14.2 3H5a2 2 0 0 0-2 2v14a2 2 0 0 0 2 2h14l2-2V9.8z"/>'
    )
    light = 1 - rgba(square + badge, 128)[..., 3:] / np.float32(255)
    assert sheet_on_desk(np.repeat(light, 3, axis=2)) is None
