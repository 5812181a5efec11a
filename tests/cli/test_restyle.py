"""Line styles from the command line: single icons, scribbles, and whole sets."""

import json
import re
import sys

import numpy as np
import pytest

from iconstudio.cli import line_styles
from iconstudio.cli.app import run
from iconstudio.inputs.line_style import write_style
from iconstudio.inputs.styles import named
from iconstudio.model import CANVAS, Frame
from iconstudio.output.restyled_set import MANIFEST
from iconstudio.session import Session
from iconstudio.svg.resvg import render_coverage
from tests.cli.test_interrupt import interrupted, until

CROSS = (
    '<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 24 24" fill="none" stroke="black" '
    'stroke-width="2"><path d="M{x} 4V20M4 {x}H20"/></svg>'
)

BAR = {"width": 9, "points": [[20, 128], [236, 128]]}


def ink(svg):
    return render_coverage(svg, Frame(0, 0, CANVAS), CANVAS) > 127


@pytest.fixture
def icons(tmp_path):
    folder = tmp_path / "icons"
    (folder / "more").mkdir(parents=True)
    for number in range(4):
        (folder / f"cross-{number}.svg").write_text(CROSS.format(x=7 + number))
    (folder / "more" / "cross-1.SVG").write_text(CROSS.format(x=15))
    (folder / ".hidden.svg").write_text(CROSS.format(x=9))
    (folder / "notes.txt").write_text("no icon")
    return folder


def test_styles_are_listed(capsys):
    assert run(["restyle", "--list-styles"], None) == 0
    rows = [line.split("\t") for line in capsys.readouterr().out.splitlines()]
    assert ["Shaky", "Iconstudio", "CC0-1.0"] in rows


def test_an_icon_in_a_style_by_name_and_by_file(tmp_path, capsys):
    out, again = tmp_path / "house.svg", tmp_path / "again.svg"
    words = "restyle", "lucide:house", "--seed", "3"
    assert run([*words, "--style", "shaky", "--out", str(out)], None) == 0
    write_style(tmp_path / "own.json", named("Shaky"))
    assert run([*words, "--style", str(tmp_path / "own.json"), "--out", str(again)], None) == 0
    assert again.read_bytes() == out.read_bytes()
    with Session() as session:
        plain = session.exemplar(session.icon("lucide:house")).ink
        credits = [one.credit for one in session.icon(str(out)).made_of]
    assert [one.author for one in credits] == ["Lucide Contributors", "Iconstudio"]
    restyled = ink(out.read_text("utf-8"))
    assert 0 < (restyled ^ plain).sum() < 0.7 * plain.sum()
    assert all(one.startswith("Preparing") for one in "".join(capsys.readouterr()).splitlines())


def test_a_style_may_be_a_drawing_as_in_the_window(tmp_path, capsys):
    zigzag = " ".join(f"L{2 + x} {12 + 3 * (-1) ** x}" for x in range(1, 20))
    drawing = f'<path d="M2 12{zigzag}"/><text x="2" y="9" fill="url(#none)">a</text>'
    style = tmp_path / "zigzag.svg"
    style.write_text(CROSS.format(x=7).replace('<path d="M7 4V20M4 7H20"/>', drawing))
    out, line = tmp_path / "o.svg", tmp_path / "line.svg"
    house = tmp_path / "house.svg"
    house.write_text(CROSS.format(x=12))
    assert run(["restyle", str(house), "--style", str(style), "--out", str(out)], None) == 0
    with Session() as session:
        plain = session.exemplar(session.icon(str(house))).ink
    assert (ink(out.read_text("utf-8")) ^ plain).mean() > 0.01
    words = ["--style", str(style), "--length", "200", "--out", str(line)]
    assert run(["scribble", *words], None) == 0
    assert "<title>scribble, zigzag" in line.read_text("utf-8")
    capsys.readouterr()
    for command in ("restyle", "scribble"):
        assert run([command, "--help"], None) == 0
        assert "SVG whose lines" in " ".join(capsys.readouterr().out.split())


def test_strokes_look_like_the_outline(tmp_path):
    words = "restyle", "lucide:house", "--style", "wobbly", "--out"
    assert run([*words, str(tmp_path / "outline.svg")], None) == 0
    assert run([*words, str(tmp_path / "strokes.svg"), "--strokes"], None) == 0
    strokes = (tmp_path / "strokes.svg").read_text("utf-8")
    assert strokes.count("<path") == 1 and 'stroke-width="' in strokes
    outline = (tmp_path / "outline.svg").read_text("utf-8")
    assert "stroke" not in outline
    assert (ink(strokes) ^ ink(outline)).sum() < 0.01 * ink(outline).sum()


def test_a_file_gives_a_folder_or_an_icon(tmp_path, capsys):
    file = tmp_path / "restyle.json"
    file.write_text(json.dumps({"icon": "lucide:house", "style": "Loose", "seed": 3}))
    assert run(["restyle", str(file), "--out", str(tmp_path / "out")], None) == 0
    assert "1 icon; see" in capsys.readouterr().out
    made = (tmp_path / "out" / "restyle-1.svg").read_bytes()
    assert json.loads((tmp_path / "out" / "results.json").read_text())["results"]
    assert run(["restyle", str(file), "--out", str(tmp_path / "one.svg")], None) == 0
    assert (tmp_path / "one.svg").read_bytes() == made
    words = ["restyle", str(file), "--seed", "4", "--out", str(tmp_path / "other.svg")]
    assert run(words, None) == 0
    assert (tmp_path / "other.svg").read_bytes() != made


@pytest.mark.parametrize(
    ("file", "said"),
    [
        ({"icon": "cross.svg"}, "no"),
        ({"icon": "cross.svg", "others": [9]}, "line 9, which is not there: there are lines 0 to"),
        ({"lines": [BAR], "others": [0, 1]}, "line 1, which is not there: there is line 0 only"),
        ({"others": [0]}, "line 0, which is not there: there are no lines"),
        ({"lines": [BAR, BAR], "others": [1, 1]}, '"others" gives line 1 2 styles. Keep one.'),
    ],
)
def test_a_line_that_is_not_there_has_no_style(tmp_path, capsys, file, said):
    (tmp_path / "cross.svg").write_text(CROSS.format(x=9))
    others = [{"line": line, "style": "Waves"} for line in file.get("others", ())]
    path = tmp_path / "restyle.json"
    path.write_text(json.dumps(file | {"style": "Loose", "others": others}))
    code = run(["restyle", str(path), "--out", str(tmp_path / "x.svg")], None)
    told = capsys.readouterr().err
    assert (code, said in told) == ((2, True) if others else (0, False)), told


def test_a_line_that_would_not_be_seen_is_told(tmp_path, capsys):
    path, out = tmp_path / "restyle.json", tmp_path / "x.svg"
    thin, away = {"points": BAR["points"]}, {"width": 9, "points": [[900, 128], [990, 128]]}
    path.write_text(json.dumps({"style": "Loose", "lines": [BAR, thin]}))
    assert run(["restyle", str(path), "--out", str(out)], None) == 2
    assert 'line 2: The line encloses nothing that is filled. Give it a "width"' in (
        capsys.readouterr().err
    )
    path.write_text(json.dumps({"style": "Loose", "lines": [BAR, away]}))
    assert run(["restyle", str(path), "--out", str(out)], None) == 0
    assert "Line 2 lies outside the canvas" in capsys.readouterr().err


def test_a_scribble_is_as_long_as_asked_and_wholly_in_its_picture(tmp_path):
    words = "scribble", "--style", "waves", "--length", "500", "--out"
    assert run([*words, str(tmp_path / "a.svg"), "--seed", "5"], None) == 0
    assert run([*words, str(tmp_path / "b.svg"), "--seed", "5"], None) == 0
    assert run([*words, str(tmp_path / "c.svg"), "--seed", "6"], None) == 0
    svg = (tmp_path / "a.svg").read_text("utf-8")
    assert svg == (tmp_path / "b.svg").read_text("utf-8")
    assert svg != (tmp_path / "c.svg").read_text("utf-8")
    width, height = map(float, re.search(r'viewBox="0 0 (\S+) (\S+)"', svg).groups())
    numbers = re.search(r'<path d="([^"]+)" fill="none"', svg)[1]
    points = np.array(re.findall(r"-?[\d.]+", numbers), float)
    assert points.min() > 0 and points.max() < max(width, height)
    with Session() as session:
        (line,) = session.lines(session.icon(str(tmp_path / "a.svg")))
        frame = session.exemplar(session.icon(str(tmp_path / "a.svg"))).frame
    steps = np.diff(np.array(line.points), axis=0)
    length = np.hypot(*steps.T).sum() * frame.size / 256
    assert length == pytest.approx(500, rel=0.15)


def test_a_scribble_has_the_widths_of_its_style(tmp_path):
    file = str(tmp_path / "brush.svg")
    assert run(["scribble", "--style", "Brush", "--length", "300", "--out", file], None) == 0
    svg = (tmp_path / "brush.svg").read_text("utf-8")
    assert "stroke-width" not in svg, "a stroke has one width"
    height = float(re.search(r'viewBox="0 0 (\S+) (\S+)"', svg)[2])
    found = ink(svg)
    thick = found.sum(axis=0)[found.any(axis=0)] * height / found.shape[0]
    assert thick.max() > 2 * thick.min()


def test_a_line_of_very_many_points_is_told_to_be_simplified(tmp_path, capsys):
    file = tmp_path / "restyle.json"
    turn = np.linspace(0, 2 * np.pi, 30_000)
    points = np.column_stack([128 + 90 * np.cos(turn), 128 + 90 * np.sin(turn)]).round(4)
    line = {"points": points.tolist(), "width": 8}
    file.write_text(json.dumps({"lines": [line], "style": "Waves"}))
    assert run(["restyle", str(file), "--out", str(tmp_path / "one.svg")], None) == 0
    assert "Line 1 has 30,000 points; it is drawn with fewer" in capsys.readouterr().err


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (["restyle", "--out", "x.svg"], "Name one icon"),
        (["restyle", "lucide:house", "--set", "lucide", "--out", "x.svg"], "Name one icon"),
        (["restyle", "lucide:house", "--out", "x.svg"], "Which style?"),
        (["restyle", "lucide:house", "--style", "shakey", "--out", "x.svg"], "“Shaky”?"),
        (["restyle", "lucide:house", "--style", "no.svg", "--out", "x.svg"], "no such file"),
        (["restyle", "lucide:house", "--style", "no.json", "--out", "x.svg"], "cannot be read"),
        (["restyle", "lucide:house", "--style", "shaky", "--out", "x.png"], "“x.svg”"),
        (["restyle", "lucide:house", "--style", "shaky", "--out", "no/x.svg"], "no such folder"),
        (["restyle", "lucide:huose", "--style", "shaky", "--out", "x.svg"], "no icon"),
        (["restyle", "no.svg", "--style", "shaky", "--out", "x.svg"], "no such file"),
        (["restyle", "no.json", "--out", "x"], "cannot be read"),
        (["restyle", "a:b", "--style", "shaky", "--strength", "nan", "--out", "x.svg"], "from 0.1"),
        (["restyle", "a:b", "--style", "shaky", "--size", "9", "--out", "x.svg"], "to 4"),
        (["restyle", "a:b", "--style", "shaky", "--seed", "-1", "--out", "x.svg"], "whole number"),
        (
            ["restyle", "a:b", "--style", "shaky", "--seed", "1e300", "--out", "x.svg"],
            "'1e300' is no whole number",
        ),
        (
            ["restyle", "a:b", "--scheduler", "x", "--style", "shaky", "--out", "x.svg"],
            "whole sets",
        ),
        (["restyle", "--set", "lucide", "--out", "x"], "Which style?"),
        (["restyle", "--set", "lucid", "--style", "shaky", "--out", "x"], "Did you mean lucide"),
        (["restyle", "--set", ".", "--style", "shaky", "--out", "../y"], "no SVG in the folder"),
        (["restyle", "--set", "", "--style", "shaky", "--out", "x"], "no set of icons"),
        (["scribble", "--length", "99", "--out", "x.svg"], "Which style?"),
        (["scribble", "--style", "shaky", "--length", "1e9", "--out", "x.svg"], "to 20000"),
        (["scribble", "--style", "shaky", "--length", "nan", "--out", "x.svg"], "from 20"),
    ],
)
def test_bad_input_is_told_in_a_sentence(tmp_path, monkeypatch, capsys, words, said):
    monkeypatch.chdir(tmp_path)
    assert run(words, None) == 2
    assert said in capsys.readouterr().err
    assert not list(tmp_path.iterdir())


def test_a_folder_is_restyled_and_what_is_broken_is_named(tmp_path, icons, capsys):
    (icons / "broken.svg").write_text("<svg")
    (icons / "empty.svg").write_text('<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 9 9"/>')
    out = tmp_path / "out"
    words = ["restyle", "--set", str(icons), "--style", "Shaky", "--out", str(out), "--seed", "2"]
    assert run(words, None) == 0
    told = capsys.readouterr()
    assert re.findall(r"^Skipped (\S+):", told.err, re.M) == ["broken.svg", "empty.svg"]
    assert told.out.startswith("5 icons, 2 skipped; see")
    files = sorted(one.name for one in out.iterdir())
    assert files[:6] == ["CREDITS.md", *(f"cross-{n}.svg" for n in range(4)), files[5]]
    assert re.fullmatch(r"more-cross-1-[0-9a-f]{8}\.svg", files[5])
    assert files[6:] == [MANIFEST, "sheet.png"]

    seed = json.loads((out / MANIFEST).read_text())["files"]["cross-2.svg"]["seed"]
    alone = ["restyle", str(icons / "cross-2.svg"), "--style", "Shaky", "--seed", str(seed)]
    assert run([*alone, "--out", str(tmp_path / "alone.svg")], None) == 0
    assert (tmp_path / "alone.svg").read_bytes() == (out / "cross-2.svg").read_bytes()


def test_icons_of_a_set_keep_their_scale_and_it_is_told_if_they_have_no_room(tmp_path, capsys):
    (tmp_path / "in").mkdir()
    page = '<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 24 24"><path d="{}"/></svg>'
    (tmp_path / "in" / "dot.svg").write_text(page.format("M10 10h4v4h-4z"))
    (tmp_path / "in" / "full.svg").write_text(page.format("M0 0h24v24H0z"))
    words = ["restyle", "--set", str(tmp_path / "in"), "--style", "Torn"]
    assert run([*words, "--out", str(tmp_path / "out")], None) == 0
    told = r"^1 icon had no room on its page, and came out smaller, by [1-9]\.\d% at most; "
    assert re.search(told, capsys.readouterr().err, re.M)
    dot = ink((tmp_path / "out" / "dot.svg").read_text("utf-8"))
    assert dot.any(axis=0).sum() == pytest.approx(4 / 24 * CANVAS, abs=12)
    words = ["restyle", str(tmp_path / "in" / "full.svg"), "--style", "Torn"]
    assert run([*words, "--out", str(tmp_path / "full.svg")], None) == 0
    told = r"^It had no room on the canvas, and came out [1-9]\.\d% smaller\.$"
    assert re.search(told, capsys.readouterr().err, re.M)


def test_what_becomes_of_pale_parts_is_told_and_recorded(tmp_path, capsys):
    words = ["restyle", "reicon:house-duotone", "--style", "ink", "--out", str(tmp_path / "a.svg")]
    assert run(words, None) == 0
    assert "Its pale parts were left out" in capsys.readouterr().err
    (tmp_path / "a.json").write_text(json.dumps({"icon": "reicon:house-duotone", "style": "Ink"}))
    assert run(["restyle", str(tmp_path / "a.json"), "--out", str(tmp_path / "b.svg")], None) == 0
    assert "Its pale parts were left out" in capsys.readouterr().err


def test_nothing_but_broken_icons(tmp_path, capsys):
    (tmp_path / "in").mkdir()
    (tmp_path / "in" / "broken.svg").write_text("<svg")
    words = ["restyle", "--set", str(tmp_path / "in"), "--style", "Shaky"]
    assert run([*words, "--out", str(tmp_path / "out")], None) == 2
    assert "No icon of the set could be restyled." in capsys.readouterr().err
    assert not (tmp_path / "out").exists()


def test_a_folder_of_another_style_is_left_alone_and_one_of_other_options_told(
    tmp_path, icons, capsys
):
    out = tmp_path / "out"
    words = ["restyle", "--set", str(icons), "--out", str(out), "--style"]
    assert run([*words, "Shaky"], None) == 0
    before = {one: one.read_bytes() for one in out.iterdir()}
    capsys.readouterr()
    assert run([*words, "Torn"], None) == 2
    assert "holds icons of icons in the style Shaky. Choose another" in capsys.readouterr().err
    assert {one: one.read_bytes() for one in out.iterdir()} == before
    assert run([*words, "Shaky", "--seed", "5"], None) == 0
    assert "are replaced; they were made with seed 0" in capsys.readouterr().err


def test_what_takes_long_the_first_time_is_said(tmp_path, capsys, monkeypatch):
    monkeypatch.setattr(line_styles, "_SOON", 0.0)
    words = ["scribble", "--style", "waves", "--length", "90", "--out", str(tmp_path / "a.svg")]
    assert run(words, None) == 0
    assert capsys.readouterr().err == "Preparing, which takes longer the first time…\n"


def test_originals_are_never_written_over(icons, capsys):
    before = {one: one.read_bytes() for one in icons.rglob("*.*")}
    for out in (icons, icons / "more", icons / "new"):
        words = ["restyle", "--set", str(icons), "--style", "Shaky", "--out", str(out)]
        assert run(words, None) == 2
        assert "Choose one outside of it" in capsys.readouterr().err
    assert {one: one.read_bytes() for one in icons.rglob("*.*")} == before


@pytest.mark.thorough
@pytest.mark.skipif(sys.platform != "linux", reason="reads /proc")
def test_a_set_that_is_stopped_goes_on_where_it_was(tmp_path, icons):
    for number in range(4, 12):
        (icons / f"cross-{number}.svg").write_text(CROSS.format(x=6 + number))
    out = tmp_path / "out"
    words = ["restyle", "--set", str(icons), "--style", "Shaky", "--out", str(out)]

    def begun(process):
        assert until(lambda: any(out.glob("*.svg")))

    interrupted(words, begun)
    kept = json.loads((out / MANIFEST).read_text())["files"]
    assert 0 < len(kept) == len(list(out.glob("*.svg"))) < 13
    times = {file: (out / file).stat().st_mtime_ns for file in kept}
    assert run(words, None) == 0
    assert all((out / file).stat().st_mtime_ns == times[file] for file in times)
    fresh = tmp_path / "fresh"
    assert run([*words[:-1], str(fresh)], None) == 0
    assert {one.name: one.read_bytes() for one in out.iterdir()} == {
        one.name: one.read_bytes() for one in fresh.iterdir()
    }


def test_a_set_replaces_no_file_of_the_users(icons, tmp_path, capsys):
    out = tmp_path / "out"
    out.mkdir()
    words = ["restyle", "--set", str(icons), "--style", "Shaky", "--out", str(out)]
    (out / "CREDITS.md").write_text("mine")
    assert run(words, None) == 2
    assert "CREDITS.md of yours" in capsys.readouterr().err
    assert (out / "CREDITS.md").read_text() == "mine"
    (out / "CREDITS.md").unlink()
    (out / "cross-2.svg").write_text("mine")
    assert run(words, None) == 0
    assert "“cross-2.svg” is there already" in capsys.readouterr().err
    assert (out / "cross-2.svg").read_text() == "mine"
    with (out / "cross-3.svg").open("a") as file:
        file.write("<!-- edited -->")
    assert run(words, None) == 0
    assert "“cross-3.svg” is there already" in capsys.readouterr().err
    assert (out / "cross-3.svg").read_text().endswith("<!-- edited -->")
