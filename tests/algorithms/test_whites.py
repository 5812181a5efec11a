"""White on colour is paper: in a bite into it, and within an outline where it is a shape."""

import numpy as np
import pytest
import scipy

from iconstudio.algorithms.tones import tone
from iconstudio.algorithms.tones.alternation import Omission
from iconstudio.algorithms.tones.paints import Paints, paints
from iconstudio.algorithms.tones.resolution import SIDE
from iconstudio.algorithms.tones.tone import OUTLINE
from tests.algorithms.test_tone import amiss, pictogram, rgba

pytestmark = pytest.mark.thorough(but=1)

BOX = "0 0 100 100"
MOON = '<circle cx="45" cy="50" r="40" fill="{}"/>'
DISC = '<circle cx="65" cy="42" r="34" fill="{}"/>'
APPLE = '<path d="M50 25c10-15 40-5 40 20s-20 50-30 50-5-4-10-4-2 4-12 4-28-25-28-50 30-35 40-20z"'
LEAF = '<path d="M50 21c0-10 8-18 16-20 0 10-6 18-16 20z" fill="#2a2"/>'
CLOUD = '<path d="M25 85a18 18 0 0 1 0-36a22 22 0 0 1 42-4a20 20 0 0 1 10 40z" fill="#fff"/>'

BITES = {
    "crescent": (MOON.format("#000"), DISC.format("#fff")),
    "blue crescent": (MOON.format("#246"), DISC.format("#fff")),
    "yellow crescent": (MOON.format("#fc3"), DISC.format("#fefefe")),
    "shallow bite": (MOON.format("#000"), '<circle cx="85" cy="22" r="20" fill="#fff"/>'),
    "deep bite": (
        '<circle cx="35" cy="50" r="30" fill="#222"/>',
        '<circle cx="65" cy="50" r="34" fill="#fff"/>',
    ),
    "apple": (f'{APPLE} fill="#c22"/>{LEAF}', '<circle cx="95" cy="50" r="18" fill="#fff"/>'),
    "wedge": (
        '<circle cx="50" cy="50" r="40" fill="#fc0"/>',
        '<path d="M50 50L100 20V80z" fill="#fff"/>',
    ),
    "letter": (
        '<rect x="10" y="10" width="60" height="60" fill="#06c"/>',
        '<path d="M40 30h55v18h-18v45h-18v-45h-19z" fill="#fff"/>',
    ),
    "band": (
        '<circle cx="50" cy="50" r="35" fill="#06c"/>',
        '<path d="M5 90L95 10" stroke="#fff" stroke-width="26"/>',
    ),
}


@pytest.mark.parametrize("kind", BITES)
def test_pure_white_that_bites_into_a_colour_is_paper(kind):
    colour, white = BITES[kind]
    drawing = rgba(colour + white, box=BOX)
    right = np.where(rgba(white, box=BOX)[..., 3] > 127, 0, rgba(colour, box=BOX)[..., 3])
    coverage = pictogram(drawing)
    assert amiss(coverage, right) < 0.03
    if kind != "apple":  # whose leaf a line sets off
        assert paints(drawing, coverage) is Paints.DARK


def test_what_is_drawn_on_a_bite_in_the_same_colour_is_ink():
    gear = '<path d="M39 5h12v30h30v12h-80v-12h38zM39 47h12v34h-12z" fill="#555"/>'
    badge = '<circle cx="72" cy="72" r="24" fill="#fff"/>'
    disc, plus = '<circle cx="45" cy="45" r="30" fill="#555"/>', "M60 72h24M72 60v24"
    sign = f'<path d="{plus}" stroke="#555" stroke-width="7"/>'
    right = np.where(
        rgba(badge, box=BOX)[..., 3] > 127,
        rgba(sign, box=BOX)[..., 3],
        rgba(gear + disc, box=BOX)[..., 3],
    )
    assert amiss(pictogram(rgba(gear + disc + badge + sign, box=BOX)), right) < 0.03


SHAPES = {
    "cloud before the sun": f'<circle cx="65" cy="35" r="25" fill="#fc3"/>{CLOUD}',
    "cloud before much of the sun": (
        '<circle cx="60" cy="40" r="35" fill="#fc3"/>'
        '<path d="M20 90a16 16 0 0 1 0-32a20 20 0 0 1 38-4a18 18 0 0 1 10 36z" fill="#fff"/>'
    ),
    "sheep": (
        '<path d="M30 60h8v30h-8zM55 60h8v30h-8z" fill="#333"/><circle cx="78" cy="38" r="14" '
        'fill="#333"/><circle cx="45" cy="45" r="30" fill="#fff"/>'
    ),
    "panda": (
        '<circle cx="22" cy="25" r="15"/><circle cx="78" cy="25" r="15"/>'
        '<circle cx="50" cy="55" r="40" fill="#fff"/>'
        '<circle cx="36" cy="50" r="8"/><circle cx="64" cy="50" r="8"/>'
    ),
    "pill": (
        '<path d="M50 30h25a20 20 0 0 1 0 40H50z" fill="#fff"/>'
        '<path d="M50 30H25a20 20 0 0 0 0 40H50z" fill="#e33"/>'
    ),
    "badge": (
        '<circle cx="45" cy="45" r="40" fill="#39f"/><circle cx="78" cy="78" r="20" fill="#fff"/>'
        '<path d="M70 78h16M78 70v16" stroke="#3a3" stroke-width="5"/>'
    ),
    "off-white disc": MOON.format("#246") + DISC.format("#f5f5f5"),
}


def assert_outlined(drawing: np.ndarray, coverage: np.ndarray) -> None:
    """Assert that white is paper with ink along the outside, and that dark colours are ink."""
    inside = drawing[..., 3] > 127
    white = (drawing[..., :3] > 228).all(axis=2) & inside
    depth = scipy.ndimage.distance_transform_edt(np.pad(inside, 1))[1:-1, 1:-1]
    width = OUTLINE * len(drawing) / SIDE
    at_edge = scipy.ndimage.binary_erosion(white | ~inside, iterations=4) & inside
    ink = coverage > 127
    assert ink[at_edge & (depth < width - 3)].mean() > 0.95
    assert ink[white & (depth > width + 3)].mean() < 0.03
    assert ink[scipy.ndimage.binary_erosion(inside & ~white, iterations=4)].mean() > 0.9


@pytest.mark.parametrize("kind", SHAPES)
def test_white_shapes_beside_a_colour_are_outlined(kind):
    """Solid, a panda's head would swap what is white and what is black."""
    drawing = rgba(SHAPES[kind], box=BOX)
    assert_outlined(drawing, pictogram(drawing))


FLAGS = {
    "white above": '<path d="M0 20h100v30H0z" fill="#fff"/><path d="M0 50h100v30H0z" fill="#d13"/>',
    "white below": '<path d="M0 20h100v30H0z" fill="#e12"/><path d="M0 50h100v30H0z" fill="#fff"/>',
    "triangle": '<path d="M0 20h100v30H0z" fill="#fff"/><path d="M0 50h100v30H0z" fill="#d12"/>'
    '<path d="M0 20l50 30-50 30z" fill="#147"/>',
    "between two": '<path d="M0 20h34v60H0z" fill="#05a"/><path d="M34 20h32v60H34z" fill="#fff"/>'
    '<path d="M66 20h34v60H66z" fill="#e43"/>',
    "quarters": '<path d="M0 20h100v60H0z" fill="#fff"/><path d="M50 20h50v30H50z" fill="#d13"/>'
    '<path d="M0 50h50v30H0z" fill="#059"/>',
    "cross": '<path d="M0 20h100v60H0z" fill="#fff"/>'
    '<path d="M0 44h100v12H0zM44 20h12v60H44z" fill="#c12"/>',
    "round": '<path d="M10 50a40 40 0 0 1 80 0z" fill="#fff"/>'
    '<path d="M10 50a40 40 0 0 0 80 0z" fill="#d13"/>',
}
PARTS = {
    "flap": '<path d="M8 20h84v60H8z" fill="{}"/><path d="M8 20h84L50 55z" fill="#e53935"/>',
    "ribbon": '<path d="M10 10h80v80H10z" fill="{}"/>'
    '<path d="M10 42h80v16H10zM42 10h16v80H42z" fill="#e53935"/>',
    "stripe": '<path d="M10 10h80v80H10z" fill="{}"/><path d="M10 38h80v24H10z" fill="#1e88e5"/>',
    "diagonal": '<path d="M10 10h80v80H10z" fill="{}"/>'
    '<path d="M10 70L70 10h20L10 90z" fill="#43a047"/>',
}


@pytest.mark.parametrize("kind", FLAGS)
def test_white_at_the_edge_of_a_flag_is_outlined(kind):
    drawing = rgba(FLAGS[kind], SIDE, BOX)
    assert_outlined(drawing, pictogram(drawing))


@pytest.mark.parametrize("kind", PARTS)
def test_the_parts_of_one_paint_are_alike(kind):
    drawing = rgba(PARTS[kind].format("#eceff1"), SIDE, BOX)
    assert_outlined(drawing, pictogram(drawing))


BODIES = {
    "egg": (
        '<path d="M10 50a30 30 0 0 1 60-25a25 25 0 0 1 20 40a30 25 0 0 1-50 15a30 30 0 0 1-30-30z"'
        ' fill="#fff"/><circle cx="48" cy="48" r="17" fill="#fb0"/>'
    ),
    "ghost": (
        '<path d="M15 95V45a35 35 0 0 1 70 0v50l-17-12-18 12-18-12z" fill="#fff"/>'
        '<circle cx="38" cy="42" r="7"/><circle cx="62" cy="42" r="7"/>'
    ),
}


@pytest.mark.parametrize("kind", BODIES)
def test_white_all_around_is_the_body_of_a_drawing(kind):
    drawing = rgba(BODIES[kind], box=BOX)
    white = (drawing[..., :3] > 240).all(axis=2) & (drawing[..., 3] > 127)
    ink = pictogram(drawing) > 127
    assert ink[white].mean() > 0.99
    assert ink[~white].mean() < 0.01


@pytest.mark.parametrize(
    "behind",
    ['<path d="M0 20h100v60H0z" fill="#fff"/>', '<circle cx="50" cy="50" r="45" fill="#fff"/>'],
)
def test_white_behind_a_drawing_is_left_out_and_told(behind):
    sign = '<circle cx="50" cy="50" r="22" fill="#b02"/>'
    coverage, omissions = tone.pictogram(rgba(behind + sign, box=BOX))
    assert amiss(coverage, rgba(sign, box=BOX)[..., 3]) < 0.01
    assert omissions == {Omission.PAGE}
    drawn = rgba(behind + sign.replace("#b02", "#222"), SIDE, BOX)
    assert tone.pictogram(drawn).omissions == ({Omission.PAGE} if "circle" in behind else set())


FACE = (
    '<circle cx="50" cy="50" r="45" fill="#fc4"/><path d="M22 55h56a28 28 0 0 1-56 0z" fill="{}"/>'
)
TEETH = {
    "free": '<path d="M32 60h36v7H32z" fill="#fff"/>',
    "at the lip": '<path d="M28 55h44v9H29z" fill="#fff"/>',
    "fangs": '<path d="M32 55h10l-5 14zM58 55h10l-5 14z" fill="#fff"/>',
}


@pytest.mark.parametrize("kind", TEETH)
def test_teeth_in_a_mouth_stay(kind):
    face = rgba(FACE, box=BOX)
    ink = pictogram(rgba(FACE + TEETH[kind], box=BOX)) > 127
    teeth = rgba(TEETH[kind], box=BOX)[..., 3] > 127
    hole = (face[..., 3] > 127) & (face[..., 0] < 120) & ~teeth
    assert ink[scipy.ndimage.binary_erosion(teeth, iterations=12)].mean() > 0.8
    assert ink[scipy.ndimage.binary_erosion(hole, iterations=4)].mean() < 0.05


@pytest.mark.parametrize("grey", ["#d2d3d4", "#ccc", "#bbb", "#999"])
def test_grey_beside_white_that_is_paper_is_kept(grey):
    """A chart of a white disc and a ring in two colours."""
    chart = (
        '<circle cx="50" cy="50" r="38" fill="#fff"/><g fill="none" stroke-width="14">'
        f'<circle cx="50" cy="50" r="38" stroke="{grey}"/>'
        '<path d="M50 12a38 38 0 1 1 -22 69" stroke="#ce4b99"/></g>'
    )
    drawing = rgba(chart, box=BOX)
    coverage = pictogram(drawing) > 127
    ring = (
        rgba(
            '<circle cx="50" cy="50" r="38" fill="none" stroke="#000" stroke-width="14"/>', box=BOX
        )[..., 3]
        > 127
    )
    assert coverage[ring].mean() > 0.9 and coverage[~ring].mean() < 0.01


RING = '<circle cx="{}" cy="50" r="{}" fill="none" stroke="{}" stroke-width="5"/>'
WITHIN_LINES = {
    "a clock": (
        RING.format(50, 40, "#e53935") + '<path d="M50 25v25l15 12" fill="none" stroke="#111" '
        'stroke-width="4"/>',
        '<circle cx="50" cy="50" r="36.5" fill="#fff"/>',
    ),
    "glasses": (
        RING.format(25, 20, "#1b5e20")
        + RING.format(75, 20, "#1b5e20")
        + '<path d="M44 50h12" stroke="#1b5e20" stroke-width="5"/>',
        '<g fill="#fff"><circle cx="25" cy="50" r="16.5"/><circle cx="75" cy="50" r="17"/></g>',
    ),
    "wheels, which the frame crosses": (
        RING.format(25, 20, "#000")
        + RING.format(75, 20, "#000")
        + '<path d="M25 50L35 20M25 12h18M38 28H65L75 50L52 52zM52 52L70 14M60 12h22" fill="none" '
        'stroke="#ea5a47" stroke-width="6"/>',
        '<circle cx="25" cy="50" r="16" fill="#fff"/><circle cx="75" cy="50" r="16" fill="#fff"/>'
        '<path d="M47 35h12l-6 9z" fill="#fff"/>',
    ),
}


@pytest.mark.parametrize("kind", WITHIN_LINES)
def test_white_in_a_line_that_leaves_a_gap_has_no_other_outline(kind):
    lines, white = WITHIN_LINES[kind]
    right = rgba(lines, box=BOX)[..., 3]
    drawn = white + lines if "crosses" in kind or "clock" in kind else lines + white
    assert amiss(pictogram(rgba(drawn, box=BOX)), right) < 0.05  # where lines cross, one is set off


def test_white_in_a_wide_ring_is_a_body_of_its_own():
    star = '<path d="M50 26l7 16 17 1-13 11 4 17-15-9-15 9 4-17-13-11 17-1z" fill="{}"/>'
    ring = RING.format(50, 40, "#1976d2")
    right = rgba(ring + star.format("#000"), box=BOX)[..., 3]
    assert amiss(pictogram(rgba(ring + star.format("#fff"), box=BOX)), right) < 0.02


DAYS = "".join(
    f'<rect x="{x}" y="{y}" width="10" height="8" fill="{{marks}}"/>'
    for y in (45, 60, 75)
    for x in (20, 37, 54, 71)
)
PERSON = '<circle cx="28" cy="50" r="10" fill="#ffab91"/><path d="M12 75q0-14 16-14t16 14z"'
PAGE = '<rect x="9" y="16" width="82" height="76" rx="9" fill="#fff" stroke="{line}"'
PAGES = {
    "days": DAYS,
    "card": f'{PERSON} fill="#5c6bc0"/>'
    '<path d="M54 44h30v7h-30zM54 58h30v7h-30z" fill="{marks}"/>',
    "nothing": "",
}


@pytest.mark.parametrize("header", ["#e53935", "#00acc1", "#333"])
@pytest.mark.parametrize("line", ["#b0bec5", "#78909c", "#ccc"])
@pytest.mark.parametrize("kind", PAGES)
def test_a_page_in_a_pale_line_with_a_header_is_paper(kind, line, header):
    band = f'<path d="M9 25a9 9 0 0 1 9-9h64a9 9 0 0 1 9 9v10H9z" fill="{header}"/>'
    marks = PAGES[kind].format(marks="#90a4ae")
    page = PAGE.format(line=line) + ' stroke-width="3"/>'
    lines = rgba(PAGE.format(line="#000").replace("#fff", "none") + ' stroke-width="3"/>', box=BOX)
    right = np.maximum(lines, rgba(band + marks, box=BOX))[..., 3]
    assert amiss(pictogram(rgba(page + band + marks, box=BOX)), right) < 0.06


@pytest.mark.parametrize(
    ("white", "line"), [("#fafafa", "#eee"), ("#fff", "#eee"), ("#fff", "#ddd")]
)
def test_a_faint_line_around_white_is_drawn(white, line):
    egg = BODIES["egg"].replace("/>", f' stroke="{line}" stroke-width="2"/>', 1)
    coverage = pictogram(rgba(egg.replace("#fff", white), box=BOX)) > 127
    inside = rgba(egg, box=BOX)[..., 3] > 127
    depth = scipy.ndimage.distance_transform_edt(inside)
    yolk = rgba('<circle cx="48" cy="48" r="17"/>', box=BOX)[..., 3] > 127
    assert coverage[inside & (depth < 6)].mean() > 0.9
    assert coverage[yolk].mean() > 0.97
    assert coverage[(depth > 16) & ~scipy.ndimage.binary_dilation(yolk, iterations=3)].mean() < 0.01


@pytest.mark.parametrize("seam", [1, 1.5, 2.5])
def test_facets_between_white_seams_are_ink_and_white_ones_within_an_outline(seam):
    facets = {
        "#d35400": ["6,6 22,22 12,34", "58,6 42,22 52,34"],
        "#f39c12": ["22,22 12,34 32,38", "42,22 52,34 32,38", "22,22 42,22 32,38"],
        "#f5f5f5": ["12,34 32,38 26,54", "52,34 32,38 38,54", "26,54 32,38 38,54"],
        "#2c3e50": ["26,54 38,54 32,60"],
    }
    fox = {
        colour: "".join(
            f'<polygon points="{one}" fill="{colour}" stroke="#fff" stroke-width="{seam}"/>'
            for one in points
        )
        for colour, points in facets.items()
    }
    drawing = rgba("".join(fox.values()), box="0 0 64 64")
    ink = pictogram(drawing) > 127
    inside = drawing[..., 3] > 127
    white = (drawing[..., :3] > 240).all(axis=2) & inside
    depth = scipy.ndimage.distance_transform_edt(inside)
    assert ink[scipy.ndimage.binary_erosion(inside & ~white, iterations=4)].mean() > 0.95
    assert ink[scipy.ndimage.binary_erosion(white, iterations=10) & (depth > 18)].mean() < 0.05


@pytest.mark.parametrize("page", ["#fff", "#f5f5f5", "#eceff1"])
@pytest.mark.parametrize("days", [(3, 4), (4, 5)])
def test_a_page_with_many_marks_is_within_an_outline(page, days):
    rows, columns = days
    marks = "".join(
        f'<rect x="{20 + 56 / columns * x}" y="{42 + 44 / rows * y}" width="9" height="8" '
        'fill="#90a4ae"/>'
        for y in range(rows)
        for x in range(columns)
    )
    body = f'<rect x="9" y="16" width="82" height="76" rx="9" fill="{page}"/>'
    header = '<path d="M9 36V25a9 9 0 0 1 9-9h64a9 9 0 0 1 9 9v11z" fill="#e53935"/>'
    drawing = rgba(body + header + marks, box=BOX)
    ink = pictogram(drawing) > 127
    depth = scipy.ndimage.distance_transform_edt(drawing[..., 3] > 127)
    assert ink[(depth > 2) & (depth < OUTLINE - 3)].mean() > 0.98
    assert ink[rgba(marks, box=BOX)[..., 3] > 127].mean() > 0.95
    paper = (depth > OUTLINE + 3) & (rgba(header + marks, box=BOX)[..., 3] < 128)
    assert ink[scipy.ndimage.binary_erosion(paper, iterations=3)].mean() < 0.01
