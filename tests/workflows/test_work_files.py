"""Files of work are told from each other: by the workflow that they name; older ones by fields."""

import json
from dataclasses import dataclass, replace

import pytest

from iconstudio.inputs.formats import Many, Reference
from iconstudio.model import Axis, Credit, IconstudioError, Mix, Pictogram
from iconstudio.workflows.files import likely_workflow, open_file, write_file
from iconstudio.workflows.hybrids.file import HybridsFile, read_hybrids
from iconstudio.workflows.hybrids.spec import HYBRIDS
from iconstudio.workflows.registry import registered, workflows
from iconstudio.workflows.workflow import File
from tests.toy import MIRROR


@dataclass(frozen=True)
class Pattern:
    icons: tuple[Pictogram, ...]


class PatternFile(File[Pattern], frozen=True):
    """Shares all its fields but one with those of hybrids."""

    icons: Many[Reference]
    seed: int = 0
    symmetry: Axis | None = None
    columns: int = 3

    @classmethod
    def of(cls, work, refer):
        return cls(tuple(map(refer, work.icons)))

    def resolved(self, find):
        return Pattern(tuple(map(find, self.icons)))


PATTERNS = replace(MIRROR, name="patterns", title="Patterns", noun="pattern", file=PatternFile)
ICONS = tuple(
    Pictogram(f"set:{name}", "<svg/>", Credit(name, "", "", "", "")) for name in ("cat", "dog")
)
OLD = {"icons": ["set:cat", "set:dog"], "seed": 4}


@pytest.fixture(autouse=True)
def patterns():
    with registered(PATTERNS):
        yield


@pytest.fixture
def path(tmp_path):
    return tmp_path / "work.json"


def write(path, data):
    path.write_text(json.dumps(data))
    return path


def test_two_formats_that_share_fields_are_told_by_the_name_of_the_workflow(path):
    write_file(path, HYBRIDS, Mix(ICONS, seed=4))
    written = json.loads(path.read_text())
    assert written == OLD | {"workflow": "hybrids"}
    assert likely_workflow(written, workflows()) is HYBRIDS
    assert read_hybrids(path).seed == 4
    with pytest.raises(IconstudioError, match=r"no pattern, but looks like a mix.*hybrids"):
        open_file(path, PatternFile)
    write_file(path, PATTERNS, Pattern(ICONS))
    assert likely_workflow(json.loads(path.read_text()), workflows()) is PATTERNS
    assert open_file(path, PatternFile).icons == ("set:cat", "set:dog")
    with pytest.raises(IconstudioError, match="no mix, but looks like a pattern"):
        read_hybrids(path)


def test_a_file_without_a_name_is_of_the_workflow_with_most_of_its_fields(path):
    assert likely_workflow(OLD | {"columns": 2}, workflows()) is PATTERNS
    assert likely_workflow(OLD | {"draws": 2}, workflows()) is HYBRIDS
    assert likely_workflow({"polygon": [], "keyword": "cat"}, workflows()).name == "model"


@pytest.mark.parametrize("kind", [HybridsFile, PatternFile])
def test_a_file_that_may_be_of_several_is_opened_as_the_user_says(kind, path):
    assert likely_workflow(OLD, workflows()) is None
    assert open_file(write(path, OLD), kind).seed == 4


def test_a_file_of_a_workflow_to_come_is_refused(path):
    write(path, OLD | {"workflow": "weaving"})
    with pytest.raises(IconstudioError, match="“weaving”, which this version does not know"):
        read_hybrids(path)


@pytest.mark.parametrize(
    ("name", "meant"),
    [
        ("Hybrids", "hybrids"),
        (" edit ", "edit"),
        ("editing", "edit"),
        ("Line style", "restyle"),
        ("sketch", "model"),
        ("montag", "montage"),
    ],
)
def test_the_name_of_a_workflow_that_is_nearly_right_is_proposed(name, meant, path):
    write(path, OLD | {"workflow": name})
    with pytest.raises(IconstudioError, match=f'Write "workflow": "{meant}" if you mean that.'):
        read_hybrids(path)


def test_the_name_of_a_workflow_is_a_text(path):
    with pytest.raises(IconstudioError, match="workflow"):
        read_hybrids(write(path, OLD | {"workflow": 5}))
