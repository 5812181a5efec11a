"""Collections of a small world, built and opened."""

import json
from pathlib import Path

import pytest
from small_world import write_sets, write_wordnet

from iconstudio.building.builder import Inputs, build
from iconstudio.library.collection import Collection
from iconstudio.workers import Workers


@pytest.fixture(scope="session")
def workers():
    with Workers(1) as pool:
        yield pool


@pytest.fixture(scope="session")
def packages(tmp_path_factory):
    """WordNet and licences, unpacked."""
    folder = tmp_path_factory.mktemp("packages")
    write_wordnet(folder / "wordnet" / "dict")
    (folder / "spdx" / "licenses").mkdir(parents=True)
    for name in ("MIT", "CC-BY-4.0"):
        text = json.dumps({"licenseText": f"Full text of {name}"})
        (folder / "spdx" / "licenses" / f"{name}.json").write_text(text)
    return folder


@pytest.fixture
def make(tmp_path, packages, workers):
    """Return a function that builds a collection of sets into a new folder."""
    made = []

    def build_of(*sets: dict[str, object]) -> Path:
        folder = tmp_path / f"built{len(made)}"
        made.append(folder)
        iconify = write_sets(tmp_path / f"iconify{len(made)}", *sets)
        inputs = Inputs(iconify, packages / "wordnet", packages / "spdx")
        steps = list(build(inputs, folder, workers))
        assert [step.done for step in steps] == sorted(step.done for step in steps)
        assert steps[-1].done == 1
        return folder

    return build_of


@pytest.fixture
def opened(make, tmp_path):
    """Return a function that builds a collection of sets, and opens it."""
    collections = []

    def open_of(*sets: dict[str, object]) -> Collection:
        collections.append(Collection.open(make(*sets), tmp_path / "cache"))
        return collections[-1]

    yield open_of
    for collection in collections:
        collection.close()


@pytest.fixture(scope="session")
def bundled():
    """The collection that comes with the program."""
    with Collection.open() as collection:
        yield collection
