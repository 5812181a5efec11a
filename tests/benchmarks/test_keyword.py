"""How soon the icons of a keyword are ready: retrieved, drawn and measured.

Run with ``pytest -n 0 tests/benchmarks/test_keyword.py --benchmark-only``. Medians.
"""

import shutil

import numpy as np
import pytest
from scipy import ndimage

from iconstudio.algorithms.iconification.matching import SCALES, padding
from iconstudio.algorithms.iconification.tsdf import D_MAX
from iconstudio.algorithms.raster import scaled_ink, solid
from iconstudio.model import CANVAS, Exemplar, IconstudioError
from iconstudio.session import Session
from iconstudio.svg.rasterise import rasterise

WORD = "house"
"""It retrieves as many icons as the paper's 200."""
OTHER = "otter"


@pytest.fixture(scope="module")
def cache(tmp_path_factory):
    """A cache folder with nothing but the unpacked collection."""
    folder = tmp_path_factory.mktemp("cache")
    with Session(folder) as session:
        assert len(session.search(WORD)) == 200
    return folder


class Opened:
    """A session that is open, its processes started, as when the user begins to type."""

    def __init__(self, cache):
        self.session = Session(cache)
        for steps in (self.session.get_ready(), self.session.prepare(OTHER)):
            self.drain(steps)

    def prepare(self):
        self.drain(self.session.prepare(WORD))

    @staticmethod
    def drain(steps):
        for _ in steps:
            pass


def empty(cache):
    """Leave the unpacked collection alone."""
    for made in cache.iterdir():
        if made.is_dir():
            shutil.rmtree(made)
        elif not made.name.startswith("collection-"):
            made.unlink()


def measured(benchmark, cache, rounds, cold):
    opened = []

    def setup():
        while opened:
            opened.pop().session.close()
        if cold:
            empty(cache)
        opened.append(Opened(cache))

    def close():
        opened.pop().session.close()

    benchmark.pedantic(lambda: opened[-1].prepare(), setup=setup, rounds=rounds)
    close()


@pytest.mark.benchmark(group="a keyword of 200 icons made ready")
def test_cold(benchmark, cache):
    measured(benchmark, cache, rounds=3, cold=True)


@pytest.mark.benchmark(group="a keyword of 200 icons made ready")
def test_from_cache(benchmark, cache):
    opened = Opened(cache)
    opened.prepare()
    opened.session.close()
    measured(benchmark, cache, rounds=5, cold=False)


@pytest.mark.benchmark(group="a keyword of 200 icons made ready")
def test_plainly(benchmark, cache):
    """One icon after the other, in one process, with whole distance transforms."""
    with Session(cache) as session:
        pictograms = session.search(WORD)
    pad = padding(SCALES)

    def distances(filled):
        both = ndimage.distance_transform_edt(~filled) - ndimage.distance_transform_edt(filled)
        return np.clip(both, -D_MAX, D_MAX) / CANVAS

    def plain():
        for pictogram in pictograms:
            try:
                exemplar = Exemplar(pictogram, *rasterise(pictogram.svg))
            except IconstudioError:
                continue
            for scale in SCALES:
                distances(solid(scaled_ink(exemplar.coverage, scale, pad)))

    benchmark.pedantic(plain, rounds=1)
