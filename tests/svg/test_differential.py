"""Icons of the collection by the whole way in of files, and by the renderer alone."""

import random
from itertools import islice

import numpy as np
import pytest
from scipy.ndimage import binary_dilation

from iconstudio.algorithms.iconification.style import has_pale_areas
from iconstudio.library.collection import Collection
from iconstudio.svg.rasterise import rasterise
from iconstudio.svg.reading import own_svg
from tests.svg.pictures import overlap

SETS = ("lucide", "mdi", "tabler", "ph", "carbon", "fluent", "material-symbols", "solar", "bi",
        "game-icons")  # fmt: skip
EACH = 30


def compared(pictogram, alone):
    """How far the two ways agree; runs in a worker process."""
    read = own_svg(pictogram.svg.encode(), "icon.svg")
    _, drawn = rasterise(read.svg)
    return pictogram.id, overlap(drawn > 127, alone > 127), astray(drawn, alone), read.remarks


def astray(one, other):
    """Part of the ink of two pictures that is more than a pixel away from the other's."""
    inks = one > 127, other > 127
    wide = [binary_dilation(ink, np.ones((3, 3))) for ink in inks]
    lost = (inks[0] & ~wide[1]) | (inks[1] & ~wide[0])
    return lost.sum() / (inks[0] | inks[1]).sum()


def plain(pictograms):
    """Yield those that have no pale layer, which own files show as well, each with its picture."""
    for pictogram in pictograms:
        if "duotone" not in pictogram.id:
            _, alone = rasterise(pictogram.svg)
            if not has_pale_areas(alone):
                yield pictogram, alone


@pytest.fixture(scope="module")
def some():
    with Collection.open() as collection:
        chosen = []
        for name in SETS:
            rows = collection._rows("SELECT id FROM icon WHERE id GLOB ?", (f"{name}:*",))
            ids = sorted(row[0] for row in rows)
            random.Random(name).shuffle(ids)
            chosen += islice(plain(map(collection.get, ids)), EACH)
    return chosen


@pytest.mark.thorough
@pytest.mark.timeout(600)
def test_icons_of_ten_sets_look_as_the_renderer_draws_them(some, workers):
    found = [one.result() for one in [workers.submit(compared, *icon) for icon in some]]
    assert len(found) == EACH * len(SETS)
    assert not [one for one in found if one[3]]
    assert np.median([one[1] for one in found]) > 0.995
    # Lines of a pixel or two may lie a fraction of one beside each other.
    assert not [one for one in found if one[2] > 0.002]
