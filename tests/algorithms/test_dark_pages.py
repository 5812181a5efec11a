"""A coloured drawing on a dark page, as of a program in dark mode, is what it is without one."""

import io

import numpy as np
import pytest
from PIL import Image

from iconstudio.algorithms.scanning.binarisation import ink_of, recognised
from iconstudio.algorithms.tones.alternation import Omission
from tests import scans
from tests.algorithms.test_tone import as_svg, rgba

pytestmark = pytest.mark.thorough(but=1)

DRAWINGS = {
    "floppy disk": '<path d="M10 10h68l12 12v68H10z" fill="#3f51b5"/>'
    '<path d="M28 10h44v30H28z" fill="#cfd8dc"/><path d="M56 14h10v20H56z" fill="#3f51b5"/>'
    '<path d="M22 54h56v36H22z" fill="#fff"/>'
    '<path d="M30 64h40v5H30zM30 76h40v5H30z" fill="#9fa8da"/>',
    "dark floppy disk": '<path d="M10 10h68l12 12v68H10z" fill="#263238"/>'
    '<path d="M28 10h44v30H28z" fill="#90a4ae"/><path d="M56 14h10v20H56z" fill="#263238"/>'
    '<path d="M22 54h56v36H22z" fill="#eceff1"/><path d="M22 54h56v10H22z" fill="#ef5350"/>',
    "badge": '<circle cx="50" cy="50" r="42" fill="#4fd1d9"/>'
    '<path d="M34 28h10v30h22v10H34z" fill="#fff"/>',
    "disc in three colours": '<circle cx="50" cy="50" r="42" fill="#d80027"/>'
    '<path d="M11 34h78q6 16 0 32H11q-6-16 0-32z" fill="#eee"/>'
    '<circle cx="50" cy="50" r="9" fill="#ff9811"/>',
}


def on_dark(drawing, page, side, quality):
    pixels = rgba(f'<path d="M-9 0h118v100H-9z" fill="{page}"/>{drawing}', side, "0 0 100 100")
    opaque = Image.fromarray(np.ascontiguousarray(pixels[..., :3]))
    if not quality:
        return np.asarray(opaque)
    file = io.BytesIO()
    opaque.save(file, "JPEG", quality=quality)
    return np.asarray(Image.open(file))


@pytest.mark.parametrize("name", DRAWINGS)
@pytest.mark.parametrize(
    ("page", "side", "quality"), [("#18191b", 240, 0), ("#0d1117", 160, 0), ("#1e1e1e", 360, 85)]
)
def test_a_dark_page_is_no_part_of_the_drawing_on_it(name, page, side, quality):
    right = as_svg(DRAWINGS[name])
    scan = recognised(on_dark(DRAWINGS[name], page, side, quality))
    assert scan.coloured is not None and scan.omissions - {Omission.TILE} == right.omissions
    ink = scans.fitted(ink_of(scan).astype(float))
    assert scans.iou(ink, scans.fitted(right.coverage / 255)) > 0.9
