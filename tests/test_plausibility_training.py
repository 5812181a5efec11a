"""The weights of plausibility: how they are fitted, and that those that come with it are good."""

from pathlib import Path

import numpy as np
import pytest
from click.testing import CliRunner

from iconstudio.algorithms.iconification.plausibility import FEATURES, VERSION
from iconstudio.building.plausibility.degrading import degraded
from iconstudio.building.plausibility.examples import examples_of
from iconstudio.building.plausibility.judged import (
    JudgedSketch,
    read_examples,
    read_grades,
    read_sketches,
    write_examples,
)
from iconstudio.cli.library import command
from iconstudio.inputs.plausibility import BUNDLED, read_plausibility
from iconstudio.model import CANVAS, IconstudioError
from iconstudio.session import Session
from iconstudio.svg.resvg import render_placed
from tests.output.made import SOURCES, SQUARE, made, quarters

JUDGED = Path(__file__).parent.parent / "resources" / "judged"


@pytest.fixture(scope="module")
def every():
    return read_examples(JUDGED)


@pytest.fixture(scope="module")
def asked(every):
    """What was judged by eye, of keywords that no weight was fitted to."""
    return [one for one in every if one.held_out and one.kind == "judged"]


def test_examples_are_made_of_results():
    sketch = JudgedSketch(name="square", keyword="dog", polygon=SQUARE.vertices, held_out=True)
    icons = [made(quarters(), 0.05), made(quarters(), 0.75), made(0 * quarters(), 0.1)]
    grades = {("square", "light", 0.05): 2}
    found = list(examples_of(sketch, icons, grades, render_placed))
    kinds = [one.kind for one in found]
    assert kinds.count("judged") == kinds.count("one") == 1
    assert kinds.count("cheapest") == 3
    assert {"moved"} <= set(kinds)
    for one in found:
        assert one.held_out
        assert one.plausible == (one.kind in ("judged", "one"))
        assert set(one.features) == set(FEATURES)
    again = list(examples_of(sketch, icons, grades, render_placed))
    assert [one.features for one in again] == pytest.approx([one.features for one in found])


def test_what_is_degraded_changes_in_one_place():
    inks = np.stack([source.exemplar.ink for source in SOURCES])
    labels = quarters()
    for one in degraded(labels, inks, SOURCES, np.random.default_rng(1)):
        changed = one.labels != labels
        ys, xs = np.nonzero(changed)
        assert 0 < changed.sum() < CANVAS**2 / 8
        assert max(np.ptp(ys), np.ptp(xs)) < 90
        assert one.labels.max() < len(one.sources)


def test_weights_are_fitted_to_some_and_measured_on_others(every, tmp_path):
    pytest.importorskip("sklearn")
    few = [one for number, one in enumerate(every) if one.kind == "judged" or number % 10 == 0]
    write_examples(tmp_path, few)
    out = tmp_path / "plausibility.json"
    done = CliRunner().invoke(
        command, ["plausibility", "--judged", str(tmp_path), "--out", str(out)]
    )
    assert done.exit_code == 0, done.output
    area = float(done.output.split("under the curve ")[1].split(",")[0])
    assert area > 0.75
    assert len(read_plausibility(out).weights) == len(FEATURES)


def test_the_weights_that_come_with_the_program_are_those_of_its_examples(every):
    pytest.importorskip("sklearn")
    from iconstudio.building.plausibility.fitting import fit

    again = fit([one for one in every if not one.held_out])
    bundled = read_plausibility()
    assert again.bias == pytest.approx(bundled.bias, abs=0.01)
    for one, other in zip(again.weights, bundled.weights, strict=True):
        assert one.feature == other.feature
        assert one.weight == pytest.approx(other.weight, abs=0.01)


def test_judgements_are_of_sketches_that_are_there(every):
    names = {sketch.name: sketch.held_out for sketch in read_sketches(JUDGED)}
    grades = read_grades(JUDGED)
    assert len(grades) >= 200
    assert {name for name, _, _ in grades} <= set(names)
    assert sum(one.kind == "judged" for one in every) == len(grades)
    assert all(one.held_out == names[one.sketch] for one in every)
    keywords = {sketch.keyword: set() for sketch in read_sketches(JUDGED)}
    for sketch in read_sketches(JUDGED):
        keywords[sketch.keyword].add(sketch.held_out)
    assert all(len(sides) == 1 for sides in keywords.values())


def test_judgements_are_met_on_keywords_never_fitted_to(asked):
    from iconstudio.building.plausibility.fitting import agreement, area_under_curve

    pytest.importorskip("sklearn")
    model = read_plausibility()
    assert len(asked) >= 100
    assert area_under_curve(model, asked) > AREA
    assert agreement(model, asked) > AGREEMENT


@pytest.mark.parametrize(
    ("text", "said"),
    [
        (f'{{"version": {VERSION + 1}, "bias": 0, "weights": []}}', "needs version"),
        (f'{{"version": {VERSION}, "bias": 0, "weights": []}}', "features that are needed"),
        ('{"version": 1', "no JSON"),
        ("", "plausibility.json"),
    ],
)
def test_a_file_that_does_not_fit_is_told(text, said, tmp_path):
    file = tmp_path / "plausibility.json"
    file.write_text(text)
    with pytest.raises(IconstudioError, match=said) as told:
        read_plausibility(file)
    assert str(told.value).startswith("Results are ranked by simple rules")


def test_the_program_goes_on_without_it(monkeypatch, tmp_path):
    monkeypatch.setattr("iconstudio.session.read_plausibility", lambda: read_plausibility(tmp_path))
    with Session(tmp_path) as session:
        assert session.plausibility is None
        assert "ranked by simple rules" in session.trouble
    monkeypatch.undo()
    with Session(tmp_path) as session:
        assert session.plausibility == read_plausibility(BUNDLED)
        assert session.trouble is None
