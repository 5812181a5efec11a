"""Samples of line styles are kept from one start to the next."""

from dataclasses import replace

import pytest

from iconstudio.caches.samples import SampleCache
from iconstudio.inputs.styles import named
from iconstudio.model import Path
from tests.shapes import outline

INK = named("Ink")
SQUARE = outline([(1.25, 2), (9, 2), (9, 9), (1.25, 9)])


@pytest.mark.parametrize("sample", [SQUARE, Path()])
def test_a_sample_is_found_by_the_content_of_its_style(tmp_path, sample):
    SampleCache(tmp_path).write(INK, sample)
    kept = SampleCache(tmp_path)
    found = kept.read(INK)
    assert bool(found) == bool(sample)
    assert found.area == sample.area
    assert kept.read(replace(INK, pairs=INK.pairs[:1])) is None
    assert kept.read(named("Loops")) is None


def test_a_damaged_sample_is_drawn_anew(tmp_path):
    cache = SampleCache(tmp_path)
    cache.write(INK, SQUARE)
    (file,) = (one for one in tmp_path.rglob("*") if one.is_file())
    file.write_bytes(file.read_bytes()[:-3])
    assert SampleCache(tmp_path).read(INK) is None
