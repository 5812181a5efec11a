import numpy as np

from iconstudio.workflows.editing.opened import is_opened

YS, XS = np.mgrid[:256, :256] + 0.5
RING = abs(np.hypot(XS - 128, YS - 128) - 70) < 8
HANDLE = abs(np.hypot(XS - 205, YS - 128) - 20) < 6
DISC = np.hypot(XS - 128, YS - 128) < 60
NOTHING = np.zeros_like(RING)
LEFT_EAR = (XS < 90) & (YS < 90)


def test_a_ring_with_a_gap_is_open():
    assert is_opened(RING, LEFT_EAR, NOTHING)


def test_what_is_added_may_close_it():
    assert not is_opened(RING, LEFT_EAR, solid_bar())


def test_without_a_handle_a_mug_is_not_open():
    mug = RING | HANDLE
    assert not is_opened(mug, (XS > 206), NOTHING)
    assert not is_opened(DISC | HANDLE, (XS > 186), NOTHING)


def test_what_is_removed_whole_leaves_nothing_open():
    assert not is_opened(RING, np.ones_like(RING), NOTHING)
    assert not is_opened(DISC, LEFT_EAR, NOTHING)


def solid_bar():
    """A line across the gap."""
    return (abs(XS + YS - 150) < 12) & (abs(XS - YS) < 120)
