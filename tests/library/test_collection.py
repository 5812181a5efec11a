"""Opening a collection: whole, damaged, twice at once, on a full disk; and the bundled one."""

import json
import os
import subprocess
import sys
from collections import Counter
from concurrent.futures import ThreadPoolExecutor

import pytest
from small_world import icon_set, shape

from iconstudio.library import database
from iconstudio.library.archive import MANIFEST, Archive
from iconstudio.library.collection import Collection, cache_folder
from iconstudio.library.selection import LICENCES
from iconstudio.model import IconstudioError
from iconstudio.resources import resource


@pytest.fixture
def folder(make):
    return make(icon_set("a", {"dog": shape(1), "horse": shape(2), "bowl": shape(3)}))


def test_first_opening_shows_progress_and_later_ones_have_none(folder, tmp_path):
    cache = tmp_path / "cache"
    steps = list(Collection.opening(folder, cache))
    assert steps[0].done == 0 and steps[-1].done == 1
    assert [step.done for step in steps] == sorted(step.done for step in steps)
    assert list(Collection.opening(folder, cache)) == []
    assert len(list(cache.iterdir())) == 1


@pytest.mark.parametrize("name", [MANIFEST, "bodies.txt.xz", "index.json.xz", "shapes.bin.xz"])
@pytest.mark.parametrize("keep", [0, 20, -1])
def test_a_file_cut_short_says_to_reinstall(folder, tmp_path, name, keep):
    path = folder / name
    path.write_bytes(path.read_bytes()[:keep])
    if name == MANIFEST and keep == -1:
        assert json.loads(path.read_text())  # only the line end is gone
        return
    with pytest.raises(IconstudioError, match=r"cut short.*Reinstall"):
        Collection.open(folder, tmp_path / "cache")
    assert list((tmp_path / "cache").glob("*")) == []


def test_a_missing_file_says_to_reinstall(folder, tmp_path):
    (folder / "bodies.txt.xz").unlink()
    with pytest.raises(IconstudioError, match=r"bodies\.txt\.xz.*Reinstall"):
        Collection.open(folder, tmp_path / "cache")
    assert list((tmp_path / "cache").glob("*")) == []


@pytest.mark.parametrize("keep", [0, 50, 5000])
def test_an_unpacked_file_cut_short_is_unpacked_again(folder, tmp_path, keep):
    cache = tmp_path / "cache"
    Collection.open(folder, cache).close()
    (path,) = cache.iterdir()
    path.write_bytes(path.read_bytes()[:keep])
    with Collection.open(folder, cache) as collection:
        assert len(collection) == 3


def test_a_full_disk_is_said_and_nothing_is_left(folder, tmp_path, monkeypatch):
    monkeypatch.setattr(database, "_SCHEMA", "PRAGMA max_page_count = 3;" + database._SCHEMA)
    with pytest.raises(IconstudioError, match=r"The disk is full\. Make room"):
        Collection.open(folder, tmp_path / "cache")
    assert list((tmp_path / "cache").iterdir()) == []


def test_a_cache_that_cannot_be_written_is_named(folder, tmp_path):
    (tmp_path / "file").write_text("no folder")
    with pytest.raises(IconstudioError, match=r"cannot be unpacked into .*file"):
        Collection.open(folder, tmp_path / "file" / "cache")


def test_an_opening_given_up_leaves_nothing(folder, tmp_path):
    steps = Collection.opening(folder, tmp_path / "cache")
    next(steps)
    next(steps)
    steps.close()
    assert list((tmp_path / "cache").iterdir()) == []


def test_two_processes_may_unpack_at_once(folder, tmp_path):
    program = (
        "import sys, pathlib\n"
        "from iconstudio.library.collection import Collection\n"
        "sys.stdin.readline()\n"
        "with Collection.open(*map(pathlib.Path, sys.argv[1:])) as collection:\n"
        "    print([found.id for found in collection.search('dog')])\n"
    )
    command = [sys.executable, "-c", program, str(folder), str(tmp_path / "cache")]
    environment = {**os.environ, "PYTHONPATH": os.pathsep.join(filter(None, sys.path))}
    both = [
        subprocess.Popen(
            command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True, env=environment
        )
        for _ in range(2)
    ]
    for process in both:
        process.stdin.write("go\n")
        process.stdin.flush()
    assert [process.communicate(timeout=60)[0].strip() for process in both] == ["['a:dog']"] * 2
    assert len(list((tmp_path / "cache").iterdir())) == 1


def test_an_old_version_and_a_killed_opening_are_cleared_away(folder, tmp_path):
    cache = tmp_path / "cache"
    cache.mkdir()
    for name in ("collection-0123.sqlite", ".unpacking-x.sqlite", "collection-new.sqlite"):
        (cache / name).write_text("")
        if "new" not in name:
            os.utime(cache / name, (1, 1))
    (cache / "rasters").mkdir()
    Collection.open(folder, cache).close()
    names = {path.name for path in cache.iterdir()}
    assert {"rasters", "collection-new.sqlite"} < names and len(names) == 3


def test_the_cache_folder_can_be_named(monkeypatch, tmp_path):
    monkeypatch.setenv("ICONSTUDIO_CACHE", str(tmp_path))
    assert cache_folder() == tmp_path
    monkeypatch.delenv("ICONSTUDIO_CACHE")
    assert cache_folder().name == "iconstudio"


def test_threads_share_a_collection(folder, tmp_path):
    with Collection.open(folder, tmp_path / "cache") as collection, ThreadPoolExecutor(8) as pool:
        words = ["dog", "horse", "bowl"] * 50
        found = list(pool.map(lambda word: collection.search(word)[0].id, words))
    assert found == [f"a:{word}" for word in words]


def test_get_by_identifier(folder, tmp_path):
    with Collection.open(folder, tmp_path / "cache") as collection:
        assert collection.get("a:dog").id == "a:dog"
        with pytest.raises(IconstudioError, match=r"no icon 'a:dogg'\. Did you mean a:dog\?"):
            collection.get("a:dogg")
        with pytest.raises(IconstudioError, match="no icon 'x:dog'"):
            collection.get("x:dog")


def test_the_bundled_collection_is_large_small_and_free():
    folder = resource("collection")
    archive = Archive.at(folder)
    index = json.loads(archive.read("index.json.xz"))
    assert archive.icons == len(index["names"]) >= 100_000
    assert sum(path.stat().st_size for path in folder.iterdir()) <= 14_500_000
    assert {one["license"] for one in index["sets"]} <= LICENCES
    per_set = Counter(index["set_of"])
    credits = (folder / "CREDITS").read_text(encoding="utf-8")
    for number, one in enumerate(index["sets"]):
        entry = f"({one['prefix']}, {per_set[number]} icons)\n    Copyright (c) {one['author']}"
        assert entry in credits
    pairs = set(zip(index["set_of"], index["names"], strict=True))
    assert len(pairs) == archive.icons
