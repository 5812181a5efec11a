"""A picked result in a project: its outline and how it was made as JSON, and its SVG beside."""

from collections.abc import Callable, Iterable, Mapping
from dataclasses import asdict, dataclass
from math import isqrt
from pathlib import Path as FilePath
from typing import Annotated, Protocol
from weakref import WeakKeyDictionary

import numpy as np
from msgspec import Meta, structs
from numpy.typing import NDArray

from iconstudio.inputs import json
from iconstudio.inputs.formats import Many, Points, Record, Text, plain_text
from iconstudio.model import (
    CANVAS,
    Axis,
    Composite,
    Drawing,
    Exemplar,
    Frame,
    Icon,
    IconstudioError,
    Path,
    Patterned,
    Pictogram,
    Remix,
    Score,
    Source,
)
from iconstudio.project.archive import part_name
from iconstudio.project.outlines import Contours, StoredContour, StoredPattern
from iconstudio.workflows.pages import StoredPlacement

LARGEST_SIDE = 4 * CANVAS
"""Of the pixels of a result."""

Unit = Annotated[float, Meta(ge=0, le=1)]
_Far = Annotated[float, Meta(ge=-1e6, le=1e6)]
_Huge = Annotated[float, Meta(ge=-1e15, le=1e15)]


class StoredFrame(Record, frozen=True):
    """A square of an SVG's user space."""

    x: _Far
    y: _Far
    size: _Far


class StoredScore(Record, frozen=True):
    """How good a remix looks."""

    seam: Unit = 1.0
    whole: Unit = 1.0
    symmetry: Unit = 1.0
    sharing: Unit = 1.0
    likeness: Unit = 1.0
    inside: Unit = 1.0
    plausible: Unit | None = None


class StoredSource(StoredPlacement, frozen=True, kw_only=True):
    """An icon where it lies, and how much it gave."""

    icon: Text
    error: _Huge = 0.0
    region: Annotated[int, Meta(ge=-1, le=1000)] = -1
    share: Unit = 0.0


class StoredRemix(Record, frozen=True, kw_only=True):
    """How a remix was made."""

    style: Text = ""
    lambda_s: Annotated[float, Meta(ge=0, le=1e6)]
    energy: _Huge = 0.0
    data_cost: _Huge = 0.0
    smoothness_cost: _Huge = 0.0
    iou: Unit | None = None
    symmetry: Axis | None = None
    without: Many[Text] = ()
    score: StoredScore = StoredScore()
    seeds: Many[Points] = ()
    draw: Annotated[int, Meta(ge=-1, le=1 << 60)] = -1
    unchanged: Unit | None = None
    side: Annotated[int, Meta(ge=CANVAS, le=LARGEST_SIDE, multiple_of=CANVAS)] = CANVAS
    frame: StoredFrame
    sources: Many[StoredSource] = ()
    labels: Text
    """The part with the numbers of the sources, a byte a pixel."""
    owners: Text | None = None
    """The same for the pixels of the drawing."""

    def check(self) -> None:
        """Refuse seeds of other sources than there are."""
        if self.seeds and len(self.seeds) != len(self.sources):
            raise IconstudioError('"seeds" must be as many lists as there are sources.')


class StoredResult(Record, frozen=True):
    """A result."""

    title: Text
    svg: Text
    """Its part."""
    outline: Contours = ()
    remix: StoredRemix | None = None
    pattern: StoredPattern | None = None


@dataclass(frozen=True, slots=True)
class Written:
    """A result as it is stored."""

    references: tuple[str, ...]
    """What the icons that it names are called."""
    name: str
    """Of the part that describes it."""
    parts: Mapping[str, bytes]


class Store(Protocol):
    """What a result is read from."""

    def content(self, part: str) -> bytes:
        """Return a part as it was stored."""
        ...

    def drawn(self, part: str) -> Pictogram:
        """Return an SVG of the file, which went through the gate."""
        ...

    def icon(self, reference: str) -> Pictogram:
        """Return an icon that is named."""
        ...

    def exemplar(self, pictogram: Pictogram) -> Exemplar:
        """Return an icon on the canvas."""
        ...

    def note_unknown(self, where: str, fields: Iterable[str]) -> None:
        """Note fields that are not known here."""
        ...


_written: "WeakKeyDictionary[Icon, Written]" = WeakKeyDictionary()


def write(icon: Icon, refer: Callable[[Pictogram], str]) -> Written:
    """Return the parts of a result; ``refer`` takes the icons in that it names.

    They are made once for each icon: every edit of a page stores the results with it.
    """
    kept = _kept(icon)
    references = tuple(refer(source.exemplar.pictogram) for source in kept.values())
    before = _written.get(icon)
    if before is None or before.references != references:
        _written[icon] = before = _described(icon, list(kept), references)
    return before


def read(part: str, store: Store) -> Icon:
    """Return a result.

    How it was made is left out if that cannot be read any more.

    Raises
    ------
    IconstudioError
        If it is no good.
    """
    here = FilePath(part)
    data = json.parsed(store.content(part), here)
    stored = json.converted(data, StoredResult, here)
    store.note_unknown("Of the results", json.unknown_fields(stored, data))
    path = Path(tuple(one.contour for one in stored.outline))
    drawn = store.drawn(stored.svg)
    if stored.pattern is not None:
        return stored.pattern.icon(path, stored.title, drawn.made_of)
    if stored.remix is None:
        return Icon(path, stored.title, drawn.made_of)
    return _remix(stored.remix, path, stored.title, drawn.made_of, store)


def _kept(icon: Icon) -> dict[int, Source]:
    """Return the sources to store, by label: those that own a pixel, or all that are seeded."""
    if not isinstance(icon, Remix):
        return {}
    sources, owners = dict(enumerate(icon.composite.sources)), icon.drawing.owners
    if icon.seeds:
        return sources
    used = np.unique(icon.composite.labels)
    used = used if owners is None else np.union1d(used, owners)
    return {label: source for label, source in sources.items() if label in used}


def _described(icon: Icon, kept: list[int], references: tuple[str, ...]) -> Written:
    from iconstudio.output.svg import svg_document

    parts: dict[str, bytes] = {}

    def add(suffix: str, data: bytes) -> str:
        name = part_name("results", icon.title, suffix, data)
        parts[name] = data
        return name

    stored = StoredResult(
        plain_text(icon.title),
        add(".svg", svg_document(icon).encode(errors="replace")),
        tuple(map(StoredContour.of, icon.path.contours)),
        _made(icon, kept, references, add) if isinstance(icon, Remix) else None,
        StoredPattern.of(icon) if isinstance(icon, Patterned) else None,
    )
    name = add(".json", json.encoded(stored))
    return Written(references, name, parts)


def _made(
    icon: Remix, kept: list[int], references: tuple[str, ...], add: Callable[[str, bytes], str]
) -> StoredRemix:
    """Describe how a remix was made."""
    composite, drawing = icon.composite, icon.drawing
    owners = drawing.owners
    numbers = np.zeros(256, np.uint8)
    numbers[kept] = range(len(kept))
    return StoredRemix(
        style=composite.style,
        lambda_s=float(composite.lambda_s),
        energy=float(composite.energy),
        data_cost=float(composite.data_cost),
        smoothness_cost=float(composite.smoothness_cost),
        iou=None if composite.iou is None else float(composite.iou),
        symmetry=composite.symmetry,
        without=composite.without,
        score=StoredScore(**_known(icon.score)),
        seeds=icon.seeds,
        draw=icon.draw,
        unchanged=None if icon.unchanged is None else float(icon.unchanged),
        side=len(drawing.coverage),
        frame=StoredFrame(**asdict(drawing.frame)),
        sources=tuple(
            _source(composite.sources[label], composite.shares[label], reference)
            for label, reference in zip(kept, references, strict=True)
        ),
        labels=add(".labels", numbers[composite.labels].tobytes()),
        owners=None if owners is None else add(".labels", numbers[owners].tobytes()),
    )


def _known(score: Score) -> dict[str, float]:
    return {name: float(one) for name, one in asdict(score).items() if one is not None}


def _source(source: Source, share: float, reference: str) -> StoredSource:
    return StoredSource(
        icon=reference,
        error=float(source.error),
        region=int(source.region),
        share=float(share),
        **asdict(source.placement),
    )


def _remix(
    stored: StoredRemix, path: Path, title: str, credits: Iterable[Pictogram], store: Store
) -> Remix:
    from iconstudio.output.png import coverage

    count, owners = len(stored.sources), None
    labels = _labels(store.content(stored.labels), count)
    if len(labels) % CANVAS:
        raise IconstudioError(f"The side of the labels must be a multiple of {CANVAS}.")
    if stored.owners is not None:
        owners = _labels(store.content(stored.owners), count)
    composite = Composite(
        stored.style,
        stored.lambda_s,
        tuple(_placed(one, store) for one in stored.sources),
        labels,
        stored.energy,
        stored.data_cost,
        stored.smoothness_cost,
        tuple(one.share for one in stored.sources),
        stored.iou,
        stored.symmetry,
        stored.without,
    )
    frame = Frame(**structs.asdict(stored.frame))
    return Remix(
        path,
        title,
        tuple(credits),
        composite=composite,
        drawing=Drawing(path, coverage(path, stored.side), owners, frame),
        score=Score(**structs.asdict(stored.score)),
        seeds=stored.seeds,
        draw=stored.draw,
        unchanged=stored.unchanged,
    )


def _placed(stored: StoredSource, store: Store) -> Source:
    exemplar = store.exemplar(store.icon(stored.icon))
    return Source(exemplar, stored.placement, stored.error, stored.region)


def _labels(data: bytes, count: int) -> NDArray[np.uint8]:
    side = isqrt(len(data))
    labels = np.frombuffer(data, np.uint8)
    if side * side != len(data) or not 0 < side <= LARGEST_SIDE:
        raise IconstudioError("The labels are no square of pixels.")
    if labels.max() >= count:
        raise IconstudioError("The labels name sources that are not there.")
    return labels.reshape(side, side)
