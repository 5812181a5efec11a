"""Where commands write: names that say what is in a file, links, folders that were used before."""

import json
import os
import re
import time

import pytest
from PIL import Image

from iconstudio.cli.app import run
from iconstudio.cli.rows import row
from iconstudio.model import IconstudioError
from iconstudio.output.folder import ResultsFolder

ICON = "mdi:lighthouse"
SVG = '<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 9 9"><path d="M0 0H9V9H0Z"/></svg>'


@pytest.mark.parametrize(
    "command", [["show", ICON, "--png"], ["search", "lighthouse", "--sheet"], ["gallery", "--out"]]
)
@pytest.mark.parametrize("name", ["dogs.pdf", "pic.jpg", "dogs", "dogs.png.svg", ".png"])
def test_another_ending_than_png_is_refused_before_any_work(tmp_path, capsys, command, name):
    assert run([*command, str(tmp_path / name)], None) == 2
    assert ".png”" in capsys.readouterr().err
    assert not list(tmp_path.iterdir())


@pytest.mark.skipif(os.name != "posix", reason="needs POSIX files")
@pytest.mark.timeout(120)
@pytest.mark.parametrize(
    "command", [["show", ICON, "--png"], ["search", "lighthouse", "--sheet"], ["gallery", "--out"]]
)
def test_pipes_and_folders_are_not_written(tmp_path, capsys, command):
    os.mkfifo(tmp_path / "pipe.png")
    (tmp_path / "folder.png").mkdir()
    for name in ("pipe.png", "folder.png"):
        assert run([*command, str(tmp_path / name)], None) == 2
        assert name in capsys.readouterr().err
    assert (tmp_path / "pipe.png").is_fifo()


@pytest.mark.skipif(os.name != "posix", reason="needs symbolic links")
def test_a_picture_is_written_through_a_link(tmp_path):
    (tmp_path / "far.png").write_bytes(b"old")
    (tmp_path / "near.PNG").symlink_to("far.png")
    assert run(["show", ICON, "--png", str(tmp_path / "near.PNG")], None) == 0
    assert (tmp_path / "near.PNG").is_symlink()
    with Image.open(tmp_path / "far.png") as picture:
        assert picture.format == "PNG"


@pytest.mark.parametrize("name", ["none.svgz", "./none", "folder/none", "none.png"])
def test_what_looks_like_a_path_is_a_missing_file(tmp_path, capsys, monkeypatch, name):
    monkeypatch.chdir(tmp_path)
    assert run(["show", name], None) == 2
    assert "no such file" in capsys.readouterr().err


def test_cells_stay_in_their_row():
    assert row("a", "b c", 'say "x"') == 'a\tb c\tsay "x"'
    cells = ["a\tb", "a\nb", '"a"', "\x1b[31m", "\udcff", "\u2028", "plain"]
    parts = row(*cells).split("\t")
    assert len(row(*cells).splitlines()) == 1
    assert [json.loads(part) if part[0] == '"' else part for part in parts] == cells
    assert row("\udcff").isascii()


@pytest.mark.skipif(os.name != "posix", reason="needs such names of files")
@pytest.mark.parametrize("name", ["a\tb", "a\nb"])
def test_names_of_files_break_no_rows(tmp_path, capsys, name):
    path = tmp_path / f"{name}.svg"
    path.write_text(SVG, "utf-8")
    assert run(["show", str(path)], None) == 0
    (line,) = capsys.readouterr().out.splitlines()
    assert len(line.split("\t")) == 3
    assert json.loads(line.split("\t")[0]).startswith(f"own:{name}")


# -- a folder that was used before ---------------------------------------------------------------


STEMS = r"sheet|hybrid-\d+"


def fill(path, *names, kind="hybrids"):
    folder = ResultsFolder(path, kind, STEMS)
    for name in names:
        folder.write({name: b"new"})
    folder.write_report({"results": []})


def there(path):
    return {one.name for one in path.iterdir()}


def test_a_second_run_removes_what_the_first_one_listed_and_nothing_else(tmp_path):
    fill(tmp_path, "hybrid-01.svg", "hybrid-02.svg", "sheet.png", "dark.npz")
    (tmp_path / "hybrid-x.svg").write_text("mine")
    fill(tmp_path, "hybrid-01.svg", "sheet.png")
    assert there(tmp_path) == {"hybrid-01.svg", "hybrid-x.svg", "sheet.png", "results.json"}
    fill(tmp_path)
    assert there(tmp_path) == {"hybrid-x.svg", "results.json"}


def test_results_of_another_workflow_are_refused_and_left(tmp_path):
    fill(tmp_path, "hybrid-01.svg", "sheet.png")
    before = {path.name: path.read_bytes() for path in tmp_path.iterdir()}
    with pytest.raises(IconstudioError, match=r"holds the results of “hybrids”\. Choose another"):
        fill(tmp_path, "montage.svg", kind="montage")
    assert {path.name: path.read_bytes() for path in tmp_path.iterdir()} == before


@pytest.mark.parametrize("name", ["hybrid-02.svg", "sheet.png"])
@pytest.mark.parametrize("earlier", [0, 3600, -3600])
def test_what_was_changed_since_is_in_the_way(tmp_path, name, earlier):
    fill(tmp_path, "hybrid-01.svg", "hybrid-02.svg", "sheet.png")
    (tmp_path / name).write_text("mine")
    when = time.time() - earlier
    os.utime(tmp_path / name, (when, when))
    with pytest.raises(IconstudioError, match=f"{re.escape(name)}” is there already"):
        fill(tmp_path, "hybrid-03.svg")
    assert (tmp_path / name).read_text() == "mine"


def test_what_was_removed_since_is_in_nobodys_way(tmp_path):
    fill(tmp_path, "hybrid-01.svg", "sheet.png")
    (tmp_path / "hybrid-01.svg").unlink()
    fill(tmp_path, "hybrid-01.svg")
    assert there(tmp_path) == {"hybrid-01.svg", "results.json"}


@pytest.mark.parametrize("name", ["hybrid-01.svg", "sheet.png"])
def test_a_file_of_a_users_own_is_never_replaced(tmp_path, name):
    fill(tmp_path, "hybrid-02.svg")
    (tmp_path / name).write_text("mine")
    with pytest.raises(IconstudioError, match="is there already"):
        ResultsFolder(tmp_path, "hybrids", STEMS)  # before any work
    with pytest.raises(IconstudioError, match="is there already"):
        fill(tmp_path, "hybrid-02.svg", name)
    assert (tmp_path / name).read_text() == "mine"


def test_a_run_that_was_stopped_can_be_run_again(tmp_path):
    fill(tmp_path, "hybrid-01.svg", "hybrid-02.svg")
    stopped = ResultsFolder(tmp_path, "hybrids", STEMS)
    stopped.write({"hybrid-03.svg": b"half"})
    report = json.loads((tmp_path / "results.json").read_text("utf-8"))
    assert not report["finished"] and "hybrid-03.svg" in report["files"]
    fill(tmp_path, "hybrid-03.svg")
    assert there(tmp_path) == {"hybrid-03.svg", "results.json"}
    assert (tmp_path / "hybrid-03.svg").read_bytes() == b"new"


def test_reports_of_earlier_versions_list_their_results(tmp_path):
    result = {"svg": "dark-1.svg", "png": "dark-1.png", "sources_png": "dark-1-sources.png"}
    for name in (*result.values(), "dark-2.svg"):
        (tmp_path / name).write_text("old")
    (tmp_path / "results.json").write_text(json.dumps({"results": [result]}), "utf-8")
    fill(tmp_path, "dark-1.svg")
    assert there(tmp_path) == {"dark-1.svg", "dark-2.svg", "results.json"}


FOREIGN = [{"files": [7]}, {"results": 7}, {"results": [7]}, {"a": 1}, [], "[" * 9999, "mine"]


@pytest.mark.parametrize("report", FOREIGN)
def test_a_report_that_is_none_of_ours_is_not_replaced(tmp_path, report):
    text = report if isinstance(report, str) else json.dumps(report)
    (tmp_path / "results.json").write_text(text, "utf-8")
    with pytest.raises(IconstudioError, match="is a file of yours"):
        fill(tmp_path, "new.svg")
    assert there(tmp_path) == {"results.json"}
    assert (tmp_path / "results.json").read_text("utf-8") == text


@pytest.mark.parametrize(
    "report",
    [
        {"files": ["../mine.svg", "sub/mine.svg", "mine.txt", "..", "", "folder.svg"]},
        {"files": "mine.svg"},
    ],
)
def test_what_no_run_of_ours_wrote_is_left_alone(tmp_path, report):
    out = tmp_path / "out"
    (out / "sub").mkdir(parents=True)
    (out / "folder.svg").mkdir()
    mine = [tmp_path / "mine.svg", out / "mine.svg", out / "sub" / "mine.svg", out / "mine.txt"]
    for path in mine:
        path.write_text("mine")
    (out / "results.json").write_text(json.dumps(report), "utf-8")
    fill(out, "new.svg")
    assert all(path.read_text() == "mine" for path in mine)
    assert (out / "folder.svg").is_dir()


@pytest.mark.thorough
def test_hybrids_of_a_second_run_stand_alone(tmp_path, capsys):
    file, out = tmp_path / "mix.json", tmp_path / "out"
    file.write_text(json.dumps({"icons": [ICON, "game-icons:lighthouse"]}), "utf-8")
    for draws in ("14", "3"):
        assert run(["hybrids", str(file), "--out", str(out), "--draws", draws], None) == 0
    report = json.loads((out / "results.json").read_text("utf-8"))
    assert {one.name for one in out.glob("*.svg")} == {one["svg"] for one in report["results"]}
    assert there(out) == {*report["files"], "results.json"}


@pytest.mark.parametrize(
    "command",
    [
        ["show", "in.png", "--png", "in.png"],
        ["restyle", "in.svg", "--style", "Castle", "--out", "in.svg"],
        ["restyle", ICON, "--style", "in.svg", "--out", "in.svg"],
        ["scribble", "--style", "in.svg", "--length", "50", "--out", "./in.svg"],
        ["pattern", "in.svg", "--out", "in.svg"],
        ["pattern", ICON, "--fill", "in.svg", "--out", "in.svg"],
        ["search", "lamp", "--exclude", "in.png", "--sheet", "in.png"],
    ],
)
def test_what_is_read_is_never_replaced(tmp_path, monkeypatch, capsys, command):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "in.svg").write_text(SVG, "utf-8")
    Image.new("L", (64, 64), 255).save(tmp_path / "in.png")
    before = {path.name: path.read_bytes() for path in tmp_path.iterdir()}
    assert run(command, None) == 2
    assert "is read, and what is made would replace it" in capsys.readouterr().err
    assert {path.name: path.read_bytes() for path in tmp_path.iterdir()} == before
