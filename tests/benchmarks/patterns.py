"""Patterns: speed, what it costs as sizes, layers and exemplars grow, and what others make.

``python -m tests.benchmarks.patterns`` prints tables; ``--readme`` writes them into the README.
G'MIC (``gmic``) is left out where it is not installed.
"""

import argparse
import statistics
import sys
from collections.abc import Iterator

import numpy as np

from iconstudio.algorithms.patterns.exemplar import Exemplar
from iconstudio.algorithms.patterns.prepared import Prepared
from iconstudio.algorithms.patterns.synthesis import Settings, synthesised
from iconstudio.reading import returned
from iconstudio.resources import resource
from iconstudio.session import Session
from iconstudio.workflows.files import read_file
from iconstudio.workflows.pattern.drawing import SAMPLES
from iconstudio.workflows.pattern.layout import Arrangement
from iconstudio.workflows.pattern.spec import PATTERN
from tests.benchmarks.pattern_peers import peers_table, processor
from tests.benchmarks.readme import put
from tests.benchmarks.scale import Costs, cpu, say, table

SINGLE = "garden", "cats", "sea", "fruit", "night", "music", "forest", "tea"
"""Exemplars of one layer; none was looked at while the algorithm was made."""
SIZES = 128, 256, 512
LAYERS = 1, 2, 3
ROUNDS = 5


def main() -> None:
    """Measure, and print or write the tables."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--readme", action="store_true")
    wanted = parser.parse_args()
    with Session() as session:
        exemplars = {name: exemplar(session, name) for name in SINGLE}
    found = "\n\n".join(
        (speed_table(exemplars["garden"]), *scale_tables(exemplars["garden"]),
         peers_table(exemplars))
    )  # fmt: skip
    put("patterns", found) if wanted.readme else sys.stdout.write(found + "\n")


def exemplar(session: Session, name: str) -> Exemplar:
    """Return an example of the program as an exemplar of 128 x 128 pixels."""
    path = resource("examples") / "patterns" / f"{name}.json"
    work = returned(read_file(path, PATTERN, session))
    paths = [session.drawing(session.exemplar(one.icon)).path for one in work.motifs]
    return Arrangement.of(work, paths).layout(SAMPLES).exemplar


def speed_table(given: Exemplar) -> str:
    """Return what goals there are, and what was measured."""
    rows = ["| What | Goal | Measured |", "| --- | --- | --- |"]
    goals = {256: 2.5, 512: 10.0}
    list(synthesised(Prepared.of(given), Settings((64, 64))))  # compiles
    for side, goal in goals.items():
        say(f"{side} x {side}")
        times = [_timed(given, side, seed) for seed in range(ROUNDS)]
        first, whole = (statistics.median(some) for some in zip(*times, strict=True))
        rows.append(f"| {side} x {side} of 128 x 128, one layer | {goal:g} s | {whole:.1f} s |")
        if side == 256:
            rows.append(f"| its first preview | 0.4 s | {first:.2f} s |")
    return "\n".join(rows)


def _timed(given: Exemplar, side: int, seed: int) -> tuple[float, float]:
    """Return the seconds of a processor until the first preview, and the end."""
    began = processor()
    times = [
        processor() - began
        for _ in synthesised(Prepared.of(given), Settings((side, side), True, seed))
    ]
    return times[0], times[-1]


def scale_tables(given: Exemplar) -> Iterator[str]:
    """Yield what a pattern costs as it grows, as its exemplar does, and with its layers."""
    yield table("side of the pattern", SIZES, [_cost(given, side) for side in SIZES])
    sides = [64, 96, 128]
    yield table("side of the exemplar", sides, [_cost(_part(given, side), 256) for side in sides])
    yield layers_table(given)


def layers_table(given: Exemplar) -> str:
    """Return what a pattern costs with the same elements in more layers; three: at most twice."""
    return table("layers", LAYERS, [_cost(_layered(given, count), 256) for count in LAYERS])


def _cost(given: Exemplar, side: int) -> Costs:
    preparing, prepared = cpu(Prepared.of, given)
    drawing, _ = cpu(lambda: list(synthesised(prepared, Settings((side, side), True))), rounds=3)
    return {"preparing the exemplar, s": preparing, "the pattern, s": drawing}


def _layered(given: Exemplar, count: int) -> Exemplar:
    """Return an exemplar of one layer with its elements in so many."""
    labels = given.labels[0]
    masks = [given.masks[0] * (labels % count == layer) * (labels > 0) for layer in range(count)]
    own = [np.where(labels % count == layer, labels, 0) for layer in range(count)]
    return Exemplar(given.colours, np.stack(masks), np.stack(own))


def _part(given: Exemplar, side: int) -> Exemplar:
    labels = None if given.labels is None else given.labels[:, :side, :side]
    return Exemplar(np.ascontiguousarray(given.colours[:side, :side]),
                    np.ascontiguousarray(given.masks[:, :side, :side]), labels)  # fmt: skip


if __name__ == "__main__":
    main()
