"""A session that needs no collection: the same interface, on a few simple bitmaps, at once."""

import hashlib
import threading
from collections.abc import Iterator
from concurrent.futures import Future
from dataclasses import replace
from functools import cache
from pathlib import Path
from types import SimpleNamespace

import numpy as np

from iconstudio.algorithms.scanning.binarisation import Scan, ink_of, scanned
from iconstudio.files import read_bytes
from iconstudio.images.photo import photo_of
from iconstudio.images.pillow import decode
from iconstudio.images.reading import LONGEST, Image, is_image_file
from iconstudio.images.scans import Tracing
from iconstudio.loading import Libraries
from iconstudio.model import (
    CANVAS,
    ColouredLayer,
    Composite,
    Credit,
    Drawing,
    Edit,
    Exemplar,
    Fill,
    Frame,
    IconstudioError,
    Line,
    LineStyle,
    Mix,
    Montage,
    Patterning,
    Pictogram,
    Placement,
    Polygon,
    Remix,
    Restyling,
    Score,
    Separation,
    Sketch,
    Source,
    SpriteError,
)
from iconstudio.model import Path as Outline
from iconstudio.reading import returned
from iconstudio.svg import credits
from iconstudio.svg.decode import decode as svg_text
from iconstudio.svg.markup import markup_of
from iconstudio.svg.parse import parse
from iconstudio.svg.plain import document, plain
from iconstudio.svg.reading import file_and_symbol, own_artwork, read_file
from iconstudio.workflows.events import (
    Event,
    Progress,
    Recommended,
    RegionsFound,
    Result,
    Retrieved,
    StyleMatched,
    StyleSkipped,
)
from iconstudio.workflows.grid import GridSettings
from iconstudio.workflows.hybrids.hybrids import check as check_mix
from iconstudio.workflows.line_style.restyling import (
    RestyleSettings,
    icon_of,
    lines_of,
    variations,
)
from iconstudio.workflows.line_style.sampling import SAMPLE
from iconstudio.workflows.montage.montage import check as check_montage
from iconstudio.workflows.workflow import Workflow
from tests.shapes import outline

RECOMMENDED = 2
"""The column that is recommended in every row."""


@cache
def exemplar(number: int) -> Exemplar:
    """A ring, square, cross or triangle of its own size."""
    y, x = np.mgrid[:CANVAS, :CANVAS] - CANVAS / 2 + 0.5
    size = 60 + number % 7 * 8
    kind = number % 4
    if kind == 0:
        ink = (np.hypot(x, y) < size) & (np.hypot(x, y) > size / 2)
    elif kind == 1:
        ink = (abs(x) < size) & (abs(y) < size) & ((abs(x) > size / 2) | (abs(y) > size / 2))
    elif kind == 2:
        ink = ((abs(x) < size / 3) | (abs(y) < size / 3)) & (abs(x) < size) & (abs(y) < size)
    else:
        ink = (y < size) & (abs(x) < (y + size) / 2)
    name = ("ring", "frame", "cross", "triangle")[kind]
    credit = Credit(
        f"{name} {number}",
        "Ada Example",
        "CC-BY-4.0",
        "https://example.org/licence",
        f"https://example.org/{name}-{number}",
    )
    coverage = np.where(ink, 255, 0).astype(np.uint8)
    coverage.flags.writeable = False
    svg = "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 1 1'/>"
    pictogram = Pictogram(f"shapes:{name}-{number}", svg, credit)
    return Exemplar(pictogram, Frame(0, 0, CANVAS), coverage)


def drawing(sketch: Sketch, row: int, column: int) -> Drawing:
    """The sketch with a hole that grows from row to row; before it was tidied, a narrower one."""
    outer = sketch.polygon.fitted().vertices
    hole = 10 * (3 - row) + 2 * column
    middle = CANVAS / 2
    inner = [(-hole, -hole), (-hole, hole), (hole, hole), (hole, -hole)]
    area = sum(
        x0 * y1 - x1 * y0 for (x0, y0), (x1, y1) in zip(outer, outer[1:] + outer[:1], strict=True)
    )
    if area < 0:
        inner.reverse()
    subpaths = [outer, [(middle + x, middle + y) for x, y in inner]]
    path = outline(*subpaths)
    coverage = np.zeros((CANVAS, CANVAS), np.uint8)
    coverage[40:216, 40:216] = 255
    before = outline(outer, [(middle + 0.9 * x, middle + y) for x, y in inner])
    return Drawing(path, coverage, untidied=before)


def read_simply(data: bytes, name: str, symbol: str | None = None) -> Pictogram:
    """An SVG as it is read, but for its colours, which take time to think about."""
    try:
        markup, unread = markup_of(svg_text(data))
        root, said = parse(markup)
        rdf = credits.metadata(root)
        drawing = plain(root, [*unread, *said], symbol)
        if drawing.bounds is None:
            raise IconstudioError("There is nothing to be seen in it.")
    except SpriteError:
        raise
    except IconstudioError as error:
        raise IconstudioError(f"“{name}” cannot be used. {error}") from None
    svg = document(drawing.content, drawing.page or drawing.bounds, rdf)
    digest = hashlib.sha256(data).hexdigest()[:8]
    return Pictogram(
        f"own:{Path(name).stem}-{digest}",
        svg,
        credits.credit(rdf, Path(name).name),
        credits.sources(rdf),
        drawing.remarks,
    )


class FakeSession:
    """Same interface as ``Session``.

    ``gate``, ``search_gate``: each result of a run, and a search, wait for it, so that a test can
    look at them half-way.
    ``stuck``: a run that comes to no ``yield`` until ``close``.
    """

    def __init__(self, skip: str = "dark") -> None:
        self.skip = skip
        self.trouble: str | None = None
        self.gate: threading.Semaphore | None = None
        self.search_gate: threading.Semaphore | None = None
        self.stuck = False
        self.fits: dict[str, float] = {}
        """How well the results of a style fit, where not as all others do."""
        self.closed = threading.Event()
        self.calls: list[tuple] = []
        self.kept_samples: dict[str, Outline] = {}
        self.workers = SimpleNamespace(
            everywhere=lambda function, *args: None,
            ticket=lambda: SimpleNamespace(stop=lambda: None),
            submit=_answered,
        )
        self.libraries = Libraries()
        self.generators_closed = 0
        self.thread_ids: set[int] = set()

    def get_ready(self) -> Iterator[Event]:
        yield Progress("search", 0.5, "Opening the collection")
        yield Progress("search", 1.0, "Opening the collection")

    def search(self, keyword: str, exclude: frozenset[str] = frozenset()):
        if keyword.startswith("zz"):
            raise IconstudioError(f"No icon is found for “{keyword}”. Near: “zebra”, “zip”.")
        return tuple(e.pictogram for e in self._exemplars(exclude))

    def icon(self, reference: str) -> Pictogram:
        self.calls.append(("icon", reference))
        if is_image_file(path := Path(reference)):
            image = returned(self.image(path))
            return returned(self.trace(returned(self.scan(image)), None, path.name)).pictogram
        path, symbol = file_and_symbol(reference)
        if path.endswith(".svg"):
            return read_simply(read_file(Path(path)), path, symbol)
        for one in self._exemplars(frozenset()):
            if one.id == reference:
                return one.pictogram
        raise IconstudioError(f"The collection has no icon '{reference}'.")

    def icon_from(self, data: bytes, name: str, symbol: str | None = None) -> Pictogram:
        self.calls.append(("icon_from", data, name))
        return read_simply(data, name, symbol)

    def image(self, source: Path | bytes):
        """As the real one, but in this process."""
        self.thread_ids.add(threading.get_ident())
        yield
        data = source if isinstance(source, bytes) else read_bytes(source, 1 << 24)
        try:
            pixels, (width, height), remark = decode(data, LONGEST)
        except IconstudioError as error:
            name = f"“{source.name}”" if isinstance(source, Path) else "The image"
            raise IconstudioError(f"{name} cannot be opened. {error}") from None
        return Image(pixels, width, height, remark)

    def artwork(self, path: Path):
        """As the real one, but in this process."""
        self.thread_ids.add(threading.get_ident())
        yield
        if is_image_file(path):
            return Separation(photo_of((yield from self.image(path)), str(path)))
        pixels, pictogram = own_artwork(read_bytes(path, 1 << 24), str(path))
        image = Image(pixels, pixels.shape[1], pixels.shape[0])
        return Separation(photo_of(image, str(path)), credits=(pictogram,))

    def scan(self, image: Image, inverted: bool | None = None):
        self.calls.append(("scan", inverted))
        self.thread_ids.add(threading.get_ident())
        yield
        return scanned(image.pixels, inverted)

    def trace(self, scan: Scan, threshold: int | None, name: str, remark: str = ""):
        """The bounding box of the ink."""
        self.calls.append(("trace", threshold, name))
        self.thread_ids.add(threading.get_ident())
        yield
        ink = ink_of(scan, threshold)
        (height, width), (ys, xs) = ink.shape, np.nonzero(ink)
        left, top, right, bottom = xs.min(), ys.min(), xs.max(), ys.max()
        path = outline([(left, top), (right, top), (right, bottom)])
        svg = (
            f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width} {height}">'
            f'<path d="{path.svg()}"/></svg>'
        )
        credit = Credit(name, "an unnamed author", "licence not stated", "", "")
        remarks = (remark,) if remark else ()
        return Tracing(Pictogram(f"own:{name}", svg, credit, remarks=remarks), path, width, height)

    def exemplar(self, pictogram: Pictogram) -> Exemplar:
        self.thread_ids.add(threading.get_ident())
        for one in self._exemplars(frozenset()):
            if one.id == pictogram.id:
                return one
        if "<path" not in pictogram.svg:
            raise IconstudioError(f"{pictogram.id} cannot be used. It has no dark ink.")
        return replace(exemplar(1), pictogram=pictogram)

    def drawing(self, exemplar: Exemplar) -> Drawing:
        """The icon's bounding box."""
        ys, xs = np.nonzero(exemplar.ink)
        left, top, right, bottom = xs.min(), ys.min(), xs.max() + 1, ys.max() + 1
        path = outline([(left, top), (right, top), (right, bottom), (left, bottom)])
        return Drawing(path, exemplar.coverage)

    def keyword(self, pictogram: Pictogram) -> str:
        return pictogram.credit.title.split()[0]

    def run(self, workflow: Workflow, work, settings=None):
        """What is faked of a workflow; others run as they are."""
        match workflow.name:
            case "model":
                return self.model(work, settings)
            case "edit":
                return self.edit(work, settings)
            case "hybrids":
                return self.mix(work)
            case "montage":
                return self.montage(work)
            case "restyle":
                return self.restyle(work, settings)
            case "pattern":
                return self.pattern(work, settings)
        return workflow.run(self, work)

    def kept_sample(self, style: LineStyle) -> Outline | None:
        return self.kept_samples.get(style.name)

    def sample(self, style: LineStyle):
        work = Restyling(style, strokes=SAMPLE)
        for event in self.restyle(work, RestyleSettings(coarse=True)):
            if isinstance(event, Result):
                path = event.icon.path
            else:
                yield event
        return path

    def edit(self, edit: Edit, settings: GridSettings) -> Iterator[Event]:
        """The results of ``model`` for the icon's frame, nine tenths of them unchanged."""
        self.calls.append(("edit", edit, settings))
        frame = Polygon(((0, 0), (9, 0), (9, 9), (0, 9)))
        try:
            for event in self._model(Sketch(frame, edit.keyword, edit.exclude), settings):
                if isinstance(event, Result):
                    event = replace(event, icon=replace(event.icon, unchanged=0.9))
                yield event
        finally:
            self.generators_closed += 1

    def prepare(self, keyword, exclude=frozenset(), scales=(0.9, 1.0, 1.1)) -> Iterator[Event]:
        self.calls.append(("prepare", keyword, exclude))
        self.thread_ids.add(threading.get_ident())
        self.search(keyword, exclude)
        while self.search_gate is not None and not self.search_gate.acquire(timeout=0.02):
            yield Progress("prepare", 0.1, f"Drawing the icons for “{keyword}”")
        yield Progress("prepare", 0.2, f"Drawing the icons for “{keyword}”")
        remark = "“doog” was read as “dog”." if "doog" in keyword else ""
        yield Retrieved(keyword, tuple(self._exemplars(exclude)), remark)
        yield Progress("prepare", 1.0, f"Drawing the icons for “{keyword}”")

    def model(self, sketch: Sketch, settings: GridSettings = GridSettings()) -> Iterator[Event]:  # noqa: B008
        self.calls.append(("model", sketch, settings))
        try:
            yield from self._model(sketch, settings)
        finally:
            self.generators_closed += 1

    def choose(self, keyword, count, symmetry=None, seed=0) -> Iterator[Event]:
        """The icons from number ``seed`` on."""
        self.calls.append(("choose", keyword, count, symmetry, seed))
        yield from self.prepare(keyword)
        return tuple(one.pictogram for one in self._exemplars(frozenset())[seed : seed + count])

    def mix(self, mix: Mix) -> Iterator[Event]:
        """Blocks of the icons at random; every draw after the ninth repeats it once in ten."""
        self.calls.append(("mix", mix))
        self.thread_ids.add(threading.get_ident())
        check_mix(mix)
        sources = tuple(Source(self.exemplar(icon), Placement()) for icon in mix.icons)
        try:
            for draw in range(mix.first, mix.first + mix.draws):
                if self.gate is not None:
                    while not self.gate.acquire(timeout=0.02):
                        yield Progress("remix", 0.5, "Mixing")
                yield self._hybrid(mix, draw if draw % 10 < 9 else 9, draw, sources)
        finally:
            self.generators_closed += 1

    def montage(self, montage: Montage) -> Iterator[Event]:
        """A frame that is larger the more is scribbled; every pixel is owned by the last marked."""
        self.calls.append(("montage", montage))
        self.thread_ids.add(threading.get_ident())
        scribbles = check_montage(montage)
        layers = montage.layers
        sources = tuple(Source(self.exemplar(one.icon), one.placement) for one in layers)
        try:
            while self.gate is not None and not self.gate.acquire(timeout=0.02):
                yield Progress("remix", 0.5, "Joining parts")
            owner = max(k for k, one in enumerate(scribbles) if one.any())
            labels = np.full((CANVAS, CANVAS), owner, np.uint8)
            shares = tuple(float(k == owner) for k in range(len(sources)))
            composite = Composite("montage", 3.0, sources, labels, 3.0, 2.0, 1.0, shares, None)
            side = 10 + scribbles.sum() / 1000
            shape = Sketch(Polygon(((0, 0), (100, 0), (100, side), (0, side))))
            score = Score(1.0, 1.0, 1.0, 1.0, 1.0)
            yield Result(Remix.of(composite, drawing(shape, 1, 1), score))
        finally:
            self.generators_closed += 1

    def expect_lines(self) -> None:
        """Nothing is to be loaded."""

    def lines(self, pictogram: Pictogram) -> tuple[Line, ...]:
        """A square around a short stroke."""
        self.thread_ids.add(threading.get_ident())
        square = ((60.0, 60.0), (196.0, 60.0), (196.0, 196.0), (60.0, 196.0))
        return Line(square, closed=True), Line(((100.0, 128.0), (156.0, 128.0)), width=10.0)

    def restyle(self, work: Restyling, settings: RestyleSettings | None = None) -> Iterator[Event]:
        """A box for each line, which is larger with the strength, the size and the seed."""
        self.calls.append(("restyle", work))
        self.thread_ids.add(threading.get_ident())
        lines = lines_of(self, work)
        try:
            settings = settings or RestyleSettings()
            for one in variations(work) if settings.variations else [work]:
                styles = [one.style_of(number) for number in range(len(lines))]
                if settings.previews:
                    rough = replace(one, strength=0.9 * one.strength)
                    yield Result(
                        icon_of(rough, _boxes(lines, styles, rough), lines, 1.0, styles),
                        preview=True,
                    )
                while self.gate is not None and not self.gate.acquire(timeout=0.02):
                    yield Progress("remix", 0.5, "Restyling the lines")
                yield Result(icon_of(one, _boxes(lines, styles, one), lines, 1.0, styles))
        finally:
            self.generators_closed += 1

    def pattern(self, work: Patterning, settings: object) -> Iterator[Event]:
        """A square for each motif, in its colour, at its place; smaller for a larger seed."""
        from iconstudio.workflows.pattern.patterning import icon_of as make
        from iconstudio.workflows.pattern.patterning import samples

        self.calls.append(("pattern", work, settings))
        self.thread_ids.add(threading.get_ident())
        size = samples(work)
        try:
            for number in range(settings.seeds):
                one = replace(work, seed=work.seed + number)
                if settings.previews:
                    yield Result(make(one, _squares(one, size, 3.0), None), preview=True)
                while self.gate is not None and not self.gate.acquire(timeout=0.02):
                    yield Progress("pattern", 0.5, "Continuing the exemplar")
                yield Result(make(one, _squares(one, size, 0.0), None))
        finally:
            self.generators_closed += 1

    def close(self) -> None:
        self.closed.set()

    def _exemplars(self, exclude: frozenset[str]) -> list[Exemplar]:
        return [e for e in map(exemplar, range(60)) if e.id not in exclude]

    def _hybrid(self, mix: Mix, looks: int, draw: int, sources: tuple[Source, ...]) -> Result:
        random = np.random.default_rng([mix.seed, looks, len(mix.like)])
        blocks = random.integers(len(sources), size=(16, 16), dtype=np.uint8)
        labels = np.kron(blocks, np.ones((16, 16), np.uint8))
        shares = (1 / len(sources),) * len(sources)
        composite = Composite("hybrid", 3.0, sources, labels, 3.0, 2.0, 1.0, shares, None)
        score = Score(float(random.random()), 1.0, 1.0, 1.0, 1.0)
        side = 60 + looks % 40 + 0.01 * looks
        shape = Sketch(Polygon(((0, 0), (100, 0), (100, side), (0, side))))
        seeds = tuple(((float(draw), 9.0),) for _ in sources)
        icon = Remix.of(composite, drawing(shape, 1, 1), score)
        return Result(replace(icon, seeds=seeds, draw=draw))

    def _model(self, sketch: Sketch, settings: GridSettings) -> Iterator[Event]:
        exemplars = self._exemplars(sketch.exclude)
        if self.stuck:
            yield Progress("match", 0.1, "Matching")
            self.closed.wait()
            raise IconstudioError("The session was closed.")
        yield RegionsFound(tuple((64.0 + 64 * (i % 3), 64.0 + 64 * (i // 3)) for i in range(9)))
        sources = tuple(
            Source(exemplars[i], Placement((0.9, 1.0, 1.1)[i % 3], i % 2 == 1, 9 - i, i))
            for i in range(27)
        )
        labels = np.zeros((CANVAS, CANVAS), np.uint8)
        labels[:, 128:] = 1
        labels[150:, :] = 2
        shares = (0.5, 0.3, 0.2) + (0.0,) * 24
        focus = settings.focus or (settings.styles[0], settings.lambdas[0])
        preview = settings.previews
        # Those in focus come first.
        for style in sorted(settings.styles, key=lambda one: one != focus[0]):
            row = settings.styles.index(style)
            yield Progress("match", row / 4, f"Matching the {style} icons")
            if style == self.skip:
                yield StyleSkipped(style, 4, f"Only 4 icons are {style}; at least 9 are needed.")
                continue
            yield StyleMatched(style, (sources[0].exemplar,) * (120 - row), (sources[:3],) * 9)
            lambdas = sorted(settings.lambdas, key=lambda one: one != focus[1])
            for lambda_s in lambdas[:1] * preview + lambdas:
                column = settings.lambdas.index(lambda_s)
                if self.gate is not None:
                    while not self.gate.acquire(timeout=0.02):
                        yield Progress("remix", column / 8, f"Remixing the {style} icons")
                composite = Composite(style, lambda_s, sources, labels, 3.0, 2.0, 1.0, shares, 0.87)
                score = Score(1.0, 1.0, 1.0, 1.0, self.fits.get(style, 0.87))
                icon = Remix.of(composite, drawing(sketch, row, column), score)
                yield Result(icon, preview=preview)
                preview = False
            yield Recommended(style, settings.lambdas[RECOMMENDED])


def _answered(function, *args, timeout, memory, ticket):
    """Return what a worker process would answer."""
    future = Future()
    try:
        future.set_result(function(*args))
    except Exception as error:
        future.set_exception(error)
    return future


def _squares(work: Patterning, size: tuple[int, int], less: float):
    from iconstudio.workflows.pattern.drawing import Drawn

    rows, columns = size
    fills = []
    for one in work.motifs:
        x, y = one.x / CANVAS * columns, one.y / CANVAS * rows
        half = max(1.0, one.size / 8 - less - work.seed % 10 / 4)
        corners = [(x - half, y - half), (x + half, y - half), (x + half, y + half)]
        fills.append(Fill(outline([*corners, (x - half, y + half)]), one.colour))
    return Drawn(size, (ColouredLayer("layer-1", tuple(fills)),), work.ground, 0.01)


def _boxes(lines: tuple[Line, ...], styles: list[LineStyle | None], work: Restyling) -> Outline:
    boxes = []
    for line, style in zip(lines, styles, strict=True):
        xs, ys = zip(*line.points, strict=True)
        more = 4 * work.strength + work.size + work.seed % 100 / 50 + len(style.name) / 10
        left, top, right, bottom = min(xs) - more, min(ys) - more, max(xs) + more, max(ys) + more
        boxes.append([(left, top), (right, top), (right, bottom), (left, bottom)])
    return outline(*boxes)
