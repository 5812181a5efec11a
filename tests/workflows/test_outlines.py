"""What of an outline lies at a place, against a slow and obvious measure."""

import math
from itertools import pairwise

from hypothesis import given, settings
from hypothesis import strategies as st
from shapely import LineString
from shapely import Point as Spot

from iconstudio.model import Polygon, Sketch
from iconstudio.workflows.modelling.page import SketchPage
from iconstudio.workflows.outline import Outline

places = st.tuples(st.integers(-20, 60), st.integers(-20, 60)).map(lambda p: (p[0] / 2, p[1] / 2))


class Paper:
    def __init__(self, vertices, closed):
        self.page = SketchPage(Sketch(Polygon(vertices), ""), closed)


@settings(max_examples=60)
@given(st.lists(places, max_size=6).map(tuple), st.booleans(), places)
def test_the_nearest_vertex_in_reach_is_hit_or_else_the_nearest_edge(vertices, closed, place):
    hit = Outline(Paper(vertices, closed)).hit(place, 3.0, 2.0)
    gaps = [math.dist(place, one) for one in vertices]
    ends = (*vertices, vertices[0]) if closed and vertices else vertices
    edges = [LineString(pair).distance(Spot(place)) for pair in pairwise(ends)]
    if gaps and min(gaps) <= 3:
        assert (hit.kind, hit.point) == ("vertex", vertices[hit.index])
        assert gaps[hit.index] == min(gaps)
    elif edges and min(edges) <= 2:
        assert hit.kind == "edge" and math.isclose(edges[hit.index], min(edges), abs_tol=1e-9)
        assert math.isclose(math.dist(place, hit.point), edges[hit.index], abs_tol=1e-9)
    else:
        assert hit is None
