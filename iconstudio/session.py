"""One run of the program: the collection, its caches and the worker processes, joined to workflows.

The command line and the window both talk to a ``Session``; neither composes algorithms itself.
"""

import threading
from collections import OrderedDict
from collections.abc import Generator, Iterator
from pathlib import Path

from iconstudio.algorithms.matching import SCALES, PreparedExemplar, prepare
from iconstudio.library.collection import Collection, cache_folder
from iconstudio.library.rasters import RasterCache
from iconstudio.library.resvg import render_placed
from iconstudio.model import Exemplar, Pictogram, Sketch
from iconstudio.workers import Workers
from iconstudio.workflows.events import Event, Progress, Retrieved
from iconstudio.workflows.modelling import ModelSettings, model

_KEPT = 3
"""How many keywords stay prepared: some 100 MiB each."""

_Key = tuple[str, frozenset[str], tuple[float, ...]]


class Session:
    """The collection, its caches and the worker processes of one run.

    All methods may be called from any thread; the generators work while they are iterated, and
    closing them cancels the work.
    """

    def __init__(self, cache: Path | None = None) -> None:
        self._cache = cache or cache_folder()
        self._workers = Workers()
        self._rasters = RasterCache(self._cache / "rasters", self._workers)
        self._collection: Collection | None = None
        self._opening = threading.Lock()
        self._prepared: OrderedDict[_Key, tuple[PreparedExemplar, ...]] = OrderedDict()

    def open(self) -> Iterator[Progress]:
        """Open the bundled collection, which the very first use unpacks."""
        with self._opening:
            if self._collection is None:
                steps = Collection.opening(cache=self._cache)
                try:
                    while True:
                        step = next(steps)
                        yield Progress("search", step.done, step.message)
                except StopIteration as end:
                    self._collection = end.value

    @property
    def collection(self) -> Collection:
        """The bundled collection, opened if need be."""
        for _ in self.open():
            pass
        assert self._collection is not None
        return self._collection

    @property
    def trouble(self) -> str | None:
        """A sentence for the user if drawings cannot be kept in the cache, else None."""
        return self._rasters.trouble

    def search(self, keyword: str, exclude: frozenset[str] = frozenset()) -> tuple[Pictogram, ...]:
        """Return at most 200 pictograms for a keyword, best first (section 3.1).

        Raises
        ------
        IconstudioError
            If there is none; it says what is near.
        """
        return self.collection.search(keyword, exclude=exclude)

    def rasterise(
        self, pictograms: tuple[Pictogram, ...]
    ) -> Generator[Progress, None, tuple[Exemplar, ...]]:
        """Rasterise pictograms, in their order; one that cannot be drawn is left out."""
        found: dict[int, Exemplar] = {}
        for done, (index, drawn) in enumerate(self._rasters.exemplars(pictograms), start=1):
            if isinstance(drawn, Exemplar):
                found[index] = drawn
            yield Progress("prepare", done / len(pictograms), "Drawing the icons")
        return tuple(found[index] for index in sorted(found))

    def prepare(
        self,
        keyword: str,
        exclude: frozenset[str] = frozenset(),
        scales: tuple[float, ...] = SCALES,
    ) -> Generator[Event, None, tuple[PreparedExemplar, ...]]:
        """Retrieve and rasterise a keyword's icons, and compute their distance fields.

        Yields ``Progress``, and ``Retrieved`` once the icons are drawn; returns the prepared
        exemplars, best first. They are kept in memory, so that a later ``model`` of the keyword
        starts at once.
        """
        key = keyword.strip().casefold(), exclude, scales
        kept = self._prepared.get(key)
        if kept is not None:
            yield Retrieved(keyword, tuple(one.exemplar for one in kept))
            return kept
        yield from self.open()
        yield Progress("search", 0.0, f"Looking for “{keyword}”")
        pictograms = self.search(keyword, exclude)
        exemplars = yield from self.rasterise(pictograms)
        yield Retrieved(keyword, exemplars)
        ready = []
        for number, exemplar in enumerate(exemplars, start=1):
            ready.append(prepare(exemplar, scales))
            yield Progress("prepare", number / len(exemplars), "Measuring distances")
        self._prepared[key] = tuple(ready)
        while len(self._prepared) > _KEPT:
            self._prepared.popitem(last=False)
        return self._prepared[key]

    def model(self, sketch: Sketch, settings: ModelSettings | None = None) -> Iterator[Event]:
        """Run sketch-based modelling (section 4.1): see ``workflows.modelling.model``.

        Raises
        ------
        IconstudioError
            If the polygon or the keyword is no good; before any work is done.
        """
        settings = settings or ModelSettings()
        settings.chosen_styles()
        sketch.polygon.fitted()
        exemplars = yield from self.prepare(sketch.keyword, sketch.exclude, settings.scales)
        yield from model(sketch, exemplars, settings, self._workers, render_placed)

    def close(self) -> None:
        """End the worker processes and close the collection."""
        self._workers.close()
        if self._collection is not None:
            self._collection.close()
            self._collection = None

    def __enter__(self) -> "Session":
        return self

    def __exit__(self, *exc: object) -> None:
        self.close()
