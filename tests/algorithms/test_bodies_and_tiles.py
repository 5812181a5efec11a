"""Bodies of things that look like tiles, wheels, and lines that cross, in colour and in black."""

from itertools import pairwise

import numpy as np
import pytest
import scipy

from iconstudio.algorithms.tones import tone
from iconstudio.algorithms.tones.alternation import Omission
from tests.algorithms.test_tone import assert_alike, ink, rgba

FRAME = '<rect x="3" y="3" width="18" height="18" rx="2" fill="{}"/>'
WHOLE = FRAME.format("#000")


def panel(x: float, y: float, width: float, height: float, fill: str) -> str:
    return f'<rect x="{x}" y="{y}" width="{width}" height="{height}" fill="{fill}"/>'


def coverage_of(body: str) -> np.ndarray:
    found = tone.pictogram(rgba(body))
    assert Omission.TILE not in found.omissions
    return found.coverage


@pytest.mark.thorough(but=1)
@pytest.mark.parametrize("paper", ["#fff", "#fff8e1"])
@pytest.mark.parametrize("colour", ["#d32f2f", "#1976d2", "#2e7d32"])
@pytest.mark.parametrize(
    "box", [(4, 8, 16, 12), (4, 12, 16, 8), (9, 4, 11, 16), (4, 4, 16, 12), (5, 9, 14, 10)]
)
def test_a_frame_with_a_header_is_no_tile(box, colour, paper):
    x, y, width, height = box
    mark = f'<circle cx="{x + width / 2}" cy="{y + height / 2}" r="2.5" fill="#333"/>'
    coverage = coverage_of(FRAME.format(colour) + panel(*box, paper) + mark)
    hole = ink(panel(*box, "#000")).astype(int) - ink(mark)
    assert_alike(coverage, ink(WHOLE) - hole, 0.02)


def test_the_days_of_a_calendar_do_not_make_it_a_mosaic():
    days = "".join(
        panel(x, y, 1.8, 1.6, "#90a4ae") for x in (5.5, 9, 12.5, 16) for y in (10, 13, 16)
    )
    coverage = coverage_of(FRAME.format("#1976d2") + panel(4, 8, 16, 12, "#fff") + days)
    hole = ink(panel(4, 8, 16, 12, "#000")).astype(int) - ink(days)
    assert_alike(coverage, ink(WHOLE) - hole, 0.03)


@pytest.mark.parametrize("corner", [0, 4])
def test_the_body_of_a_floppy_disk_is_no_tile(corner):
    outline = f'<path d="M3 3H{21 - corner}L21 {3 + corner}V21H3z" fill="#333"/>'
    labels = panel(8, 4, 8, 5, "#ddd") + panel(6, 12, 12, 8, "#ddd")
    slot = panel(12, 4.8, 2.2, 3.4, "#333")
    coverage = coverage_of(outline + labels + slot)
    assert_alike(coverage, ink(outline) - (ink(labels).astype(int) - ink(slot)), 0.02)


def test_the_body_of_a_camera_is_no_tile():
    lens = (
        '<circle cx="12" cy="12" r="6.5" fill="#fff"/><circle cx="12" cy="12" r="4" fill="#333"/>'
    )
    flash = '<circle cx="19" cy="5" r="1" fill="#fff"/>'
    coverage = coverage_of(FRAME.format("#3d9bd5") + lens + flash)
    assert coverage[: tone.SIDE // 2, tone.SIDE // 2].max() > 127
    assert coverage[int(6.8 / 24 * tone.SIDE), tone.SIDE // 2] < 127


@pytest.mark.parametrize(
    "drawn",
    [
        # two letters, one of which holds some of the tile
        'M7 7h2.5v10H7zM12 7h2a5 5 0 0 1 0 10h-2zM14 9.5v5a2.5 2.5 0 0 0 0-5z',
        'M8 7h3v10H8zM13 7h3v10h-3z',
    ],
)  # fmt: skip
def test_what_stands_free_keeps_no_tile(drawn):
    sign = f'<path d="{drawn}" fill="#fff" fill-rule="evenodd"/>'
    found = tone.pictogram(rgba(FRAME.format("#9266cc") + sign))
    assert found.omissions == {Omission.TILE}
    assert_alike(found.coverage, ink(sign))


def test_a_tile_with_one_sharp_corner_is_left_out():
    tile = '<path d="M3 3H19a2 2 0 0 1 2 2V19a2 2 0 0 1-2 2H5a2 2 0 0 1-2-2z" fill="#639"/>'
    sign = '<path d="M8 8h8v2h-3v7h-2v-7H8z" fill="#fff"/>'
    found = tone.pictogram(rgba(tile + sign + '<path d="M15 15h2v2h-2z" fill="#fff"/>'))
    assert found.omissions == {Omission.TILE}


@pytest.mark.parametrize("count", [5, 8, 12])
def test_no_sector_of_a_wheel_of_hues_is_missing(count):
    points = [
        np.array([np.cos(a), np.sin(a)]) * 10 + 12 for a in np.linspace(0, 2 * np.pi, count + 1)
    ]
    body = "".join(
        f'<path d="M12 12L{a[0]} {a[1]}A10 10 0 0 1 {b[0]} {b[1]}z" '
        f'fill="hsl({round(360 * n / count)},90%,50%)"/>'
        for n, (a, b) in enumerate(pairwise(points))
    )
    covered = tone.pictogram(rgba(body)).coverage > 127
    for n in range(count):
        angle = 2 * np.pi * (n + 0.5) / count
        column, row = ((12 + 7 * np.array([np.cos(angle), np.sin(angle)])) / 24 * tone.SIDE).astype(
            int
        )
        assert covered[row - 4 : row + 5, column - 4 : column + 5].all()


@pytest.mark.thorough(but=1)
@pytest.mark.parametrize(
    "colours", [("#0085c7", "#000", "#f4c300"), ("#e53935", "#43a047", "#1e88e5")]
)
@pytest.mark.parametrize("width", [0.7, 0.9, 1.2])
def test_rings_that_cross_are_whole(colours, width):
    places = (8, 9), (16, 9), (12, 14)
    rings = "".join(
        f'<circle cx="{x}" cy="{y}" r="4.4" fill="none" stroke="{colour}" stroke-width="{width}"/>'
        for (x, y), colour in zip(places, colours, strict=True)
    )
    coverage = tone.pictogram(rgba(rings)).coverage
    assert_alike(coverage, ink(rings), 0.02)
    assert scipy.ndimage.label(coverage > 127)[1] == 1
