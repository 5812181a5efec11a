"""Collections of a small world, built and opened: each once, for all tests that want the same."""

import json
import shutil
from contextlib import ExitStack
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


@pytest.fixture(scope="session")
def built(tmp_path_factory, packages, workers):
    """Return a function that builds a collection of sets; nobody writes into its folder."""
    made = {}

    def build_of(*sets: dict[str, object]) -> Path:
        key = json.dumps(sets)
        if key not in made:
            place = tmp_path_factory.mktemp("collection")
            inputs = Inputs(
                write_sets(place / "iconify", *sets), packages / "wordnet", packages / "spdx"
            )
            steps = list(build(inputs, place / "built", workers))
            assert [step.done for step in steps] == sorted(step.done for step in steps)
            assert steps[-1].done == 1
            made[key] = place / "built"
        return made[key]

    return build_of


@pytest.fixture
def make(built, tmp_path):
    """Return a function that gives a test a folder of its own with the collection of sets."""
    made = []

    def copy_of(*sets: dict[str, object]) -> Path:
        made.append(shutil.copytree(built(*sets), tmp_path / f"built{len(made)}"))
        return made[-1]

    return copy_of


@pytest.fixture(scope="session")
def opened(built, tmp_path_factory):
    """Return a function that opens the collection of sets."""
    with ExitStack() as closed_at_last:
        collections = {}

        def open_of(*sets: dict[str, object]) -> Collection:
            folder = built(*sets)
            if folder not in collections:
                cache = tmp_path_factory.mktemp("unpacked")
                collections[folder] = closed_at_last.enter_context(Collection.open(folder, cache))
            return collections[folder]

        yield open_of


@pytest.fixture(scope="session")
def bundled():
    """The collection that comes with the program."""
    with Collection.open() as collection:
        yield collection
