"""Line styles beside rough.js and Inkscape's *Pattern along path*, on the same icons.

Lengths are units of a 256 canvas.
"""

import json
import shutil
import subprocess
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path as FilePath
from statistics import mean, median
from tempfile import TemporaryDirectory
from time import perf_counter, process_time
from typing import Any, cast
from xml.etree import ElementTree

import numpy as np
import shapely
from fontTools.svgLib.path import parse_path
from numpy.typing import NDArray

from iconstudio.algorithms.curves.fitting import fitted
from iconstudio.algorithms.curves.outline import strokes_of
from iconstudio.algorithms.curves.restyle import prepare, restyled
from iconstudio.algorithms.flattening import flattened
from iconstudio.inputs.styles import named
from iconstudio.model import Line, LineStyle, PathPen
from iconstudio.model.path import Contour, Path, Segment
from iconstudio.session import Session

ICONS = (
    "lucide:house", "lucide:bird", "lucide:castle", "tabler:bike", "lucide:coffee",
    "lucide:umbrella", "tabler:coffee", "tabler:plant", "mdi:cat", "mdi:dog-side", "ph:dog-fill",
    "ph:guitar-fill",
)  # fmt: skip
STYLES = "Shaky", "Torn", "Castle"
_PATTERN = 120.0
"""How much of an example Inkscape repeats: what does not fit a line is stretched or squeezed."""
_NEAR = 0.75
"""Lines end on one another in the plain icon if they come so near."""
_EVEN = 1.0
"""Between places at which the distance from the plain line is taken."""
_LONG = 40.0
"""Along which distances are averaged, and beyond which what is alike repeats."""
_DRAWS = 16
"""Noises whose repetition is averaged."""
_REACH = 24.0
"""Farther than this from the plain line nothing is looked for."""

_ROUNDS = 3
"""Starts of Inkscape whose times are compared: they differ by more than the drawing takes."""

Points = NDArray[np.float64]
Drawing = list[list[Points]]
"""The pieces that each line of an icon is drawn with, each (n, 2)."""


@dataclass
class Peer:
    """What draws, and what it drew: by icon, with the seconds."""

    name: str
    drawings: dict[str, Drawing]
    seconds: float


@dataclass
class Figures:
    """What is measured of one drawing; None if there is nothing to measure it on."""

    closes: float | None
    joins: float | None
    rms: float
    """Of the distances from the plain lines: how strong the texture is."""
    strays: float
    """Of the same, averaged over ``_LONG``: how far the lines are off as a whole."""
    repeats: float | None
    chance: float | None
    """What noise repeats that is as rough, of the same length."""


def measured(lines: Sequence[Line], drawing: Drawing) -> Figures:
    """Return how well a drawing keeps the lines of an icon, and how visibly it repeats."""
    pairs = list(zip(lines, drawing, strict=True))
    closes = [_opening(pieces) for line, pieces in pairs if line.closed]
    joins = list(_partings(lines, drawing))
    long = [(line, pieces) for line, pieces in pairs if _row(line).length > _EVEN]
    off = [_offsets(line, pieces) for line, pieces in long]
    whole = np.concatenate(off)
    return Figures(
        max(closes, default=None),
        max(joins, default=None),
        _rms(whole),
        _rms(np.concatenate([_averaged(one) for one in off])),
        repetition(whole),
        by_chance(whole),
    )


def repetition(offsets: Points) -> float | None:
    """Return the highest peak of the autocorrelation, after it was negative for the first time."""
    centred = offsets - offsets.mean()
    count = len(centred)
    lags = np.arange(count // 2)
    products = np.correlate(centred, centred, "full")[count - 1 :][: len(lags)]
    energy = np.cumsum(centred**2)
    first, second = energy[count - 1 - lags], energy[-1] - np.append(0, energy)[lags]
    found = products / np.maximum(np.sqrt(first * second), 1e-12)
    negative = np.flatnonzero(found < 0)
    return float(found[negative[0] :].max()) if len(negative) else None


def by_chance(offsets: Points) -> float | None:
    """Return what noise repeats whose autocorrelation is the same at short lags, and else none."""
    centred = offsets - offsets.mean()
    count = len(centred)
    products = np.correlate(centred, centred, "full")[count - 1 :]
    lags = np.minimum(np.arange(count) / _LONG, 1.0)
    near = products * (0.5 + 0.5 * np.cos(np.pi * lags))
    power = np.maximum(np.fft.rfft(np.concatenate([near, near[-2:0:-1]])).real, 0.0)
    random = np.random.default_rng(0)
    found = [
        repetition(np.fft.irfft(np.sqrt(power) * np.fft.rfft(one))[:count])
        for one in random.normal(size=(_DRAWS, 2 * count - 2))
    ]
    some = [one for one in found if one is not None]
    return mean(some) if some else None


def _opening(pieces: Sequence[Points]) -> float:
    """Return the largest gap between a piece and the next one, around a closed line."""
    return max(
        float(np.hypot(*(one[-1] - after[0])))
        for one, after in zip(pieces, [*pieces[1:], pieces[0]], strict=True)
    )


def _partings(lines: Sequence[Line], drawing: Drawing) -> Iterator[float]:
    """Yield how far apart lines are drawn where one ends on another one."""
    for number, line in enumerate(lines):
        if line.closed or not line.width:
            continue
        for end, drawn in ((0, drawing[number][0][0]), (-1, drawing[number][-1][-1])):
            place = shapely.Point(line.points[end])
            for other, onto in enumerate(lines):
                if other == number or not onto.width:
                    continue
                if _row(onto).distance(place) < _NEAR:
                    whole = shapely.MultiLineString([one for one in drawing[other] if len(one) > 1])
                    yield float(whole.distance(shapely.Point(drawn)))


def _row(line: Line) -> shapely.LineString:
    return shapely.LineString(_whole(line))


def _rms(values: Points) -> float:
    return float(np.sqrt(np.mean(values**2)))


def _averaged(offsets: Points) -> Points:
    """Return means over ``_LONG``; of a shorter line, that of all."""
    count = min(len(offsets), int(_LONG / _EVEN))
    return np.convolve(offsets, np.ones(count) / count, "valid")


def _offsets(line: Line, pieces: Sequence[Points]) -> Points:
    """Return how far to its left a line is drawn, at even steps along it."""
    row = _row(line)
    at = np.arange(_EVEN / 2, row.length, _EVEN)
    places = shapely.get_coordinates(shapely.line_interpolate_point(row, at))
    ahead = shapely.get_coordinates(shapely.line_interpolate_point(row, at + 0.1))
    behind = shapely.get_coordinates(shapely.line_interpolate_point(row, at - 0.1))
    way = (ahead - behind) / np.maximum(np.hypot(*(ahead - behind).T), 1e-12)[:, None]
    left = np.column_stack([way[:, 1], -way[:, 0]])
    drawn = shapely.MultiLineString([one for one in pieces if len(one) > 1])
    across = shapely.linestrings(np.stack([places - _REACH * left, places + _REACH * left], axis=1))
    found = []
    for cut, place, side in zip(shapely.intersection(across, drawn), places, left, strict=True):
        met = (shapely.get_coordinates(cut) - place) @ side
        found.append(met[abs(met).argmin()] if len(met) else 0.0)
    return np.array(found)


def ours(icons: Mapping[str, Sequence[Line]], style: LineStyle) -> Peer:
    """Restyle icons, strokes as strokes."""
    prepared = prepare(style)
    drawings, times = {}, []
    for name, lines in icons.items():
        restyled([(line, prepared) for line in lines])
        began = process_time()
        made = restyled([(line, prepared) for line in lines])
        strokes_of(made)
        times.append(process_time() - began)
        drawings[name] = [[_whole(line)] for line in made]
    return Peer(f"ours, {style.name}", drawings, mean(times))


def _whole(line: Line) -> Points:
    points = np.array(line.points)
    return np.concatenate([points, points[:1]]) if line.closed else points


def roughjs(icons: Mapping[str, Sequence[Line]], name: str, **options: object) -> Peer:
    """Draw icons by rough.js, as single strokes."""
    options = {"disableMultiStroke": True, **options}
    with TemporaryDirectory() as folder:
        given, drawn = FilePath(folder, "in.json"), FilePath(folder, "out.json")
        data = {icon: [_svg(line) for line in lines] for icon, lines in icons.items()}
        given.write_text(json.dumps({"options": options, "icons": data}))
        script = FilePath(__file__).with_name("roughjs.cjs")
        subprocess.run(["node", script, given, drawn], check=True)
        found = json.loads(drawn.read_text())
    drawings = {icon: [_pieces_of(ops) for ops in found[icon]["lines"]] for icon in icons}
    return Peer(name, drawings, mean(one["seconds"] for one in found.values()))


def _pieces_of(ops: Sequence[Mapping[str, Any]]) -> list[Points]:
    """Return the points of what each "move" begins."""
    rows: list[list[Contour]] = []
    at = (0.0, 0.0)
    for op in ops:
        numbers = op["data"]
        pairs = tuple(zip(numbers[::2], numbers[1::2], strict=True))
        if op["op"] == "move":
            rows.append([])
        else:
            rows[-1].append(Contour(at, (cast(Segment, pairs),), False))
        at = pairs[-1]
    return [np.concatenate([row for row, _ in flattened(Path(tuple(one)))]) for one in rows]


def inkscape(icons: Mapping[str, Sequence[Line]], style: LineStyle) -> Peer:
    """Draw icons by Inkscape, the example a pattern that is repeated.

    All are in one drawing; the seconds are those above what a drawing of nothing takes, medians.
    """
    together = [line for lines in icons.values() for line in lines]
    times: dict[bool, list[float]] = {False: [], True: []}
    made: Drawing = []
    for _ in range(_ROUNDS):
        for is_whole, lines in ((False, []), (True, together)):
            began = perf_counter()
            made = _inkscape(lines, style)
            times[is_whole].append(perf_counter() - began)
    drawn = iter(made)
    seconds = max(median(times[True]) - median(times[False]), 0.0)
    drawings = {name: [next(drawn) for _ in lines] for name, lines in icons.items()}
    return Peer(f"Inkscape, {style.name}", drawings, seconds / len(icons))


SVG, INKSCAPE = "http://www.w3.org/2000/svg", "http://www.inkscape.org/namespaces/inkscape"


def _inkscape(lines: Sequence[Line], style: LineStyle) -> Drawing:
    root = ElementTree.Element(f"{{{SVG}}}svg")
    root.set("viewBox", "0 0 256 256")
    root.set("width", "256")
    root.set("height", "256")
    styled = np.array(style.pairs[0].styled)
    pattern = fitted(styled[styled[:, 0] < styled[0, 0] + _PATTERN] @ [1, 1j], False)
    effect = {
        "effect": "skeletal", "id": "effect", "is_visible": "true", "lpeversion": "1",
        "pattern": Path((pattern,)).svg(), "copytype": "repeated_stretched", "prop_scale": "1",
        "scale_y_rel": "false", "spacing": "0", "normal_offset": "0", "tang_offset": "0",
        "prop_units": "false", "vertical_pattern": "false", "fuse_tolerance": "0",
    }  # fmt: skip
    ElementTree.SubElement(
        ElementTree.SubElement(root, f"{{{SVG}}}defs"), f"{{{INKSCAPE}}}path-effect", effect
    )
    for number, line in enumerate(lines):
        path = ElementTree.SubElement(
            root, f"{{{SVG}}}path", id=f"line{number}", style="fill:none;stroke:#000"
        )
        path.set(f"{{{INKSCAPE}}}original-d", _svg(line))
        path.set(f"{{{INKSCAPE}}}path-effect", "#effect")
    with TemporaryDirectory() as folder:
        given, drawn = FilePath(folder, "in.svg"), FilePath(folder, "out.svg")
        ElementTree.ElementTree(root).write(given)
        actions = f"select-all;object-to-path;export-filename:{drawn};export-plain-svg;export-do"
        subprocess.run(["inkscape", f"--actions={actions}", given], check=True, capture_output=True)
        found = {
            one.get("id"): one.get("d") for one in ElementTree.parse(drawn).iter(f"{{{SVG}}}path")
        }
    return [_pieces(_parsed(found[f"line{number}"])) for number in range(len(lines))]


def _parsed(data: str) -> Path:
    pen = PathPen()
    parse_path(data, pen)
    return pen.path


def _pieces(path: Path) -> list[Points]:
    return [np.concatenate([row, row[:1]]) if closed else row for row, closed in flattened(path)]


def _svg(line: Line) -> str:
    return Path((_contour(line),)).svg()


def _contour(line: Line) -> Contour:
    return fitted(np.array(line.points) @ [1, 1j], line.closed)


def table(icons: Mapping[str, Sequence[Line]], peers: Sequence[Peer]) -> str:
    """Return the figures of what was drawn, over all icons."""
    rows = [
        "| | seconds an icon | gap where a shape closes | gap where lines join "
        "| off the line: texture | as a whole | over the texture | repeats | by chance |",
        "| --- | --- | --- | --- | --- | --- | --- | --- | --- |",
    ]
    for peer in peers:
        found = [measured(icons[name], drawing) for name, drawing in peer.drawings.items()]
        closes = max(one.closes for one in found if one.closes is not None)
        joins = max(one.joins for one in found if one.joins is not None)
        rms, strays = (mean(getattr(one, what) for one in found) for what in ("rms", "strays"))
        repeats, chance = (
            median(value for one in found if (value := getattr(one, what)) is not None)
            for what in ("repeats", "chance")
        )
        rows.append(
            f"| {peer.name} | {_seconds(peer.seconds)} | {closes:.2f} | {joins:.2f} "
            f"| {rms:.2f} | {strays:.2f} "
            f"| {strays / rms:.2f} | {repeats:.2f} | {chance:.2f} |"
        )
    return "\n".join(rows)


def _seconds(seconds: float) -> str:
    return f"{seconds:.2g}" if seconds else "below noise"


def _texture(icons: Mapping[str, Sequence[Line]], peer: Peer) -> float:
    return mean(measured(icons[name], drawing).rms for name, drawing in peer.drawings.items())


def peers_table() -> str:
    """Draw the icons by all that is there, and return the table."""
    with Session() as session:
        icons = {name: session.lines(session.icon(name)) for name in ICONS}
    peers = []
    for name in STYLES:
        peers.append(ours(icons, named(name)))
        if shutil.which("inkscape"):
            peers.append(inkscape(icons, named(name)))
    if shutil.which("node") and FilePath("node_modules/roughjs").is_dir():
        peers.append(roughjs(icons, "rough.js", roughness=2))
        kept = roughjs(icons, "rough.js, vertices kept", roughness=2, preserveVertices=True)
        rough = 2 * _texture(icons, peers[0]) / _texture(icons, kept)
        same = f"rough.js, vertices kept, as rough as {STYLES[0]}"
        peers.append(kept)
        peers.append(roughjs(icons, same, roughness=rough, preserveVertices=True))
    return table(icons, peers)
