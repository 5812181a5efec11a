"""Editing, hybrids, montage and single icons from the command line, on the real collection."""

import json

import numpy as np
import pytest
from PIL import Image
from scipy import ndimage

from iconstudio.cli.app import run
from iconstudio.model import CANVAS, Frame
from iconstudio.session import Session
from iconstudio.svg.check import check
from iconstudio.svg.resvg import render_coverage
from tests.cli.energies import prove_energies

LIGHTHOUSE = "mdi:lighthouse"
LAMPS = ["lets-icons:lamp", "lets-icons:lamp-light", "cuida:lamp-outline"]


def written(path, data):
    path.write_text(json.dumps(data), "utf-8")
    return str(path)


def results_of(folder):
    return json.loads((folder / "results.json").read_text("utf-8"))


def drawn(folder, entry):
    """The ink of a result's SVG on the canvas, wherever its frame lies."""
    svg = (folder / entry["svg"]).read_text("utf-8")
    check(svg)
    frame, unit = entry["frame"], CANVAS / entry["frame"]["size"]
    canvas = Frame(-frame["x"] * unit, -frame["y"] * unit, CANVAS * unit)
    return render_coverage(svg, canvas, CANVAS) > 127


def own_ink(reference):
    with Session() as session:
        return session.exemplar(session.icon(reference)).ink


def disc(x, y, radius):
    angles = np.linspace(0, 2 * np.pi, 24, endpoint=False)
    return [[x + radius * np.cos(a), y + radius * np.sin(a)] for a in angles]


@pytest.fixture(scope="module")
def edited(tmp_path_factory):
    out = tmp_path_factory.mktemp("edit")
    edit = {"icon": LIGHTHOUSE, "keyword": "lighthouse", "remove": [disc(128, 45, 40)],
            "add": [[[90, 4], [166, 4], [166, 70], [90, 70]]]}  # fmt: skip
    file = written(out / "edit.json", edit)
    options = ["--styles", "medium", "--lambdas", "0.1,0.3", "--dump"]
    assert run(["edit", file, "--out", str(out), *options], None) == 0
    return out


@pytest.mark.thorough
def test_the_rest_of_the_icon_stays(edited):
    report = results_of(edited)
    assert report["base"]["icon"] == LIGHTHOUSE
    assert [result["lambda_s"] for result in report["results"]] == [0.1, 0.3]
    with np.load(edited / "medium.npz", allow_pickle=False) as dump:
        change, own = dump["change"], dump["ink"][0]
    far = ndimage.distance_transform_edt(~change) > 25
    for result in report["results"]:
        assert result["unchanged"] >= 0.995
        same = (drawn(edited, result) == own)[far].mean()
        assert same >= 0.99  # resampled and traced, while `own` is a bitmap
        assert any(s["icon"] != LIGHTHOUSE and s["share"] > 0.02 for s in result["sources"])
        assert any(s["icon"] == LIGHTHOUSE for s in result["sources"])


def test_the_icon_is_left_out_of_matching(edited):
    style = results_of(edited)["styles"]["medium"]
    assert LIGHTHOUSE not in {match["icon"] for row in style["matches"] for match in row}


def test_the_dump_proves_the_energies(edited):
    with np.load(edited / "medium.npz", allow_pickle=False) as dump:
        held = dict(dump)
    count = len(held["ink"])
    near = held["change"]
    assert held["penalty"].shape == (count, CANVAS, CANVAS)
    np.testing.assert_allclose(held["penalty"][0][near], 0.1, rtol=1e-6)
    # Off the canvas, the icon shows nothing, which fits what is removed.
    assert (held["penalty"][1, near] <= 0).all()
    assert (held["penalty"][2:, near] == 0).all()
    prove_energies(held, results_of(edited)["results"])


@pytest.mark.thorough
def test_a_dump_of_fine_quality_proves_the_energies(tmp_path):
    edit = {"icon": LIGHTHOUSE, "keyword": "lighthouse", "remove": [disc(128, 45, 40)]}
    file = written(tmp_path / "edit.json", edit)
    options = ["--styles", "medium", "--lambdas", "0.3", "--dump", "--fine"]
    assert run(["edit", file, "--out", str(tmp_path), *options], None) == 0
    with np.load(tmp_path / "medium.npz", allow_pickle=False) as dump:
        held = dict(dump)
    assert held["m"] == 2 * CANVAS
    prove_energies(held, results_of(tmp_path)["results"])


@pytest.mark.thorough
def test_what_is_added_beyond_the_canvas_is_drawn(tmp_path):
    """Drawing and label map agree; no number of NumPy's is written out by its name."""
    edit = {"icon": LIGHTHOUSE, "keyword": "lighthouse",
            "add": [[[110, -40], [150, -40], [150, 40], [110, 40]]]}  # fmt: skip
    file = written(tmp_path / "edit.json", edit)
    options = ["--styles", "medium", "--lambdas", "0.3", "--dump"]
    assert run(["edit", file, "--out", str(tmp_path), *options], None) == 0
    (result,) = results_of(tmp_path)["results"]
    with np.load(tmp_path / "medium.npz", allow_pickle=False) as dump:
        joined = np.take_along_axis(dump["ink"], dump["labels"][:1].astype(int), axis=0)[0]
    picture = drawn(tmp_path, result)
    assert (joined & picture).sum() / (joined | picture).sum() > 0.9
    assert sum(source["share"] for source in result["sources"]) == pytest.approx(1)
    for path in tmp_path.iterdir():
        if path.suffix in (".svg", ".json"):
            assert "np." not in path.read_text("utf-8"), path


def test_the_sheet_is_there(edited):
    with Image.open(edited / "grid.png") as sheet:
        assert sheet.width > 600


@pytest.mark.thorough
def test_an_edit_of_a_file_under_symmetry_in_the_icons_own_style(tmp_path):
    (tmp_path / "mine.svg").write_text(
        '<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 100 200">'
        '<path d="M30 200L40 60H60L70 200ZM30 20H70V50H30Z" fill="#203060"/></svg>',
        "utf-8",
    )
    edit = {"icon": "mine.svg", "keyword": "lighthouse", "symmetry": "horizontal",
            "remove": [disc(128, 50, 35)]}  # fmt: skip
    file = written(tmp_path / "edit.json", edit)
    out = tmp_path / "out"
    assert run(["edit", file, "--out", str(out), "--lambdas", "0.3", "--dump"], None) == 0
    report = results_of(out)
    assert report["symmetry"] == "horizontal"
    assert report["base"]["icon"].startswith("own:mine")
    assert report["results"]
    for style in {result["style"] for result in report["results"]}:
        with np.load(out / f"{style}.npz", allow_pickle=False) as dump:
            held = dict(dump)
        assert np.array_equal(held["labels"], held["labels"][:, :, ::-1])
        prove_energies(held, [one for one in report["results"] if one["style"] == style])


@pytest.fixture(scope="module")
def runs(tmp_path_factory):
    """The same hybrids twice, the second time with draws and seed from the options."""
    folders = [tmp_path_factory.mktemp("hybrids") / name for name in ("first", "again")]
    data = {"icons": LAMPS, "symmetry": "horizontal"}
    file = written(folders[0].parent / "hybrids.json", data | {"draws": 6, "seed": 5})
    assert run(["hybrids", file, "--out", str(folders[0])], None) == 0
    other = written(folders[1].parent / "hybrids.json", data)
    options = ["--draws", "6", "--seed", "5"]
    assert run(["hybrids", other, "--out", str(folders[1]), *options], None) == 0
    return folders


@pytest.mark.thorough
def test_the_same_seed_gives_the_same_bytes(runs):
    first, again = runs
    names = sorted(path.name for path in first.iterdir())
    assert names == sorted(path.name for path in again.iterdir())
    assert sum(name.endswith(".svg") for name in names) >= 2
    for name in names:
        if name != "results.json":
            assert (first / name).read_bytes() == (again / name).read_bytes(), name
    reports = [results_of(folder) for folder in runs]
    for report in reports:
        del report["timings"]
    assert reports[0] == reports[1]


def test_results_come_in_rank_order(runs):
    report = results_of(runs[0])
    assert (report["draws"], report["seed"]) == (6, 5)
    assert report["kept"] == len(report["results"])
    assert report["icons"] == LAMPS
    scores = [result["rank_score"] for result in report["results"]]
    assert scores == sorted(scores, reverse=True)
    for rank, result in enumerate(report["results"], start=1):
        assert result["rank"] == rank
        terms = result["rank_terms"]
        looks = np.sqrt(terms.pop("seam") * terms.pop("whole"))
        looks *= terms["plausible"]  # it counts twice
        assert result["rank_score"] == pytest.approx(looks * np.prod(list(terms.values())))
        assert {source["icon"] for source in result["sources"]} <= set(LAMPS)
        for points in result["seeds"]:
            assert {(CANVAS - x, y) for x, y in points} == {(x, y) for x, y in points}


def test_no_result_repeats_a_source_or_another(runs):
    report = results_of(runs[0])
    pictures = [drawn(runs[0], result) for result in report["results"]]
    pictures += [own_ink(lamp) for lamp in LAMPS]
    for number, picture in enumerate(pictures):
        for other in pictures[:number]:
            assert (picture & other).sum() / (picture | other).sum() < 0.97


def test_hybrids_of_a_keyword(tmp_path, capsys):
    file = written(tmp_path / "hybrids.json", {"keyword": "lighthouse", "count": 3, "draws": 4})
    assert run(["hybrids", file, "--out", str(tmp_path / "out")], None) == 0
    report = results_of(tmp_path / "out")
    assert report["keyword"] == "lighthouse"
    assert len(set(report["icons"])) == 3
    assert 1 <= report["kept"] < 4
    assert "like one of the icons, or like another hybrid." in capsys.readouterr().out
    with Image.open(tmp_path / "out" / "sheet.png") as sheet:
        assert sheet.width > 600


def test_a_montage_keeps_what_is_scribbled_over(tmp_path):
    top = {"width": 30, "points": [[60, 40], [196, 40]]}
    bottom = {"width": 30, "points": [[60, 210], [196, 210]]}
    layers = [
        {"icon": LIGHTHOUSE, "strokes": [top]},
        {"icon": "game-icons:lighthouse", "flip": True, "dx": 5.2, "scale": 0.95,
         "strokes": [bottom]},
        {"icon": "hugeicons:lighthouse"},
    ]  # fmt: skip
    file = written(tmp_path / "montage.json", {"layers": layers})
    assert run(["montage", file, "--out", str(tmp_path)], None) == 0
    report = results_of(tmp_path)
    (result,) = report["results"]
    shares = {source["icon"]: source["share"] for source in result["sources"]}
    assert min(shares.get(LIGHTHOUSE, 0), shares.get("game-icons:lighthouse", 0)) > 0.1
    own, joined = own_ink(LIGHTHOUSE), drawn(tmp_path, result)
    rows, columns = slice(26, 54), slice(50, 206)
    assert (own == joined)[rows, columns].mean() > 0.98
    assert report["layers"][1]["dx"] == 5
    credited = (tmp_path / "montage.svg").read_text("utf-8")
    assert all(icon in credited for icon in shares)
    assert (tmp_path / "sheet.png").is_file()


def test_show_draws_the_icon_on_its_canvas(tmp_path, capsys):
    assert run(["show", LIGHTHOUSE, "--png", str(tmp_path / "icon.png")], None) == 0
    said = capsys.readouterr().out.split("\t")
    assert said[0] == LIGHTHOUSE and said[1] == "Pictogrammers"
    with Image.open(tmp_path / "icon.png") as picture:
        assert picture.size == (1024, 1024)
        small = np.asarray(picture.convert("L").resize((CANVAS, CANVAS), Image.Resampling.BOX))
    own = own_ink(LIGHTHOUSE)
    assert ((small < 128) == own).mean() > 0.995
    assert small[0, 0] == 255


def test_a_result_is_an_icon_like_any_other(tmp_path, capsys):
    """A hybrid's SVG goes into a montage, and its sources are thanked there too."""
    file = written(tmp_path / "hybrids.json", {"icons": LAMPS, "draws": 3})
    assert run(["hybrids", file, "--out", str(tmp_path)], None) == 0
    sources = {one["icon"] for one in results_of(tmp_path)["results"][0]["sources"]}
    assert run(["show", str(tmp_path / "hybrid-01.svg")], None) == 0
    said = capsys.readouterr().out
    assert all(source in said for source in sources)
    layers = [
        {"icon": "hybrid-01.svg", "strokes": [{"width": 20, "points": [[128, 20], [128, 120]]}]},
        {"icon": LIGHTHOUSE, "strokes": [{"width": 20, "points": [[100, 210], [150, 210]]}]},
    ]
    file = written(tmp_path / "montage.json", {"layers": layers})
    assert run(["montage", file, "--out", str(tmp_path / "out")], None) == 0
    (result,) = results_of(tmp_path / "out")["results"]
    made = next(one for one in result["sources"] if one["icon"].startswith("own:hybrid-01"))
    assert {one["icon"] for one in made["made_of"]} == sources
    svg = (tmp_path / "out" / "montage.svg").read_text("utf-8")
    assert all(source in svg for source in sources)
