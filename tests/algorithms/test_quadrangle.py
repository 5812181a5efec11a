"""What a photo shows of a sheet is told from other shapes."""

import numpy as np
import pytest
from skimage.draw import disk, polygon2mask

from iconstudio.algorithms.scanning.quadrangle import quadrangularity

SHEETS = {
    "straight": [(20, 30), (20, 170), (120, 170), (120, 30)],
    "turned": [(70, 20), (20, 130), (80, 170), (130, 60)],
    "from below": [(20, 60), (20, 140), (130, 190), (130, 10)],
    "a corner past the photo": [(20, 30), (10, 230), (120, 190), (130, 20)],
    "a side past the photo": [(20, 60), (20, 140), (180, 190), (180, 10)],
    "two sides past the photo": [(40, 60), (30, 260), (200, 260), (200, 50)],
}
OTHERS = {
    "triangle": [(20, 100), (130, 190), (130, 10)],
    "arrow": [(20, 100), (80, 190), (80, 130), (130, 130), (130, 70), (80, 70), (80, 10)],
    "star": [(10, 100), (130, 160), (50, 20), (50, 180), (130, 40)],
    "needle": [(70, 10), (60, 100), (70, 190), (80, 100)],
}


@pytest.mark.parametrize("corners", SHEETS.values(), ids=SHEETS)
def test_a_rectangle_seen_askew_is_a_quadrangle(corners):
    assert quadrangularity(polygon2mask((150, 200), corners)) > 0.98


@pytest.mark.parametrize("corners", OTHERS.values(), ids=OTHERS)
def test_other_polygons_are_none(corners):
    assert quadrangularity(polygon2mask((150, 200), corners)) < 0.9


def test_a_disc_is_none_and_a_torn_sheet_less_of_one():
    shape = np.zeros((150, 200), bool)
    shape[disk((75, 100), 60)] = True
    assert quadrangularity(shape) < 0.9
    sheet = polygon2mask((150, 200), SHEETS["from below"])
    torn = sheet.copy()
    torn[:50, :85] = False
    assert torn.sum() / sheet.sum() == pytest.approx(quadrangularity(torn), abs=0.03)


def test_nothing_is_no_quadrangle():
    assert quadrangularity(np.zeros((30, 40), bool)) == 0
