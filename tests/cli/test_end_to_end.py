"""One run on the real collection, checked from what it wrote."""

import json
import math
import xml.etree.ElementTree as ET

import numpy as np
import pytest
from PIL import Image

from iconstudio.cli.app import run
from iconstudio.model import CANVAS, Frame
from iconstudio.resources import resource
from iconstudio.svg.resvg import render_coverage
from tests.cli.energies import prove_energies

LAMBDAS = (0.05, 0.3)
STYLE = "dark"


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    out = tmp_path_factory.mktemp("run") / "out"
    sketch = resource("examples") / "gallery" / "fish.json"
    options = ["--styles", STYLE, "--lambdas", "0.05,0.3", "--dump"]
    assert run(["model", str(sketch), "--out", str(out), *options], None) == 0
    return out


@pytest.fixture(scope="module")
def report(folder):
    return json.loads((folder / "results.json").read_text("utf-8"))


@pytest.mark.thorough
def test_the_report_says_all(report):
    assert report["keyword"] == "fish"
    assert report["canvas"] == CANVAS
    assert set(report["timings"]) == {
        "search", "prepare", "match", "remix", "vectorize", "total",
    }  # fmt: skip
    assert len(report["regions"]) == 9
    assert set(report["styles"]) == {STYLE}
    matches = report["styles"][STYLE]["matches"]
    assert [len(row) for row in matches] == [3] * 9
    for row in matches:
        assert len({match["icon"] for match in row}) == 3
        assert [m["error"] for m in row] == sorted(m["error"] for m in row)
        assert set(row[0]) == {"icon", "scale", "flip", "dx", "dy", "error"}
    assert [result["lambda_s"] for result in report["results"]] == list(LAMBDAS)
    for result in report["results"]:
        assert {
            "style", "lambda_s", "energy", "data_cost", "smoothness_cost", "iou", "svg", "png",
            "sources_png", "sources", "rank_score", "rank_terms", "recommended", "without",
            "frame", "m", "symmetry",
        } == set(result)  # fmt: skip
        assert math.isclose(sum(source["share"] for source in result["sources"]), 1, abs_tol=1e-6)
        assert result["iou"] > 0.6
        assert result["rank_terms"]["likeness"] == result["iou"]
    assert sum(result["recommended"] for result in report["results"]) == 1
    best = max(report["results"], key=lambda result: result["rank_score"])
    assert best["recommended"]


def test_every_icon_is_one_path_with_credits(folder, report):
    for result in report["results"]:
        root = ET.fromstring((folder / result["svg"]).read_text("utf-8"))
        assert root.get("viewBox") == "0 0 256 256"
        paths = root.findall(".//{http://www.w3.org/2000/svg}path")
        assert len(paths) == 1
        text = (folder / result["svg"]).read_text("utf-8")
        assert 'fill="currentColor"' in text
        for source in result["sources"]:
            assert source["license"] in text
        for name in (result["png"], result["sources_png"]):
            with Image.open(folder / name) as picture:
                assert picture.width == picture.height >= CANVAS


def test_the_dump_proves_the_energies(folder, report):
    with np.load(folder / f"{STYLE}.npz", allow_pickle=False) as dump:
        assert len(dump["exemplar_solid"]) == len(dump["exemplar_id"])
        prove_energies(dict(dump), report["results"])


def test_the_svg_shows_the_labelling(folder, report):
    with np.load(folder / f"{STYLE}.npz", allow_pickle=False) as dump:
        ink, labels = dump["ink"], dump["labels"]
    for chosen, result in zip(labels, report["results"], strict=True):
        joined = np.take_along_axis(ink, chosen[None].astype(int), 0)[0]
        svg = (folder / result["svg"]).read_text("utf-8")
        drawn = render_coverage(svg, Frame(0, 0, CANVAS), CANVAS) > 127
        assert (drawn & joined).sum() / (drawn | joined).sum() > 0.93


def test_the_contact_sheet_is_there(folder):
    with Image.open(folder / "grid.png") as sheet:
        assert sheet.width > 600
    assert not list(folder.glob("*.part")) and not list(folder.glob(".*"))
