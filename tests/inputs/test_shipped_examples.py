"""The examples that come with the program are listed by title, open, and can be worked on."""

from dataclasses import replace

import numpy as np
import pytest

from iconstudio.inputs.examples import examples
from iconstudio.reading import returned
from iconstudio.workflows.editing.file import read_edit
from iconstudio.workflows.editing.placing import place_edit
from iconstudio.workflows.files import read_file, write_file
from iconstudio.workflows.hybrids import hybrids
from iconstudio.workflows.hybrids.file import read_hybrids
from iconstudio.workflows.modelling.file import read_sketch
from iconstudio.workflows.montage import montage
from iconstudio.workflows.montage.file import read_montage
from iconstudio.workflows.registry import workflows


def listed(folder):
    return pytest.mark.parametrize("example", examples(folder), ids=lambda one: one.path.stem)


@pytest.mark.parametrize(
    ("folder", "least"), [("", 5), ("edits", 3), ("hybrids", 4), ("montages", 3)]
)
def test_there_are_some_of_every_kind_each_with_a_title_of_its_own(folder, least):
    titles = [one.title for one in examples(folder)]
    assert len(titles) >= least
    assert titles == sorted(set(titles))
    assert not set(titles) & {one.path.stem for one in examples(folder)}


@listed("")
def test_a_sketch_opens(example):
    file = read_sketch(example.path)
    assert file.title == example.title
    assert file.sketch.keyword
    file.sketch.polygon.fitted()


@pytest.mark.thorough(but=1)
@listed("edits")
def test_an_edit_changes_its_icon(example, session):
    file = read_edit(example.path)
    assert file.title == example.title
    edit = file.resolved(session.icon)
    assert edit.keyword
    change = place_edit(edit, session.exemplar(edit.icon))
    assert (change.mask < 1).any()


@listed("hybrids")
def test_icons_to_mix_are_there(example, session):
    file = read_hybrids(example.path)
    assert file.title == example.title
    mix = file.resolved(session.icon)
    hybrids.check(mix)
    assert all(session.exemplar(icon).ink.any() for icon in mix.icons)


@listed("montages")
def test_a_montage_keeps_something_of_every_icon(example, session):
    file = read_montage(example.path)
    assert file.title == example.title
    scribbles = montage.check(file.resolved(session.icon))
    assert all(one.any() for one in scribbles)


@pytest.mark.parametrize("workflow", workflows(), ids=lambda one: one.name)
def test_every_workflow_writes_what_it_reads(workflow, session, tmp_path):
    for number, example in enumerate(examples(workflow.examples)):
        work = returned(read_file(example.path, workflow, session))
        path = tmp_path / f"{number}.json"
        write_file(path, workflow, work)
        again = returned(read_file(path, workflow, session))
        if getattr(work, "image", None) is not None:  # photos are told from each other by identity
            assert np.array_equal(again.image.photo.levels[0], work.image.photo.levels[0])
            again = replace(again, image=replace(again.image, photo=work.image.photo))
        assert again == work
