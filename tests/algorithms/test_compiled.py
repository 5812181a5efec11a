"""What was compiled is kept; what is damaged of it is thrown away and made anew, once."""

import os
import runpy
import shutil
import subprocess
import sys
from pathlib import Path

import pytest
from numba.core import config

ROOT = Path(__file__).parents[2]
PROGRAM = """
from iconstudio.algorithms.compiled import entry

@entry
def doubled(number):
    return 2 * number

print(doubled(21), doubled(1.5), sum(doubled.stats.cache_hits.values()))
"""


COMPILED, KEPT = ["42", "3.0", "0"], ["42", "3.0", "2"]


@pytest.fixture(scope="module")
def program(tmp_path_factory):
    """A program of compiled code."""
    path = tmp_path_factory.mktemp("program") / "program.py"
    path.write_text(PROGRAM)
    return path


def started(program, folder, **environment):
    """Run a program by itself: what it printed, and complained."""
    done = subprocess.run(
        [sys.executable, str(program)],
        env=os.environ | {"PYTHONPATH": str(ROOT), "NUMBA_CACHE_DIR": str(folder)} | environment,
        capture_output=True,
        text=True,
        timeout=120,
        check=True,
    )
    return done.stdout.split(), done.stderr


@pytest.fixture(scope="module")
def compiled(program, tmp_path_factory):
    """The folder with what its first run has compiled."""
    folder = tmp_path_factory.mktemp("compiled")
    assert started(program, folder) == (COMPILED, "")
    return folder


@pytest.fixture
def run(program, compiled, tmp_path, monkeypatch, capsys, caplog):
    """Return a function that runs the program again: what it printed, and complained.

    Not by itself, which takes a second: its functions are new ones, that know nothing but what is
    in the folder.
    """
    folder = shutil.copytree(compiled, tmp_path / "cache")
    monkeypatch.setenv("NUMBA_CACHE_DIR", str(folder))
    monkeypatch.setattr(config, "CACHE_DIR", str(folder))

    def go():
        caplog.clear()
        runpy.run_path(str(program))
        return capsys.readouterr().out.split(), caplog.messages

    return go


def files(tmp_path, kind):
    return sorted((tmp_path / "cache").rglob(f"*.{kind}"))


def test_what_is_compiled_is_kept(program, compiled):
    assert started(program, compiled) == (KEPT, "")
    assert len(list(compiled.rglob("*.nbi"))) == 1
    assert len(list(compiled.rglob("*.nbc"))) == 2


def empty(path, data):
    path.write_bytes(b"")


def cut_short(path, data):
    path.write_bytes(data[: len(data) // 2])


def flip_middle(path, data):
    middle = len(data) // 2
    path.write_bytes(data[:middle] + bytes([data[middle] ^ 4]) + data[middle + 1 :])


def a_folder(path, data):
    path.unlink()
    path.mkdir()
    (path / "something").touch()


@pytest.mark.parametrize("kind", ["nbi", "nbc"])
@pytest.mark.parametrize(
    "damage",
    [empty, cut_short, flip_middle, a_folder],
)
def test_what_is_damaged_is_made_anew_once(run, tmp_path, kind, damage):
    path = files(tmp_path, kind)[0]
    damage(path, path.read_bytes())
    (*values, hits), (said,) = run()
    assert [*values] == COMPILED[:2]
    assert int(hits) < 2
    assert f"thrown away and made anew: {path}" in said
    assert run() == (KEPT, [])


def test_a_missing_file_is_made_anew(run, tmp_path):
    files(tmp_path, "nbc")[0].unlink()
    assert run()[0][:2] == COMPILED[:2]
    assert run() == (KEPT, [])


def test_files_of_another_version_are_left_alone(run, tmp_path):
    (index,) = files(tmp_path, "nbi")
    old = index.with_name(index.name.replace(".sha256", ""))
    old.write_bytes(b"of another version")
    assert run() == (KEPT, [])
    assert old.exists()


def test_a_cache_that_cannot_be_written(program, tmp_path):
    file = tmp_path / "cache"
    file.write_text("a file where the folder should be")
    values, said = started(program, file, HOME=str(file), XDG_CACHE_HOME=str(file))
    assert values[:2] == COMPILED[:2]
    assert "Traceback" not in said


def test_a_full_disk(tmp_path):
    full = "\nimport builtins\nimport errno\nfrom numba.core import caching\n"
    full += "def no(*_): raise OSError(errno.ENOSPC, 'No space left on device')\n"
    full += "caching.IndexDataCacheFile._open_for_write = no\n"
    (tmp_path / "program.py").write_text(full + PROGRAM)
    values, said = started(tmp_path / "program.py", tmp_path / "cache")
    assert values == COMPILED
    assert "cannot be kept" in said
    assert "Traceback" not in said
