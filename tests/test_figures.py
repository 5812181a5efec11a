"""The figures of the documentation can be made again, and show what they should."""

from functools import cache

import numpy as np
import pytest
import shapely

from iconstudio.model import Frame, Line
from iconstudio.svg.resvg import render_coverage
from tests.figures.curves import FIGURES, Panel, document


@cache
def panels(name):
    return FIGURES[name]()


@pytest.mark.parametrize("name", sorted(FIGURES.keys() - {"styles"}))  # which takes long
def test_a_figure_shows_its_panels(name):
    rows = panels(name)
    assert document(rows).count("<path") >= sum(map(len, rows)) > 0


@pytest.mark.parametrize("widths", [(), (4.0, 12.0)])
def test_strokes_of_one_width_and_of_several_are_seen(widths):
    line = Line(((10.0, 40.0), (90.0, 40.0)), width=8.0, widths=widths)
    drawn = render_coverage(document([[Panel("", (line,))]]), Frame(0, 0, 160), 160)
    assert 300 < (drawn > 127).sum() < 1200


def test_the_handwriting_flows():
    """Parted at its tips, a word was jagged: each of its strokes was made by itself."""
    (_, (plain, styled)) = panels("figure-12")
    assert _turning(styled.lines[0]) < 1.5 * _turning(plain.lines[0])


def _turning(line):
    """Return by how much a line turns in all, between places three units apart."""
    drawn = shapely.LineString(line.points)
    places = shapely.line_interpolate_point(drawn, np.arange(0, drawn.length, 3.0))
    way = np.diff(shapely.get_coordinates(places) @ [1, 1j])
    return abs(np.angle(way[1:] * way[:-1].conj())).sum()
