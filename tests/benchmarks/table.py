"""Runs the benchmarks and writes the README's table of goals from what they measured.

``python -m tests.benchmarks.table`` runs all, which takes some 20 minutes, keeps what
pytest-benchmark says in ``.benchmarks/table``, prints the table and puts it into the README.
``--only NAME ...`` runs some files again and takes the others as they were; ``--only`` alone runs
none.
"""

import argparse
import json
import os
import platform
import subprocess
import sys
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from statistics import mean, median
from time import perf_counter
from typing import Any

from tests.benchmarks.readme import put

ROOT = Path(__file__).parents[2]
KEPT = ROOT / ".benchmarks" / "table"
FILES = (
    "keyword", "matching", "solver", "live", "hybrids", "montage", "stages", "tracing", "window",
    "whole_run",
)  # fmt: skip


class Measured:
    """What the benchmarks said, by ``file.test``; of a test with parameters, all of them."""

    def __init__(self, found: Mapping[str, Sequence[Mapping[str, Any]]]) -> None:
        self._found = found

    def __getitem__(self, name: str) -> float:
        """Return the median time of a ``file.test``, or what it noted as ``file.test: note``.

        Of a test with parameters, the median of all; or name one: ``file.test[parameter]``.

        Raises
        ------
        KeyError
            If it did not run.
        """
        test, _, note = name.partition(": ")
        if note:
            return median(one["extra_info"][note] for one in self._found[test])
        return median(one["stats"]["median"] for one in self._found[test])

    def notes(self, test: str) -> Mapping[str, Any]:
        """Return all that a test noted."""
        return self._found[test][0]["extra_info"]

    def pairs(self, first: str, second: str, note: str) -> list[tuple[Any, Any]]:
        """Return what two tests noted with the same parameters."""
        others = {one["param"]: one["extra_info"][note] for one in self._found[second]}
        return [(one["extra_info"][note], others[one["param"]]) for one in self._found[first]]


Say = Callable[[Measured], str]


def time(seconds: float) -> str:
    """Return a time in words."""
    if seconds < 0.0995:
        return f"{1e3 * seconds:.0f} ms"
    return f"{seconds:.2f} s" if seconds < 0.995 else f"{seconds:.1f} s"


def times(*names: str) -> Say:
    """Say what the tests took."""
    return lambda found: " / ".join(time(found[name]) for name in names)


def against(ours: str, plain: str, how: str) -> Say:
    """Say what a plain way took, and how many times ours that is."""
    return lambda found: f"{time(found[plain])}, {found[plain] / found[ours]:.1f} x ours: {how}"


def nothing(found: Measured) -> str:
    """Say nothing."""
    return ""


def same_matches(found: Measured) -> str:
    """Say how often the matches are those of an exhaustive search."""
    test = "matching.test_matches_are_those_of_the_exhaustive_search: "
    same = found[test + "% of regions with the same pictograms"]
    worst = found[test + "worst error ratio where they differ"]
    sketches = found[test + "sketches"]
    return f"{same:.1f}% over {sketches:.0f} sketches, within {100 * (worst - 1):.1f}%"


def energies(found: Measured) -> str:
    """Compare energies with the lower of two plain ways, lambda_S by lambda_S."""
    plain = ("solver.test_plain_expansion_begun_anew",
             "solver.test_plain_expansion_each_from_the_last")  # fmt: skip
    cold, warm = (found.pairs("solver.test_sweep", test, "energies") for test in plain)
    ratios = [
        mine / min(one, other)
        for (ours, begun), (_, followed) in zip(cold, warm, strict=True)
        for mine, one, other in zip(ours, begun, followed, strict=True)
    ]
    return f"mean {mean(ratios):.3f}, worst {max(ratios):.3f}, over {len(cold)} problems"


def preview_energies(found: Measured) -> str:
    """Say how much worse previews are."""
    note = "live.test_drag: energy of the preview / refined, "
    return f"median {found[note + 'median']:.3f}, worst {found[note + 'greatest']:.3f}"


def scores(found: Measured) -> str:
    """Compare the hybrids' rank scores."""
    tests = ("hybrids.test_cuts", "hybrids.test_cuts_by_plain_expansion")
    ours, plain = (found[f"{test}: mean rank score"] for test in tests)
    return f"{ours:.3f}; plainly {plain:.3f}"


def overlap(found: Measured) -> str:
    """Say how like the traced outlines are to what was drawn."""
    note = "tracing.test_draw[at 1024 px]: least overlap with the redrawn sources"
    return f"{found[note]:.3f} at least"


def standstill(found: Measured) -> str:
    """Say when the window stands still longest."""
    longest = {
        stage: float(said.split(" / ")[0])
        for stage, said in found.notes("window.test_gaps").items()
    }
    stage = max(longest, key=longest.__getitem__)
    return f"{longest[stage]:.0f} ms ({stage})"


def memory(found: Measured) -> str:
    """Say how much memory a run takes."""
    note = "whole_run.test_motorbike: peak memory of all processes, MiB"
    return f"{found[note] / 1024:.2f} GiB"


@dataclass(frozen=True)
class Row:
    """A line of the table. What cannot be told, as its benchmark did not run, is left open."""

    what: str
    goal: str
    measured: Say
    plain: Say = nothing
    paper: str = ""

    def cells(self, found: Measured) -> list[str]:
        """Return the line's cells."""
        said = []
        for say in (self.measured, self.plain):
            try:
                said.append(say(found))
            except KeyError:
                said.append("not measured")
        return [self.what, self.goal, *said, self.paper]


ROWS = (
    Row(
        "A keyword of 200 icons made ready: cold / from the cache", "4 s / 0.3 s",
        times("keyword.test_cold", "keyword.test_from_cache"),
        against("keyword.test_cold", "keyword.test_plainly", "one process, whole transforms"),
    ),
    Row(
        "Matching 200 icons x 3 scales x 2 flips x 9 regions", "1.5 s, 30 x plain",
        times("matching.test_match"),
        against("matching.test_match", "matching.test_match_exhaustively: seconds for 200",
                "batched FFT of whole pictures"),
        "140 s, one thread",
    ),
    Row("- the same pictograms as by exhaustive search", "99%, within 1%", same_matches),
    Row(
        "8 lambda_S of one style, some 27 labels, one thread", "4 s, 7 x plain",
        times("solver.test_sweep"),
        against("solver.test_sweep", "solver.test_plain_expansion_begun_anew",
                "cold alpha-expansion by PyMaxflow"),
        "8 x 3 to 11 s",
    ),
    Row("- energy, as part of the lower of two plain ones", "1.01, mean below 1", energies),
    Row(
        "4 styles x 8 lambda_S, from closing the polygon: first / all", "1 s / 8 s",
        times("live.test_full_grid: first result, seconds", "live.test_full_grid"),
        paper="140 s + 32 x 3 to 11 s",
    ),
    Row(
        "After dragging a vertex, the result in focus: preview / refined", "0.5 s / 2 s",
        times("live.test_drag: preview, seconds", "live.test_drag"),
    ),
    Row("- energy of the preview, as part of the refined one", "1.05", preview_energies),
    Row("40 hybrids of 5 icons, symmetric", "6 s", times("hybrids.test_session")),
    Row(
        "- their cuts alone, one thread", "", times("hybrids.test_cuts"),
        against("hybrids.test_cuts", "hybrids.test_cuts_by_plain_expansion", "alpha-expansion"),
    ),
    Row("- mean rank score", "the same", scores),
    Row(
        "Montage of 4 icons after a stroke: result / on the screen", "0.15 s",
        times("montage.test_session", "montage.test_window"),
    ),
    Row("Drawing a result as SVG at 1024 px", "0.15 s", times("stages.test_draw")),
    Row("- IoU with the redrawn sources", "0.99", overlap),
    Row("From starting the program to a painted window, and its end", "1.5 s",
        times("window.test_opening")),
    Row("The longest that the window stands still", "50 ms", standstill),
    Row("Memory of all processes at the peak of a run", "1.5 GiB", memory),
)  # fmt: skip


def run(name: str) -> None:
    """Run one file's benchmarks, and keep what they say."""
    began = perf_counter()
    print(f"{name}: ", end="", flush=True)
    KEPT.mkdir(parents=True, exist_ok=True)
    made = KEPT / f"{name}.json"
    made.unlink(missing_ok=True)
    test = f"tests/benchmarks/test_{name}.py"
    options = ["--benchmark-only", f"--benchmark-json={made}", "--timeout=1800"]
    command = [sys.executable, "-m", "pytest", "-n", "0", test, *options]
    done = subprocess.run(command, cwd=ROOT, capture_output=True, text=True)
    print(f"{perf_counter() - began:.0f} s", flush=True)
    if done.returncode:
        print(done.stdout[-3000:], done.stderr[-1000:], file=sys.stderr, flush=True)


def read(folder: Path = KEPT) -> Measured:
    """Return what was kept of all files."""
    found: dict[str, list[Mapping[str, Any]]] = {}
    for path in sorted(folder.glob("*.json")):
        text = path.read_text("utf-8")
        for one in json.loads(text)["benchmarks"] if text else ():
            test = one["name"].partition("[")[0]
            for name in {test, one["name"]}:
                found.setdefault(f"{path.stem}.{name}", []).append(one)
    return Measured(found)


def table(found: Measured) -> str:
    """Return the table, and on what it was measured."""
    head = ["What", "Goal", "Measured", "The plain way, in the same run", "The paper"]
    lines = [head, ["---"] * len(head), *(row.cells(found) for row in ROWS)]
    return "\n".join(f"| {' | '.join(cells)} |" for cells in lines) + f"\n\n{machine()}"


def machine() -> str:
    """Say on what was measured."""
    model, info = platform.machine(), Path("/proc/cpuinfo")
    for line in info.read_text().splitlines() if info.exists() else ():
        if line.startswith("model name"):
            model = line.partition(":")[2].strip()
    return f"Medians on {os.cpu_count()} processors ({model}), Python {platform.python_version()}."


def main() -> None:
    """Run what is asked for, and write the table."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--only", nargs="*", choices=FILES, help="run these files alone")
    only = parser.parse_args().only
    for name in FILES if only is None else only:
        run(name)
    text = table(read())
    print(f"\n{text}")
    put("goals", text)


if __name__ == "__main__":
    main()
