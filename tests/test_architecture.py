"""The house rules that a machine can check."""

import ast
import re
import subprocess
import sys
from functools import cache
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[1]
PACKAGE = ROOT / "iconstudio"
ADAPTERS = {
    "numba": {"algorithms/compiled.py"},
    "resvg_py": {"svg/resvg.py"},
    "fontTools": {
        "algorithms/regions.py",
        "svg/geometry.py",
        "model/path.py",
        "model/placement.py",
        "gui/pictures/vector.py",
    },
    "tree_sitter": {"svg/syntax.py"},
    "tree_sitter_typescript": {"svg/syntax.py"},
    "tinycss2": {"svg/stylesheet.py"},
    "cssselect2": {"svg/matching.py"},
    "coloraide": {"svg/colours.py"},
    "shapely": {"algorithms/areas.py", "algorithms/geometry.py"},
    "pillow_heif": {"images/pillow.py"},
    "pathops": {"algorithms/regions.py"},
    "maxflow": {"algorithms/patterns/seams.py"},
    "potrace": {"algorithms/tracing/potrace.py"},
    "tqdm": {"cli/progress.py"},
    "distributed": {"cluster.py"},
}


@cache
def imported(path: Path) -> set[str]:
    """Top-level names of all modules that a file imports, also inside functions."""
    names = set()
    for node in ast.walk(ast.parse(path.read_text("utf-8"))):
        if isinstance(node, ast.Import):
            names |= {alias.name.split(".")[0] for alias in node.names}
        elif isinstance(node, ast.ImportFrom) and node.module and not node.level:
            names.add(node.module.split(".")[0])
    return names


def test_import_contracts_hold():
    run = subprocess.run(
        [sys.executable, "-c", "from importlinter.cli import lint_imports_command as c; c()"],
        cwd=ROOT,
        capture_output=True,
        text=True,
        check=False,
    )
    assert run.returncode == 0, run.stdout + run.stderr
    assert "0 broken" in run.stdout


def test_each_foreign_library_has_one_adapter():
    for library, adapters in ADAPTERS.items():
        users = {
            str(path.relative_to(PACKAGE).as_posix())
            for path in PACKAGE.rglob("*.py")
            if library in imported(path)
        }
        assert users == adapters, (library, users)


def test_the_toy_workflow_keeps_the_rules_of_the_house():
    toy = ROOT / "tests" / "toy.py"
    modules = {
        name.module
        for name in ast.walk(ast.parse(toy.read_text("utf-8")))
        if isinstance(name, ast.ImportFrom)
    }
    ours = {name for name in modules if name.startswith("iconstudio.")}
    assert modules - ours <= sys.stdlib_module_names | {"collections.abc"}
    assert {name.split(".")[1] for name in ours} <= {"inputs", "model", "workflows"}
    run = subprocess.run(
        [sys.executable, "-m", "ruff", "check", "--stdin-filename", "iconstudio/workflows/toy.py"],
        cwd=ROOT,
        input=toy.read_text("utf-8"),
        capture_output=True,
        text=True,
        check=False,
    )
    assert run.returncode == 0, run.stdout + run.stderr


def test_what_all_workflows_share_knows_nothing_of_cuts():
    for name in ("workflow", "events", "pages", "plain", "files"):
        text = (PACKAGE / "workflows" / f"{name}.py").read_text("utf-8")
        assert "iconstudio.algorithms" not in text, name


def test_the_first_page_is_short_and_its_links_lead_somewhere():
    pages = [ROOT / "README.md", ROOT / "CONTRIBUTING.md", *PACKAGE.rglob("README.md")]
    assert pages[0].read_text("utf-8").count("\n") < 150
    for page in pages:
        for link in re.findall(r"\]\(([^)#:]+)\)", page.read_text("utf-8")):
            assert (page.parent / link).exists(), (page, link)


def test_the_modules_that_pages_name_are_there():
    for page in PACKAGE.rglob("README.md"):
        for name in re.findall(r"`([\w/]+\.py)`", page.read_text("utf-8")):
            places = PACKAGE / name, page.parent / name, ROOT / name
            found = any(place.exists() for place in places) or any(page.parent.rglob(name))
            assert found, (page, name)


def test_the_names_in_tables_are_there():
    sources = [*PACKAGE.rglob("*.py"), *(ROOT / "tests" / "oracles").rglob("*.py")]
    known = set(re.findall(r"\w+", " ".join(path.read_text("utf-8") for path in sources)))
    for page in PACKAGE.rglob("README.md"):
        for row in re.findall(r"^\|.*\|$", page.read_text("utf-8"), re.MULTILINE):
            for name in re.findall(r"`([A-Za-z_][\w.]*)`", row):
                if not name.endswith(".py"):
                    assert set(name.split(".")) <= known, (page, name)


def test_rooms_stay_small():
    for path in PACKAGE.rglob("*.py"):
        text = path.read_text("utf-8")
        assert text.count("\n") <= 400, f"{path} is over 400 lines long"
        for node in ast.walk(ast.parse(text)):
            if isinstance(node, ast.ClassDef):
                methods = [n for n in node.body if isinstance(n, ast.FunctionDef)]
                assert len(methods) <= 25, f"{node.name} in {path} has {len(methods)} methods"


COMMANDS = [
    "",
    *["demo", "edit", "hybrids", "model", "montage", "restyle", "scribble", "search", "show"],
]


def test_no_command_but_the_window_imports_qt():
    code = (
        "import sys\n"
        "from iconstudio.cli.app import run\n"
        f"for command in {COMMANDS}:\n"
        "    assert run([*command.split(), '--help'], None) == 0\n"
        "    assert not [name for name in sys.modules if name.startswith('PySide6')], command\n"
    )
    run = subprocess.run(
        [sys.executable, "-c", code], cwd=ROOT, capture_output=True, text=True, check=False
    )
    assert run.returncode == 0, run.stderr


@pytest.mark.parametrize("command", ["ruff check .", "ruff format --check .", "mypy"])
def test_code_is_clean(command):
    run = subprocess.run(
        [sys.executable, "-m", *command.split()],
        cwd=ROOT,
        capture_output=True,
        text=True,
        check=False,
    )
    assert run.returncode == 0, run.stdout + run.stderr
