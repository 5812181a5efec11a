"""Charts: thin axes beside bars of any colour, and grids as pale as may be."""

import numpy as np
import pytest

from tests.algorithms.test_tone import ink, pictogram, rgba

PAPER = '<path d="M0 0h24v20H0z" fill="#fafafa"/>'
GRID = '<path d="M3 5h20M3 10h20" stroke="{}" stroke-width=".3" fill="none"/>'
AXES = '<path d="M2.5 1v16H23" fill="none" stroke="#333" stroke-width=".4"/>'
BARS = "M5 10h3v7H5z", "M10 6h3v11h-3z", "M15 3h3v14h-3z", "M20 8h2v9h-2z"
COLOURS = "steelblue", "steelblue", "tomato", "#ffb300"
CHART = AXES + "".join(
    f'<path d="{d}" fill="{fill}"/>' for d, fill in zip(BARS, COLOURS, strict=True)
)


def test_an_axis_is_whole_below_bars_of_all_colours():
    axis = ink('<path d="M2.5 17.1H23" stroke="#333" stroke-width=".15"/>') > 200
    assert pictogram(rgba(PAPER + CHART))[axis].min() > 127


@pytest.mark.thorough(but=1)
@pytest.mark.parametrize("colour", ["#ddd", "#e5e5e5", "#cfd8dc"])
def test_the_lines_of_a_pale_grid_stay_though_bars_stand_before_them(colour):
    grid = GRID.format(colour)
    lines = (ink(grid) > 200) & (ink(CHART) == 0)
    assert np.mean(pictogram(rgba(PAPER + grid + CHART))[lines] > 127) > 0.9
