"""The examples in the docstrings of the model and the algorithms hold."""

import doctest
from importlib import import_module
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[1]
MODULES = [
    ".".join(path.relative_to(ROOT).with_suffix("").parts)
    for package in ("model", "algorithms")
    for path in sorted((ROOT / "iconstudio" / package).rglob("*.py"))
    if ">>> " in path.read_text("utf-8")
]


@pytest.mark.parametrize("module", MODULES)
def test_docstring_examples_hold(module):
    failed, attempted = doctest.testmod(import_module(module))
    assert attempted and not failed
