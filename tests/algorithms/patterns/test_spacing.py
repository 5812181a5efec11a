"""Elements that move apart."""

import numpy as np
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy import ndimage

from iconstudio.algorithms.patterns.spacing import spread

SIDE, DISC = 96, np.hypot(*np.ogrid[-6.5:7.5, -6.5:7.5]) < 6.5
NOTHING = np.zeros((SIDE, SIDE), bool)


def test_a_disc_goes_to_the_middle_of_its_gap():
    posts = NOTHING.copy()
    posts[:, :4] = posts[:, 44:48] = True  # 40 pixels between them
    (place,) = spread([DISC], np.array([(30, 6)]), posts, 20)
    assert place.tolist() == [30, 17]


def test_what_is_far_enough_stays():
    places = np.array([(10, 10), (10, 34), (34, 22)])
    assert (spread([DISC] * 3, places, NOTHING, 8) == places).all()


def test_groups_stay_where_elements_commonly_lie_that_close():
    places = np.array([(10, 10), (10, 26), (60, 50), (60, 66)])
    assert (spread([DISC] * 4, places, NOTHING, 1.5 * 2) == places).all()


def test_nothing_goes_where_it_is_not_allowed():
    places = np.array([(40, 30), (40, 44)])
    found = spread([DISC] * 2, places, NOTHING, 12, lambda number, _: number == 1)
    assert found[0].tolist() == [40, 30]
    assert found[1, 1] > 50


@given(st.integers(0, 10**6), st.integers(2, 12), st.floats(3, 16))
@settings(max_examples=20)
def test_no_gap_gets_narrower_and_borders_meet(seed, count, enough):
    random = np.random.default_rng(seed)
    cells = random.permutation(36)[:count]
    places = np.stack(np.divmod(cells, 6), axis=1) * 16 + random.integers(0, 2, (count, 2))
    before = _least(places)
    after = _least(spread([DISC] * count, places, NOTHING, enough))
    assert after >= min(before, enough) - 1e-9


def _least(places: np.ndarray) -> float:
    """Return the least distance between discs on a sheet whose borders meet, slowly."""
    least = np.inf
    for number, place in enumerate(places):
        rest = np.zeros((SIDE, SIDE), bool)
        for other in np.delete(places, number, axis=0):
            rest |= _drawn(other)
        away = ndimage.distance_transform_edt(~np.tile(rest, (3, 3)))
        own = np.tile(_drawn(place), (3, 3))
        middle = np.s_[SIDE : 2 * SIDE, SIDE : 2 * SIDE]
        least = min(least, away[middle][own[middle]].min())
    return float(least)


def _drawn(place: np.ndarray) -> np.ndarray:
    drawn = NOTHING.copy()
    drawn[np.ix_(*((begin + np.arange(len(DISC))) % SIDE for begin in place))] = DISC
    return drawn
