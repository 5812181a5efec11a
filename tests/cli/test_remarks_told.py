"""What could not be read of a drawing is said beside the result."""

import json
from dataclasses import replace

import pytest

from iconstudio.cli.app import run
from iconstudio.session import Session

TEXT = "Text was left out; turn it into shapes."
COLOUR = "The colour\nwas not understood."
SQUARE, OTHER = "M0 0h9v9h-9zM3 3v3h3v-3z", "M4 0h1v4h4v1h-4v4h-1v-4h-4v-1h4z"


@pytest.fixture(autouse=True)
def remarking(monkeypatch):
    """Whatever is read, there is a remark on files called “marked”."""
    read = Session.icon

    def icon(session, reference):
        found = read(session, reference)
        return replace(found, remarks=(TEXT, COLOUR)) if "marked" in reference else found

    monkeypatch.setattr(Session, "icon", icon)


@pytest.fixture
def files(tmp_path):
    for name, path in (("marked", SQUARE), ("plain", OTHER)):
        svg = f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 9 9"><path d="{path}"/></svg>'
        (tmp_path / f"{name}.svg").write_text(svg)
    return tmp_path


LINE = f"“marked.svg”: {TEXT} The colour was not understood."


def said(capfd):
    return [line for line in capfd.readouterr().err.splitlines() if "marked.svg" in line]


def test_show_says_so(files, capfd):
    assert run(["show", str(files / "marked.svg")], None) == 0
    assert said(capfd) == [LINE]
    assert run(["show", str(files / "plain.svg")], None) == 0
    assert said(capfd) == []


def written(files, data):
    path = files / "work.json"
    path.write_text(json.dumps(data))
    return [str(path), "--out", str(files / "out")]


def test_hybrids_say_so(files, capfd):
    data = {"icons": ["marked.svg", "plain.svg"], "draws": 9}
    assert run(["hybrids", *written(files, data)], None) == 0
    assert said(capfd) == [LINE]


def test_a_montage_says_so_once(files, capfd):
    stroke = {"width": 90, "points": [[60, 60], [200, 200]]}
    other = {"width": 10, "points": [[170, 70], [190, 70]]}
    layers = [
        {"icon": "marked.svg", "strokes": [stroke]},
        {"icon": "marked.svg", "scale": 0.5, "strokes": [other]},
    ]
    assert run(["montage", *written(files, {"layers": layers})], None) == 0
    assert said(capfd) == [LINE]


@pytest.mark.thorough
def test_an_edit_says_so(files, capfd):
    data = {"icon": "marked.svg", "keyword": "lighthouse", "remove": [[[0, 0], [99, 0], [0, 99]]]}
    options = ["--styles", "medium", "--lambdas", "0.1"]
    code = run(["edit", *written(files, data), *options], None)
    assert said(capfd) == [LINE]
    assert code == 0
