"""What everything costs as the collection, the retrieved set, K and m grow.

``python -m tests.benchmarks.scale`` prints tables with the exponents p of cost = c size^p, fitted
to the logarithms; ``--readme`` writes them into the README. Costs are seconds of a processor, so
that other programs on the machine disturb them little.
"""

import argparse
import multiprocessing
import random
import statistics
import sys
import tempfile
from collections.abc import Callable, Iterable, Iterator, Sequence
from pathlib import Path
from time import process_time
from typing import Any

import numpy as np

from iconstudio.algorithms.iconification.alpha_expansion import AlphaExpansion
from iconstudio.algorithms.iconification.energy import distance_field, remix_problem
from iconstudio.algorithms.iconification.matching import Matcher, prepare, sources_of
from iconstudio.algorithms.iconification.saliency import Region
from iconstudio.algorithms.iconification.style import STYLES
from iconstudio.algorithms.iconification.tsdf import tsdf
from iconstudio.algorithms.raster import fill_polygon
from iconstudio.library.collection import Collection
from iconstudio.model import CANVAS, Exemplar, IconstudioError, Polygon, Source
from iconstudio.session import Session
from iconstudio.svg.rasterise import rasterise
from iconstudio.workflows.grid import LAMBDAS, distinct
from iconstudio.workflows.modelling.file import example
from tests.benchmarks.grown import write_collection
from tests.benchmarks.readme import put
from tests.shapes import regions_of

COLLECTIONS = (1_000, 10_000, 102_500, 410_000)
RETRIEVED = (50, 200, 1000)
LABELS = (5, 15, 27, 40, 60)
SIDES = (128, 256, 512)
QUERIES = 1000
WORDS = ("motorcycle", "bicycle", "car", "house", "star", "arrow", "cloud", "heart", "phone", "dog")

Costs = dict[str, float]
"""What was measured at one size, by name."""


def cpu(work: Callable[..., Any], *args: Any, rounds: int = 1) -> tuple[float, Any]:
    """Call a function, and return the seconds of a processor that it took, and its value.

    All threads count; of several rounds, the quickest does.
    """
    times, value = [], None
    for _ in range(rounds):
        began = process_time()
        value = work(*args)
        times.append(process_time() - began)
    return min(times), value


def say(message: str) -> None:
    """Say what is under way."""
    print(message, file=sys.stderr, flush=True)


# The collection


def collection_costs(folder: Path) -> Iterator[Costs]:
    """Build collections, open them, and search them for the same words."""
    words: list[str] = []
    for count in COLLECTIONS:
        say(f"A collection of {count:,} icons")
        source, cache = folder / f"source-{count}", folder / f"cache-{count}"
        write_collection(source, count)
        first = alone(first_opening, source, cache)
        words = words or known_words(source, cache)
        later = alone(later_opening, source, cache, words)
        (database,) = cache.glob("*.sqlite")
        yield first | later | {"database, MB": database.stat().st_size / 1e6}


def alone(function: Callable[..., Costs], *args: Any) -> Costs:
    """Call a function in a process of its own, as its memory is measured."""
    with multiprocessing.get_context("spawn").Pool(1) as pool:
        return pool.apply(function, args)


def first_opening(source: Path, cache: Path) -> Costs:
    """Unpack a collection."""
    before = held("VmRSS")
    seconds, _ = cpu(lambda: Collection.open(source, cache).close())
    return {"first opening, s": seconds, "first opening, MiB at most": held("VmHWM") - before}


def later_opening(source: Path, cache: Path, words: Sequence[str]) -> Costs:
    """Open a collection that is unpacked, and search it."""
    before = held("VmRSS")
    seconds, _ = cpu(lambda: Collection.open(source, cache).close(), rounds=3)
    with Collection.open(source, cache) as collection:
        times = [cpu(collection.search, word)[0] for word in words]
    median, high = statistics.median(times), statistics.quantiles(times, n=20)[-1]
    return {
        "later opening, ms": 1e3 * seconds,
        "search, median, ms": 1e3 * median,
        "search, 95th of 100, ms": 1e3 * high,
        "opened and searched, MiB": held("VmHWM") - before,
    }


def known_words(source: Path, cache: Path) -> list[str]:
    """Return random words that retrieve something."""
    found: list[str] = []
    with Collection.open(source, cache) as collection:
        listed = collection._rows("SELECT DISTINCT word FROM relation ORDER BY word")
        for (word,) in random.Random(3).sample(listed, len(listed)):
            try:
                collection.search(word)
            except IconstudioError:
                continue
            found.append(word)
            if len(found) == QUERIES:
                break
    return found


def held(when: str) -> float:
    """Return how much memory this process holds ("VmRSS") or has held at most ("VmHWM"), in MiB."""
    lines = Path("/proc/self/status").read_text().splitlines()
    return next(int(line.split()[1]) for line in lines if line.startswith(when)) / 2**10


# The retrieved set


def retrieved_costs(exemplars: Sequence[Exemplar]) -> Iterator[Costs]:
    """Draw, measure and match so many icons, whatever word has them."""
    field, regions = wanted()
    value_of(Matcher([*map(prepare, exemplars[:2])]).match(field, regions, range(2)))  # compiles
    for count in RETRIEVED:
        say(f"{count} retrieved icons")
        some = exemplars[:count]
        drawing, _ = cpu(list, (rasterise(one.pictogram.svg) for one in some))
        measuring, ready = cpu(list, map(prepare, some))
        joining, matcher = cpu(Matcher, ready)
        matching, _ = cpu(value_of, matcher.match(field, regions, range(count)))
        yield {
            "drawing, s": drawing,
            "distance fields and spectra, s": measuring,
            "matching, s": joining + matching,
        }


# K, and m


def label_costs(sources: Sequence[Source]) -> Iterator[Costs]:
    """Solve remixes of so many sources."""
    for count in LABELS:
        say(f"K = {count}")
        yield solving_costs(sources[:count], CANVAS)


def side_costs(sources: Sequence[Source]) -> Iterator[Costs]:
    """Solve a remix of the medium style on canvases of other sides."""
    for side in SIDES:
        say(f"m = {side}")
        yield solving_costs(sources, side)


def solving_costs(sources: Sequence[Source], side: int) -> Costs:
    """Solve a remix for all lambda_S, which weigh more on a finer canvas (see ``RemixProblem``)."""
    polygon = outline()
    target = distance_field(fill_polygon(polygon, side))
    posing, problem = cpu(remix_problem, target, sources)
    weights = [value * side / CANVAS for value in LAMBDAS]

    def solve_all() -> None:
        expansion = AlphaExpansion(problem)
        for weight in weights:
            expansion.find(weight, weights)

    arrays = (problem.data, problem.ink, problem.solid, problem.patches, problem.penalty)
    solving, _ = cpu(solve_all, rounds=2)  # the first one may have to compile
    preview, _ = cpu(lambda: AlphaExpansion(problem).preview(weights[4]), rounds=2)
    return {
        "posing, s": posing,
        "8 lambda_S, s": solving,
        "preview of one, s": preview,
        "arrays, MiB": sum(array.nbytes for array in arrays) / 2**20,
    }


# What is measured on


def outline() -> Polygon:
    return example("motorbike").sketch.polygon.fitted()


def wanted() -> tuple[np.ndarray, tuple[Region, ...]]:
    """Return field and regions of the motorbike."""
    return tsdf(fill_polygon(outline())), regions_of(outline())


def value_of(steps: Any) -> Any:
    """Return what a generator returns."""
    while True:
        try:
            next(steps)
        except StopIteration as end:
            return end.value


def retrieved(count: int) -> list[Exemplar]:
    """Return icons of several words."""
    found: dict[str, Exemplar] = {}
    with Session() as session:
        for word in WORDS:
            pictograms = session.collection.search(word, limit=count)
            for one in value_of(session.rasterise(pictograms)):
                found.setdefault(one.id, one)
            if len(found) >= count:
                return [*found.values()][:count]
    raise SystemExit(f"The words have {len(found)} icons only.")


def matched(styles: Iterable[str]) -> tuple[Source, ...]:
    """Return the sources that the motorbike's regions get in some styles."""
    with Session() as session:
        matcher = value_of(session.prepare(example("motorbike").sketch.keyword))
    rows = []
    for style in STYLES:
        if style.name in styles:
            admitted = [i for i, one in enumerate(matcher.exemplars) if style.admits(one.blackness)]
            matches = value_of(matcher.match(*wanted(), admitted))
            rows += sources_of(matches, matcher.exemplars)
    return distinct(rows)


# The tables


def table(name: str, sizes: Sequence[int], costs: Sequence[Costs]) -> str:
    """Return a table with a row for each cost, and its exponent."""
    head = [name, *(f"{size:,}" for size in sizes), "exponent"]
    lines = [head, ["---"] + ["--:"] * (len(head) - 1)]
    for what in costs[0]:
        values = [one[what] for one in costs]
        exponent = np.polyfit(np.log(sizes), np.log(np.maximum(values, 1e-6)), 1)[0]
        lines.append([what, *map(rounded, values), f"{exponent:.2f}"])
    return "\n".join(f"| {' | '.join(cells)} |" for cells in lines)


def rounded(value: float) -> str:
    """Return a number with two digits that count."""
    return f"{value:,.0f}" if value >= 10 else f"{value:.2g}"


def all_tables() -> Iterator[str]:
    with tempfile.TemporaryDirectory() as folder:
        yield table("icons in the collection", COLLECTIONS, [*collection_costs(Path(folder))])
    exemplars = retrieved(max(RETRIEVED))
    yield table("icons retrieved", RETRIEVED, [*retrieved_costs(exemplars)])
    every = list(matched(style.name for style in STYLES))
    random.Random(5).shuffle(every)
    yield table("labels K", LABELS, [*label_costs(every)])
    yield table("side m", SIDES, [*side_costs(matched(["medium"]))])


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--readme", action="store_true", help="write the tables into the README")
    asked = parser.parse_args()
    tables = []
    for one in all_tables():
        print(one, end="\n\n", flush=True)
        tables.append(one)
    if asked.readme:
        put("scale", "\n\n".join(tables))


if __name__ == "__main__":
    main()
