"""Patterns from the command line."""

import io
import json
import re

import numpy as np
import pytest
from PIL import Image

from iconstudio.cli.app import run
from iconstudio.session import Session

MOTIFS = [
    {"icon": "mdi:fish", "x": x, "y": y, "size": 70, "colour": "#aa3311"}
    for x in (48, 128, 208)
    for y in (48, 128, 208)
]


@pytest.fixture(scope="module")
def file(tmp_path_factory):
    path = tmp_path_factory.mktemp("pattern") / "fish.json"
    path.write_text(json.dumps({"motifs": MOTIFS, "ground": "navy", "width": 128, "height": 192}))
    return path


@pytest.fixture(scope="module")
def svg(file):
    out = file.with_name("fish.svg")
    assert run(["pattern", str(file), "--out", str(out)], None) == 0
    return out.read_text("utf-8")


def test_an_svg_of_the_size_and_the_colours(svg):
    assert 'width="128" height="192"' in svg
    assert set(re.findall(r"#[0-9a-f]{6}", svg)) == {"#aa3311", "#000080"}
    assert re.findall(r'id="([^"]+)"', svg) == ["ground", "layer-1"]


def test_its_credits_are_read_back(svg, tmp_path):
    (tmp_path / "fish.svg").write_text(svg)
    with Session() as session:
        (credit,) = session.icon(str(tmp_path / "fish.svg")).made_of
    assert credit.id == "mdi:fish"


@pytest.mark.parametrize("kind", ["svg", "png", "css"])
def test_the_ground_can_be_transparent_or_another(file, kind, tmp_path):
    out = tmp_path / f"a.{kind}"
    words = ["pattern", str(file), "--size", "128x128", "--out", str(out), "--ground"]
    assert run([*words, "none"], None) == 0
    if kind == "png":
        assert np.asarray(Image.open(out).convert("RGBA"))[..., 3].min() == 0
    else:
        assert "id='ground'" not in out.read_text().replace('"', "'")
        assert run([*words, "#0a0B0c"], None) == 0
        assert "0a0b0c" in out.read_text()


def test_what_an_image_does_not_heed_is_told(tmp_path, capfd):
    colours = np.full((96, 96, 3), 255, np.uint8)
    for x, y in ((12, 12), (60, 12), (12, 60), (60, 60)):
        colours[y : y + 24, x : x + 24] = 220, 30, 30
    Image.fromarray(colours).save(tmp_path / "a.png")
    words = [
        "--size",
        "128x128",
        "--turn",
        "30",
        "--density",
        "2",
        "--out",
        str(tmp_path / "a.svg"),
    ]
    assert run(["pattern", str(tmp_path / "a.png"), *words], None) == 0
    assert "An image keeps its own density and turn" in capfd.readouterr().err


def test_a_png_and_a_style_sheet_show_the_same(file, svg, tmp_path):
    words = ["pattern", str(file), "--out"]
    assert run([*words, str(tmp_path / "a.png")], None) == 0
    assert run([*words, str(tmp_path / "Some fish!.css")], None) == 0
    picture = Image.open(tmp_path / "a.png")
    assert picture.size == (128, 192)
    sheet = (tmp_path / "Some fish!.css").read_text("utf-8")
    assert sheet.count("mdi") and ".some-fish {" in sheet and "128px 192px" in sheet
    from urllib.parse import unquote

    from resvg_py import svg_to_bytes

    inner = unquote(re.search(r'url\("data:image/svg\+xml,([^"]*)"\)', sheet)[1])
    drawn = Image.open(io.BytesIO(bytes(svg_to_bytes(svg_string=inner, skip_system_fonts=True))))
    differ = abs(np.asarray(drawn.convert("RGB"), int) - np.asarray(picture.convert("RGB"), int))
    assert differ.max() < 24 and differ.mean() < 0.1


def test_options_count_more_than_the_file(file, tmp_path):
    out = tmp_path / "a.svg"
    words = ["--size", "96x64", "--no-tile", "--seed", "4", "--scale", "0.5", "--turn", "90"]
    assert run(["pattern", str(file), *words, "--out", str(out)], None) == 0
    assert 'width="96" height="64"' in out.read_text("utf-8")


@pytest.mark.parametrize(
    ("content", "said"),
    [
        ({"motifs": [{"icon": "mdi:fish", "x": float("nan")}]}, '"x" must be a number'),
        ({"motifs": [{"icon": "mdi:fish", "colour": "bluish"}]}, "“bluish” is no opaque colour"),
        ({"motifs": [{"icon": "mdi:fish", "x": -900}]}, "No ink of the icons lies on the canvas"),
        ({"motifs": [], "workflow": "pattern"}, "no exemplar yet"),
        ({"motifs": MOTIFS, "image": "x.png"}, "give one of the two"),
        ({"motifs": MOTIFS, "colours": 3}, '"colours" goes with "image", and there is none.'),
        ({"motifs": MOTIFS, "width": 10_000, "height": 10_000}, "GiB of memory"),
        ({"motifs": MOTIFS * 30}, "has 270 entries; at most 200 are read"),
        ({"motifs": MOTIFS, "widht": 9}, 'Write "width"'),
        ({"image": "nothing.png"}, "There is no such file"),
    ],
)
def test_bad_files_are_refused_in_a_sentence(content, said, tmp_path, capsys):
    (tmp_path / "a.json").write_text(json.dumps(content))
    words = ["pattern", str(tmp_path / "a.json"), "--out", str(tmp_path / "a.svg")]
    assert run(words, None) == 2
    error = capsys.readouterr().err
    assert said in error and "Traceback" not in error
    assert not (tmp_path / "a.svg").exists()


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (["--size", "512", "--out", "a.svg"], "write one as 512x512"),
        (["--size", "10x10", "--out", "a.svg"], "from 64 to 10000"),
        (["--scale", "nan", "--out", "a.svg"], "give a number from 0.25 to 4"),
        (["--ground", "bluish", "--out", "a.svg"], "For a transparent ground, write none."),
        (["--out", "a.jpg"], "Call it “a.svg”"),
        (["--out", ""], "is empty"),
        (["--fill", "nothing.svg", "--out", "a.svg"], "nothing.svg"),
    ],
)
def test_bad_options_are_refused_in_a_sentence(words, said, file, tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    assert run(["pattern", str(file), *words], None) == 2
    assert said in capsys.readouterr().err
    assert not list(tmp_path.iterdir())


def test_a_coloured_svg_drawing_is_an_exemplar_in_its_colours(tmp_path, capfd):
    dots = "".join(
        f'<circle cx="{x}" cy="{y}" r="14" fill="#c2185b"/><circle cx="{x}" cy="{y}" r="5" '
        'fill="#f0a202"/>' for y in (24, 72, 120) for x in (24, 72, 120)
    )  # fmt: skip
    (tmp_path / "dots.svg").write_text(
        '<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 144 144">'
        f'{dots}<path d="M200 9h9v9z"/></svg>'
    )
    words = ["pattern", str(tmp_path / "dots.svg"), "--size", "128x128", "--out"]
    assert run([*words, str(tmp_path / "out.svg")], None) == 0
    assert "An object lies outside its canvas, and was left out." in capfd.readouterr().err
    found = set(re.findall(r"#[0-9a-f]{6}", (tmp_path / "out.svg").read_text("utf-8")))
    assert found == {"#c2185b", "#f0a202", "#ffffff"}


def test_a_folder_that_is_not_there_is_told(file, tmp_path, capfd):
    assert run(["pattern", str(file), "--out", str(tmp_path / "none" / "a.svg")], None) == 2
    assert "there is no such folder" in capfd.readouterr().err
