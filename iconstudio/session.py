"""The composition of library and workflows that the command line and the window share.

INTERFACE (being implemented): see the signatures below.
"""

from collections.abc import Iterator
from dataclasses import dataclass

from iconstudio.model import Pictogram, Sketch
from iconstudio.workflows.events import Event

LAMBDAS: tuple[float, ...] = tuple(0.03 * (0.75 / 0.03) ** (i / 7) for i in range(8))


@dataclass(frozen=True, slots=True)
class ModelSettings:
    """Parameters of sketch-based modelling."""

    styles: tuple[str, ...] = ("lightest", "light", "medium", "dark")
    lambdas: tuple[float, ...] = LAMBDAS
    scales: tuple[float, ...] = (0.9, 1.0, 1.1)


class Session:
    """Collection, worker processes and caches of one run of the program."""

    def open(self) -> Iterator[Event]:
        """Open the bundled collection (unpacks it on the very first use), yielding Progress."""

    def search(self, keyword: str, exclude: frozenset[str] = frozenset()) -> tuple[Pictogram, ...]:
        """At most 200 pictograms for the keyword, best first. Raises IconstudioError if none."""

    def prepare(self, keyword: str, exclude=frozenset(), scales=(0.9, 1.0, 1.1)) -> Iterator[Event]:
        """Retrieve, rasterise, and compute distance fields; cached in memory, so that a later
        ``model`` of the same keyword starts at once. Yields Progress."""

    def model(self, sketch: Sketch, settings: ModelSettings = ModelSettings()) -> Iterator[Event]:
        """Sketch-based pictogram modelling (section 4.1): Progress, RegionsFound, StyleMatched,
        StyleSkipped, and Result events as they are ready. Closing the generator cancels the work
        (worker processes busy for it are killed)."""

    def close(self) -> None:
        """End the worker processes."""
