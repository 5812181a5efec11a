import errno
import os
import subprocess
import sys
import time
from concurrent.futures import CancelledError
from pathlib import Path

import numpy as np
import pytest

from iconstudio.caches import rasters, store
from iconstudio.caches.rasters import RasterCache, draw_entries
from iconstudio.files import reason_of
from iconstudio.model import Credit, IconstudioError, Pictogram
from iconstudio.svg.rasterise import rasterise
from iconstudio.workers import Workers

CREDIT = Credit("shape", "A. Artist", "MIT", "https://example.org/mit", "https://example.org")


def pictogram(name, body=None):
    if body is None:
        body = f'<path d="M1 1h{2 + len(name)}v9H1z"/>'
    svg = f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 24 24">{body}</svg>'
    return Pictogram(f"test:{name}", svg, CREDIT)


GOOD = [pictogram("a" * i, f'<path d="M1 1h{i + 3}v9H1z"/>') for i in range(1, 12)]
EMPTY, DEEP = pictogram("empty", ""), pictogram("deep", "<g>" * 300 + "</g>" * 300)


def perilous_entries(documents):
    """Draw, but crash and hang on request, as a renderer might."""
    for svg in documents:
        if "crash" in svg:
            os._exit(1)
        if "hang" in svg:
            time.sleep(600)
        if "greedy" in svg:
            raise MemoryError
        if "bug" in svg:
            raise ZeroDivisionError
    return draw_entries(documents)


class NoWorkers:
    count = 1

    def submit(self, *_args, **_options):
        raise AssertionError("all should come from the cache")


@pytest.fixture
def cache(tmp_path, workers):
    return RasterCache(tmp_path / "rasters", workers)


def drawn(cache, pictograms):
    """Return the exemplars or errors in the pictograms' order; each comes exactly once."""
    pairs = list(cache.exemplars(pictograms))
    assert sorted(index for index, _ in pairs) == list(range(len(pictograms)))
    return [found for _, found in sorted(pairs, key=lambda pair: pair[0])]


def assert_drawn(found, pictogram):
    frame, coverage = rasterise(pictogram.svg)
    assert found.pictogram is pictogram
    assert found.frame == frame
    np.testing.assert_array_equal(found.coverage, coverage)
    assert not found.coverage.flags.writeable


def files(folder):
    return sorted(path for path in folder.rglob("*") if path.is_file())


def test_what_was_drawn_once_comes_from_the_disk(cache, tmp_path):
    for found, one in zip(drawn(cache, GOOD), GOOD, strict=True):
        assert_drawn(found, one)
    assert len(files(tmp_path)) == len(GOOD)
    again = drawn(RasterCache(tmp_path / "rasters", NoWorkers()), GOOD)
    for found, one in zip(again, GOOD, strict=True):
        assert_drawn(found, one)
    assert cache.trouble is None


def test_it_is_the_content_that_counts(cache, tmp_path):
    first, copy = GOOD[0], Pictogram("other:name", GOOD[0].svg, CREDIT)
    drawn(cache, [first])
    (found,) = drawn(RasterCache(tmp_path / "rasters", NoWorkers()), [copy])
    assert found.id == "other:name"


@pytest.mark.parametrize("name", ["FORMAT", "VERSION"])
def test_another_version_does_not_read_these_files(cache, tmp_path, monkeypatch, name):
    drawn(cache, GOOD[:1])
    monkeypatch.setattr(rasters, name, "another")
    with pytest.raises(AssertionError, match="from the cache"):
        drawn(RasterCache(tmp_path / "rasters", NoWorkers()), GOOD[:1])


def test_refusals_are_kept_as_well(cache, tmp_path):
    for one in (cache, RasterCache(tmp_path / "rasters", NoWorkers())):
        empty, deep = drawn(one, [EMPTY, DEEP])
        assert isinstance(empty, IconstudioError)
        assert str(empty).startswith("test:empty cannot be used. It has no dark ink")
        assert "deep" in str(deep)


def test_what_is_cached_comes_first(cache):
    drawn(cache, GOOD[5:7])
    order = [index for index, _ in cache.exemplars(GOOD[:8])]
    assert order[:2] == [5, 6]


def test_broken_files_are_made_again(cache, tmp_path):
    drawn(cache, [*GOOD[:1], EMPTY])
    whole = {path: path.read_bytes() for path in files(tmp_path)}
    for path, data in whole.items():
        middle = len(data) // 2
        damaged = [data[:length] for length in (0, 1, 2, 3, middle, len(data) - 4, len(data) - 1)]
        damaged += [b"\0" * len(data), data[:middle] + b"?" + data[middle + 1 :], b"<html>"]
        for bad in damaged:
            path.write_bytes(bad)
            exemplar, refusal = drawn(cache, [*GOOD[:1], EMPTY])
            assert_drawn(exemplar, GOOD[0])
            assert isinstance(refusal, IconstudioError)
            assert path.read_bytes() == data


@pytest.mark.parametrize("above", [False, True], ids=["file", "folder"])
def test_what_stands_in_the_way_is_removed(cache, tmp_path, caplog, above):
    drawn(cache, GOOD[:1])
    (path,) = files(tmp_path)
    path.unlink()
    if above:
        path.parent.rmdir()
        path.parent.touch()
    else:
        (path / "something").mkdir(parents=True)
    assert_drawn(*drawn(cache, GOOD[:1]), GOOD[0])
    assert cache.trouble is None
    assert files(tmp_path) == [path]
    assert len(caplog.records) == 1


def test_damage_is_told_once_in_the_log(cache, tmp_path, caplog):
    drawn(cache, GOOD)
    assert not caplog.records
    for path in files(tmp_path):
        path.write_bytes(b"")
    drawn(cache, GOOD)
    (record,) = caplog.records
    assert "made anew" in record.getMessage()
    drawn(cache, GOOD)
    assert len(caplog.records) == 1


def test_a_folder_that_cannot_be_written(tmp_path, workers):
    (tmp_path / "rasters").write_text("a file where the folder should be")
    cache = RasterCache(tmp_path / "rasters", workers)
    for found, one in zip(drawn(cache, GOOD[:3]), GOOD[:3], strict=True):
        assert_drawn(found, one)
    assert str(tmp_path / "rasters") in cache.trouble


@pytest.mark.parametrize("reason", [errno.ENOSPC, errno.EACCES, errno.EROFS])
def test_a_folder_that_lets_nothing_in(cache, tmp_path, monkeypatch, reason):
    def full(path, data):
        raise OSError(reason, os.strerror(reason))

    monkeypatch.setattr(store, "write_atomically", full)
    for found, one in zip(drawn(cache, GOOD[:3]), GOOD[:3], strict=True):
        assert_drawn(found, one)
    assert reason_of(OSError(reason, "")) in cache.trouble
    assert not files(tmp_path)


@pytest.mark.thorough
def test_a_crash_a_hang_and_greed_lose_only_the_culprit(cache, tmp_path, monkeypatch):
    monkeypatch.setattr(rasters, "draw_entries", perilous_entries)
    monkeypatch.setattr(rasters, "_CHUNK_SECONDS", 1.0)
    monkeypatch.setattr(rasters, "_ONE_SECONDS", 0.5)
    kinds = ("crash", "hang", "greedy")
    culprits = [pictogram(kind, f"<title>{kind}</title>") for kind in kinds]
    mixed = [*GOOD[:2], culprits[0], *GOOD[2:8], culprits[1], *GOOD[8:], culprits[2]]
    found = dict(zip((one.id for one in mixed), drawn(cache, mixed), strict=True))
    for one in GOOD:
        assert_drawn(found[one.id], one)
    for kind, word in zip(kinds, ("crashes", "too long", "memory"), strict=True):
        assert isinstance(found[f"test:{kind}"], IconstudioError)
        assert word in str(found[f"test:{kind}"])
    # They are not tried again in this run, but in the next.
    monkeypatch.setattr(cache, "_workers", NoWorkers())
    assert all(isinstance(one, IconstudioError) for one in drawn(cache, culprits))
    assert len(files(tmp_path)) == len(GOOD)


def test_a_mistake_of_the_program_is_not_hidden(cache, monkeypatch):
    monkeypatch.setattr(rasters, "draw_entries", perilous_entries)
    with pytest.raises(ZeroDivisionError):
        drawn(cache, [pictogram("bug", "<title>bug</title>")])


@pytest.mark.thorough
@pytest.mark.skipif(not sys.platform.startswith("linux"), reason="no other limits address space")
def test_a_document_that_eats_all_memory_loses_only_itself(cache, monkeypatch, capfd):
    monkeypatch.setattr(rasters, "_MEMORY", 100 << 20)
    monkeypatch.setattr(rasters, "_CHUNK_SECONDS", 100.0)
    monkeypatch.setattr(rasters, "_ONE_SECONDS", 100.0)
    shape = "<g>" + '<path d="M0 0h1v1z"/>' * 5000 + "</g>"
    dots = f'<path d="M0 0{"h1" * 100_000}" marker-mid="url(#m)"/>'
    eater = pictogram("eater", f'<marker id="m">{shape}</marker>{dots}')
    found, lost = drawn(cache, [GOOD[0], eater])
    assert_drawn(found, GOOD[0])
    assert "memory" in str(lost)
    assert capfd.readouterr().err == ""


def test_closing_the_generator_leaves_the_rest_undone(cache, tmp_path):
    exemplars = cache.exemplars(
        [pictogram(f"n{i}", f'<path d="M0 0h{i}v9z"/>') for i in range(200)]
    )
    next(exemplars)
    exemplars.close()
    assert_drawn(*drawn(cache, GOOD[:1]), GOOD[0])
    assert len(files(tmp_path)) == 2


OTHER = """
import sys
from pathlib import Path
from iconstudio.caches.rasters import RasterCache
from iconstudio.model import Exemplar
from iconstudio.workers import Workers
from tests.library.test_rasters import GOOD

if __name__ == "__main__":
    with Workers(1) as workers:
        for _ in range(3):
            for _, found in RasterCache(Path(sys.argv[1]), workers).exemplars(GOOD):
                assert isinstance(found, Exemplar)
            for path in Path(sys.argv[1]).rglob("*"):
                if path.is_file():
                    path.unlink(missing_ok=True)
"""


def test_two_processes_use_one_folder(tmp_path):
    """Both write and delete the same files at the same time."""
    script = tmp_path / "other.py"
    script.write_text(OTHER)
    root = str(Path(__file__).parents[2])
    both = [
        subprocess.Popen(
            [sys.executable, str(script), str(tmp_path / "rasters")],
            env=os.environ | {"PYTHONPATH": root},
            stderr=subprocess.PIPE,
        )
        for _ in range(2)
    ]
    for process in both:
        _, errors = process.communicate(timeout=120)
        assert (process.returncode, errors) == (0, b"")


def test_workers_closed_meanwhile_end_the_work(tmp_path):
    workers = Workers(1)
    exemplars = RasterCache(tmp_path / "rasters", workers).exemplars(GOOD * 20)
    next(exemplars)
    workers.close()
    with pytest.raises(CancelledError):
        list(exemplars)
