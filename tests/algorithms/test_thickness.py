"""Thin shapes and near neighbours: textures that are larger than there is room do not pinch."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from iconstudio.algorithms.curves.curve import Curve
from iconstudio.algorithms.curves.restyle import prepare, restyled
from iconstudio.algorithms.curves.thickness import held_back
from iconstudio.inputs.styles import named
from iconstudio.model import Line
from tests.line_styles import circle, rounded_square, unit


def wavy(plain, height, period=15.0):
    """A curve that goes so far to both sides of a plain one."""
    even = plain.resampled(0.5)
    along = plain.arc_at(even.parameters)
    ways = plain.at_arc(along + 0.1) - plain.at_arc(along - 0.1)
    count = round(plain.length / period)
    off = height * np.sin(2 * np.pi * count * along / plain.length)
    points = even.points + 1j * off * ways / abs(ways)
    return Curve(points, even.parameters, plain.end, plain.closed)


def heights(made, plain):
    return abs(made.points - plain.at(made.parameters))


def two_bars(gap):
    return [unit(np.array([20 + y * 1j, 236 + y * 1j])) for y in (100, 100 + gap)]


@settings(max_examples=25)
@given(st.floats(1, 40), st.floats(0.5, 12), st.sampled_from([0.0, 6.0]))
def test_between_parallel_lines_each_stays_in_its_half(gap, height, width):
    """A fixed part of half of what is free is the most that is taken, and else nothing changes."""
    plain = two_bars(gap + width)
    made = held_back(plain, [wavy(one, height) for one in plain], [width, width])
    for one, before in zip(made, plain, strict=True):
        assert heights(one, before).max() == pytest.approx(min(height, 0.5 * gap / 2), rel=0.02)


def test_where_there_is_room_nothing_changes():
    for plain in (circle(90.0), circle(12.0), rounded_square(radius=1.0)):
        styled = wavy(plain, 4.0)
        (made,) = held_back([plain], [styled], [0.0])
        assert np.array_equal(made.points, styled.points)


def test_strokes_that_overlap_or_meet_keep_their_texture():
    across, down = unit(np.array([20 + 100j, 236 + 100j])), unit(np.array([128 + 100j, 128 + 236j]))
    near = unit(np.array([20 + 112j, 236 + 112j]))
    styled = [wavy(one, 5.0) for one in (across, down, near)]
    made = held_back([across, down, near], styled, [20.0, 20.0, 20.0])
    for one, before in zip(made, styled, strict=True):
        assert np.array_equal(one.points, before.points)


def test_a_texture_that_goes_outwards_is_not_held_back_from_within():
    bar = unit(np.array([20 + 100j, 236 + 100j, 236 + 106j, 20 + 106j]), True)
    styled = wavy(bar, 6.0)
    out = styled.points - bar.at(styled.parameters)
    ways = bar.at(styled.parameters + 1e-4) - bar.at(styled.parameters - 1e-4)
    inwards = (ways.conj() * out).imag > 0
    bumps = Curve(np.where(inwards, bar.at(styled.parameters), styled.points), styled.parameters,
                  styled.end, True)  # fmt: skip
    (made,) = held_back([bar], [bumps], [0.0])
    far = ~inwards & (abs(out) > 1)
    assert np.median(heights(made, bar)[far] / abs(out)[far]) > 0.9


def test_texture_becomes_flatter_gradually():
    """Towards the thin middle of a bow tie; so it stays of one hand."""
    half = np.array([20 + 60j, 128 + 125j, 236 + 60j])
    bow = unit(np.append(half, half[::-1].conj() + 256j), True)
    styled = wavy(bow, 5.0)
    (made,) = held_back([bow], [styled], [0.0])
    off = abs(styled.points - bow.at(styled.parameters))
    kept = (heights(made, bow) / np.maximum(off, 1e-9))[off > 1.0]
    x = styled.points.real[off > 1.0]
    assert kept[abs(x - 128) < 4].max() < 0.6
    assert kept[(abs(x - 128) > 60) & (abs(x - 128) < 85)].min() > 0.9
    assert abs(np.diff(kept)).max() < 0.25


@pytest.mark.parametrize("name", ["Torn", "Shaky", "Castle", "Retraced"])
def test_thin_bars_are_not_pinched(name):
    """They kept only as much as is needed not to touch."""
    bars = [
        Line(((20, y), (236, y), (236, y + 7), (20, y + 7)), True) for y in (40.0, 120.0, 200.0)
    ]
    style = prepare(named(name))
    for made in restyled([(one, style) for one in bars], seed=2):
        points = np.array(made.points)
        inside = points[(points[:, 0] > 30) & (points[:, 0] < 226)]
        middle = (points[:, 1].min() + points[:, 1].max()) / 2
        upper, lower = inside[inside[:, 1] < middle], inside[inside[:, 1] > middle]
        gaps = np.hypot(*(upper[:, None] - lower[None]).transpose(2, 0, 1)).min(axis=1)
        assert gaps.min() > 2.5
