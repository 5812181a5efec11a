"""The command line as a user meets it: one process, one answer."""

import json
import os
import subprocess
import sys
from types import SimpleNamespace

import pytest

from iconstudio.cli import grid
from iconstudio.cli.app import run
from iconstudio.cli.grid import GridOptions
from iconstudio.model import Polygon, Sketch

SQUARE = [[0, 0], [100, 0], [100, 80], [0, 80]]


class NoWindow:
    """A machine where no window can open."""

    def __init__(self):
        self.opened = []

    def obstacle(self):
        return "There is no screen."

    def open(self, example):
        self.opened.append(example)
        return 0


class AWindow(NoWindow):
    def obstacle(self):
        return None


def write(folder, text):
    path = folder / "sketch.json"
    path.write_text(text if isinstance(text, str) else json.dumps(text), "utf-8")
    return str(path)


@pytest.mark.parametrize(
    ("sketch", "words"),
    [
        ("", "not valid JSON"),
        ('{"polygon": [[0, 0], [1', "not valid JSON"),
        ("[" * 5000, "not valid JSON"),
        ("[]", "An object"),
        ({"keyword": "dog"}, '"polygon" is missing: a list'),
        ({"keyword": 7, "polygon": SQUARE}, '"keyword" must be a text'),
        ({"keyword": "dog", "polygon": []}, "at least 3"),
        ({"keyword": "dog", "polygon": [[0, 0], [1, 1]]}, "at least 3"),
        ({"keyword": "dog", "polygon": [[0, 0], [1, 1], [2, 2]]}, "no area"),
        ('{"keyword": "dog", "polygon": [[0, 0], [NaN, 1], [2, 5]]}', "not a number"),
        ({"keyword": "dog", "polygon": [[0, 0], [1e300, 1], [2, 5]]}, "out of all scale"),
        ({"keyword": "dog", "polygon": [[0, 0], "no", [2, 5]]}, "not a pair"),
        ({"polygon": SQUARE}, "no keyword"),
        ({"keyword": "  ", "polygon": SQUARE}, "no keyword"),
        ({"keyword": "motorbyke", "polygon": SQUARE}, "Did you mean"),
        ({"keyword": "xqzvw", "polygon": SQUARE}, "No icon is called"),
    ],
)
def test_bad_sketches_are_told_in_a_sentence(tmp_path, capsys, sketch, words):
    code = run(["model", write(tmp_path, sketch), "--out", str(tmp_path / "out")], NoWindow())
    assert code == 2
    told = capsys.readouterr().err
    assert words in told
    assert "Traceback" not in told


@pytest.mark.parametrize(
    ("options", "words"),
    [
        (["--styles", "shiny"], "no style 'shiny'"),
        (["--lambdas", "0.1,x"], "no list of numbers"),
        (["--lambdas", "0"], "above 0"),
        (["--styles", ""], "give a name"),
        (["--lambdas", ",".join(map(str, range(1, 100)))], "at most 64"),
        (["--lambdas", "nan"], "above 0"),
        (["--scales", "-1"], "above 0"),
        (["--scales", "50"], "up to 3"),
        (["--no-such-option"], "No such option"),
    ],
)
def test_bad_options_are_told(tmp_path, capsys, options, words):
    sketch = write(tmp_path, {"keyword": "dog", "polygon": SQUARE})
    assert run(["model", sketch, "--out", str(tmp_path / "out"), *options], NoWindow()) == 2
    assert words in capsys.readouterr().err


def test_a_missing_sketch(tmp_path, capsys):
    assert run(["model", str(tmp_path / "none.json"), "--out", str(tmp_path)], NoWindow()) == 2
    assert "cannot be read" in capsys.readouterr().err


def test_an_output_folder_that_is_a_file(tmp_path, capsys):
    sketch = write(tmp_path, {"keyword": "dog", "polygon": SQUARE})
    (tmp_path / "out").write_text("mine")
    assert run(["model", sketch, "--out", str(tmp_path / "out")], NoWindow()) == 2
    assert "out" in capsys.readouterr().err
    assert (tmp_path / "out").read_text() == "mine"


def test_search_lists_identifiers_and_draws(tmp_path, capsys):
    sheet = tmp_path / "sheet.png"
    assert run(["search", "sewing machine", "--sheet", str(sheet)], NoWindow()) == 0
    lines = capsys.readouterr().out.splitlines()
    assert lines and all(line.split("\t")[0].count(":") == 1 for line in lines)
    from PIL import Image

    with Image.open(sheet) as picture:
        assert picture.width > 300


def test_excluded_icons_are_not_listed(capsys):
    assert run(["search", "otter"], NoWindow()) == 0
    first = capsys.readouterr().out.split("\t")[0]
    assert run(["search", "otter", "--exclude", first], NoWindow()) == 0
    assert first not in capsys.readouterr().out


def test_an_icon_is_left_out_however_it_is_spelt(capsys):
    assert run(["search", "otter"], NoWindow()) == 0
    first = capsys.readouterr().out.split("\t")[0]
    assert run(["search", "otter", "--exclude", first.replace(":", "-", 1)], NoWindow()) == 0
    assert first not in capsys.readouterr().out


@pytest.mark.parametrize(
    ("command", "option"),
    [
        ("search", "--exclude"),
        ("model", "--exclude"),
        ("edit", "--exclude"),
        ("model", "--include"),
    ],
)
def test_an_icon_that_is_not_there_can_be_neither_left_out_nor_used(
    tmp_path, capsys, command, option
):
    files = {
        "model": {"keyword": "otter", "polygon": SQUARE},
        "edit": {"icon": "mdi:cat", "keyword": "otter", "add": [SQUARE]},
    }
    words = ["otter"]
    if command in files:
        words = [write(tmp_path, files[command]), "--out", str(tmp_path / "out")]
    assert run([command, *words, option, "nope:nope"], NoWindow()) == 2
    told = capsys.readouterr()
    assert told.err.startswith(f"iconstudio: {option}: The collection has no icon 'nope:nope'.")
    assert not told.out and not (tmp_path / "out").exists()


def test_icons_that_are_less_alike_are_brought_in_by_name(tmp_path):
    dog = SimpleNamespace(id="a:dog")
    given = GridOptions(
        tmp_path / "otter.json", tmp_path, None, (), ("a-dog",), (), (), (), False, False, False
    )
    known = {"a-dog": dog, "a:otter": SimpleNamespace(id="a:otter")}
    session = SimpleNamespace(collection=SimpleNamespace(get=known.__getitem__))
    asked = Sketch(Polygon.of(SQUARE), "otter", include=frozenset({"a:otter"}))
    assert given.of(asked, session).include == {"a:otter", "a:dog"}


def test_what_a_file_leaves_out_in_vain_is_told(tmp_path, capsys):
    """The run itself ends at once: there is no keyword."""
    files = {
        "model": {"polygon": SQUARE},
        "edit": {"icon": "mdi:cat", "add": [SQUARE]},
    }
    for command, data in files.items():
        for exclude in (["nope:nope"], ["mdi:dog"]):
            file = write(tmp_path, data | {"exclude": exclude, "include": exclude})
            assert run([command, file, "--out", str(tmp_path / "out")], NoWindow()) == 2
            told = capsys.readouterr().err
            remark = '"exclude" leaves out nothing by “nope:nope”. The collection has no icon'
            assert (remark in told) == (exclude == ["nope:nope"])
            assert ('"include" brings in nothing by “nope:nope”' in told) == (remark in told)


def test_an_icon_that_is_left_out_and_brought_in_is_told(tmp_path, capsys):
    file = write(tmp_path, {"polygon": SQUARE, "exclude": ["mdi:dog", "mdi:cat"]})
    for names, said in (
        (("mdi:cow",), ""),
        (("mdi-dog",), '“mdi:dog” is in "exclude" and in "include": it is left out.'),
        (("mdi:dog", "mdi:cat"), "“mdi:cat” and “mdi:dog” are in"),
    ):
        words = [word for name in names for word in ("--include", name)]
        run(["model", file, "--out", str(tmp_path / "out"), *words], NoWindow())
        told = capsys.readouterr().err
        assert said in told and ('in "exclude" and in "include"' in told) == bool(said)


def test_several_words_need_no_quotation_marks(capsys):
    assert run(["search", "ice cream"], NoWindow()) == 0
    listed = capsys.readouterr().out
    assert run(["search", "ice", "cream"], NoWindow()) == 0
    assert capsys.readouterr().out == listed != ""
    assert run(["search", "dog", "cat"], NoWindow()) == 2
    assert "Alone, these words find icons: dog, cat." in capsys.readouterr().err


@pytest.mark.parametrize(
    ("word", "hint"),
    [
        ("photo.jpg", "iconstudio show photo.jpg --png icon.png"),
        ("cat.SVG", "iconstudio show cat.SVG --png icon.png"),
        ("serch", "Do you mean this? iconstudio search"),
        ("Restyl", "Do you mean this? iconstudio restyle"),
        ("my cat.png", "iconstudio show 'my cat.png' --png icon.png"),
        ("otter", "iconstudio search otter"),
        ("", "iconstudio --help lists them."),
        (".", "iconstudio --help lists them."),
    ],
)
def test_a_word_that_is_no_command_is_answered_with_what_to_type(capsys, word, hint):
    assert run([word], NoWindow()) == 2
    told = capsys.readouterr().err
    assert told.startswith(f"iconstudio: “{word}” is no command.") and hint in told


def test_the_sheet_shows_what_is_listed(tmp_path, capsys, monkeypatch):
    from iconstudio.output import sheet

    drawn = []
    monkeypatch.setattr(
        sheet, "search_sheet", lambda exemplars, word, path: drawn.extend(e.id for e in exemplars)
    )
    assert run(["search", "otter"], NoWindow()) == 0
    first = capsys.readouterr().out.split("\t")[0]
    arguments = ["search", "otter", "--exclude", first, "--sheet", str(tmp_path / "otter.png")]
    assert run(arguments, NoWindow()) == 0
    listed = [line.split("\t")[0] for line in capsys.readouterr().out.splitlines()]
    assert drawn == listed


@pytest.mark.parametrize(
    ("word", "told"),
    [
        ("speach bubble", "“speach” was read as “speech”.\n"),
        ("red otter", "No icon has all of these words: “red” was left out.\n"),
        ("calender", "Did you mean calendar?\n"),
        ("otter", ""),
    ],
)
def test_how_words_were_read_is_told_beside_the_icons(capsys, word, told):
    assert run(["search", word], NoWindow()) == 0
    out, err = capsys.readouterr()
    assert out and err == told


@pytest.mark.parametrize("word", ["", "   ", "motorbyke"])
def test_unknown_words_are_told(capsys, word):
    assert run(["search", word], NoWindow()) == 2
    assert capsys.readouterr().err.startswith("iconstudio: ")


def test_without_a_command_the_window_opens():
    window = AWindow()
    assert run([], window) == 0
    assert window.opened == [None]


def test_demo_opens_the_window_with_the_motorbike():
    window = AWindow()
    assert run(["demo"], window) == 0
    assert window.opened == ["motorbike"]


def test_without_a_screen_the_window_says_why(capsys):
    window = NoWindow()
    assert run([], window) == 2
    assert "no screen" in capsys.readouterr().err
    assert not window.opened


def test_an_unknown_example(capsys):
    assert run(["demo", "unicorn"], AWindow()) == 2
    assert "motorbike" in capsys.readouterr().err


def test_a_bar_is_shown_on_a_terminal_only(tmp_path):
    """A real process, its output piped: nothing but sentences comes out."""
    done = subprocess.run(
        [sys.executable, "-m", "iconstudio", "search", "otter"],
        capture_output=True,
        text=True,
        check=True,
        env={**os.environ, "PYTHONWARNINGS": "error"},
    )
    assert done.stderr == ""


@pytest.mark.skipif(not os.path.exists("/dev/full"), reason="needs /dev/full")
def test_output_that_has_no_room_is_told_in_a_sentence():
    with open("/dev/full", "w") as full:
        done = subprocess.run(
            [sys.executable, "-P", "-m", "iconstudio", "show", "lucide:house"],
            stdout=full,
            stderr=subprocess.PIPE,
            text=True,
            check=False,
            env={**os.environ, "PYTHONPATH": os.pathsep.join(filter(None, sys.path))},
        )
    assert done.returncode == 2
    assert done.stderr == "iconstudio: The disk is full. Make room, and run again.\n"


def test_a_project_is_opened_in_the_window(tmp_path, capsys):
    class Window(AWindow):
        def open_project(self, path):
            self.opened = path
            return 7

    window, path = Window(), tmp_path / "my dog.iconstudio"
    assert run([str(path)], window) == 2
    assert "There is no file" in capsys.readouterr().err
    path.touch()
    assert run([str(path)], window) == 7
    assert window.opened == str(path)


@pytest.mark.parametrize("option", ("", "--no-variants"))
def test_variants_are_made_unless_they_are_not_wanted(option, tmp_path):
    asked = []

    @grid.grid_command("model", "SKETCH.json", "all", tidies=True)
    def command(options):
        """Note what is asked for."""
        asked.append(options.settings(("light",)))

    path = tmp_path / "sketch.json"
    path.write_text("{}")
    arguments = [path, "--out", tmp_path / "out", option]
    command.main([str(one) for one in arguments if one], standalone_mode=False)
    assert [one.variants for one in asked] == [not option]
