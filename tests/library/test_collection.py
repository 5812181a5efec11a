"""Opening a collection: whole, damaged, twice at once, on a full disk; and the bundled one."""

import json
import os
import sqlite3
import subprocess
import sys
from collections import Counter
from concurrent.futures import ThreadPoolExecutor
from contextlib import closing
from functools import partial

import pytest
from small_world import icon_set, shape

from iconstudio.building.selection import LICENCES
from iconstudio.library import database
from iconstudio.library.archive import MANIFEST, Archive
from iconstudio.library.collection import Collection, cache_folder
from iconstudio.library.words import query
from iconstudio.model import IconstudioError
from iconstudio.resources import resource


@pytest.fixture
def folder(make):
    return make(icon_set("a", {"dog": shape(1), "horse": shape(2), "bowl": shape(3)}))


@pytest.mark.parametrize("index", [{}, {"a": []}, {"names": ["x", "ü"], "sets": {"y": [1, {}]}}])
def test_an_index_is_read_column_by_column(index):
    text = json.dumps(index, separators=(",", ":"), ensure_ascii=False)
    assert database._columns(text) == index


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


def flip(path, at):
    with path.open("r+b") as file:
        file.seek(at, os.SEEK_END if at < 0 else os.SEEK_SET)
        byte = file.read(1)[0]
        file.seek(-1, os.SEEK_CUR)
        file.write(bytes([byte ^ 0x55]))


def unpacked(folder, cache):
    Collection.open(folder, cache).close()
    (path,) = cache.iterdir()
    return path


def make_empty(path):
    path.write_bytes(b"")


def fill_with_zeros(path):
    path.write_bytes(bytes(path.stat().st_size))


def put_a_folder(path):
    path.unlink()
    path.mkdir()
    (path / "something").touch()


def put_a_broken_link(path):
    path.unlink()
    path.symlink_to("nowhere")


def put_another_database(path):
    path.unlink()
    with closing(sqlite3.connect(path)) as other:
        other.execute("CREATE TABLE icon (number)")


FLIPS = [partial(flip, at=at) for at in (0, 20, 45, 61, 110, 3000, 5000, 9000, 20000, -700, -1)]


@pytest.mark.parametrize(
    "damage",
    [make_empty, fill_with_zeros, put_a_folder, put_a_broken_link, put_another_database, *FLIPS],
)
def test_a_damaged_file_is_unpacked_again_once(folder, tmp_path, caplog, damage):
    cache = tmp_path / "cache"
    path = unpacked(folder, cache)
    whole = path.read_bytes()
    damage(path)
    for _ in range(2):
        with Collection.open(folder, cache) as collection:
            assert [found.id for found in collection.search("dog")] == ["a:dog"]
    assert path.read_bytes() == whole
    assert len(list(cache.iterdir())) == 1
    assert [record.getMessage() for record in caplog.records] == [
        f"The unpacked icon collection is damaged, and unpacked anew: {path}"
    ]


@pytest.mark.parametrize("method", ["search", "get", "keyword", "suggest"])
def test_damage_that_shows_only_in_use_is_mended(folder, tmp_path, caplog, method):
    path = unpacked(folder, tmp_path / "cache")
    asked = {"search": "dog", "get": "a:dog", "keyword": "dog", "suggest": "dogg"}[method]
    with Collection.open(folder, tmp_path / "cache") as collection:
        right = getattr(collection, method)(asked)
    before = path.stat()
    for page in range(3, before.st_size // 4096):
        with path.open("r+b") as file:
            file.seek(page * 4096)
            file.write(b"\xff" * 200)
    os.utime(path, ns=(before.st_atime_ns, before.st_mtime_ns))
    with Collection.open(folder, tmp_path / "cache") as collection:
        assert getattr(collection, method)(asked) == right
        assert getattr(collection, method)(asked) == right
    assert len(caplog.records) == 1


def test_an_error_that_is_no_damage_is_not_hidden(folder, tmp_path, monkeypatch):
    with Collection.open(folder, tmp_path / "cache") as collection:
        with monkeypatch.context() as patched, pytest.raises(ZeroDivisionError):
            patched.setattr(query, "plain", lambda keyword: 1 / 0)
            collection.search("dog")
        assert collection.search("dog")


def test_a_copy_is_checked_and_not_unpacked_again(folder, tmp_path, monkeypatch):
    path = unpacked(folder, tmp_path / "cache")
    os.utime(path, (1e9, 1e9))
    monkeypatch.setattr(database, "unpack", None)
    Collection.open(folder, tmp_path / "cache").close()
    monkeypatch.setattr(database, "_checksum", None)  # not read a second time
    Collection.open(folder, tmp_path / "cache").close()


@pytest.mark.skipif(os.name != "posix", reason="kills")
def test_what_a_killed_opening_leaves_is_removed_at_the_next(folder, tmp_path):
    program = (
        "import sys, pathlib, os, signal\n"
        "from iconstudio.library.collection import Collection\n"
        "steps = Collection.opening(*map(pathlib.Path, sys.argv[1:]))\n"
        "next(steps); next(steps); print('begun', flush=True); sys.stdin.readline()\n"
        "for _ in steps: pass\n"
    )
    command = [sys.executable, "-c", program, str(folder), str(tmp_path / "cache")]
    environment = {**os.environ, "PYTHONPATH": os.pathsep.join(filter(None, sys.path))}
    first, second = (
        subprocess.Popen(
            command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True, env=environment
        )
        for _ in range(2)
    )
    for process in (first, second):
        assert process.stdout.readline() == "begun\n"
    left = set((tmp_path / "cache").iterdir())
    assert len(left) == 2
    first.kill()
    first.communicate()
    database.remove_abandoned(tmp_path / "cache")
    (of_the_second,) = (tmp_path / "cache").iterdir()  # it goes on, undisturbed
    assert of_the_second in left
    second.communicate("go\n", timeout=60)
    assert second.returncode == 0
    (path,) = (tmp_path / "cache").iterdir()
    assert path.suffix == ".sqlite" and database.is_sound(path, thorough=True)
