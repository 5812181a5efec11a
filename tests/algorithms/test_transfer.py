import numpy as np
from hypothesis import given
from hypothesis import strategies as st

from iconstudio.algorithms.iconification.warm_start import transferred
from iconstudio.model import Placement, Source
from tests.shapes import blob, exemplar

SHAPES = [exemplar(blob(k), f"shape{k}") for k in range(4)]


def source(shape: int, dx: int = 0, flip: bool = False) -> Source:
    return Source(SHAPES[shape], Placement(dx=dx, flip=flip))


def test_sources_that_stay_keep_what_they_own():
    labels = np.array([[0, 1], [2, 2]], np.uint8)
    before = [source(0), source(1, 5), source(1, 9)]
    now = [source(1, 9), source(3), source(0), source(1, 5)]
    moved = transferred(labels, before, now, np.zeros((4, 2, 2), np.float32))
    assert moved.tolist() == [[2, 3], [0, 0]]
    assert moved.dtype == np.uint8


def test_an_icon_that_moved_takes_its_place_nearest():
    labels = np.zeros((2, 2), np.uint8)
    now = [source(0, 40), source(0, 11, flip=True), source(0, 15), source(1, 10)]
    moved = transferred(labels, [source(0, 10)], now, np.zeros((4, 2, 2), np.float32))
    assert (moved == 2).all()
    flipped = transferred(labels, [source(0, 10)], now[1:2], np.zeros((1, 2, 2), np.float32))
    assert not flipped.any()


def test_what_is_gone_leaves_all_it_had_to_the_cheapest():
    labels = np.array([[0, 0, 0, 1]], np.uint8)
    data = np.array([[[5, 0, 5, 0]], [[2, 2, 2, 9]]], np.float32)
    now = [source(1), source(2)]
    assert transferred(labels, [source(0), source(1)], now, data).tolist() == [[1, 1, 1, 0]]


@given(st.integers(0, 2**32 - 1))
def test_renumbered_sources_show_the_same_picture(seed):
    rng = np.random.default_rng(seed)
    before = [source(k % 4, 3 * k, k > 3) for k in range(8)]
    order = rng.permutation(8)
    labels = rng.integers(0, 8, (6, 6)).astype(np.uint8)
    moved = transferred(labels, before, [before[k] for k in order], rng.random((8, 6, 6)))
    assert np.array_equal(order[moved], labels)
