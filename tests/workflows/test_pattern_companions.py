"""Motifs that keep the same company."""

import numpy as np

from iconstudio.workflows.pattern.companions import companies

SIDE = 96


def square(y, x, side=8):
    ink = np.zeros((SIDE, SIDE), bool)
    ink[y : y + side, x : x + side] = True
    return ink


def test_a_flower_and_its_leaves_belong_together():
    places = [(10, 10), (10, 20), (14, 60), (14, 70), (70, 30), (70, 40)]
    inks = [square(*place) for place in places]
    assert companies("flflfl", inks) == [[0, 1], [2, 3], [4, 5]]


def test_groups_of_other_kinds_are_chance():
    places = [(10, 10), (10, 20), (14, 60), (14, 70), (70, 30), (70, 40)]
    inks = [square(*place) for place in places]
    assert companies("abcdef", inks) == [[number] for number in range(6)]


def test_rows_are_no_groups():
    inks = [square(y, x) for y in (4, 28, 52) for x in (4, 20, 36, 52)]
    assert companies("catscatscats", inks) == [[number] for number in range(12)]


def test_what_lies_over_each_of_another_kind_goes_with_it():
    clouds = [square(y, x, 20) for y, x in ((4, 4), (4, 60), (60, 30))]
    planes = [square(y, x) for y, x in ((18, 18), (0, 58), (70, 46))]
    stars = [square(30, 10), square(36, 40)]
    groups = companies("cccpppss", [*clouds, *planes, *stars])
    assert groups == [[0, 3], [1, 4], [2, 5], [6], [7]]
    few = companies("cccpps", [*clouds, *planes[:2], stars[0]])  # one cloud has none
    assert few == [[number] for number in range(6)]


def test_one_motif_or_none_is_no_group():
    assert companies("", []) == []
    assert companies("a", [square(0, 0)]) == [[0]]
    assert companies("ab", [square(0, 0), square(4, 4)]) == [[0], [1]]
