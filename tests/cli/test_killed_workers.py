"""A worker that the system kills costs a run only time; one killed again and again, a sentence."""

import json
import os
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest

pytestmark = pytest.mark.skipif(sys.platform != "linux", reason="reads /proc")

ICONS = ["lets-icons:lamp", "lets-icons:lamp-light", "cuida:lamp-outline"]
STROKE = {"width": 12, "points": [[128, 40], [128, 120]]}
WORK = {
    "hybrids": {"icons": ICONS, "draws": 6},
    "montage": {"layers": [{"icon": ICONS[0], "strokes": [STROKE]}]},
}


def workers(group):
    found = []
    for folder in Path("/proc").glob("[0-9]*"):
        try:
            fields = (folder / "stat").read_text().rpartition(") ")[2].split()
            command = (folder / "cmdline").read_bytes()
        except OSError:
            continue
        if int(fields[2]) == group and fields[0] != "Z" and b"spawn_main" in command:
            found.append(int(folder.name))
    return found


def run_and_kill(folder, name, delay, kills):
    """Run a command, kill its workers, and return its exit code, what it said, and kills."""
    (folder / "in.json").write_text(json.dumps(WORK[name]), "utf-8")
    process = subprocess.Popen(
        [sys.executable, "-m", "iconstudio", name, folder / "in.json", "--out", folder / "out"],
        start_new_session=True,
        stdout=subprocess.DEVNULL,
        stderr=subprocess.PIPE,
        text=True,
    )
    done = 0
    try:
        while process.poll() is None and done < kills:
            for number in workers(process.pid):
                time.sleep(delay)
                try:
                    os.kill(number, signal.SIGKILL)
                    done += 1
                except ProcessLookupError:
                    continue
                if done == kills:
                    break
            time.sleep(0.02)
        _, said = process.communicate(timeout=200)
    finally:
        process.kill()
    end = time.monotonic() + 10
    while workers(process.pid) and time.monotonic() < end:
        time.sleep(0.05)
    assert workers(process.pid) == []
    assert "Traceback" not in said
    return process.returncode, said, done


@pytest.mark.thorough
@pytest.mark.parametrize(
    ("name", "delay"), [("hybrids", 0.0), ("hybrids", 0.5), ("hybrids", 1.2), ("montage", 0.5)]
)
def test_a_killed_worker_costs_nothing_but_time(tmp_path, name, delay):
    code, said, _ = run_and_kill(tmp_path, name, delay, 1)
    assert code == 0, said
    assert (tmp_path / "out" / "results.json").exists()


def test_workers_that_are_killed_again_and_again_end_in_a_sentence(tmp_path):
    code, said, kills = run_and_kill(tmp_path, "hybrids", 0.0, 1000)
    assert kills > 1
    assert code == 2, said
    assert said.rstrip().splitlines()[-1].startswith("iconstudio: ")
