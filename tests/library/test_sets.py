"""The icons of whole sets: of a collection, and of folders."""

import pytest
from small_world import icon_set, shape

from iconstudio.library import collection as module
from iconstudio.library.sets import is_folder, members
from iconstudio.model import IconstudioError

NAMES = ("dog", "cat", "bowl", "apple", "lamp")


@pytest.fixture
def collection(opened):
    one = icon_set("one", {name: shape(number) for number, name in enumerate(NAMES)})
    other = icon_set("one-more", {name: shape(9 + n) for n, name in enumerate(NAMES[:2])})
    return opened(one, other)


def test_a_set_of_the_collection(collection, monkeypatch):
    monkeypatch.setattr(module, "_PART", 2)
    found = members("one", collection)
    assert [one.id for one in found] == [f"one:{name}" for name in sorted(NAMES)]
    assert [one.name for one in found] == sorted(NAMES)
    assert [one.read() for one in found] == [collection.get(one.id) for one in found]
    assert len(members("one-more", collection)) == 2


def test_a_folder(collection, tmp_path, monkeypatch):
    folder = tmp_path / "one"
    (folder / "b").mkdir(parents=True)
    (folder / ".git").mkdir()
    for name in ("b/x.svg", "a.svg", "a.SVG", "c.txt", ".d.svg", ".git/e.svg"):
        (folder / name).write_text(name)
    found = members(str(folder), collection)
    assert [(one.id, one.name) for one in found] == [
        ("a.SVG", "a"),
        ("a.svg", "a"),
        ("b/x.svg", "b/x"),
    ]
    assert [one.read() for one in found] == [b"a.SVG", b"a.svg", b"b/x.svg"]
    assert is_folder(str(folder), collection)
    (folder / "b" / "x.svg").unlink()
    with pytest.raises(IconstudioError, match="no such file"):
        found[2].read()

    monkeypatch.chdir(tmp_path)  # a set of that name comes first
    assert not is_folder("one", collection) and is_folder("./one", collection)
    assert members("one", collection)[0].id == "one:apple"


@pytest.mark.parametrize("name", ["", "onne", "x:y", "one:dog", "no/such", "one*", "\0"])
def test_what_is_no_set(collection, name):
    with pytest.raises(IconstudioError, match="no set of icons"):
        members(name, collection)
