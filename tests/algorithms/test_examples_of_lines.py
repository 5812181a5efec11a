"""Pairs of a plain and a styled curve: which point is whose."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from hypothesis.extra.numpy import arrays

from iconstudio.algorithms.curves.example import Pair

POINTS = arrays(complex, 7, elements=st.sampled_from([0j, 1 + 0j, 3j, 2 + 2j]))


def test_with_as_many_points_the_nth_is_the_nths():
    plain = np.array([0, 10, 20, 30])
    styled = np.array([0, 10 + 50j, 20 + 50j, 30])
    pair = Pair.of(plain, styled)
    assert pair.styled.at(pair.plain.parameters) == pytest.approx(styled)


def test_with_others_it_is_the_one_as_far_along():
    pair = Pair.of(np.array([0, 30]), np.array([0, 100j, 100 + 100j]))
    assert pair.plain.at(np.array([0.25])) == pytest.approx([7.5])
    assert pair.styled.at(np.array([0.25])) == pytest.approx([50j])


@given(POINTS, POINTS, st.booleans())
@settings(max_examples=40)
def test_strokes_that_pause_are_as_good(plain, styled, closed):
    if len(set(plain.tolist())) < 2 or len(set(styled.tolist())) < 2:
        return
    pair = Pair.of(plain, styled, closed)
    for curve, points in ((pair.plain, plain), (pair.styled, styled)):
        assert (np.diff(curve.parameters) > 0).all()
        assert np.isfinite(curve.at_arc(np.linspace(-1, curve.length + 1, 9))).all()
        steps = abs(np.diff(np.append(points, points[:1]) if closed else points))
        assert curve.length == pytest.approx(steps.sum())
        assert curve.parameters[0] == 0
        assert closed or curve.parameters[-1] == 1
