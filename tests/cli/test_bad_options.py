"""Whatever the options are: a sentence and exit code 2, no traceback."""

import json

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from iconstudio.cli.app import run

STRANGE = ["", " ", "0", "-1", "1e999", "nan", "inf", "x", "9" * 400, "--", "-", "\udcff", "a\tb"]
values = st.sampled_from(STRANGE) | st.text(
    st.characters(exclude_characters="\0", exclude_categories=["Cs"]), max_size=9
)
SQUARE = [[10, 10], [90, 10], [90, 90], [10, 90]]
FILES = {
    "model": {"keyword": "xqzvw", "polygon": SQUARE},
    "edit": {"icon": "no:such", "keyword": "xqzvw", "add": [SQUARE]},
    "hybrids": {"icons": ["no:such", "no:other"]},
    "montage": {"layers": [{"icon": "no:such"}]},
    "restyle": {"icon": "no:such"},
}
"""What each command takes, of icons and words that there are not."""
GRID = [
    "--keyword",
    "--exclude",
    "--include",
    "--styles",
    "--lambdas",
    "--scales",
    "--dump",
    "--fine",
]
OPTIONS = {
    "model": GRID,
    "edit": GRID,
    "hybrids": ["--draws", "--seed", "--fine"],
    "montage": ["--fine"],
    "restyle": ["--style", "--seed", "--strength", "--size", "--strokes", "--set", "--scheduler"],
    "scribble": ["--style", "--seed"],
    "show": [],
    "search": ["--exclude"],
    "demo": [],
    "gallery": ["--sketches"],
}
USUAL = settings(max_examples=8, suppress_health_check=[HealthCheck.function_scoped_fixture])


@pytest.mark.parametrize("words", [["demo", "--", "--x"], ["demo", "--seed"]])
def test_bytes_that_are_no_text_are_told_where_nothing_is_expected(capsys, words):
    assert run([*words, "\udcff"], None) == 2
    assert "Error" in capsys.readouterr().err


@pytest.mark.parametrize("words", [["search"], ["show"], ["search", "xqzvw", "--exclude"]])
def test_bytes_that_are_no_text_are_told(capsys, words):
    assert run([*words, "\udcff"], None) == 2
    assert capsys.readouterr().err.count("\n") == 1


@pytest.mark.parametrize("name", STRANGE)
def test_no_example_is_told(capsys, name):
    assert run(["demo", "--headless", "--", name], None) == 2
    said = "".join(capsys.readouterr())
    assert "no example" in said


@pytest.mark.parametrize("command", OPTIONS)
@USUAL
@given(data=st.data())
def test_bad_options_are_told(tmp_path, capsys, command, data):
    words = [command]
    if command in FILES:
        file = tmp_path / "input.json"
        file.write_text(json.dumps(FILES[command]), "utf-8")
        words += [str(file), "--out", str(tmp_path / "out")]
    elif command == "scribble":
        words += ["--out", str(tmp_path / "out.svg"), "--length", data.draw(values)]
    elif command == "gallery":
        words += ["--out", str(tmp_path / "no" / "gallery.png")]
    elif command == "demo":
        words += ["--headless", "--out", str(tmp_path / "file" / "out"), data.draw(values)]
        (tmp_path / "file").write_text("no folder")
    else:
        words.append(data.draw(values.filter(str.isalpha).map("xqzvw{}".format)))
    for option in data.draw(st.lists(st.sampled_from(OPTIONS[command] or ["--x"]), max_size=3)):
        value = (
            None
            if option in ("--dump", "--fine", "--no-tidy", "--no-variants", "--strokes")
            else data.draw(values)
        )
        if option == "--keyword" and value and value.strip():
            # Else there may be icons of it: of a word or an emoji in it.
            value = "xqzvw" + "".join(one for one in value if one.isascii() and one.isalpha())
        words += [option, *([] if value is None else [value])]
    assert run(words, None) == (0 if {"-h", "--help"} & set(words) else 2)
    said = "".join(capsys.readouterr())
    assert said.strip() and "Traceback" not in said
    assert not (tmp_path / "out" / "results.json").exists()
