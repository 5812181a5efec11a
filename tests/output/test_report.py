"""What a run leaves in its folder."""

import errno
import json
import xml.etree.ElementTree as ET
from dataclasses import asdict, replace

import numpy as np
import pytest
from PIL import Image
from scipy import ndimage

import iconstudio
from iconstudio.algorithms.raster import fill_polygon, placed_ink, solid
from iconstudio.model import CANVAS, Axis, Edit, IconstudioError, Placement, Polygon
from iconstudio.output import png
from iconstudio.output.report import GridReport
from iconstudio.output.request import edit_request, sketch_request
from iconstudio.workflows.editing.placing import place_edit
from iconstudio.workflows.events import (
    Progress,
    Recommended,
    RegionsFound,
    Result,
    Retrieved,
    StyleMatched,
    StyleSkipped,
)
from tests.output.made import BLOCK, DISC, RING, SKETCH, SOURCES, TARGET, made, quarters

REQUEST = sketch_request(SKETCH)
CENTRES = tuple((10.0 * k, 20.5) for k in range(9))
TIMINGS = {"search": 0.25, "prepare": 1.0, "match": 2.0, "remix": 3.0, "total": 6.5}


@pytest.fixture(scope="module")
def results():
    """From the highest lambda_S down, as a workflow yields them."""
    whole = np.zeros((CANVAS, CANVAS), np.uint8)
    return [made(whole, 0.75), made(quarters(), 0.05)]


@pytest.fixture(scope="module")
def folder(tmp_path_factory, results):
    out = tmp_path_factory.mktemp("report") / "new" / "out"
    report = GridReport(out, REQUEST, (0.75, 0.05), dump=True)
    report.add(Progress("search", 0.5, "Looking"))
    report.add(Retrieved("dog & cat", (RING, DISC, BLOCK)))
    report.add(RegionsFound(CENTRES))
    report.add(StyleSkipped("lightest", 2, "Only two."))
    report.add(StyleMatched("light", (RING, BLOCK), (SOURCES[:3],) * 9))
    for result in results:
        report.add(Result(result))
        number = 2 if result.composite.lambda_s == 0.75 else 1
        assert (out / f"light-{number}.svg").is_file()  # at once
    report.add(Recommended("light", 0.05))
    report.finish(TIMINGS)
    return out


@pytest.fixture(scope="module")
def report(folder):
    def refuse(constant):
        raise AssertionError(f"{constant} is no JSON")

    return json.loads((folder / "results.json").read_text("utf-8"), parse_constant=refuse)


def test_these_files_and_no_others(folder):
    icons = {f"light-{n}{end}" for n in (1, 2) for end in (".svg", ".png", "-sources.png")}
    others = {"grid.png", "results.json", "light.npz"}
    assert {path.name for path in folder.iterdir()} == icons | others


def test_the_head_of_the_report(report):
    assert set(report) == {
        "version", "keyword", "symmetry", "canvas", "retrieved", "timings", "regions", "styles",
        "results", "kind", "files", "finished", "digests",
    }  # fmt: skip
    assert report["version"] == iconstudio.__version__
    assert report["keyword"] == "dog & cat"
    assert report["canvas"] == 256
    assert report["symmetry"] is None
    assert report["retrieved"] == 3
    assert report["timings"] == TIMINGS | {"vectorize": 0.0}
    assert report["regions"] == [list(centre) for centre in CENTRES]


def test_styles_and_their_matches(report):
    assert report["styles"]["lightest"] == {"retrieved": 2, "matches": [], "skipped": "Only two."}
    light = report["styles"]["light"]
    assert light["retrieved"] == 2
    assert light["matches"] == 9 * [
        [
            {"icon": "test:ring", "scale": 1.0, "flip": False, "dx": 0, "dy": 0, "error": 0.5},
            {"icon": "test:ring", "scale": 1.1, "flip": True, "dx": 12, "dy": -3, "error": 0.75},
            {"icon": "test:block", "scale": 1.0, "flip": False, "dx": 0, "dy": 0, "error": 1.0},
        ]
    ]


def test_results_by_rising_lambda(report, results):
    assert [result["lambda_s"] for result in report["results"]] == [0.05, 0.75]
    for written, result in zip(report["results"], reversed(results), strict=True):
        composite = result.composite
        assert written["style"] == "light"
        assert written["energy"] == pytest.approx(composite.energy)
        assert written["data_cost"] == pytest.approx(composite.data_cost)
        assert written["smoothness_cost"] == pytest.approx(composite.smoothness_cost)
        assert written["iou"] == pytest.approx(composite.iou)
        assert written["rank_score"] == pytest.approx(result.score.total)
        terms = asdict(replace(result.score, plausible=0.5))
        del terms["plausible"]  # nobody was asked
        assert written["rank_terms"] == pytest.approx(terms)
        assert "unchanged" not in written
    assert [result["recommended"] for result in report["results"]] == [True, False]


def test_sources_are_those_with_ink_by_falling_share(report):
    quartered, whole = (result["sources"] for result in report["results"])
    assert [source["icon"] for source in whole] == ["test:ring"]
    assert whole[0]["share"] == 1.0
    assert len(quartered) == 3
    shares = [source["share"] for source in quartered]
    assert shares == sorted(shares, reverse=True) and sum(shares) == pytest.approx(1)
    for source in quartered:
        placement = SOURCES[source["label"]].placement
        found = source["scale"], source["flip"], source["dx"], source["dy"]
        assert found == (placement.scale, placement.flip, placement.dx, placement.dy)
        assert source["author"] == "A. Artist"
        assert source["license"] == "MIT"
        assert source["url"] == "https://example.org"


def test_the_pictures_that_the_report_names(folder, report):
    for result in report["results"]:
        root = ET.fromstring((folder / result["svg"]).read_bytes())
        assert root.findtext("{http://www.w3.org/2000/svg}title") == "dog & cat (light)"
        with Image.open(folder / result["png"]) as picture:
            assert (picture.mode, picture.size) == ("RGBA", (png.SIZE, png.SIZE))
        with Image.open(folder / result["sources_png"]) as picture:
            assert picture.mode == "RGBA" and picture.width == picture.height


def test_the_dump_holds_the_problem_and_the_labellings(folder, results):
    with np.load(folder / "light.npz", allow_pickle=False) as dump:
        held = dict(dump)
    placed = [placed_ink(source.exemplar, source.placement) for source in SOURCES]
    assert np.array_equal(held["ink"], [ink for ink, _ in placed])
    assert np.array_equal(held["solid"], [filled for _, filled in placed])
    assert np.array_equal(held["interior"], held["solid"] & ~held["ink"])
    assert np.array_equal(held["sketch"], TARGET)
    assert held["lambda_s"].tolist() == [0.05, 0.75]
    assert held["labels"].dtype == np.uint8
    for labels, energy, result in zip(
        held["labels"], held["energy"], reversed(results), strict=True
    ):
        assert np.array_equal(labels, result.composite.labels)
        assert energy == result.composite.energy
    assert held["exemplar_id"].tolist() == ["test:ring", "test:block"]
    assert np.array_equal(held["exemplar_solid"], [solid(RING.ink), solid(BLOCK.ink)])
    assert all(held[name].dtype == bool for name in ("ink", "solid", "interior", "exemplar_solid"))


def test_a_folder_that_is_a_file(tmp_path):
    (tmp_path / "out").write_text("mine")
    for folder in (tmp_path / "out", tmp_path / "out" / "deeper"):
        with pytest.raises(IconstudioError, match="cannot be written"):
            GridReport(folder, REQUEST, (0.1,))
    assert (tmp_path / "out").read_text() == "mine"


def test_results_json_is_a_folder(tmp_path):
    (tmp_path / "results.json").mkdir()
    with pytest.raises(IconstudioError, match="is a folder"):
        GridReport(tmp_path, REQUEST, (0.1,))


def full(*args, **kwargs):
    raise OSError(errno.ENOSPC, "No space left on device")


def test_a_folder_without_room(tmp_path, monkeypatch):
    monkeypatch.setattr("iconstudio.output.folder.tempfile.TemporaryFile", full)
    with pytest.raises(IconstudioError, match="the disk is full"):
        GridReport(tmp_path, REQUEST, (0.1,))


def test_the_disk_fills_up_on_the_way(tmp_path, monkeypatch, result):
    report = GridReport(tmp_path, REQUEST, (0.1,))
    monkeypatch.setattr("iconstudio.files.write_atomically", full)
    with pytest.raises(IconstudioError, match="the disk is full"):
        report.add(Result(result))
    assert list(tmp_path.iterdir()) == []


def test_a_run_of_nothing_but_skipped_styles(tmp_path):
    report = GridReport(tmp_path, REQUEST, (0.1,), dump=True)
    report.add(StyleSkipped("dark", 0, "None."))
    report.finish({})
    assert {path.name for path in tmp_path.iterdir()} == {"grid.png", "results.json"}
    assert json.loads((tmp_path / "results.json").read_text())["results"] == []


REMOVED = Polygon.of([(48, 48), (128, 48), (128, 208), (48, 208)])


@pytest.fixture(scope="module")
def edited(tmp_path_factory, results):
    """The report of an edit, its dump, and the change."""
    out = tmp_path_factory.mktemp("edit")
    edit = Edit(BLOCK.pictogram, "dog", remove=(REMOVED,), symmetry=Axis.VERTICAL)
    change = place_edit(edit, BLOCK)
    report = GridReport(out, edit_request(change), (0.05,), dump=True)
    report.add(StyleMatched("light", (RING,), (SOURCES[:3],) * 9))
    report.add(Result(replace(results[1], unchanged=0.9975)))
    report.finish({})
    with np.load(out / "light.npz", allow_pickle=False) as dump:
        return json.loads((out / "results.json").read_text("utf-8")), dict(dump), change


def test_the_report_of_an_edit(edited):
    report, _, _ = edited
    assert report["symmetry"] == "vertical"
    assert report["base"] == {
        "icon": "test:block", "scale": 1.0, "flip": False, "dx": 0, "dy": 0,
    }  # fmt: skip
    assert report["results"][0]["unchanged"] == 0.9975


def test_the_dump_of_an_edit_holds_equation_11(edited):
    _, dump, change = edited
    distance = ndimage.distance_transform_edt(~fill_polygon(REMOVED))
    mask = np.minimum(distance / 25, 1)
    assert np.array_equal(dump["change"], fill_polygon(REMOVED))
    assert dump["penalty"].shape == (4, CANVAS, CANVAS)
    # E_0 gives way to nothing beside what is only taken off.
    assert dump["penalty"][0] == pytest.approx(0.1 * fill_polygon(REMOVED), abs=1e-6)
    for other in dump["penalty"][1:]:
        assert other == pytest.approx(0.1 * mask, abs=1e-6)
    assert np.array_equal(dump["sketch"], change.silhouette)


def test_sources_of_a_source_are_thanked(tmp_path, result):
    composite = result.composite
    inner = replace(BLOCK.pictogram, made_of=(RING.pictogram, DISC.pictogram))
    source = replace(composite.sources[0], exemplar=replace(BLOCK, pictogram=inner))
    report = GridReport(tmp_path, REQUEST, (0.1,))
    report.add(StyleMatched("light", (RING,), (SOURCES[:3],) * 9))
    made_again = replace(composite, sources=(source, *composite.sources[1:]))
    report.add(Result(replace(result, composite=made_again)))
    report.finish({})
    (written,) = json.loads((tmp_path / "results.json").read_text("utf-8"))["results"]
    first = next(one for one in written["sources"] if one["label"] == 0)
    assert [one["icon"] for one in first["made_of"]] == ["test:ring", "test:disc"]
    assert first["made_of"][0]["author"] == "A. Artist"
    assert "made_of" not in next(one for one in written["sources"] if one["label"] == 1)


def test_a_symmetric_result_takes_the_place_of_another(tmp_path, results):
    report = GridReport(tmp_path, REQUEST, (0.75, 0.05))
    report.add(StyleMatched("light", (RING, BLOCK), (SOURCES[:3],) * 9))
    for one in results:
        report.add(Result(one))
    symmetric = replace(results[0].composite, symmetry=Axis.HORIZONTAL)
    report.add(Result(replace(results[0], composite=symmetric)))
    report.finish(TIMINGS)
    found = json.loads((tmp_path / "results.json").read_text())["results"]
    assert [one["symmetry"] for one in found] == [None, "horizontal"]


def test_the_dump_holds_the_mirror_images_of_sources(tmp_path, results):
    report = GridReport(tmp_path, REQUEST, (0.75, 0.05), dump=True)
    report.add(StyleMatched("light", (RING, BLOCK), (SOURCES[:3],) * 9))
    twin = replace(SOURCES[1], placement=Placement(1.1, False, -12, -3))
    labels = np.full((CANVAS, CANVAS), len(SOURCES), np.uint8)
    mirrored = made(labels, 0.75, sources=(*SOURCES, twin))
    for one in (results[1], mirrored):
        report.add(Result(one))
    report.finish(TIMINGS)
    with np.load(tmp_path / "light.npz", allow_pickle=False) as dump:
        ink, labels = dump["ink"], dump["labels"]
    assert np.array_equal(ink[4], placed_ink(twin.exemplar, twin.placement)[0])
    assert (labels[1] == 4).all() and (labels[0] < 4).all()
