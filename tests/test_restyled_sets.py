"""Icons of ten sets, restyled: contours close, pieces and holes stay, none crosses."""

import random

import numpy as np
import pytest
import shapely

from iconstudio.algorithms.curves.outline import path_of
from iconstudio.algorithms.curves.restyle import prepare, restyled
from iconstudio.algorithms.flattening import flattened
from iconstudio.inputs.styles import named

pytestmark = pytest.mark.thorough(but=1)

SETS = {
    "lucide": "Shaky", "tabler": "Ink", "ph": "Clouds", "mdi": "Torn", "fa-solid": "Shaky",
    "bi": "Castle", "solar": "Nervous", "iconoir": "Wobbly", "material-symbols": "Fur",
    "carbon": "Waves",
}  # fmt: skip
EACH = 12


@pytest.mark.thorough
@pytest.mark.parametrize("name", SETS)
def test_icons_of_a_set_stay_what_they_are(session, name):
    style = prepare(named(SETS[name]))
    icons = random.Random(11).sample(sorted(session.collection.of_set(name), key=_id), EACH)
    changed, crossing = [], []
    for icon in icons:
        plain = session.lines(icon)
        made = restyled([(line, style) for line in plain], seed=1)
        path = path_of(made)
        assert all(contour.closed for contour in path.contours)
        pairs = [*zip(plain, made, strict=True)]
        assert all(after.closed or not before.closed for before, after in pairs)
        if _topology(path) != _topology(path_of(plain)):
            changed.append(icon.id)
        if any(_crosses(after) and not _crosses(before) for before, after in pairs):
            crossing.append(icon.id)
    assert not changed
    assert not crossing


def _id(icon):
    return icon.id


def _topology(path):
    """Return how many outer and inner contours a path has."""
    areas = [_area(points) for points, _ in flattened(path)]
    return sum(area > 0 for area in areas), sum(area < 0 for area in areas)


def _area(points):
    x, y = points.T
    return x @ np.roll(y, -1) - y @ np.roll(x, -1)


def _crosses(line):
    """Whether a contour crosses itself."""
    if line.width or not line.closed or np.ptp(np.array(line.points), axis=0).max() < 1:
        return False
    return not shapely.LinearRing(line.points).is_simple
