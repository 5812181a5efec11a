"""Tests run on machines without Qt's system libraries too: those of the window are skipped then."""

import os
import shutil
import tempfile
from collections import Counter

import pytest
from hypothesis import settings

from iconstudio.gui.window.availability import missing_library
from iconstudio.session import Session

os.environ.setdefault("QT_QPA_PLATFORM", "offscreen")
# A cache of our own, also for the programs that tests start: processes that share the tests out
# find the one of who started them, so that all is unpacked and compiled once.
PROCESS = os.environ.get("PYTEST_XDIST_WORKER", "")
CACHE = os.environ["ICONSTUDIO_CACHE"] if PROCESS else tempfile.mkdtemp(prefix="iconstudio-tests-")
os.environ["ICONSTUDIO_CACHE"] = CACHE
os.environ["ICONSTUDIO_DATA"] = os.path.join(CACHE, "data", PROCESS)  # nobody's work is offered

# The same examples each time, so that what has passed once passes again; to look for new ones:
# pytest --hypothesis-profile=explore
settings.register_profile("same", derandomize=True, deadline=None)
settings.register_profile("explore", deadline=None)
settings.load_profile("same")

MISSING = missing_library()

if MISSING:
    # Otherwise pytest-qt would stop the tests that need no Qt as well.
    from pytestqt.qt_compat import qt_api

    qt_api.set_qt_api = lambda api: None


def pytest_addoption(parser: pytest.Parser) -> None:
    parser.addoption("--thorough", action="store_true", help="run the long sweeps, too")


@pytest.hookimpl(trylast=True)
def pytest_configure(config: pytest.Config) -> None:
    thorough = "thorough(but=0): a long sweep; only so many of its cases run without --thorough"
    config.addinivalue_line("markers", thorough)
    if config.args_source is not pytest.Config.ArgsSource.TESTPATHS:
        config.option.thorough = True  # who names tests means all of them
    for name in ("pytest-qt", "_qt_logging") if MISSING else ():
        if config.pluginmanager.has_plugin(name):
            config.pluginmanager.unregister(name=name)


def pytest_unconfigure(config: pytest.Config) -> None:
    if not PROCESS:
        shutil.rmtree(CACHE, ignore_errors=True)


def pytest_ignore_collect(collection_path, config: pytest.Config) -> bool | None:
    """Do not import the window's tests without Qt; one test in their place says so."""
    if MISSING and collection_path.parent.name == "gui":
        return collection_path.name != "test_qt_is_there.py"
    return None


def pytest_collection_modifyitems(config: pytest.Config, items: list[pytest.Item]) -> None:
    """Leave out what is thorough, unless it is asked for."""
    if config.option.thorough:
        return
    cases: Counter[str] = Counter()
    kept, left = [], []
    for item in items:
        function = item.nodeid.partition("[")[0]
        mark = item.get_closest_marker("thorough")
        is_left = mark is not None and cases[function] >= mark.kwargs.get("but", 0)
        cases[function] += 1
        (left if is_left else kept).append(item)
    config.hook.pytest_deselected(items=left)
    items[:] = kept


@pytest.fixture(scope="session")
def session():
    """A session for all tests that only ask it: its processes need not start for each file."""
    with Session() as one:
        yield one


@pytest.fixture(scope="session")
def workers(session):
    """Its worker processes."""
    return session.workers
