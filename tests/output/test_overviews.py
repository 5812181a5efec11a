"""Reports of hybrids and of a montage: what is in the folder, and where it is on the sheet."""

import json
import xml.etree.ElementTree as ET
from dataclasses import replace

import numpy as np
import pytest
from PIL import Image

from iconstudio.algorithms.iconification.guidance import scribble
from iconstudio.model import CANVAS, Axis, Layer, Montage, Score, Stroke
from iconstudio.output.colours import key_of, palette
from iconstudio.output.hybrids import HybridsReport
from iconstudio.output.montage import MontageReport
from iconstudio.output.overviews import hybrids_overview, montage_overview
from iconstudio.workflows.events import Progress, Result
from tests.output.made import SOURCES, made, quarters

TIMINGS = {"remix": 1.0, "total": 1.5}


def scored(result, total, draw):
    """A hybrid with this rank score."""
    score = Score(seam=total, whole=1.0, symmetry=1.0, sharing=1.0, likeness=1.0)
    seeds = tuple(((10.5 + k, 20.5), (30.5, 40.5)) for k in range(len(SOURCES)))
    composite = replace(result.composite, style="hybrid", lambda_s=3.0, iou=None)
    return replace(result, composite=composite, score=score, seeds=seeds, draw=draw)


@pytest.fixture(scope="module")
def hybrids():
    """In the order of draws; the second and the third are equally good."""
    whole = np.zeros((CANVAS, CANVAS), np.uint8)
    results = made(quarters()), made(quarters().T), made(whole)
    scores, draws = (0.2, 0.7, 0.7), (0, 3, 4)
    return [scored(*one) for one in zip(results, scores, draws, strict=True)]


@pytest.fixture(scope="module")
def folder(tmp_path_factory, hybrids):
    out = tmp_path_factory.mktemp("hybrids")
    report = HybridsReport(out, "dog", 40, 7, Axis.HORIZONTAL)
    report.add(Progress("remix", 0.5, "Mixing"))
    for result in reversed(hybrids):
        report.add(Result(result))
    report.finish(TIMINGS)
    return out


def read(folder):
    return json.loads((folder / "results.json").read_text("utf-8"))


def test_hybrids_are_numbered_from_the_best_down_and_ties_by_draw(folder, hybrids):
    report = read(folder)
    entries = report["results"]
    assert [entry["rank"] for entry in entries] == [1, 2, 3]
    assert [entry["draw"] for entry in entries] == [3, 4, 0]
    assert [entry["rank_score"] for entry in entries] == [0.7, 0.7, 0.2]
    assert [entry["svg"] for entry in entries] == [f"hybrid-0{k}.svg" for k in (1, 2, 3)]
    for entry, k in zip(entries, (1, 2, 0), strict=True):
        root = ET.fromstring((folder / entry["svg"]).read_bytes())
        path = root.find("{http://www.w3.org/2000/svg}path")
        assert path.get("d") == hybrids[k].path.svg()


def test_the_report_of_hybrids(folder):
    report = read(folder)
    assert report["keyword"] == "dog"
    assert (report["draws"], report["kept"], report["seed"]) == (40, 3, 7)
    assert report["symmetry"] == "horizontal"
    assert report["timings"]["remix"] == 1.0
    assert report["icons"] == [source.exemplar.id for source in SOURCES]
    entry = report["results"][0]
    assert entry["seeds"][1] == [[11.5, 20.5], [30.5, 40.5]]
    assert entry["rank_terms"] == {
        "seam": 0.7, "whole": 1.0, "symmetry": 1.0, "sharing": 1.0, "likeness": 1.0, "inside": 1.0,
    }  # fmt: skip
    assert entry["iou"] is None and entry["lambda_s"] == 3.0
    assert {"icon", "share", "author", "license"} <= set(entry["sources"][0])
    names = {f"hybrid-0{k}{end}" for k in (1, 2, 3) for end in (".svg", ".png", "-sources.png")}
    assert {path.name for path in folder.iterdir()} == names | {"results.json", "sheet.png"}


def test_no_hybrid_at_all(tmp_path):
    report = HybridsReport(tmp_path, "", 1, 0, None)
    report.finish({})
    assert not list(tmp_path.iterdir())


def test_sources_and_codes_on_the_plate_have_one_palette(hybrids):
    colours = palette([result.composite for result in hybrids])
    overview = np.asarray(hybrids_overview("dog", "3 kept", hybrids, colours))
    head, body = overview[:280].reshape(-1, 3).tolist(), overview[280:].reshape(-1, 3).tolist()
    for source in SOURCES[:3]:
        assert list(colours[key_of(source)]) in head
        assert list(colours[key_of(source)]) in body


def test_at_most_twelve_hybrids_are_shown(hybrids):
    colours = palette([hybrids[0].composite])
    heights = [
        hybrids_overview("dog", "", hybrids[:1] * n, colours).height for n in (1, 4, 5, 12, 40)
    ]
    assert heights[0] == heights[1] < heights[2] < heights[3] == heights[4]


STROKES = (Stroke(20, ((40, 60), (40, 190))),), (Stroke(9, ((200, 40), (230, 90))),), (), ()
LAYERS = tuple(
    Layer(source.exemplar.pictogram, source.placement, strokes)
    for source, strokes in zip(SOURCES, STROKES, strict=True)
)


@pytest.fixture(scope="module")
def montage():
    result = made(quarters())
    return replace(result, composite=replace(result.composite, style="montage", iou=None))


def test_what_a_montage_leaves(tmp_path, montage):
    report = MontageReport(tmp_path, Montage(LAYERS))
    report.add(Result(montage))
    assert (tmp_path / "montage.svg").is_file()  # at once
    report.finish(TIMINGS)
    names = {"montage.svg", "montage.png", "montage-sources.png", "sheet.png", "results.json"}
    assert {path.name for path in tmp_path.iterdir()} == names
    written = read(tmp_path)
    assert written["symmetry"] is None
    assert [layer["strokes"] for layer in written["layers"]] == [1, 1, 0, 0]
    assert written["layers"][1] == {
        "icon": "test:ring", "scale": 1.1, "flip": True, "dx": 12, "dy": -3, "strokes": 1,
    }  # fmt: skip
    (entry,) = written["results"]
    assert entry["style"] == "montage" and entry["svg"] == "montage.svg"
    with Image.open(tmp_path / "sheet.png") as sheet:
        assert sheet.width > 1000


def test_scribbles_have_the_colour_of_what_they_keep(montage):
    overview = np.asarray(montage_overview(Montage(LAYERS), montage))
    colours = palette([montage.composite])
    for number, layer in enumerate(LAYERS[:2]):
        ys, xs = np.nonzero(scribble(layer.strokes))
        x = 40 + number * 264 + int(xs.mean() * 240 / 256)
        y = 100 + int(ys.mean() * 240 / 256)
        assert tuple(overview[y, x]) == colours[key_of(SOURCES[number])]
