"""The lines of drawings: strokes stay strokes, and drawn again they give the same picture."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from iconstudio.algorithms.curves.outline import path_of, strokes_of
from iconstudio.algorithms.raster import overlap
from iconstudio.library.collection import Collection
from iconstudio.model import CANVAS, Frame, IconstudioError, Line
from iconstudio.svg.ink import own_lines
from iconstudio.svg.lines import lines_of, lines_on_page
from iconstudio.svg.rasterise import rasterise
from iconstudio.svg.reading import own_svg
from iconstudio.svg.resvg import render_coverage

SETS = ("lucide", "tabler", "iconoir", "ph", "mdi", "fa6-solid", "bi", "heroicons", "bx", "carbon")
WHOLE = Frame(0, 0, CANVAS)


def document(body, box="0 0 24 24"):
    return f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="{box}">{body}</svg>'


def read(body):
    svg = document(body)
    return lines_of(svg, *rasterise(svg))


def drawn(body):
    return render_coverage(document(body, f"0 0 {CANVAS} {CANVAS}"), WHOLE, CANVAS) > 127


def picture(lines):
    return drawn(f'<path d="{path_of(lines).svg()}"/>')


def picture_of_strokes(lines):
    return drawn(
        "".join(
            f'<path d="{path.svg()}" fill="none" stroke="#000" stroke-width="{width}" '
            'stroke-linecap="round" stroke-linejoin="round"/>'
            if width
            else f'<path d="{path.svg()}"/>'
            for path, width in strokes_of(lines)
        )
    )


def kinds(lines):
    return ["stroke" if one.width else "contour" for one in lines]


@pytest.mark.thorough
def test_icons_of_ten_sets_are_drawn_again_as_they_are():
    found = {name: [] for name in SETS}
    with Collection.open() as collection:
        for word in ("house", "bird", "camera", "bicycle"):
            for one in collection.search(word):
                of = found.get(one.id.partition(":")[0])
                if of is not None and len(of) < 3:
                    of.append(one)
    icons = [one for of in found.values() for one in of]
    assert len(icons) >= 25
    for icon in icons:
        frame, coverage = rasterise(icon.svg)
        lines = own_lines(icon.svg, frame, coverage)
        assert lines, icon.id
        for again in (picture(lines), picture_of_strokes(lines)):
            assert overlap(again, coverage > 127) > 0.97, icon.id
        if icon.id.startswith("lucide:"):
            assert "stroke" in kinds(lines), icon.id


def test_a_stroke_is_its_centre_line_in_canvas_units():
    (line,) = read('<path d="M4 12H20" stroke="#000" stroke-width="2" stroke-linecap="round"/>')
    scale = 224 / 18
    assert line.width == pytest.approx(2 * scale, rel=0.005)
    assert line.points == pytest.approx(
        np.array([(128 - 8 * scale, 128), (128 + 8 * scale, 128)]), abs=0.3
    )
    assert not line.closed


def test_the_outline_of_a_stroke_is_that_stroke():
    """Many sets of line icons hold outlines alone."""
    (line,) = read('<path d="M4 11H20A1 1 0 0 1 20 13H4A1 1 0 0 1 4 11Z"/>')
    scale = 224 / 18
    assert line.width == pytest.approx(2 * scale, rel=0.01)
    ends = np.array([line.points[0], line.points[-1]])
    assert abs(ends[0] - ends[1]) == pytest.approx((16 * scale, 0), abs=0.5)


@pytest.mark.parametrize(
    "body",
    [
        '<g transform="rotate(30 12 12) scale(.5)"><path d="M9 9h12v9" {}/></g>',
        '<defs><path id="a" d="M4 4h12v9"/></defs><use href="#a" x="2" {}/>',
        '<style>.s{{fill:none;stroke:#000;stroke-width:2}}</style><path class="s" d="M4 4h12v9"/>',
        '<symbol id="a" viewBox="0 0 24 24"><path d="M4 4h12v9" {}/></symbol><use href="#a"/>',
        '<clipPath id="c"><path d="M0 0h24v24H0z"/></clipPath>'
        '<g clip-path="url(#c)"><path d="M4 4h12v9" {}/></g>',
    ],
)
def test_strokes_survive_where_they_are_written_in_other_ways(body):
    lines = read(body.format('fill="none" stroke="#000" stroke-width="2"'))
    assert kinds(lines) == ["stroke"]
    assert len(lines[0].points) == 3


def test_a_shape_with_fill_and_stroke_is_one_contour_of_both():
    lines = read('<circle cx="12" cy="12" r="6" stroke="#000" stroke-width="4"/>')
    assert kinds(lines) == ["contour"]
    radii = np.hypot(*(np.array(lines[0].points) - CANVAS / 2).T)
    assert radii == pytest.approx(112, abs=0.3)


def test_holes_run_the_other_way_round():
    lines = read('<path fill-rule="evenodd" d="M0 0h20v20H0zM5 5h10v10H5z"/>')
    outer, hole = (np.array(one.points) @ (1, 1j) for one in lines)

    def area(z):
        return (z.conj() * np.roll(z, -1)).imag.sum() / 2

    assert area(outer) == pytest.approx(224**2, rel=0.01)
    assert area(hole) == pytest.approx(-(112**2), rel=0.01)


def test_what_is_painted_over_is_no_ink():
    lines = read('<path d="M2 2h20v20H2z"/><circle cx="12" cy="12" r="5" fill="#fff"/>')
    assert kinds(lines) == ["contour", "contour"]
    lines = read(
        '<path d="M2 6H22" stroke="#000" stroke-width="2"/>'
        '<path d="M2 18H22" stroke="#000" stroke-width="2"/>'
        '<circle cx="12" cy="18" r="4" fill="#fff"/>'
    )
    assert sorted(kinds(lines)) == ["contour", "contour", "stroke"]  # only what is cut


def test_overlaps_are_removed():
    lines = read('<path d="M2 2h12v12H2z"/><path d="M8 8h14v14H8z"/>')
    assert kinds(lines) == ["contour"]


@pytest.mark.thorough
def test_dashes_are_lines_each():
    svg = document(
        '<path d="M2 12H22.5" stroke="#000" stroke-width="2" stroke-linecap="round" '
        'stroke-dasharray="0 5"/>'
    )
    frame, coverage = rasterise(svg)
    lines = lines_of(svg, frame, coverage)
    assert kinds(lines) == ["stroke"] * 5
    assert overlap(picture(lines), coverage > 127) > 0.97


def test_flat_ends_come_out_round_and_the_line_as_long():
    lines = read('<path d="M2 12H22" stroke="#000" stroke-width="4"/>')
    columns = np.flatnonzero(picture(lines).any(axis=0))
    assert (columns[0], columns[-1]) == (16, CANVAS - 17)


@pytest.mark.parametrize(
    "body",
    [
        '<mask id="m"><path fill="#fff" d="M0 0h12v24H0z"/></mask>'
        '<circle cx="12" cy="12" r="9" mask="url(#m)"/>',
        '<linearGradient id="g"><stop stop-color="#000"/><stop offset="1" stop-color="#222"/>'
        '</linearGradient><circle cx="12" cy="12" r="9" fill="url(#g)"/>',
        '<path d="M4 12h16" stroke="#000" stroke-width="2" marker-end="url(#m)"/>'
        '<marker id="m" viewBox="0 0 4 4" refX="2" refY="2"><path d="M0 0h4v4H0z"/></marker>',
    ],
)
def test_what_is_more_than_shapes_is_traced(body):
    svg = document(body)
    frame, coverage = rasterise(svg)
    assert own_lines(svg, frame, coverage) is None
    lines = lines_of(svg, frame, coverage)
    assert set(kinds(lines)) == {"contour"}
    assert overlap(picture(lines), coverage > 127) > 0.97


def test_a_stroke_that_is_clipped_is_an_area():
    lines = read(
        '<clipPath id="c"><circle cx="12" cy="12" r="9"/></clipPath>'
        '<path d="M0 12H24" stroke="#000" stroke-width="4" clip-path="url(#c)"/>'
    )
    assert kinds(lines) == ["contour"]


def test_a_coloured_drawing_has_the_lines_of_its_pictogram():
    icon = own_svg(
        document(
            '<circle cx="12" cy="12" r="10" fill="#ffcc4d"/>'
            '<path d="M8 9v3M16 9v3M7 16h10" stroke="#664500" stroke-width="2"/>'
        ).encode(),
        "face.svg",
    )
    frame, coverage = rasterise(icon.svg)
    lines = lines_of(icon.svg, frame, coverage)
    assert overlap(picture(lines), coverage > 127) > 0.97


def test_what_has_no_lines_is_refused_in_a_sentence():
    svg = document('<path d="M2 2h.002v.002h-.002z"/><path fill="#fff" d="M0 0h9v9H0z"/>')
    with pytest.raises(IconstudioError, match=r"no dark ink: .*Fill its shapes"):
        lines_of(svg, *rasterise(svg))
    nothing = np.zeros((CANVAS, CANVAS), np.uint8)
    with pytest.raises(IconstudioError, match=r"no lines: .*Draw something larger"):
        lines_of(svg, Frame(0, 0, 24), nothing)


def extent(lines):
    """Return left, top, right, bottom of points."""
    points = np.concatenate([one.points for one in lines])
    return np.concatenate([points.min(axis=0), points.max(axis=0)])


@pytest.mark.parametrize("own", [False, True])
@pytest.mark.parametrize(
    "body",
    [
        '<circle cx="6" cy="10" r="2" stroke="#000" fill="none" stroke-width="2"/>',
        '<linearGradient id="g"><stop stop-color="#000"/><stop offset="1" stop-color="#222"/>'
        '</linearGradient><circle cx="6" cy="10" r="2" fill="url(#g)"/>',
    ],
)
def test_a_small_icon_of_a_set_stays_small_and_where_it_is(body, own):
    svg = document(body)
    lines = lines_on_page(own_svg(svg.encode(), "dot.svg").svg if own else svg)
    found, unit = extent(lines), CANVAS / 24
    assert found == pytest.approx(np.array([4, 8, 8, 12]) * unit, abs=0.3)
    assert lines[0].width == pytest.approx(2 * unit if "stroke-width" in body else 0)


def test_a_page_that_is_not_square_lies_in_the_middle_of_the_canvas():
    svg = document('<path d="M0 0H20V10H0z"/>', "0 0 20 10")
    assert extent(lines_on_page(svg)) == pytest.approx([0, 64, CANVAS, 192], abs=0.1)


@pytest.mark.parametrize("box", ['viewBox="0 0 900 900"', ""])
def test_a_sketch_on_a_large_sheet_or_on_none_fills_the_canvas(box):
    svg = f'<svg xmlns="http://www.w3.org/2000/svg" {box}><path d="M9 9h60v30H9z"/></svg>'
    found = extent(lines_on_page(own_svg(svg.encode(), "corner.svg").svg))
    assert found == pytest.approx([16, 72, 240, 184], abs=1)


def test_what_is_too_thin_to_show_on_its_page_fills_the_canvas():
    svg = document('<path d="M10 10H110" stroke="#000" stroke-width=".7"/>', "0 0 900 900")
    thin = own_svg(svg.encode(), "thin.svg").svg
    assert extent(lines_on_page(thin))[[0, 2]] == pytest.approx([16, 240], abs=6)


SHAPE = st.sampled_from(
    [
        "M3 3h9v9H3z", "M4 4L20 20", "M12 4v.01", "M5 5a6 6 0 1 0 12 0a6 6 0 1 0-12 0",
        "M2 20C8 2 16 2 22 20", "M6 6l12 12M18 6L6 18", "M12 12",
    ]
)  # fmt: skip
PAINT = st.sampled_from(["#000", "#fff", "none"])


@pytest.mark.thorough
@settings(max_examples=60)
@given(
    st.lists(
        st.tuples(SHAPE, PAINT, PAINT, st.sampled_from(["butt", "round", "square"])),
        min_size=1,
        max_size=4,
    )
)
def test_any_shapes_one_over_the_other_look_the_same(shapes):
    svg = document(
        "".join(
            f'<path d="{d}" fill="{fill}" stroke="{stroke}" stroke-width="2" '
            f'stroke-linecap="{cap}" stroke-linejoin="round"/>'
            for d, fill, stroke, cap in shapes
        )
    )
    try:
        frame, coverage = rasterise(svg)
    except IconstudioError:
        return
    lines = lines_of(svg, frame, coverage)
    assert all(isinstance(one, Line) and np.isfinite(one.points).all() for one in lines)
    if (coverage > 127).sum() > 1000:  # of a hairline, a shade decides which pixels count
        # Ends that were flat or square are round.
        assert overlap(picture(lines), coverage > 127) > 0.9
