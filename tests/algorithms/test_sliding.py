import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from hypothesis.extra.numpy import arrays

from iconstudio.algorithms.iconification import sliding
from iconstudio.algorithms.iconification.matching import FAR
from iconstudio.algorithms.iconification.sliding import SlidingWindow, Waves, spectra_of
from iconstudio.algorithms.iconification.tsdf import tsdf
from iconstudio.algorithms.raster import shifted
from iconstudio.model import CANVAS
from tests.shapes import blob


def direct(field, mask, exemplar, dx, dy):
    """Equation 4 as it is written."""
    moved = shifted(exemplar, dx, dy, field.shape[0], np.float32(0))
    return float((mask * (moved - field) ** 2).sum(dtype=float))


def numbers(n, low, high):
    return arrays(np.float32, (n, n), elements=st.floats(low, high, width=32))


@settings(max_examples=40)
@given(st.data())
def test_with_all_waves_the_errors_are_exact_at_every_translation(data):
    with pytest.MonkeyPatch.context() as patch:
        for name, value in (("CANVAS", 8), ("REACH", 5), ("STEP", 1), ("SHORTEST", 2)):
            patch.setattr(sliding, name, value)
        waves = Waves(12)
        assert waves.period % 2  # an even period would count its shortest wave twice
        field, mask = data.draw(numbers(8, -2, 2)), data.draw(numbers(8, 0, 1))
        shapes = np.stack([data.draw(numbers(12, -2, 2)) for _ in range(2)])
        errors = SlidingWindow(waves, field, mask).errors(spectra_of(waves, shapes))
        for one, row in zip(shapes, errors, strict=True):
            for flip in (False, True):
                for dy in range(-5, 6):
                    for dx in range(-5, 6):
                        shape = one[:, ::-1] if flip else one
                        there = row[int(flip), dy + 5, (-dx if flip else dx) + 5]
                        assert there == pytest.approx(direct(field, mask, shape, dx, dy), abs=2e-3)


def test_the_long_waves_are_enough_for_distance_fields():
    waves = Waves(CANVAS)
    mask = np.outer(np.hanning(CANVAS), np.hanning(CANVAS)).astype(np.float32)
    field, other = (tsdf(blob(seed)) - FAR for seed in (3, 4))
    errors = SlidingWindow(waves, field, mask).errors(spectra_of(waves, np.stack([field, other])))
    for one, row in zip((field, other), errors, strict=True):
        exact = np.array(
            [[direct(field, mask, one, dx, dy) for dx in waves.steps] for dy in waves.steps]
        )
        assert np.abs(row[0] - exact).max() < 0.002 * exact.max()
    assert waves.steps[0] == -sliding.REACH


def test_errors_do_not_depend_on_which_regions_came_before():
    waves = Waves(CANVAS)
    rng = np.random.default_rng(0)
    mask, shape = rng.random((2, CANVAS, CANVAS), dtype=np.float32)
    spectra = spectra_of(waves, shape[None])
    first = SlidingWindow(waves, shape, mask).errors(spectra)
    SlidingWindow(waves, mask, shape).errors(spectra)
    assert np.array_equal(first, SlidingWindow(waves, shape, mask).errors(spectra))
