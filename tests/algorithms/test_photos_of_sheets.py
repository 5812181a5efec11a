"""A sheet on a photo is the ground, also on a pale desk, and what lies around it is left out."""

import numpy as np
import pytest

from iconstudio.algorithms.scanning.binarisation import ink_of, recognised
from iconstudio.algorithms.scanning.sheet import photographed_sheet
from iconstudio.algorithms.tones.alternation import Omission
from tests import scans
from tests.algorithms.test_scanning import house

pytestmark = pytest.mark.thorough(but=1)

CORNERS = {
    "whole": [(90, 50), (560, 30), (590, 440), (60, 420)],
    "past two borders": [(-60, 60), (560, 25), (600, 520), (-60, 540)],
    "all but a corner": [(-300, 170), (200, -190), (900, 100), (500, 900)],
}


@pytest.mark.parametrize("desk", ["pale", "wood"])
@pytest.mark.parametrize("corners", CORNERS)
def test_what_lies_around_a_sheet_is_left_out_and_told(corners, desk):
    sheet = np.zeros((800, 920))
    sheet[200:600, 260:660] = house()
    photo, ink = scans.photographed(sheet, CORNERS[corners], desk, blur=0.8, noise=2)
    scan = recognised(photo)
    assert scan.found and not scan.inverted and scan.omissions == {Omission.DESK}
    found = scans.fitted(ink_of(scan).astype(float))
    assert scans.iou(found, scans.fitted(ink)) > 0.9


def test_what_a_computer_painted_was_not_photographed():
    """A card is in one colour all over, and so is what is behind it."""
    picture = np.full((200, 300, 3), (0.2, 0.5, 0.8), np.float32)
    picture[40:160, 60:240] = 0.97
    picture[80:120, 120:180] = 0.1
    assert photographed_sheet(picture) is None
    uneven = picture * np.linspace(0.7, 1, 300, dtype=np.float32)[:, None]
    assert photographed_sheet(uneven) is not None
