"""A picked result in a project: its outline and how it was made as JSON, and its SVG beside."""

import json
from collections.abc import Callable, Iterable, Mapping
from dataclasses import asdict, dataclass, fields
from math import isqrt
from pathlib import Path as FilePath
from typing import Any, Protocol
from weakref import WeakKeyDictionary

import numpy as np
from numpy.typing import NDArray

from iconstudio.inputs.fields import Fields, parsed, plain_text
from iconstudio.inputs.placements import placement_in
from iconstudio.model import (
    CANVAS,
    Composite,
    Contour,
    Drawing,
    Exemplar,
    Frame,
    Icon,
    Path,
    Pictogram,
    Remix,
    Score,
    Source,
)
from iconstudio.model.path import Segment
from iconstudio.project.archive import part_name

LARGEST_SIDE = 4 * CANVAS
"""Of the pixels of a result."""
_FAR, _HUGE = 1e6, 1e15


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
    entry = parsed(store.content(part), FilePath(part))
    title = entry.text("title")
    path = Path(tuple(map(_contour, entry.objects("outline", "contour"))))
    drawn = store.drawn(entry.text("svg"))
    if not entry.has("remix"):
        return Icon(path, title, drawn.made_of)
    return _remix(entry.object("remix"), path, title, drawn.made_of, store)


def _contour(entry: Fields) -> Contour:
    start, *rest = entry.point_lists("segments") or ((),)
    if len(start) != 1:
        raise entry.mistake("A contour begins with one point.")
    return Contour(start[0], tuple(_segment(one, entry) for one in rest), entry.flag("closed"))


def _segment(points: tuple[tuple[float, float], ...], entry: Fields) -> Segment:
    if len(points) == 1:
        return (points[0],)
    if len(points) == 3:
        return points[0], points[1], points[2]
    raise entry.mistake("A segment has one point, or three.")


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

    entry: dict[str, Any] = {
        "title": plain_text(icon.title),
        "svg": add(".svg", svg_document(icon).encode(errors="replace")),
        "outline": [
            {"closed": one.closed, "segments": [[one.start], *one.segments]}
            for one in icon.path.contours
        ],
    }
    if isinstance(icon, Remix):
        entry["remix"] = _made(icon, kept, references, add)
    name = add(".json", json.dumps(entry, allow_nan=False).encode(errors="replace"))
    return Written(references, name, parts)


def _made(
    icon: Remix, kept: list[int], references: tuple[str, ...], add: Callable[[str, bytes], str]
) -> dict[str, Any]:
    """Describe how a remix was made."""
    composite, drawing = icon.composite, icon.drawing
    numbers = np.zeros(256, np.uint8)
    numbers[kept] = range(len(kept))
    return {
        "style": composite.style,
        "lambda_s": float(composite.lambda_s),
        "energy": float(composite.energy),
        "data_cost": float(composite.data_cost),
        "smoothness_cost": float(composite.smoothness_cost),
        "iou": None if composite.iou is None else float(composite.iou),
        "score": {name: float(value) for name, value in asdict(icon.score).items()},
        "seeds": icon.seeds,
        "draw": icon.draw,
        "unchanged": None if icon.unchanged is None else float(icon.unchanged),
        "side": len(drawing.coverage),
        "frame": asdict(drawing.frame),
        "sources": [
            _source(composite.sources[label], composite.shares[label], reference)
            for label, reference in zip(kept, references, strict=True)
        ],
        "labels": add(".labels", numbers[composite.labels].tobytes()),
        "owners": (
            None if drawing.owners is None else add(".labels", numbers[drawing.owners].tobytes())
        ),
    }


def _source(source: Source, share: float, reference: str) -> dict[str, Any]:
    told = {"error": float(source.error), "region": int(source.region), "share": float(share)}
    return {"icon": reference, **asdict(source.placement), **told}


def _remix(
    entry: Fields, path: Path, title: str, credits: Iterable[Pictogram], store: Store
) -> Remix:
    from iconstudio.output.png import coverage

    frame, entries = entry.object("frame"), list(entry.objects("sources", "source"))
    shares = tuple(one.number("share", 0.0, 0.0, 1.0) for one in entries)
    labels = _labels(store.content(entry.text("labels")), len(entries), entry)
    if len(labels) % CANVAS:
        raise entry.mistake(f"The side of the labels must be a multiple of {CANVAS}.")
    owners = (
        _labels(store.content(entry.text("owners")), len(entries), entry)
        if entry.has("owners")
        else None
    )
    seeds = entry.point_lists("seeds", _FAR)
    if seeds and len(seeds) != len(entries):
        raise entry.mistake('"seeds" must be as many lists as there are sources.')
    side = entry.whole("side", CANVAS, CANVAS, LARGEST_SIDE)
    if side % CANVAS:
        raise entry.mistake(f'"side" must be a multiple of {CANVAS}.')
    composite = Composite(
        entry.text("style"),
        entry.number("lambda_s", None, 0.0, _FAR),
        tuple(_placed(one, store) for one in entries),
        labels,
        entry.number("energy", 0.0, -_HUGE, _HUGE),
        entry.number("data_cost", 0.0, -_HUGE, _HUGE),
        entry.number("smoothness_cost", 0.0, -_HUGE, _HUGE),
        shares,
        entry.number("iou", None, 0.0, 1.0) if entry.has("iou") else None,
    )
    square = (frame.number(key, None, -_FAR, _FAR) for key in ("x", "y", "size"))
    return Remix(
        path,
        title,
        tuple(credits),
        composite=composite,
        drawing=Drawing(path, coverage(path, side), owners, Frame(*square)),
        score=_score(entry.object("score")),
        seeds=seeds,
        draw=entry.whole("draw", -1, -1, 1 << 60),
        unchanged=entry.number("unchanged", None, 0.0, 1.0) if entry.has("unchanged") else None,
    )


def _placed(entry: Fields, store: Store) -> Source:
    exemplar = store.exemplar(store.icon(entry.reference()))
    error = entry.number("error", 0.0, -_HUGE, _HUGE)
    return Source(exemplar, placement_in(entry), error, entry.whole("region", -1, -1, 1000))


def _score(entry: Fields) -> Score:
    return Score(*(entry.number(one.name, 1.0, 0.0, 1.0) for one in fields(Score)))


def _labels(data: bytes, count: int, entry: Fields) -> NDArray[np.uint8]:
    side = isqrt(len(data))
    labels = np.frombuffer(data, np.uint8)
    if side * side != len(data) or not 0 < side <= LARGEST_SIDE:
        raise entry.mistake("The labels are no square of pixels.")
    if labels.max() >= count:
        raise entry.mistake("The labels name sources that are not there.")
    return labels.reshape(side, side)
