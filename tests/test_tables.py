"""The tables of measured figures that the README shows."""

import json
import re
from pathlib import Path

import pytest

from iconstudio.library.collection import Collection
from tests.benchmarks import readme, table
from tests.benchmarks.grown import write_collection
from tests.benchmarks.table import Measured

BENCHMARKS = Path(table.__file__).parent


def test_text_is_put_between_its_markers(tmp_path):
    page = tmp_path / "README.md"
    page.write_text("a\n<!-- one -->\nold\n<!-- end -->\nb\n<!-- two -->\n<!-- end -->\n")
    readme.put("one", r"new \1", page)
    readme.put("two", "more", page)
    readme.put("one", "newer", page)
    assert page.read_text() == (
        "a\n<!-- one -->\n\nnewer\n\n<!-- end -->\nb\n<!-- two -->\n\nmore\n\n<!-- end -->\n"
    )
    with pytest.raises(ValueError, match="three"):
        readme.put("three", "lost", page)


@pytest.mark.parametrize("name", ["goals", "scale"])
def test_the_readme_has_room_for_both_tables(name, tmp_path):
    copy = tmp_path / "README.md"
    copy.write_text(readme.README.read_text("utf-8"), "utf-8")
    readme.put(name, "figures", copy)
    assert "\n\nfigures\n\n<!-- end -->" in copy.read_text("utf-8")


class Asked(Measured):
    """Has every figure, and knows which were wanted."""

    def __init__(self):
        self.names = set()

    def __getitem__(self, name):
        self.names.add(name)
        return 1.0

    def notes(self, test):
        self.names.add(test)
        return {"stage": "12.5 / 3"}

    def pairs(self, first, second, note):
        self.names |= {f"{first}: {note}", f"{second}: {note}"}
        return [([1.0], [2.0])]


def test_every_figure_has_a_benchmark():
    asked = Asked()
    for row in table.ROWS:
        assert "not measured" not in row.cells(asked)
    assert len(asked.names) > 15
    for name in asked.names:
        file, test, note = re.fullmatch(r"(\w+)\.(\w+)(?:\[.+\])?(?:: (.+))?", name).groups()
        source = (BENCHMARKS / f"test_{file}.py").read_text("utf-8")
        assert f"def {test}(" in source, name
        assert note is None or f'"{note}"' in source, name
        assert file in table.FILES


def test_the_table_is_made_of_what_was_measured(tmp_path):
    def wrote(file, *tests):
        found = [
            {"name": name, "param": param, "stats": {"median": seconds}, "extra_info": extra}
            for name, param, seconds, extra in tests
        ]
        (tmp_path / f"{file}.json").write_text(json.dumps({"benchmarks": found}))

    wrote("keyword", ("test_cold", None, 3.21, {}), ("test_from_cache", None, 0.056, {}),
          ("test_plainly", None, 16.05, {}))  # fmt: skip
    wrote("solver", *(
        (f"{test}[{param}]", param, seconds, {"energies": energies})
        for param, factor in (("a", 1.0), ("b", 2.0))
        for test, seconds, energies in (
            ("test_sweep", factor, [90 * factor, 55]),
            ("test_plain_expansion_begun_anew", 9.0, [100 * factor, 50]),
            ("test_plain_expansion_each_from_the_last", 8.0, [120 * factor, 60]),
        )
    ))  # fmt: skip
    (tmp_path / "montage.json").write_text("")  # as of a run that failed
    lines = table.table(table.read(tmp_path)).splitlines()
    assert "| 3.2 s / 56 ms | 16.1 s, 5.0 x ours: one process, whole transforms |" in lines[2]
    assert "| 1.5 s | 9.0 s, 6.0 x ours: " in next(
        line for line in lines if "8 lambda_S of" in line
    )
    assert any("mean 1.000, worst 1.100, over 2 problems" in line for line in lines)
    assert "not measured" in next(line for line in lines if line.startswith("| Montage"))


def test_a_small_part_of_the_collection_is_a_collection(tmp_path):
    write_collection(tmp_path / "source", 400)
    with Collection.open(tmp_path / "source", tmp_path / "cache") as part:
        assert len(part) == 400
        found = part.search("arrow")
    assert len(found) >= 3
    assert all("<svg" in one.svg for one in found)
