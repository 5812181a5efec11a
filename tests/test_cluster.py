"""Whole sets in a Dask cluster: a real scheduler, and real worker processes on this machine."""

import contextlib
import os
import signal
import socket
import subprocess
import sys
import time
from hashlib import sha256
from importlib.util import find_spec

import pytest

from iconstudio.cli.app import run
from iconstudio.cluster import Cluster, DisconnectedError, _call
from iconstudio.model import IconstudioError
from iconstudio.workers import ProcessDied

pytestmark = pytest.mark.skipif(
    find_spec("distributed") is None, reason="needs the extra “cluster”"
)

ICONS = 10
SHAPE = (
    '<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 24 24" fill="none" stroke="black" '
    'stroke-width="2"><path d="M{x} 4V20M4 {x}H20"/></svg>'
)


def free_port():
    with socket.socket() as one:
        one.bind(("127.0.0.1", 0))
        return one.getsockname()[1]


@contextlib.contextmanager
def started(module, *arguments, folder, **environment):
    """A process of Dask's, ended at last."""
    process = subprocess.Popen(
        [sys.executable, "-P", "-m", f"distributed.cli.{module}", *arguments],
        cwd=folder,
        env={**os.environ, "PYTHONPATH": os.pathsep.join(filter(None, sys.path)), **environment},
        stdout=subprocess.DEVNULL,
        stderr=subprocess.DEVNULL,
    )
    try:
        yield process
    finally:
        process.kill()
        process.wait()


@contextlib.contextmanager
def scheduling(folder, **environment):
    """The address of a scheduler that answers, and its process."""
    port = free_port()
    options = "--host", "127.0.0.1", "--port", str(port), "--no-dashboard"
    with started("dask_scheduler", *options, folder=folder, **environment) as process:
        end = time.monotonic() + 60
        while time.monotonic() < end:
            with contextlib.suppress(OSError), socket.create_connection(("127.0.0.1", port)):
                break
            time.sleep(0.05)
        yield f"tcp://127.0.0.1:{port}", process


@pytest.fixture
def scheduler(tmp_path):
    with scheduling(tmp_path) as (address, _):
        yield address


@contextlib.contextmanager
def worker(scheduler, folder):
    options = "--nthreads", "1", "--no-nanny", "--no-dashboard", "--host", "127.0.0.1"
    with started("dask_worker", scheduler, *options, folder=folder) as process:
        yield process


@pytest.fixture
def icons(tmp_path):
    folder = tmp_path / "icons"
    folder.mkdir()
    for number in range(ICONS):
        (folder / f"icon-{number}.svg").write_text(SHAPE.format(x=5 + number))
    return folder


def digests(folder):
    return {one.name: sha256(one.read_bytes()).hexdigest() for one in sorted(folder.iterdir())}


@pytest.mark.thorough
def test_a_worker_is_killed_half_way_and_all_icons_are_there_once(
    tmp_path, icons, scheduler, monkeypatch, capsys
):
    from iconstudio.output.restyled_set import RestyledSet

    arguments = "restyle", "--set", str(icons), "--style", "Shaky", "--seed", "7", "--out"
    assert run([*arguments, str(tmp_path / "here")], None) == 0
    alone = digests(tmp_path / "here")
    assert len(alone) == ICONS + 3

    written = []
    add = RestyledSet.add
    with worker(scheduler, tmp_path) as first, worker(scheduler, tmp_path) as second:
        with Cluster(scheduler, 60) as cluster:
            cluster._client.wait_for_workers(2, timeout=60)

        def adding(self, event):
            written.append(event.member.id)
            if len(written) == ICONS // 3:
                first.send_signal(signal.SIGKILL)
                first.wait()
            add(self, event)

        monkeypatch.setattr(RestyledSet, "add", adding)
        words = [*arguments, str(tmp_path / "there"), "--scheduler", scheduler]
        assert run(words, None) == 0
        assert second.poll() is None
    assert sorted(written) == sorted(f"icon-{number}.svg" for number in range(ICONS))
    assert digests(tmp_path / "there") == alone
    told = capsys.readouterr().err.replace("Preparing, which takes longer the first time…\n", "")
    assert told == ""


def test_without_the_extra_a_sentence_says_how_to_install_it(tmp_path, icons, monkeypatch, capsys):
    monkeypatch.setitem(sys.modules, "distributed", None)
    words = "restyle", "--set", str(icons), "--style", "Shaky", "--out", str(tmp_path / "out")
    assert run([*words, "--scheduler", "tcp://127.0.0.1:1"], None) == 2
    assert 'pip install "iconstudio[cluster]"' in capsys.readouterr().err
    assert not (tmp_path / "out").exists()


@pytest.mark.parametrize("address", ["", "nonsense", "http://127.0.0.1:1", "tcp://127.0.0.1:{}"])
def test_no_scheduler(address):
    with pytest.raises(IconstudioError, match="No Dask scheduler answers"):
        Cluster(address.format(free_port()), 0.5)


def test_something_else_that_listens_is_no_scheduler():
    refused = pytest.raises(IconstudioError, match="No Dask scheduler answers")
    with socket.create_server(("127.0.0.1", 0)) as silent, refused:
        Cluster(f"tcp://127.0.0.1:{silent.getsockname()[1]}", 0.5)


def test_a_scheduler_without_workers(scheduler):
    with pytest.raises(IconstudioError, match="has no workers"):
        Cluster(scheduler, 2)


def test_a_scheduler_that_ends_is_told_in_a_sentence(tmp_path, capfd):
    with (
        scheduling(tmp_path) as (address, process),
        worker(address, tmp_path),
        Cluster(address, 60) as cluster,
    ):
        assert cluster.count == 1
        assert cluster.submit(abs, -3).result(60) == 3
        future = cluster.submit(time.sleep, 60)
        process.kill()
        with pytest.raises(DisconnectedError, match="goes on where it was"):
            future.result(60)
    assert capfd.readouterr().err == ""


def test_a_worker_of_another_version_says_so():
    with pytest.raises(ImportError, match=r"instead of 0\.0\.1"):
        _call("0.0.1", abs, (-3,))


def test_a_task_that_processes_die_of_is_given_up(tmp_path):
    once = {"DASK_DISTRIBUTED__SCHEDULER__ALLOWED_FAILURES": "0"}
    with (
        scheduling(tmp_path, **once) as (address, _),
        worker(address, tmp_path),
        Cluster(address, 60) as cluster,
        pytest.raises(ProcessDied),
    ):
        cluster.submit(os._exit, 1).result(60)
