"""Ctrl-C on the terminal ends a run at once, and nothing is left of it."""

import json
import os
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest

pytestmark = pytest.mark.skipif(sys.platform != "linux", reason="reads /proc")

# A test run in the background may have interrupts ignored, and its children would inherit that.
PROGRAM = (
    "import signal, sys\n"
    "signal.signal(signal.SIGINT, signal.default_int_handler)\n"
    "from iconstudio.cli.app import run\n"
    "sys.exit(run(sys.argv[1:], None))\n"
)


def members(group):
    """The processes of a group that have not ended."""
    found = []
    for stat in Path("/proc").glob("[0-9]*/stat"):
        try:
            state, _parent, its_group = stat.read_text().rpartition(") ")[2].split()[:3]
        except OSError:
            continue
        if int(its_group) == group and state != "Z":
            found.append(stat.parent.name)
    return found


def until(condition, seconds=60):
    end = time.monotonic() + seconds
    while not condition() and time.monotonic() < end:
        time.sleep(0.05)
    return condition()


def interrupted(arguments, moment):
    """Run a command, interrupt it at a moment, and see that it ends well, and leaves no process.

    ``moment`` is called with the process, and returns at the moment.
    """
    process = subprocess.Popen(
        [sys.executable, "-c", PROGRAM, *arguments],
        start_new_session=True,
        stdout=subprocess.DEVNULL,
        stderr=subprocess.PIPE,
    )
    try:
        moment(process)
        os.killpg(process.pid, signal.SIGINT)
        _, said = process.communicate(timeout=30)
    finally:
        process.kill()
        process.wait()
    assert process.returncode == 130
    assert said.decode().rstrip().endswith("Stopped.")
    assert until(lambda: not members(process.pid), 10)


def test_an_interrupt_ends_hybrids_with_130_and_leaves_no_process(tmp_path):
    icons = ["lets-icons:lamp", "lets-icons:lamp-light", "cuida:lamp-outline"]
    (tmp_path / "in.json").write_text(json.dumps({"icons": icons, "draws": 1000}), "utf-8")
    arguments = ["hybrids", str(tmp_path / "in.json"), "--out", str(tmp_path / "out")]

    def at_work(process):
        assert until(lambda: len(members(process.pid)) > 2)  # its workers are there
        time.sleep(2)

    interrupted(arguments, at_work)
    assert not (tmp_path / "out" / "results.json").exists()
