"""Shades that differ little: told apart where they are all there is, and else drawn as one."""

import numpy as np
import pytest
import scipy

from iconstudio.algorithms.tones import tone
from iconstudio.algorithms.tones.alternation import Omission
from iconstudio.algorithms.tones.resolution import SIDE
from tests.algorithms.test_tone import amiss, rgba

pytestmark = pytest.mark.thorough(but=1)


def drawn(body: str) -> np.ndarray:
    return rgba(body, SIDE)


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


@pytest.mark.parametrize(
    ("kind", "behind", "paint"),
    [
        ("triangle", "#fff", "#ccc"),
        ("star", "#fff", "#ddd"),
        ("bar", "#fff", "#f5f5f5"),
        ("triangle", "#000", "#333"),
        ("star", "#fffbe6", "#f5e7b0"),
        ("lines", "#90a4ae", "#78909c"),
        ("star", "#78909c", "#90a4ae"),
        ("bar", "#e0e0e0", "#bdbdbd"),
        ("triangle", "#e53935", "#d32f2f"),
    ],
)
def test_a_figure_is_told_from_its_ground_however_little_they_differ(kind, behind, paint):
    ground, figure = FIGURES[kind]
    coverage, omissions = tone.pictogram(drawn(ground.format(behind) + figure.format(paint)))
    shape = drawn(figure.format("#000"))[..., 3]
    hole = np.where(shape > 127, 0, drawn(ground.format("#000"))[..., 3])
    left_out = behind == "#fff" or Omission.TILE in omissions
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
    drawing = drawn(SHADED[kind])
    coverage, omissions = tone.pictogram(drawing)
    assert amiss(coverage, drawing[..., 3]) < 0.005
    assert omissions == {Omission.SHADES}


def test_the_sides_of_a_box_are_set_off():
    box = ["M12 2l9 5-9 5-9-5z", "M3 7l9 5v10l-9-5z", "M21 7l-9 5v10l9-5z"]
    paints = ["#90caf9", "#64b5f6", "#42a5f5"]
    drawing = "".join(f'<path d="{d}" fill="{one}"/>' for d, one in zip(box, paints, strict=True))
    coverage, omissions = tone.pictogram(drawn(drawing))
    assert scipy.ndimage.label(coverage > 127)[1] == 3
    assert (coverage > 127).sum() > 0.85 * (drawn(drawing)[..., 3] > 127).sum()
    assert not omissions


def test_nobody_sees_shades_that_hardly_differ():
    drawing = drawn(
        '<path d="M1 1h22v22H1z" fill="#2196f3"/><path d="M6 6h9v9H6z" fill="#2197f3"/>'
    )
    coverage, omissions = tone.pictogram(drawing)
    assert np.array_equal(coverage, drawing[..., 3]) and not omissions


PAPER = '<rect x="3" y="5" width="18" height="14" rx="2" fill="#fff" stroke="{}" stroke-width="1"/>'
CONTENTS = {
    "nothing": "",
    "lines": '<path d="M6 9h8v2H6zM6 13h5v2H6z" fill="#1976d2"/>',
    "picture": '<circle cx="9" cy="11" r="3" fill="#e53935"/>'
    '<path d="M14 9h5M14 12h5" stroke="#90a4ae"/>',
}


@pytest.mark.parametrize(
    ("kind", "pale"), [("nothing", "#ddd"), ("lines", "#ccc"), ("picture", "#cfd8dc")]
)
def test_a_pale_line_around_paper_is_its_outline(kind, pale):
    coverage, omissions = tone.pictogram(drawn(PAPER.format(pale) + CONTENTS[kind]))
    line = PAPER.replace("#fff", "none").format("#000")
    assert amiss(coverage, drawn(line + CONTENTS[kind])[..., 3]) < 0.05
    assert not omissions


def test_white_is_told_from_grey_beside_it():
    book = '<path d="M2 4h10v16H2z" fill="#ddd"/><path d="M12 4h10v16H12z" fill="#fff"/>'
    ink = tone.pictogram(drawn(book)).coverage > 127
    grey = drawn('<path d="M2.3 4.3h9.4v15.4H2.3z"/>')[..., 3] > 127
    white = drawn('<path d="M13 5h8v14h-8z"/>')[..., 3] > 127
    assert ink[grey].all() and not ink[white].any()
    assert scipy.ndimage.label(ink)[1] == 1


@pytest.mark.thorough
def test_pale_marks_that_lie_free_on_white_stay_beside_other_colours():
    window = '<path d="M2 4h20v16H2z" fill="#fff"/><path d="M2 4h20v4H2z" fill="#1976d2"/>'
    lines = '<path d="M5 11h8v2H5zM5 15h12v2H5z" fill="{}"/>'
    ink = tone.pictogram(drawn(window + lines.format("#e0e0e0"))).coverage > 127
    right = tone.pictogram(drawn(window + lines.format("#1976d2"))).coverage > 127
    assert (ink != right).sum() < 0.01 * right.sum()


@pytest.mark.thorough
@pytest.mark.parametrize("line", ["#d0d8dc", "#ddd", "#bdc3c7"])
@pytest.mark.parametrize("paper", ["#fff", "#ecf0f1"])
def test_the_pale_flap_of_a_letter_on_a_badge_is_drawn(paper, line):
    badge = '<circle cx="12" cy="12" r="11" fill="#3498db"/>'
    letter = f'<path d="M6 7.500h12v9H6z" fill="{paper}"/>'
    flap = f'<path d="M6 7.500l6 5 6-5" fill="none" stroke="{line}" stroke-width="1"/>'
    ink = tone.pictogram(drawn(badge + letter + flap)).coverage > 127
    within = drawn('<path d="M7 8.500h10v7H7z"/>')[..., 3] > 127
    right = drawn(flap)[..., 3] > 127
    assert (ink != right)[within].sum() < 0.15 * right[within].sum()


@pytest.mark.thorough
def test_the_shade_of_something_white_is_no_mark():
    ball = '<circle cx="12" cy="12" r="9" fill="#fff"/><circle cx="19" cy="5" r="4" fill="#333"/>'
    shade = '<path d="M12 21a9 9 0 0 0 9-9h-3a6 6 0 0 1-6 6z" fill="#ddd"/>'
    plain, shaded = (tone.pictogram(drawn(one)).coverage > 127 for one in (ball, ball + shade))
    assert (plain != shaded).sum() < 0.01 * plain.sum()


def test_figures_that_are_lost_beside_other_colours_are_told():
    """A picture with paler hills and a pencil, as one says "edit the picture" with it."""
    picture = (
        '<path d="M5 15h70v60H5z" fill="#8cbcd6"/><path d="M60 90l30-30 8 8-30 30z" fill="{}"/>'
    )
    hills = '<path d="M15 60l15-28 15 28z" fill="{0}"/><circle cx="60" cy="28" r="6" fill="{0}"/>'
    both = [picture.format("#ff9800"), picture.format("#ff9800") + hills.format("#b3ddf5")]
    told = [tone.pictogram(rgba(one, 512, "0 0 100 100")).omissions for one in both]
    assert told == [set(), {Omission.SHADES}]


def flowing(name, one, other, across=1):
    stops = f'<stop stop-color="{one}"/><stop offset="1" stop-color="{other}"/>'
    return f'<linearGradient id="{name}" x2="{across}" y2="{1 - across}">{stops}</linearGradient>'


DISC = '<circle cx="12" cy="12" r="11" fill="{}"/>'
BEHIND, ABOVE = (flowing("b", "#f7971e", "#ffd200"), flowing("a", "#ffa62e", "#ffdf3a"))


def test_a_figure_is_told_from_its_ground_though_the_colours_of_both_flow():
    ground, figure = FIGURES["star"]
    drawing = BEHIND + ABOVE + ground.format("url(#b)") + figure.format("url(#a)")
    coverage, omissions = tone.pictogram(drawn(drawing))
    shape = drawn(figure.format("#000"))[..., 3]
    assert amiss(coverage, np.where(shape > 127, 0, drawn(DISC.format("#000"))[..., 3])) < 0.04
    assert not omissions


def test_sides_are_set_off_though_their_colours_flow():
    colours = flowing("b", "#6a11cb", "#2575fc", 0) + flowing("a", "#7b2bd6", "#3d88ff", 0)
    envelope = '<path d="M2 5h20v14H2z" fill="url(#b)"/><path d="M2 5l10 8 10-8z" fill="url(#a)"/>'
    coverage, omissions = tone.pictogram(drawn(colours + envelope))
    assert scipy.ndimage.label(coverage > 127)[1] == 2 and not omissions


@pytest.mark.parametrize("end", [1, 0.4])
def test_colours_that_flow_without_an_edge_are_one_shape(end):
    drawing = flowing("a", "#803", "#f9a", end).replace('y2="0.6"', 'y2="0"') + DISC
    coverage, omissions = tone.pictogram(drawn(drawing.format("url(#a)")))
    assert amiss(coverage, drawn(DISC.format("#000"))[..., 3]) < 0.01
    assert not omissions


def test_sides_that_are_one_beside_other_colours_are_told():
    """As the panels of an umbrella, beside its handle."""
    panels = '<path d="M2 12a10 10 0 0 1 20 0z" fill="#3b97d3"/>'
    panels += '<path d="M2 12A10 10 0 0 1 12 2a20 20 0 0 1 0 10z" fill="#2980b9"/>'
    handle = '<path d="M11 12h2v10h-2z" fill="#e64c3c"/>'
    coverage, omissions = tone.pictogram(drawn(panels + handle))
    assert scipy.ndimage.label(coverage > 127)[1] == 2 and omissions == {Omission.SHADES}


CUBES = {
    "blue": ("#60a5fa", "#3b82f6", "#2563eb"),
    "grey": ("#bdbdbd", "#9e9e9e", "#757575"),
    "brown, close on one side only": ("#e2b682", "#c4935a", "#a06a2c"),
}


@pytest.mark.parametrize("kind", CUBES)
def test_all_sides_of_a_thing_of_sides_are_set_off(kind):
    faces = ("M12 2l9 5-9 5-9-5z", "M3 7l9 5v10l-9-5z", "M21 7l-9 5v10l9-5z")
    cube = "".join(
        f'<path d="{d}" fill="{paint}"/>' for d, paint in zip(faces, CUBES[kind], strict=True)
    )
    coverage, omissions = tone.pictogram(drawn(cube))
    assert scipy.ndimage.label(coverage > 127)[1] == 3 and not omissions
