"""Modules that are loaded late, also while another thread loads parts of them."""

import shutil

import pytest

from iconstudio.loading import Libraries, load_module
from iconstudio.workflows.workflow import load_object


def test_a_library_that_another_thread_is_loading_is_tried_again(tmp_path, monkeypatch):
    """What Python shows of it for a moment is half of it."""
    source = "import pathlib\nat = pathlib.Path(__file__).with_name('tries')\n"
    source += "at.write_text(at.read_text() + 'x')\nif at.read_text() != 'x' * {}:\n"
    source += "    raise ImportError('half')\n"
    for name, tries in (("loaded_late", 2), ("used_late", 2), ("never_loaded", 9)):
        (tmp_path / name).mkdir()
        (tmp_path / name / "tries").write_text("")
        (tmp_path / name / "__init__.py").write_text(source.format(tries))
    monkeypatch.syspath_prepend(tmp_path)
    load_module("loaded_late")
    assert load_object("used_late:at").read_text() == "xx"
    with pytest.raises(ImportError, match="half"):
        load_module("never_loaded")


def test_what_is_not_there_is_not_waited_for(monkeypatch):
    monkeypatch.setattr("iconstudio.loading._PAUSE", float("nan"))
    with pytest.raises(ModuleNotFoundError):
        load_module("iconstudio.nothing_of_the_kind")


def test_what_is_compiled_is_read_before_it_is_loaded(tmp_path, monkeypatch):
    """With the libraries that its wheel brings along, and without importing it."""
    sizes = {"Heavy/part.so": 3_000_000, "Heavy/deep/part.pyd": 5, "heavy.libs/libblas.so.3": 70}
    for name, size in {**sizes, "Heavy/__init__.py": 1, "other/part.so": 9}.items():
        (tmp_path / name).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / name).write_bytes(bytes(size))  # no Python: importing it would fail
    monkeypatch.syspath_prepend(tmp_path)
    libraries = Libraries("Heavy", "nothing_of_the_kind")
    assert libraries.read() == sum(sizes.values())
    shutil.rmtree(tmp_path / "Heavy")
    assert libraries.read() == sum(sizes.values())  # once is enough
