"""Line styles: speed, what it costs as lines and examples grow, and what others draw.

Seconds are those of a processor, but for a whole set, and for the peers.

``python -m tests.benchmarks.line_styles`` prints tables; ``--readme`` writes them into the README.
The peers need ``inkscape``, and ``node`` with ``npm install roughjs`` done in the current folder;
one that is not there is left out.
"""

import argparse
import statistics
import subprocess
import sys
import tempfile
from collections.abc import Callable, Iterator
from pathlib import Path
from resource import RUSAGE_CHILDREN, getrusage
from time import perf_counter, process_time

import numpy as np

from iconstudio.algorithms.curves.multiresolution import analogy
from iconstudio.algorithms.curves.outline import path_of
from iconstudio.algorithms.curves.parameters import Parameters
from iconstudio.algorithms.curves.pyramid import pyramid
from iconstudio.algorithms.curves.restyle import prepare, restyled
from iconstudio.inputs.styles import bundled
from iconstudio.session import Session
from tests.benchmarks.line_style_peers import ICONS, peers_table
from tests.benchmarks.readme import put
from tests.benchmarks.scale import Costs, cpu, say, table
from tests.benchmarks.test_curves import example, once
from tests.line_styles import circle

LENGTHS = 200, 400, 800, 1600
EXAMPLES = 300, 600, 1200
ROUNDS = 7
SET = "lucide"


def main() -> None:
    """Measure, and print or write the tables."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--readme", action="store_true")
    wanted = parser.parse_args()
    found = "\n\n".join((speed_table(), *scale_tables(), peers_table()))
    put("line styles", found) if wanted.readme else sys.stdout.write(found + "\n")


def scale_tables() -> Iterator[str]:
    """Yield what a closed line costs as it grows, and as its example does."""
    yield table("length of B", LENGTHS, [_cost(length, 1200) for length in LENGTHS])
    yield table("length of A'", EXAMPLES, [_cost(800, length) for length in EXAMPLES])


def _cost(length: float, of_example: float) -> Costs:
    say(f"A line of {length} units, an example of {of_example}")
    parameters = Parameters()
    preparing, levels = cpu(pyramid, [example(of_example)], parameters, rounds=ROUNDS)
    plain = circle(length / (2 * np.pi))
    drawing, _ = cpu(analogy, levels, plain, parameters, rounds=ROUNDS)
    return {"preparing the example, ms": 1e3 * preparing, "the line, ms": 1e3 * drawing}


def speed_table() -> str:
    """Return what goals there are, and what was measured."""
    rows = [
        "| What | Goal | Measured | Beside it, in the same run |",
        "| --- | --- | --- | --- |",
        _line(),
        *_icons(),
        _whole_set(),
    ]
    return "\n".join(rows)


def _line() -> str:
    say("One line")
    levels = pyramid([example(1200)], Parameters())
    plain = circle(800 / (2 * np.pi))
    compiled, loop = once(compiled=True), once(compiled=False)
    compiled()
    seconds = _median(lambda: analogy(levels, plain, Parameters()))
    times = _median(loop, 1) / _median(compiled)
    return (
        f"| A closed line of 800 units, {len(levels[-1].order.arc)} candidates | 0.10 s "
        f"| {seconds:.2f} s | a pass as a plain loop: {times:,.0f} x as long |"
    )


def _icons() -> Iterator[str]:
    say("Icons")
    with Session() as session:
        icons = [session.lines(session.icon(name)) for name in ICONS]
    for what, goal, coarse in (("coarse", "0.1 s", True), ("finished", "0.5 s", False)):
        times = []
        for style in map(prepare, bundled()):
            for lines in icons:
                pairs = [(line, style) for line in lines]
                restyled(pairs, coarse=coarse)
                began = process_time()
                path_of(restyled(pairs, 1, coarse))
                times.append(process_time() - began)
        yield (
            f"| An icon, {what}: {len(icons)} icons in {len(bundled())} styles, median / most "
            f"| {goal} | {statistics.median(times):.2f} s / {max(times):.2f} s |  |"
        )


def _whole_set() -> str:
    say(f"The set {SET}")
    with tempfile.TemporaryDirectory() as folder:
        began, before = perf_counter(), _of_children()
        wanted = ["restyle", "--set", SET, "--style", "Shaky", "--out", folder]
        subprocess.run([sys.executable, "-P", "-m", "iconstudio", *wanted], check=True)
        seconds, work = perf_counter() - began, _of_children() - before
        count = sum(1 for _ in Path(folder).glob("*.svg"))
    return (
        f"| The set {SET}: {count:,} icons, all cores | 120 s for 1,500 | {seconds:.0f} s "
        f"| {work:.0f} s of a processor |"
    )


def _of_children() -> float:
    """Return the seconds of processors that ended processes took."""
    used = getrusage(RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


def _median(work: Callable[[], object], rounds: int = ROUNDS) -> float:
    times = []
    for _ in range(rounds):
        began = process_time()
        work()
        times.append(process_time() - began)
    return statistics.median(times)


if __name__ == "__main__":
    main()
