"""One run of the program: the collection, its caches and the worker processes, joined to workflows.

The command line and the window both talk to a ``Session``; neither composes algorithms itself.
"""

import gc
import threading
from collections import OrderedDict
from collections.abc import Generator, Iterator
from contextlib import AbstractContextManager
from functools import lru_cache, partial
from pathlib import Path as File
from typing import TypeVar

import numpy as np
from numpy.typing import NDArray

from iconstudio.algorithms.iconification.matching import SCALES, Matcher, PreparedExemplar
from iconstudio.algorithms.iconification.plausibility import Plausibility
from iconstudio.algorithms.iconification.strangers import strangers
from iconstudio.algorithms.iconification.style import has_pale_areas
from iconstudio.caches.preparing import PreparingCache
from iconstudio.caches.rasters import RasterCache
from iconstudio.caches.samples import SampleCache
from iconstudio.files import remove_abandoned
from iconstudio.inputs.plausibility import read_plausibility
from iconstudio.library.collection import Collection, cache_folder
from iconstudio.loading import Libraries, load_module
from iconstudio.model import (
    Axis,
    Composite,
    Drawing,
    Exemplar,
    IconstudioError,
    Line,
    LineStyle,
    Path,
    Pictogram,
    Placement,
    Source,
)
from iconstudio.model.pictogram import NAMELESS, UNCOLLECTED
from iconstudio.reading import MEMORY as READING_MEMORY
from iconstudio.reading import SECONDS as READING_SECONDS
from iconstudio.reading import SIMPLER, FileReader
from iconstudio.svg import lines
from iconstudio.svg.placed import render_placed
from iconstudio.workers import Workers, answer, loss
from iconstudio.workflows.drawing import MEMORY, SECONDS, draw_whole
from iconstudio.workflows.estimating import estimated
from iconstudio.workflows.events import Event, Progress, Retrieved
from iconstudio.workflows.hybrids.selection import select
from iconstudio.workflows.line_style.sampling import sampled
from iconstudio.workflows.solving import warm_up
from iconstudio.workflows.workflow import Workflow

_PLENTY = 8
"""With so many others, icons of two tones are left out: only their dark part could be used."""
_LINES_SECONDS = 5.0
"""How long reading the lines of an icon's own shapes may take."""
_KEPT = 3
"""How many keywords stay prepared: at most 70 MiB each."""

_AT_HAND = 100
"""How many icons stay drawn in memory, 64 KiB each: every stroke of a montage asks for all of its
own."""

_SLOW_TO_LOAD = (
    "scipy.ndimage",
    "scipy.spatial",
    "scipy.special",
    "shapely",
    "PIL.ImageDraw",
)
"""Libraries that are not loaded before their first use, so that the window opens soon; SciPy loads
its parts when they are first named."""
_COMPILED = ("numpy", "scipy", "shapely", "PIL", "skimage", "numba", "llvmlite")
"""What is read before it is loaded, some 300 MB."""

T = TypeVar("T")
W = TypeVar("W")
_Key = tuple[str, frozenset[str], tuple[float, ...]]


class Session(FileReader, AbstractContextManager["Session"]):
    """The collection, its caches and the worker processes of one run.

    All methods may be called from any thread; the generators work while they are iterated, and
    closing them cancels the work.
    """

    def __init__(self, cache: File | None = None) -> None:
        super().__init__()
        self._cache = cache or cache_folder()
        self.workers = Workers()
        self.libraries = Libraries(*_COMPILED)
        self.render = render_placed
        self._rasters = RasterCache(self._cache / "rasters", self.workers)
        self._single = RasterCache(self._cache / "rasters", self._readers)
        self._preparing = PreparingCache(self._cache / "prepared", self.workers)
        self._samples = SampleCache(self._cache / "samples")
        self._collection: Collection | None = None
        self._opening = threading.Lock()
        self._cold = self._lines_unexpected = True
        self._prepared: OrderedDict[_Key, tuple[Retrieved, Matcher]] = OrderedDict()
        self._drawn = lru_cache(_AT_HAND)(self._draw)
        self._lines = lru_cache(_AT_HAND)(self._read_lines)
        self._traced = lru_cache(_AT_HAND)(partial(_traced, self.workers))
        self.earlier: dict[str, Composite] = {}
        self.plausibility, self._unlearned = _learned()

    def open(self) -> Iterator[Progress]:
        """Open the bundled collection, which the very first use unpacks."""
        with self._opening:
            if self._collection is None:
                self._collection = yield from Collection.opening(cache=self._cache)

    def get_ready(self) -> Iterator[Progress]:
        """Open the collection, and have the worker processes and libraries ready to remix.

        The very first time the workers compile what cuts, which takes some seconds; later it is at
        hand.
        """
        yield from self.open()
        cold, self._cold = self._cold, False
        if cold:
            self.workers.everywhere(warm_up, render_placed)
            for cache in ("rasters", "prepared", "samples"):
                self.workers.submit(remove_abandoned, self._cache / cache)
            self.libraries.read()
            for name in _SLOW_TO_LOAD:
                load_module(name)
            gc.freeze()  # They stay: they need not be looked through for garbage.

    @property
    def collection(self) -> Collection:
        """The bundled collection, opened if need be."""
        for _ in self.open():
            pass
        assert self._collection is not None
        return self._collection

    @property
    def trouble(self) -> str | None:
        """A sentence for the user if drawings cannot be kept or results judged, else None."""
        return self._rasters.trouble or self._preparing.trouble or self._unlearned

    def search(self, keyword: str, exclude: frozenset[str] = frozenset()) -> tuple[Pictogram, ...]:
        """Return at most 200 pictograms for a keyword, best first (section 3.1).

        Raises
        ------
        IconstudioError
            If there is none; it says what is near.
        """
        return self.collection.search(keyword, exclude=exclude)

    def icon(self, reference: str) -> Pictogram:
        """Return an icon of the collection, ``set:name``, or of a file: an SVG, or a scan.

        Of a sprite sheet, ``FILE.svg#id`` is one symbol.

        Raises
        ------
        IconstudioError
            If there is no such icon, or the file is no good.
        """
        if (own := self.icon_in(reference)) is not None:
            return own
        try:
            return self.collection.get(reference)
        except IconstudioError as error:
            if "/" in reference:
                raise IconstudioError(f"There is no such file “{reference}”. {error}") from None
            raise

    def exemplar(self, pictogram: Pictogram) -> Exemplar:
        """Return a pictogram on the canvas.

        Raises
        ------
        IconstudioError
            If it has no dark ink, or cannot be drawn.
        """
        return self._drawn(pictogram)

    def _draw(self, pictogram: Pictogram) -> Exemplar:
        ((_, drawn),) = self._single.exemplars((pictogram,))
        if isinstance(drawn, IconstudioError):
            raise drawn
        return drawn

    def drawing(self, exemplar: Exemplar) -> Drawing:
        """Return an icon drawn and traced as results are: crisp at any size."""
        return self._traced(exemplar)

    def expect_lines(self) -> None:
        """Have what reads lines loaded, so that no time limit counts it; nobody waits for that."""
        unexpected, self._lines_unexpected = self._lines_unexpected, False
        if unexpected:
            self._readers.everywhere(lines.warm_up)

    def lines(self, pictogram: Pictogram) -> tuple[Line, ...]:
        """Return the lines of an icon: contours, and centre lines of its strokes.

        Its page fills the canvas: see ``rasterise_page``.

        Raises
        ------
        IconstudioError
            If it has none, or reading them takes too long or too much memory.
        """
        return self._lines(pictogram)

    def _read_lines(self, pictogram: Pictogram) -> tuple[Line, ...]:
        self.expect_lines()
        reading = self._readers.submit(
            lines.lines_on_page, pictogram.svg, timeout=_LINES_SECONDS, memory=READING_MEMORY
        )
        doing = f"Reading the lines of “{pictogram.name}”"
        if loss(reading.exception(), doing) is None:
            return answer(reading, doing)
        # Its own shapes are too much: the outline of its picture is not.
        exemplar = self.exemplar(pictogram)
        task = lines.lines_of_drawing, self.drawing(exemplar).path, exemplar.frame, pictogram.svg
        return answer(self._readers.submit(*task, timeout=READING_SECONDS), doing)

    def picture(self, exemplar: Exemplar, size: int) -> NDArray[np.uint8]:
        """Draw an icon on its canvas as it is: (size, size) uint8, 255 = ink.

        Raises
        ------
        IconstudioError
            If that takes too long or too much memory.
        """
        svg, frame = exemplar.pictogram.svg, exemplar.frame
        drawing = self._readers.submit(
            render_placed, svg, frame, Placement(), size, timeout=SECONDS, memory=MEMORY
        )
        return answer(drawing, f"Drawing “{exemplar.name}”", SIMPLER)

    def kept_sample(self, style: LineStyle) -> Path | None:
        """Return the sample of a line style, if it was drawn before."""
        return self._samples.read(style)

    def sample(self, style: LineStyle) -> Generator[Event, None, Path]:
        """Draw the sample of a line style, and keep it for the next start: see ``sampled``."""
        path = yield from sampled(self, style)
        self._samples.write(style, path)
        return path

    def keyword(self, pictogram: Pictogram) -> str:
        """Return what icons like this one are looked for by; empty if its name does not say.

        A name that nobody gave says nothing.
        """
        keyword = self.collection.keyword(pictogram.credit.title)
        nameless = pictogram.id.startswith(UNCOLLECTED) and keyword in NAMELESS
        return "" if nameless else keyword

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

    def retrieve(
        self, keyword: str, exclude: frozenset[str] = frozenset()
    ) -> Generator[Event, None, tuple[Exemplar, ...]]:
        """Return a keyword's icons on the canvas, the best match first, the less alike last.

        Yields ``Progress``, and ``Retrieved`` once the icons are drawn.
        """
        return (yield from self._retrieved(keyword, exclude)).exemplars

    def _retrieved(
        self, keyword: str, exclude: frozenset[str]
    ) -> Generator[Event, None, Retrieved]:
        yield from self.open()
        yield Progress("search", 0.0, f"Looking for “{keyword}”")
        exemplars = yield from self.rasterise(self.search(keyword, exclude))
        plain = tuple(one for one in exemplars if not has_pale_areas(one.coverage))
        if len(plain) >= _PLENTY:
            exemplars = plain
        less_alike = _strangers(self.collection, keyword, exemplars)
        in_order = tuple(sorted(exemplars, key=lambda one: one.id in less_alike))
        retrieved = Retrieved(keyword, in_order, self.collection.remark(keyword), less_alike)
        yield retrieved
        return retrieved

    def prepare(
        self,
        keyword: str,
        exclude: frozenset[str] = frozenset(),
        scales: tuple[float, ...] = SCALES,
    ) -> Generator[Event, None, Matcher]:
        """Retrieve a keyword's icons, and make them ready for matching: see ``retrieve``.

        Returns their ``Matcher``. It is kept in memory, so that a later ``model`` of the keyword
        starts at once.
        """
        key = keyword.strip().casefold(), exclude, scales
        kept = self._prepared.get(key)
        if kept is not None:
            yield kept[0]
            return kept[1]
        yield from self.get_ready()
        retrieved = yield from self._retrieved(keyword, exclude)
        exemplars = retrieved.exemplars
        ready: dict[int, PreparedExemplar] = {}
        for index, one in self._preparing.prepared(exemplars, scales):
            ready[index] = one
            yield Progress("prepare", len(ready) / len(exemplars), "Measuring distances")
        in_order = [ready[index] for index in range(len(exemplars))]
        matcher = Matcher(in_order, strangers=retrieved.strangers)
        self._prepared[key] = retrieved, matcher
        while len(self._prepared) > _KEPT:
            self._prepared.popitem(last=False)
        return matcher

    def choose(
        self, keyword: str, count: int, symmetry: Axis | None = None, seed: int = 0
    ) -> Generator[Event, None, tuple[Pictogram, ...]]:
        """Choose icons of a keyword that mix well: see ``workflows.hybrids.selection``."""
        return (yield from select(self, keyword, count, symmetry, seed))

    def run(self, workflow: Workflow[W], work: W, settings: object = None) -> Generator[Event]:
        """Run a workflow; yield its events, the progress with the time that remains.

        ``settings`` are the workflow's own, if it has any; without them, it has its usual ones.

        Raises
        ------
        IconstudioError
            If the work is no good; before any is done.
        """
        chosen = () if settings is None else (settings,)
        yield from estimated(workflow.run(self, work, *chosen), self.workers.count)

    def close(self) -> None:
        """End the worker processes and close the collection."""
        self.workers.close()
        self._readers.close()
        if self._collection is not None:
            self._collection.close()
            self._collection = None

    def __exit__(self, *exc: object) -> None:
        self.close()


def _learned() -> tuple[Plausibility | None, str | None]:
    """Return what tells plausible results from others, or a sentence that says why it cannot."""
    try:
        return read_plausibility(), None
    except IconstudioError as error:
        return None, str(error)


def _traced(workers: Workers, exemplar: Exemplar) -> Drawing:
    drawing = draw_whole(Source(exemplar, Placement()), exemplar.ink, workers, render_placed)
    return answer(drawing, f"Drawing “{exemplar.name}”")


def _strangers(
    collection: Collection, keyword: str, exemplars: tuple[Exemplar, ...]
) -> frozenset[str]:
    """Return the identifiers of those less alike than others, if there are any others."""
    told = collection.strangers(keyword, (one.id for one in exemplars))
    named, doubtful = (np.array([one.id in ids for one in exemplars], bool) for ids in told)
    found = strangers([one.ink for one in exemplars], named, doubtful)
    if found.all():
        return frozenset()
    return frozenset(one.id for one, less in zip(exemplars, found, strict=True) if less)
