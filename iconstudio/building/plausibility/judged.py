"""Sketches whose results were judged by eye, and the judgements.

``sketches.json`` has the sketches, ``cells.csv`` what was said of their results as they were cut
for a lambda_S, and of those of two sources, whose numbers it gives: 0 implausible, 1 plausible, 2
fit to be handed over. ``examples.csv.xz`` has the features of these and of others.
"""

import csv
import io
import lzma
from collections.abc import Iterable
from dataclasses import dataclass
from pathlib import Path
from typing import Annotated

from msgspec import Meta

from iconstudio.algorithms.iconification.plausibility import FEATURES
from iconstudio.inputs import json
from iconstudio.inputs.formats import Many, Points, Record, Text, TextSet
from iconstudio.model import Polygon, Sketch

PLAUSIBLE = 1
"""The least grade of a plausible result."""
FIT = 2
"""The grade of one that is fit to be handed over."""


class JudgedSketch(Record, frozen=True, kw_only=True):
    """A sketch."""

    name: Text
    keyword: Text
    polygon: Points
    exclude: TextSet = frozenset()
    held_out: bool = False
    """Whether weights are measured on its results, and never fitted to them."""

    @property
    def sketch(self) -> Sketch:
        """The value."""
        return Sketch(Polygon.of(self.polygon), self.keyword, self.exclude)


class SketchesFile(Record, frozen=True):
    """All of them."""

    sketches: Many[JudgedSketch]


Grade = Annotated[int, Meta(ge=0, le=2)]
Cell = tuple[str, str, float, str]
"""Name of the sketch, style, lambda_S, and the numbers of the two sources if it is a pair's."""


@dataclass(frozen=True, eq=False, slots=True)
class Example:
    """A picture's features, and whether it is plausible."""

    sketch: str
    kind: str
    """``judged``, or how it was made."""
    grade: int
    features: dict[str, float]
    held_out: bool = False

    @property
    def plausible(self) -> bool:
        """Whether it is."""
        return self.grade >= PLAUSIBLE


def read_sketches(folder: Path) -> tuple[JudgedSketch, ...]:
    """Return the sketches of a folder.

    Raises
    ------
    IconstudioError
        If the file is no good.
    """
    return json.read(folder / "sketches.json", SketchesFile).sketches


def read_grades(folder: Path) -> dict[Cell, int]:
    """Return the judgements of a folder."""
    with (folder / "cells.csv").open(encoding="utf-8", newline="") as file:
        return {
            (row["sketch"], row["style"], float(row["lambda_s"]), row["sources"]): int(row["grade"])
            for row in csv.DictReader(file)
        }


def read_examples(folder: Path) -> tuple[Example, ...]:
    """Return the examples of a folder."""
    text = lzma.decompress((folder / "examples.csv.xz").read_bytes()).decode()
    return tuple(
        Example(
            row["sketch"],
            row["kind"],
            int(row["grade"]),
            {name: float(row[name]) for name in FEATURES},
            row["held_out"] == "1",
        )
        for row in csv.DictReader(io.StringIO(text))
    )


def write_examples(folder: Path, examples: Iterable[Example]) -> None:
    """Write the examples of a folder."""
    text = io.StringIO()
    rows = csv.writer(text, lineterminator="\n")
    rows.writerow(["sketch", "kind", "grade", "held_out", *FEATURES])
    for one in examples:
        values = (f"{one.features[name]:.4g}" for name in FEATURES)
        rows.writerow([one.sketch, one.kind, one.grade, int(one.held_out), *values])
    (folder / "examples.csv.xz").write_bytes(lzma.compress(text.getvalue().encode()))
