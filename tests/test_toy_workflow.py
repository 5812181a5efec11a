"""A workflow that is declared in one small file is at hand everywhere: see ``toy``."""

import json
import re
from dataclasses import replace
from pathlib import Path

import pytest

from iconstudio.cli.app import run
from iconstudio.svg.reading import own_svg
from iconstudio.workflows.registry import registered, workflows
from tests.toy import MIRROR

FEW_LINES = 60


class NoWindow:
    def obstacle(self):
        return "There is no window here."

    def open(self, example):
        raise AssertionError(example)


@pytest.fixture(autouse=True)
def toy():
    with registered(MIRROR):
        yield
    assert MIRROR not in workflows()


@pytest.fixture
def mirroring(tmp_path):
    path = tmp_path / "cat.json"
    path.write_text(json.dumps({"mirrored": ["mdi:cat", "mdi:coffee"]}))
    return path


def test_it_is_small():
    lines = (Path(__file__).parent / "toy.py").read_text("utf-8").splitlines()
    assert len(lines) < FEW_LINES


def test_the_command_line_knows_it(capsys):
    assert run(["--help"], NoWindow()) == 0
    assert re.search(r"mirror +Mirror icons, left to right\.", capsys.readouterr().out)
    assert run(["mirror", "--help"], NoWindow()) == 0
    told = capsys.readouterr().out
    assert "MIRROR.json" in told and "--fine" not in told


def test_its_command_makes_icons_with_their_credits(mirroring, tmp_path, capsys):
    out = tmp_path / "out"
    assert run(["mirror", str(mirroring), "--out", str(out)], NoWindow()) == 0
    assert "2 icons" in capsys.readouterr().out
    report = json.loads((out / "results.json").read_text("utf-8"))
    assert [one["credits"][0]["icon"] for one in report["results"]] == ["mdi:cat", "mdi:coffee"]
    assert set(report["timings"]) >= {"mirror", "total"} and "remix" not in report["timings"]
    assert set(report["files"]) == {
        "mirror-1.svg", "mirror-1.png", "mirror-2.svg", "mirror-2.png", "sheet.png",
    }  # fmt: skip
    saved = own_svg((out / "mirror-1.svg").read_bytes(), "mirror-1.svg")
    assert saved.credit.title.startswith("mirrored")
    assert [one.id for one in saved.origins] == ["mdi:cat"]


def test_a_workflow_without_a_workspace_declares_its_work():
    with pytest.raises(TypeError, match="it must declare `work`"):
        replace(MIRROR, work=None)


@pytest.mark.thorough
def test_its_command_tells_what_it_could_not_read(tmp_path, capsys):
    text = '<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 9 9"><path d="M1 1h5v5z"/>{}</svg>'
    (tmp_path / "own.svg").write_text(text.format('<foreignObject width="9" height="9"/>'))
    path = tmp_path / "own.json"
    path.write_text(json.dumps({"mirrored": ["own.svg"]}))
    assert run(["mirror", str(path), "--out", str(tmp_path / "out")], NoWindow()) == 0
    assert "“own.svg”: A part that only web pages show" in capsys.readouterr().err


def test_its_files_are_told_from_others(mirroring, tmp_path, capsys):
    out = str(tmp_path / "out")
    assert run(["model", str(mirroring), "--out", out], NoWindow()) == 2
    said = capsys.readouterr().err
    assert "looks like a mirror image" in said and "iconstudio mirror" in said
    montage = tmp_path / "montage.json"
    montage.write_text(json.dumps({"layers": []}))
    assert run(["mirror", str(montage), "--out", out], NoWindow()) == 2
    assert "this is no mirror image, but looks like a montage" in capsys.readouterr().err


def test_where_there_is_nothing_to_run_nothing_is_written(tmp_path, capsys):
    path = tmp_path / "nothing.json"
    path.write_text(json.dumps({"mirrored": []}))
    out = tmp_path / "out"
    assert run(["mirror", str(path), "--out", str(out)], NoWindow()) == 2
    said = "There is nothing to run: the mirror image in “nothing.json” is empty."
    assert said in capsys.readouterr().err
    assert not out.exists()
