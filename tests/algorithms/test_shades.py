"""Shades that differ little: told apart where they are all there is, and else drawn as one."""

import numpy as np
import pytest
import scipy

from iconstudio.algorithms.tones import tone
from iconstudio.algorithms.tones.alternation import Omission
from tests.algorithms.test_tone import amiss, rgba

PAIRS = [
    ("#ccc", "#fff"),
    ("#ddd", "#fff"),
    ("#f5f5f5", "#fff"),
    ("#333", "#000"),
    ("#f5e7b0", "#fffbe6"),
    ("#78909c", "#90a4ae"),
    ("#90a4ae", "#78909c"),
    ("#d32f2f", "#e53935"),
]
FIGURES = {
    "triangle": ('<path d="M1 1h22v22H1z" fill="{}"/>', '<path d="M12 5l8 14H4z" fill="{}"/>'),
    "star": (
        '<circle cx="12" cy="12" r="11" fill="{}"/>',
        '<path d="M12 4l2 6h6l-5 4 2 6-5-4-5 4 2-6-5-4h6z" fill="{}"/>',
    ),
    "bar": (
        '<rect x="1" y="1" width="22" height="22" rx="4" fill="{}"/>',
        '<path d="M6 10h12v4H6z" fill="{}"/>',
    ),
    "lines": (
        '<rect x="1" y="4" width="22" height="16" rx="2" fill="{}"/>',
        '<path d="M4 8h15v2H4zM4 13h9v2H4z" fill="{}"/>',
    ),
}


@pytest.mark.parametrize("paints", PAIRS)
@pytest.mark.parametrize("kind", FIGURES)
def test_a_figure_is_told_from_its_ground_however_little_they_differ(kind, paints):
    ground, figure = FIGURES[kind]
    drawing = rgba(ground.format(paints[1]) + figure.format(paints[0]))
    coverage, omissions = tone.pictogram(drawing)
    shape = rgba(figure.format("#000"))[..., 3]
    hole = np.where(shape > 127, 0, rgba(ground.format("#000"))[..., 3])
    left_out = omissions & {Omission.TILE, Omission.PAGE}
    assert amiss(coverage, shape if left_out else hole) < 0.04
    assert Omission.SHADES not in omissions


SHADED = {
    "half": '<circle cx="12" cy="12" r="10" fill="#e53935"/>'
    '<path d="M12 2a10 10 0 0 1 0 20z" fill="#d32f2f"/>',
    "crescent": '<circle cx="12" cy="12" r="10" fill="#ffb300"/>'
    '<path d="M12 2a10 10 0 1 0 9 14A10 10 0 0 1 12 2z" fill="#ffa000"/>',
    "rim": '<circle cx="12" cy="12" r="10" fill="#f9a825"/>'
    '<circle cx="12" cy="11" r="9" fill="#fbc02d"/>',
    "highlight": '<circle cx="12" cy="12" r="10" fill="#e53935"/>'
    '<path d="M6 8a7 7 0 0 1 6-4" stroke="#ef5350" stroke-width="2" fill="none"/>',
}


@pytest.mark.parametrize("kind", SHADED)
def test_shading_is_one_shape_and_told(kind):
    drawing = rgba(SHADED[kind])
    coverage, omissions = tone.pictogram(drawing)
    assert amiss(coverage, drawing[..., 3]) < 0.005
    assert omissions == {Omission.SHADES}


def test_nobody_sees_shades_that_hardly_differ():
    drawing = rgba('<path d="M1 1h22v22H1z" fill="#2196f3"/><path d="M6 6h9v9H6z" fill="#2197f3"/>')
    coverage, omissions = tone.pictogram(drawing)
    assert np.array_equal(coverage, drawing[..., 3]) and not omissions


PAPER = '<rect x="3" y="5" width="18" height="14" rx="2" fill="#fff" stroke="{}" stroke-width="1"/>'
CONTENTS = {
    "nothing": "",
    "lines": '<path d="M6 9h8v2H6zM6 13h5v2H6z" fill="#1976d2"/>',
    "picture": '<circle cx="9" cy="11" r="3" fill="#e53935"/>'
    '<path d="M14 9h5M14 12h5" stroke="#90a4ae"/>',
}


@pytest.mark.parametrize("pale", ["#ccc", "#ddd", "#e0e0e0", "#cfd8dc"])
@pytest.mark.parametrize("kind", CONTENTS)
def test_a_pale_line_around_paper_is_its_outline(kind, pale):
    coverage, omissions = tone.pictogram(rgba(PAPER.format(pale) + CONTENTS[kind]))
    line = PAPER.replace("#fff", "none").format("#000")
    assert amiss(coverage, rgba(line + CONTENTS[kind])[..., 3]) < 0.05
    assert not omissions


def test_white_is_told_from_grey_beside_it():
    book = '<path d="M2 4h10v16H2z" fill="#ddd"/><path d="M12 4h10v16H12z" fill="#fff"/>'
    ink = tone.pictogram(rgba(book)).coverage > 127
    grey = rgba('<path d="M2.3 4.3h9.4v15.4H2.3z"/>')[..., 3] > 127
    white = rgba('<path d="M13 5h8v14h-8z"/>')[..., 3] > 127
    assert ink[grey].all() and not ink[white].any()
    assert scipy.ndimage.label(ink)[1] == 1
