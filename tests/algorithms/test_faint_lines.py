"""Long pale lines beside what is darker, as the grey axes of a chart, are drawn, too."""

import io

import numpy as np
import pytest
from PIL import Image, ImageDraw

from iconstudio.algorithms.scanning.binarisation import ink_of, recognised
from iconstudio.algorithms.scanning.faint_lines import faint_lines, is_clean

pytestmark = pytest.mark.thorough

WIDTH, HEIGHT = 400, 260
POINTS = [(60, 200), (130, 130), (200, 150), (270, 70), (350, 40)]


def chart(grey: int, kind: str, ground: int = 255) -> np.ndarray:
    """Return a chart whose axes have that grey."""
    picture = Image.new("RGB", (WIDTH, HEIGHT), (ground,) * 3)
    draw = ImageDraw.Draw(picture)
    if kind == "curve":
        draw.line(POINTS, fill=(31, 119, 180), width=4)
    else:
        for x, y in POINTS:
            draw.rectangle((x - 20, y, x + 20, 229), fill=(31, 119, 180))
    draw.line([(20, 20), (20, 230), (380, 230)], fill=(grey,) * 3, width=1)
    return np.asarray(picture)


def lossy(pixels: np.ndarray) -> np.ndarray:
    file = io.BytesIO()
    Image.fromarray(pixels).save(file, "JPEG", quality=90)
    return np.asarray(Image.open(file))


@pytest.mark.parametrize("quality", ["exact", "lossy"])
@pytest.mark.parametrize("kind", ["curve", "bars"])
@pytest.mark.parametrize("grey", [136, 187])
def test_the_pale_axes_of_a_chart_are_drawn_whole(grey, kind, quality):
    pixels = chart(grey, kind)
    scan = recognised(lossy(pixels) if quality == "lossy" else pixels)
    ink = ink_of(scan)
    rows, columns = np.flatnonzero(ink.any(axis=1)), np.flatnonzero(ink.any(axis=0))
    ink = ink[rows[0] : rows[-1] + 1, columns[0] : columns[-1] + 1]
    assert ink.shape[1] / ink.shape[0] == pytest.approx(360 / 210, abs=0.08)
    assert ink[:, :12].any(axis=1).mean() > 0.97 and ink[-12:].any(axis=0).mean() > 0.97
    assert not scan.faint


def test_pale_areas_and_rules_are_no_such_lines():
    dark = np.zeros((300, 400), np.float32)
    dark[40:60, 50:350] = 1
    dark[100:180, 20:60] = 0.3
    dark[250] = 0.3
    assert not faint_lines(dark, 0.5).any()
    dark[220, 20:380] = 0.3
    assert faint_lines(dark, 0.5).sum() == 360


def test_where_nothing_is_paper_no_line_is_faint():
    assert not is_clean(np.ones((20, 20), np.float32), 0.5)
