"""What is dark along the edges of a scan is left out, and told."""

import io

import numpy as np
import pytest
from PIL import Image
from scipy import ndimage

from iconstudio.algorithms.scanning.binarisation import ink_of, recognised
from iconstudio.algorithms.scanning.dark_edge import dark_edge
from iconstudio.algorithms.scanning.resampling import shrunk
from iconstudio.algorithms.tones.alternation import Omission
from tests import scans
from tests.algorithms.test_tone import rgba

pytestmark = pytest.mark.thorough

LEAF = '<path d="M4 20C2 10 10 4 21 3c0 12-6 17-15 15l-1 3zM6 17l8-7" fill="{}" stroke="#fff"/>'
HEIGHT, WIDTH = 480, 400
Y, X = np.mgrid[:HEIGHT, :WIDTH].astype(float)


def beyond(away: np.ndarray, soft: float) -> np.ndarray:
    """How bright a picture is that is dark where ``away`` is negative."""
    return 0.1 + 0.9 / (1 + np.exp(-away / soft))


EDGES = {
    "hard": beyond(X - 20, 1),
    "soft": beyond(X - 18, 8),
    "slanted": beyond(X - 8 - Y * 0.06, 1.2),
    "slanted and soft": beyond(X - 8 - Y * 0.06, 6),
    "at the top": beyond(Y - 6 - X * 0.05, 1.5),
    "torn": beyond(X - 16 - 8 * np.sin(Y / 45) - 4 * np.sin(Y / 15), 2),
    "two sides": beyond(X - 20, 1.5) * beyond(HEIGHT - 26 - Y, 4),
    "gutter": np.clip(1 - 0.85 * np.exp(-X / 26), 0, 1),
    "grey lid": np.where(X < 20, 0.45, 1),
}


def scan(light: np.ndarray, colour: str = "#222") -> np.ndarray:
    sheet = Image.new("L", (WIDTH, HEIGHT), 238)
    leaf = Image.fromarray(rgba(LEAF.format(colour), 200)).convert("RGBA")
    sheet.paste(leaf.convert("L"), (110, 130), leaf)
    grain = np.random.default_rng(0).normal(0, 4, (HEIGHT, WIDTH))
    grey = ndimage.gaussian_filter(np.asarray(sheet, float), 0.7) * light + grain
    file = io.BytesIO()
    Image.fromarray(np.clip(grey, 0, 255).astype(np.uint8)).save(file, "JPEG", quality=85)
    return np.asarray(Image.open(file).convert("RGB"))


@pytest.mark.parametrize("edge", EDGES)
def test_what_is_dark_along_an_edge_is_left_out(edge):
    plain = recognised(scan(np.ones((HEIGHT, WIDTH))))
    assert Omission.DESK not in plain.omissions
    found = recognised(scan(EDGES[edge]))
    assert Omission.DESK in found.omissions and not found.shaded
    inks = (scans.fitted(ink_of(one).astype(float)) for one in (plain, found))
    assert scans.iou(*inks) > 0.93


def test_what_is_drawn_from_the_edge_inwards_is_kept():
    drawn = np.ones((HEIGHT, WIDTH))
    drawn[100:400, :200] = 0.2
    assert dark_edge(shrunk(scan(drawn), 1)) is None


def test_lines_that_reach_the_edge_are_kept():
    drawn = np.where((Y + 20) % 40 < 6, 0.3, 1)
    assert dark_edge(shrunk(scan(drawn), 1)) is None


def test_a_corner_in_the_shadow_is_no_edge():
    light = 1 - 0.5 * np.exp(-np.hypot(X, Y) / 150)
    assert dark_edge(shrunk(scan(light), 1)) is None


def test_a_frame_around_the_drawing_is_kept():
    framed = np.ones((HEIGHT, WIDTH))
    framed[:12], framed[-12:], framed[:, :12], framed[:, -12:] = 0.2, 0.2, 0.2, 0.2
    assert dark_edge(shrunk(scan(framed), 1)) is None
