"""Bad input of editing, hybrids, montage and single icons: a sentence each, and exit code 2."""

import json
import os

import pytest

from iconstudio.cli.app import run

ICON, OTHER = "mdi:lighthouse", "game-icons:lighthouse"
PART = [[100, 100], [150, 100], [150, 150], [100, 150]]
SVG = '<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 100 100">{}</svg>'
OWN = {
    "empty.svg": SVG.format(""),
    "nothing.svg": "",
    "pale.svg": SVG.format('<rect width="90" height="90" fill="none"/>'),
    "huge.svg": SVG.format(f'<path d="M0 0H9V9Z{"M1 1" * 600_000}"/>'),
    "hostile.svg": '<!DOCTYPE svg [<!ENTITY a SYSTEM "a.txt">]>' + SVG.format("<text>&a;</text>"),
    "script.svg": SVG.format("<script>alert(1)</script>"),
    "text.svg": "Hello",
}


def told(tmp_path, capsys, command, data, *options):
    """Run a command on what is no good; return what it says."""
    for name, svg in OWN.items():
        (tmp_path / name).write_text(svg, "utf-8")
    file = tmp_path / "input.json"
    file.write_text(data if isinstance(data, str) else json.dumps(data), "utf-8")
    code = run([command, str(file), "--out", str(tmp_path / "out"), *options], None)
    said = capsys.readouterr().err
    assert code == 2, said
    assert "Traceback" not in said
    assert not (tmp_path / "out" / "results.json").exists()
    return said


def edit(**fields):
    return {"icon": ICON, "keyword": "lighthouse", "remove": [PART]} | fields


@pytest.mark.thorough(but=1)
@pytest.mark.parametrize(
    ("data", "words"),
    [
        ("[1", "not valid JSON"),
        (edit(icon=None), '"icon" is missing'),
        (edit(icon="mdi:lighthose"), "Did you mean"),
        (edit(icon="none.svg"), "no such file"),
        (edit(icon="empty.svg"), "nothing to be seen"),
        (edit(icon="nothing.svg"), "file is empty"),
        (edit(icon="pale.svg"), "nothing to be seen"),
        (edit(icon="huge.svg"), "2,000,000 characters"),
        (edit(icon="hostile.svg"), "from outside itself"),
        (edit(icon="script.svg"), "script"),
        (edit(icon="text.svg"), "cannot be used"),
        (edit(icon="."), "folder"),
        (edit(remove=[]), "Nothing is changed"),
        (edit(remove=[[[0, 0], [20, 0], [20, 20], [0, 20]]]), "beside the icon"),
        (edit(remove=[[[300, 0], [320, 0], [320, 20]]]), "beside the icon"),
        (edit(add=[[[300, 0], [320, 0], [320, 20]]]), "beside the canvas"),
        (edit(remove=[[[0, 0], [256, 0], [256, 256], [0, 256]]]), "Nothing of the icon"),
        (edit(remove=[PART[:2]]), "at least 3"),
        (edit(remove=[[[0, 0], [1, 1], [2, 2]]]), "no area"),
        (edit(remove=[[[0, 0], [float("nan"), 1], [2, 2]]]), "not a number, or too large"),
        (edit(symmetry="sideways"), "horizontal, vertical"),
        (edit(keyword=""), "no keyword"),
        (edit(keyword="lighthose"), "Did you mean"),
        (edit(keyword=None), "no keyword"),
    ],
)  # fmt: skip
def test_bad_edits(tmp_path, capsys, data, words):
    assert words in told(tmp_path, capsys, "edit", data)


@pytest.mark.parametrize(
    ("options", "words"),
    [(["--styles", "shiny"], "no style 'shiny'"), (["--lambdas", "0"], "above 0")],
)
def test_bad_options_of_edits(tmp_path, capsys, options, words):
    assert words in told(tmp_path, capsys, "edit", edit(), *options)


@pytest.mark.parametrize(
    ("data", "words"),
    [
        ({"icons": []}, "0 icons"),
        ({"icons": [ICON]}, "1 icon cannot be mixed"),
        ({"icons": [ICON, ICON]}, "twice"),
        ({"icons": [ICON, OTHER] * 100}, "200 icons cannot be mixed"),
        ({"icons": [ICON, OTHER], "draws": 0}, "from 1 to 1000"),
        ({"icons": [ICON, OTHER], "draws": -3}, "from 1 to 1000"),
        ({"icons": [ICON, OTHER], "draws": 10**7}, "from 1 to 1000"),
        ({"icons": [ICON, OTHER], "keyword": "dog"}, "not both"),
        ({"icons": [ICON, "mdi:lighthose"]}, "Did you mean"),
        ({"icons": [ICON, "pale.svg"]}, "nothing to be seen"),
        ({}, "either"),
        ({"keyword": "xqzvw"}, "No icon is called"),
        ({"keyword": "otter", "count": 12}, "alike enough"),
        ({"keyword": "lighthouse", "count": 200}, "from 2 to 12"),
    ],
)  # fmt: skip
def test_bad_hybrids(tmp_path, capsys, data, words):
    assert words in told(tmp_path, capsys, "hybrids", data)


def test_two_files_of_the_same_looks_are_no_two_icons(tmp_path, capsys):
    for name in ("a.svg", "b.svg"):
        (tmp_path / name).write_text(SVG.format(f'<path id="{name}" d="M0 0H90V40Z"/>'), "utf-8")
    assert "looks the same" in told(tmp_path, capsys, "hybrids", {"icons": ["a.svg", "b.svg"]})


@pytest.mark.parametrize("option", [["--draws", "0"], ["--draws", "2000"], ["--seed", "-1"]])
def test_bad_options_of_hybrids(tmp_path, capsys, option):
    assert option[0] in told(tmp_path, capsys, "hybrids", {"icons": [ICON, OTHER]}, *option)


def stroke(*points, width=10):
    return {"width": width, "points": [list(point) for point in points]}


DOWN, ACROSS = stroke((128, 20), (128, 200)), stroke((20, 128), (200, 128))


@pytest.mark.parametrize(
    ("layers", "words"),
    [
        ([], "Add icons"),
        ([{"icon": ICON}] * 31, "1 to 30"),
        ([{"icon": ICON}], "Nothing is marked"),
        ([{"icon": ICON, "strokes": [stroke()]}], "no point"),
        ([{"icon": ICON, "strokes": [stroke((300, 9), (400, 90))]}], "outside the canvas"),
        ([{"icon": ICON, "strokes": [stroke((-9, -9), (-90, 9))]}], "outside the canvas"),
        ([{"icon": ICON, "strokes": [stroke((9, 9), (99, 9), width=0)]}], "above 0"),
        ([{"icon": ICON, "strokes": [DOWN]}, {"icon": OTHER, "strokes": [ACROSS]}], "overlap"),
        ([{"icon": ICON, "dx": 5000}], "Layer 1, “mdi:lighthouse”, lies outside the canvas"),
        ([{"icon": ICON, "scale": 0, "strokes": [DOWN]}], "from 0.02 to 20"),
        ([{"icon": ICON, "scale": 50, "strokes": [DOWN]}], "from 0.02 to 20"),
        ([{"icon": "hostile.svg", "strokes": [DOWN]}], "from outside itself"),
        ([{"icon": "empty.svg", "strokes": [DOWN]}], "nothing to be seen"),
        ([{"strokes": [DOWN]}], '"icon" is missing'),
    ],
)  # fmt: skip
def test_bad_montages(tmp_path, capsys, layers, words):
    assert words in told(tmp_path, capsys, "montage", {"layers": layers})


def test_a_montage_without_layers(tmp_path, capsys):
    assert "Add icons" in told(tmp_path, capsys, "montage", {})


@pytest.mark.parametrize("command", ["model", "edit", "hybrids", "montage"])
@pytest.mark.parametrize("what", ["a file", "in a file", "a dangling link", "a long name"])
def test_an_output_folder_that_cannot_be_is_told_before_anything_is_read(
    tmp_path, capsys, command, what
):
    out = tmp_path / "out"
    if what == "a dangling link":
        out.symlink_to(tmp_path / "nowhere")
    elif what == "a long name":
        out = tmp_path / ("x" * 400)
    else:
        out.write_text("mine")
    folder = out / "deeper" if what == "in a file" else out
    assert run([command, str(tmp_path / "none.json"), "--out", str(folder)], None) == 2
    assert "cannot be written" in capsys.readouterr().err
    assert not os.path.isfile(out) or out.read_text() == "mine"


def test_an_output_folder_without_a_name(tmp_path, capsys, monkeypatch):
    monkeypatch.chdir(tmp_path)
    assert run(["model", "none.json", "--out", ""], None) == 2
    assert "name of the folder" in capsys.readouterr().err


@pytest.mark.parametrize(
    ("command", "data", "words"),
    [
        ("model", {"layers": [{"icon": ICON}]}, "looks like a montage. Open it in Montage"),
        ("edit", {"keyword": "dog", "polygon": [[0, 0], [9, 0], [9, 9]]}, "like a sketch"),
        ("montage", edit(), "with iconstudio edit"),
        ("hybrids", {"layers": []}, "like a montage"),
        ("restyle", {"name": "Mine", "pairs": []}, "is a line style. Open it by"),
        ("edit", {"name": "Mine", "pairs": []}, "restyle ICON --style"),
    ],
)
def test_files_of_another_command(tmp_path, capsys, command, data, words):
    assert words in told(tmp_path, capsys, command, data)


@pytest.mark.parametrize(
    ("command", "data"),
    [("edit", edit(icon="no:such")), ("montage", {"layers": [{"icon": ICON}]})],
)
def test_what_is_refused_leaves_no_folder(tmp_path, capsys, command, data):
    told(tmp_path, capsys, command, data)
    assert not (tmp_path / "out").exists()


@pytest.mark.parametrize(
    ("name", "words"),
    [("mdi:lighthose", "Did you mean"), ("none.svg", "no such file"), ("", "no icon")],
)
def test_showing_what_is_not_there(tmp_path, capsys, name, words):
    assert run(["show", name, "--png", str(tmp_path / "x.png")], None) == 2
    assert words in capsys.readouterr().err
    assert not (tmp_path / "x.png").exists()


def test_a_picture_that_cannot_be_written(tmp_path, capsys):
    assert run(["show", ICON, "--png", str(tmp_path / "no" / "x.png")], None) == 2
    assert "cannot be written" in capsys.readouterr().err


@pytest.mark.parametrize(
    ("data", "said"),
    [
        ({"icons": [ICON, OTHER]}, "but mix work. Run it by: iconstudio hybrids {} --out FOLDER"),
        ({"hello": 1}, "Name one before it: iconstudio COMMAND {} --out FOLDER"),
        ("{", "is not valid JSON"),
        (None, "There is no"),
    ],
)
def test_a_file_in_place_of_a_command_is_told_which_one_runs_it(tmp_path, capsys, data, said):
    file = tmp_path / "input.json"
    if data is not None:
        file.write_text(data if isinstance(data, str) else json.dumps(data), "utf-8")
    assert run([str(file)], None) == 2
    assert said.format(file) in capsys.readouterr().err
