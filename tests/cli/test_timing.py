"""Where the time went, and how far a run is."""

import json
import re
from types import SimpleNamespace

import pytest

from iconstudio.cli import progress, timing
from iconstudio.cli.app import run
from iconstudio.workflows.events import Progress, Result, Retrieved

LIGHTHOUSE = "mdi:lighthouse"


@pytest.fixture
def clock(monkeypatch):
    clock = SimpleNamespace(now=50.0)
    monkeypatch.setattr(timing, "perf_counter", lambda: clock.now)
    monkeypatch.setattr(timing, "since_start", lambda: clock.now - 48)
    return clock


def test_every_second_is_booked_once(clock):
    stopwatch = timing.Stopwatch()
    for seconds, event in (
        (1, Progress("search", 1, "")),
        (2, Progress("prepare", 0.5, "")),
        (3, Retrieved("", ())),
        (4, Progress("match", 1, "")),
        (5, Result(None, {"remix": 6.0, "vectorize": 2.0})),
        (3, Result(None, {"remix": 0.5, "vectorize": 1.5})),
    ):
        clock.now += seconds
        stopwatch.note(event)
    clock.now += 7
    stopwatch.wrote()
    assert stopwatch.timings() == pytest.approx(
        {"search": 1, "prepare": 5, "match": 4, "remix": 8 * 0.65, "vectorize": 8 * 0.35,
         "write": 7, "total": 25}
    )  # fmt: skip
    assert stopwatch.worked == {"remix": 6.5, "vectorize": 3.5}
    assert stopwatch.first == 17


def test_the_table_names_what_took_place(clock, capsys):
    with timing.profiled(True) as stopwatch:
        clock.now += 1.25
        stopwatch.note(Progress("search", 1, ""))
        clock.now += 3
        stopwatch.note(Result(None, {"remix": 4.0, "vectorize": 1.0}))
    told = capsys.readouterr()
    assert told.out == ""
    rows = [re.split(r"  +", line) for line in told.err.splitlines()]
    assert ["searching", "1.25"] in rows
    assert ["cutting", "2.40", "4.00"] in rows
    assert ["drawing", "0.60", "1.00"] in rows
    assert ["all together", "6.25", "since the program was started"] in rows
    assert ["first result", "6.25", "after the start"] in rows
    assert not any(row[0] == "matching" for row in rows)


def test_the_stages_of_any_workflow_are_told_by_their_names(clock, capsys):
    with timing.profiled(True) as stopwatch:
        for event in (Progress("weave", 0.5, ""), Result(None), Progress("weave", 1, "")):
            clock.now += 2
            stopwatch.note(event)
        clock.now += 1
        stopwatch.wrote()
    rows = [re.split(r"  +", line) for line in capsys.readouterr().err.splitlines()]
    assert [row[:2] for row in rows[1:3]] == [["weave", "6.00"], ["writing files", "1.00"]]
    assert not any(row[0] == "cutting" for row in rows)


def test_nothing_is_told_unasked_or_of_a_run_that_failed(clock, capsys):
    with timing.profiled(False):
        pass
    with pytest.raises(ValueError), timing.profiled(True):
        raise ValueError
    assert capsys.readouterr().err == ""


def test_a_search_with_its_profile(capsys):
    assert run(["search", "otter", "--profile"], None) == 0
    told = capsys.readouterr()
    assert all(line.count("\t") == 2 for line in told.out.splitlines())
    assert [line.split()[0] for line in told.err.splitlines()[1:3]] == ["searching", "all"]


def test_a_montage_with_its_profile(tmp_path, capsys):
    strokes = [{"width": 20, "points": [[128, 40], [128, 200]]}]
    file = tmp_path / "montage.json"
    file.write_text(json.dumps({"layers": [{"icon": LIGHTHOUSE, "strokes": strokes}]}), "utf-8")
    assert run(["montage", str(file), "--out", str(tmp_path), "--profile"], None) == 0
    told = capsys.readouterr().err.splitlines()
    assert [line.split("  ")[0] for line in told[1:6]] == [
        "cutting", "drawing", "writing files", "all together", "first result",
    ]  # fmt: skip
    timings = json.loads((tmp_path / "results.json").read_text("utf-8"))["timings"]
    assert 0 < timings["remix"] + timings["vectorize"] <= timings["total"]


def test_the_start_of_the_program_is_before_now():
    before = timing.since_start()
    assert 0 < before <= timing.since_start() < 7200


def test_the_bar_says_what_remains(monkeypatch):
    written = []
    terminal = SimpleNamespace(
        isatty=lambda: True, write=written.append, flush=lambda: None, encoding="utf-8"
    )
    monkeypatch.setattr("sys.stderr", terminal)
    with progress.ProgressBar() as bar:
        bar.show(0.5, "Joining parts")
        assert "left" not in "".join(written)
        bar.show(0.6, "Joining parts", 12.0)
    assert "about 10 s left" in "".join(written)
