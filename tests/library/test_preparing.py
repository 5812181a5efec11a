import os
from concurrent.futures import CancelledError

import numpy as np
import pytest

from iconstudio.algorithms.iconification import sliding
from iconstudio.algorithms.iconification.matching import SCALES, prepare
from iconstudio.caches import preparing
from iconstudio.caches.preparing import PreparingCache, prepared_entries
from iconstudio.workers import Workers
from tests.shapes import blob, exemplar

ICONS = [exemplar(blob(seed), f"blob-{seed}") for seed in range(20)]


class NoWorkers:
    count = 1

    def ticket(self):
        return Workers(1).ticket()

    def submit(self, *_args, **_options):
        raise AssertionError("all should come from the cache")


@pytest.fixture
def cache(tmp_path, workers):
    return PreparingCache(tmp_path / "prepared", workers)


def unworking(tmp_path):
    return PreparingCache(tmp_path / "prepared", NoWorkers())


def prepared(cache, icons, scales=SCALES):
    """Return what is prepared in the icons' order; each comes exactly once."""
    pairs = list(cache.prepared(icons, scales))
    assert sorted(index for index, _ in pairs) == list(range(len(icons)))
    return [found for _, found in sorted(pairs, key=lambda pair: pair[0])]


def assert_prepared(found, icon, scales=SCALES):
    expected = prepare(icon, scales)
    assert found.exemplar is icon
    assert (found.blackness, found.scales) == (expected.blackness, scales)
    for name in ("squared", "spectra"):
        ours, theirs = getattr(found, name), getattr(expected, name)
        assert ours.dtype == theirs.dtype
        np.testing.assert_array_equal(ours, theirs)


def files(folder):
    return sorted(path for path in folder.rglob("*") if path.is_file())


@pytest.mark.thorough
def test_what_was_prepared_once_comes_from_the_disk(cache, tmp_path):
    for found, icon in zip(prepared(cache, ICONS), ICONS, strict=True):
        assert_prepared(found, icon)
    assert len(files(tmp_path)) == len(ICONS)
    for found, icon in zip(prepared(unworking(tmp_path), ICONS), ICONS, strict=True):
        assert_prepared(found, icon)
    assert cache.trouble is None


@pytest.mark.parametrize("scales", [(1.0,), (0.5, 1.25), (1.5, 0.9, 1.0, 1.1)])
def test_other_scales_are_kept_apart(cache, tmp_path, scales):
    prepared(cache, ICONS[:1])
    for one in (cache, unworking(tmp_path)):
        assert_prepared(*prepared(one, ICONS[:1], scales), ICONS[0], scales)
    assert len(files(tmp_path)) == 2


@pytest.mark.parametrize(
    ("module", "name", "value"),
    [(preparing, "FORMAT", -1), (sliding, "REACH", 99), (sliding, "SHORTEST", 30)],
)
def test_another_version_does_not_read_these_files(
    cache, tmp_path, monkeypatch, module, name, value
):
    prepared(cache, ICONS[:1])
    monkeypatch.setattr(module, name, value)
    with pytest.raises(AssertionError, match="from the cache"):
        prepared(unworking(tmp_path), ICONS[:1])


def test_what_is_cached_comes_first(cache):
    prepared(cache, ICONS[5:7])
    assert [index for index, _ in cache.prepared(ICONS[:8], SCALES)][:2] == [5, 6]


def test_broken_files_are_made_again(cache, tmp_path):
    prepared(cache, ICONS[:1])
    (path,) = files(tmp_path)
    data = path.read_bytes()
    middle = len(data) // 2
    damaged = [data[:length] for length in (0, 1, 3, middle, len(data) - 1)]
    damaged += [b"\0" * len(data), data[:middle] + b"???" + data[middle + 3 :], b"<html>"]
    for bad in damaged:
        path.write_bytes(bad)
        assert_prepared(*prepared(cache, ICONS[:1]), ICONS[0])
        assert path.read_bytes() == data


def test_a_folder_that_cannot_be_written(cache, tmp_path):
    (tmp_path / "prepared").write_text("a file where the folder should be")
    assert_prepared(*prepared(cache, ICONS[:1]), ICONS[0])
    assert str(tmp_path / "prepared") in cache.trouble


def die_in_a_worker(exemplars, scales):
    if os.getpid() != TESTS:
        os._exit(1)
    return prepared_entries(exemplars, scales)


TESTS = int(os.environ.setdefault("PID_OF_THE_TESTS", str(os.getpid())))


@pytest.mark.thorough
def test_what_a_lost_process_should_have_prepared_is_prepared_here(cache, monkeypatch):
    monkeypatch.setattr(preparing, "prepared_entries", die_in_a_worker)
    for found, icon in zip(prepared(cache, ICONS[:9]), ICONS, strict=False):
        assert_prepared(found, icon)


@pytest.mark.thorough
def test_closing_the_generator_leaves_the_rest_undone(cache, tmp_path):
    begun = cache.prepared([exemplar(blob(seed)) for seed in range(100, 160)], SCALES)
    next(begun)
    begun.close()
    assert len(files(tmp_path)) == 1
    assert_prepared(*prepared(cache, ICONS[:1]), ICONS[0])


def test_workers_closed_meanwhile_end_the_work(tmp_path):
    workers = Workers(1)
    begun = PreparingCache(tmp_path / "prepared", workers).prepared(ICONS * 5, SCALES)
    next(begun)
    workers.close()
    with pytest.raises(CancelledError):
        list(begun)
