"""A window that is killed at any of twenty moments loses at most one edit."""

import random
import sys
from pathlib import Path

import pytest

sys.path.insert(0, str(Path(__file__).parents[1] / "gui"))

from fixtures import *  # noqa: F403
from test_crashes import check_a_kill, started  # noqa: F401


@pytest.mark.parametrize("number", range(20))
def test_a_kill(started, qtbot, number):  # noqa: F811
    check_a_kill(random.Random(100 + number).uniform(0.05, 3.0), started, qtbot)
