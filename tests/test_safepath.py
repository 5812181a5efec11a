"""Nothing is imported from the folder in which the user happens to stand, whatever is started."""

import os
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest

from iconstudio import safepath

ROOT = Path(__file__).parents[1]
OTHERS = {
    "iconstudio", "numpy", "scipy", "PIL", "numba", "llvmlite", "skimage", "click", "maxflow",
    "platformdirs", "PySide6", "shiboken6", "resvg_py", "tqdm", "_multiprocessing",
    # Looked for by those, and not installed.
    "yaml", "cupy", "defusedxml", "olefile", "pooch", "matplotlib", "threadpoolctl", "colorama",
    "scikits", "pythran", "psutil", "sitecustomize", "usercustomize",
}  # fmt: skip
PLANT = "import os\nwith open(os.environ['PLANTS'], 'a') as file:\n    print(__file__, file=file)\n"
CODE = "import sys; from iconstudio.__main__ import main; sys.argv[0] = 'iconstudio'; main()"
SKETCH = '{"keyword": "dog", "polygon": [[0, 0], [100, 0], [100, 80], [0, 80]]}'


@pytest.fixture
def start(tmp_path):
    """Return a function that starts Python beside planted modules, and one that names those run."""
    here, log = tmp_path / "here", tmp_path / "plants"
    here.mkdir()
    for name in (OTHERS | sys.stdlib_module_names) - {"__main__"}:
        (here / f"{name}.py").write_text(PLANT)
    (here / ".numba_config.yaml").write_text("CACHE_DIR: elsewhere\n")
    (here / "sketch.json").write_text(SKETCH)
    (here / "this_is_empty.py").touch()
    log.touch()
    started = []

    def begin(*arguments, spare=(), **environment):
        for name in spare:
            (here / f"{name}.py").unlink(missing_ok=True)
        inherited = {name: value for name, value in os.environ.items() if name != "PYTHONSAFEPATH"}
        process = subprocess.Popen(
            [sys.executable, *arguments],
            cwd=here,
            env=inherited | {"PYTHONPATH": str(ROOT), "PLANTS": str(log)} | environment,
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            start_new_session=True,
        )
        started.append(process)
        return process

    def planted():
        return sorted({Path(line).name for line in log.read_text().splitlines()})

    yield begin, planted
    for process in started:
        process.kill()
        process.communicate()


@pytest.fixture
def script(tmp_path):
    """Return a command as an installer makes it."""
    (tmp_path / "bin").mkdir()
    path = tmp_path / "bin" / "iconstudio"
    path.write_text(
        'from iconstudio.__main__ import main\nif __name__ == "__main__":\n    main()\n'
    )
    return str(path)


SHOW = ("show", "lucide:house", "--png", "home.png")
MODEL = ("model", "sketch.json", "--out", "out", "--styles", "dark", "--lambdas", "0.1")


@pytest.mark.thorough
@pytest.mark.parametrize("work", [SHOW, MODEL], ids=["show", "model"])
def test_the_command(start, script, work):
    begin, planted = start
    process = begin(script, *work)
    _, said = process.communicate(timeout=240)
    assert planted() == []
    assert process.returncode == 0, said
    assert b"numba" not in said


@pytest.mark.parametrize(
    ("options", "path"),
    [
        ((), str(ROOT)),
        ((), os.pathsep + str(ROOT)),
        ((), str(ROOT) + os.pathsep),
        ((), os.curdir + os.pathsep + str(ROOT)),
        (("-P",), str(ROOT)),
    ],
    ids=["plain", "empty first", "empty last", "dot", "safe path"],
)
def test_the_module(start, options, path):
    begin, planted = start
    # Python puts the folder first, and imports some itself before anything of ours can run.
    before, found = {"encodings"}, {"iconstudio"}
    while found - before and not options:
        before |= found
        begin("-m", "this_is_empty", spare=before, PYTHONPATH=path).communicate(timeout=60)
        found = {one.removesuffix(".py") for one in planted()}
    assert not before & {"pickle", "random", "numpy", "subprocess", "multiprocessing"}
    process = begin(*options, "-m", "iconstudio", *SHOW, spare=before, PYTHONPATH=path)
    _, said = process.communicate(timeout=120)
    assert {one.removesuffix(".py") for one in planted()} <= before
    assert process.returncode == 0, said


@pytest.mark.parametrize("options", [("-E",), ("-I",), ("-s", "-B")], ids=" ".join)
def test_options_of_python(start, script, options):
    begin, planted = start
    if "PYTHONPATH" in os.environ:
        pytest.skip("these options keep Python from looking there")
    process = begin(*options, script, *SHOW)
    _, said = process.communicate(timeout=120)
    assert planted() == []
    assert process.returncode == 0, said


@pytest.mark.thorough
@pytest.mark.skipif(sys.platform != "linux", reason="looks for processes in /proc")
def test_the_window_and_its_processes(start, script):
    begin, planted = start
    process = begin(script, "demo", QT_QPA_PLATFORM="offscreen")
    end = time.monotonic() + 60
    while len(members(process.pid)) < 3 and time.monotonic() < end and process.poll() is None:
        time.sleep(0.1)
    time.sleep(4)  # they load what they need
    assert process.poll() is None, process.stderr.read()
    os.killpg(process.pid, signal.SIGKILL)
    assert planted() == []


def members(group):
    found = []
    for stat in Path("/proc").glob("[0-9]*/stat"):
        try:
            if stat.read_text().rpartition(") ")[2].split()[2] == str(group):
                found.append(stat.parent.name)
        except OSError:
            continue
    return found


WORKERS = """
import os, sys
from iconstudio.workers import Workers
from tests.test_safepath import import_all
if __name__ == "__main__":
    with Workers(1) as workers:
        workers.submit(import_all).result(timeout=60)
"""


def import_all():
    import iconstudio.algorithms.iconification.alpha_expansion
    import iconstudio.session  # noqa: F401


def test_workers_that_another_program_starts(start, tmp_path):
    begin, planted = start
    program = tmp_path / "program.py"
    program.write_text(WORKERS)
    process = begin(str(program))
    _, said = process.communicate(timeout=120)
    assert planted() == []
    assert process.returncode == 0, said


@pytest.fixture
def path(monkeypatch, tmp_path):
    monkeypatch.chdir(tmp_path)
    monkeypatch.delenv("PYTHONSAFEPATH", raising=False)
    monkeypatch.setattr(sys, "path", ["", str(tmp_path), "/usr/lib/elsewhere", str(ROOT), "."])
    return sys.path


def test_a_folder_that_the_user_names_stays(path, monkeypatch, tmp_path):
    monkeypatch.setenv("PYTHONPATH", str(tmp_path) + os.pathsep + os.pathsep + "/other")
    safepath.leave_current_folder()
    assert path == [str(tmp_path), "/usr/lib/elsewhere", str(ROOT)]
    assert os.environ["PYTHONPATH"] == str(tmp_path) + os.pathsep + "/other"
    assert os.environ["PYTHONSAFEPATH"] == "1"


def test_a_checkout_comes_last(path, monkeypatch):
    monkeypatch.chdir(ROOT)
    monkeypatch.delenv("PYTHONPATH", raising=False)
    path[:] = ["", "/usr/lib/elsewhere", str(ROOT)]
    safepath.leave_current_folder()
    assert path == ["/usr/lib/elsewhere", str(ROOT)]


def test_a_folder_of_packages_stays(path, monkeypatch):
    packages = Path(pytest.__file__).parents[1]
    monkeypatch.chdir(packages)
    monkeypatch.setattr("site.getsitepackages", lambda: [str(packages)])
    monkeypatch.delenv("PYTHONPATH", raising=False)
    path[:] = ["", str(packages), str(ROOT)]
    safepath.leave_current_folder()
    assert path == [str(packages), str(ROOT)]


def test_a_folder_that_is_gone(path, monkeypatch, tmp_path):
    monkeypatch.delenv("PYTHONPATH", raising=False)
    (tmp_path / "gone").mkdir()
    monkeypatch.chdir(tmp_path / "gone")
    (tmp_path / "gone").rmdir()
    safepath.leave_current_folder()
    assert "" not in path
