"""Sheets: the grid of a run, what a search found, and the gallery, as in the paper's figures."""

from collections import defaultdict
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray
from PIL import Image

from iconstudio.algorithms.raster import placed_ink
from iconstudio.files import write_bytes
from iconstudio.grammar import counted
from iconstudio.model import CANVAS, Composite, Exemplar, Polygon, Remix, Source
from iconstudio.output import png
from iconstudio.output.colours import SIGNIFICANT, Palette, colour_code, key_of, palette
from iconstudio.output.figure import ACCENT, MUTED, PALE, WARNING, Figure
from iconstudio.output.request import Request

_EDGE = 40
_GAP = 12
_CELL = 168
"""Side of a result, in pixels."""
_THUMB = 104
_ACROSS = 3
_SIDE = _ACROSS * (_THUMB + _GAP) + 2 * _GAP
"""Width of the column of sources."""
_HEAD = 190
_WHOLE = 0.95
"""A pictogram with this share of the ink is the result, but for crumbs."""
_VERDICTS = {
    "remixed": (ACCENT, "joined from parts of several icons"),
    "existing": ((232, 190, 60), "one existing icon would do"),
    "failed": (WARNING, "failed"),
}


@dataclass(frozen=True, slots=True)
class Row:
    """A style: its results from the lowest lambda_S to the highest, or why it has none."""

    style: str
    retrieved: int
    remixes: tuple[Remix, ...]
    skipped: str = ""
    recommended: float | None = None
    """lambda_S of the result to look at first."""


@dataclass(frozen=True, slots=True)
class Subject:
    """A cell of the gallery; without ``remix`` it says why there is none."""

    name: str
    polygon: Polygon
    remix: Remix | None
    remark: str = ""
    failed: bool = False


def grid_sheet(request: Request, lambdas: Sequence[float], rows: Sequence[Row]) -> Image.Image:
    """Return the contact sheet of a run as a picture.

    A row a style, a column a lambda_S, each result above its colour code; at the left what was
    asked for, and the sources that contribute most. The recommended results are framed.
    """
    lambdas = sorted(lambdas)
    left = _EDGE + _SIDE + 2 * _GAP
    height = 2 * _CELL + 3 * _GAP + 52
    heights = [height if row.remixes else 110 for row in rows]
    width = left + len(lambdas) * (_CELL + _GAP) + _EDGE
    figure = Figure(max(width, 900), _HEAD + sum(heights) + _EDGE)
    for bitmap, colour in request.layers:
        figure.stencil(_EDGE - 8, 24, 150, grey(bitmap), colour)
    words = figure.picture.width - 2 * _EDGE - 160
    figure.text(_EDGE + 160, 52, request.keyword, 34, bold=True, width=words - 180)
    figure.text(_EDGE + 160, 98, request.caption, 18, colour=MUTED, width=words)
    _column_heads(figure, lambdas, left)
    if any(row.recommended is not None for row in rows):
        right = figure.picture.width - _EDGE
        said = figure.text(right, 58, "recommended", 16, colour=MUTED, anchor="ra")
        figure.frame(right - said - 26, 58, 16, 16, ACCENT)
    top = _HEAD
    for row, step in zip(rows, heights, strict=True):
        figure.rule(top, _EDGE, figure.picture.width - _EDGE)
        _row(figure, row, lambdas, left, top)
        top += step
    return figure.picture


def search_sheet(exemplars: Sequence[Exemplar], word: str, path: Path) -> None:
    """Draw the exemplars of a keyword into a PNG file, each with its identifier beneath.

    Raises
    ------
    IconstudioError
        If the file cannot be written.
    """
    across, side = 10, 120
    step_x, step_y = side + 3 * _GAP, side + 64
    lines = -(-len(exemplars) // across)
    figure = Figure(2 * _EDGE + across * step_x, 110 + lines * step_y + _EDGE)
    figure.text(_EDGE, 36, word, 34, bold=True, width=across * step_x - 200)
    count = counted(len(exemplars), "icon")
    figure.text(figure.picture.width - _EDGE, 48, count, 20, colour=MUTED, anchor="ra")
    for number, exemplar in enumerate(exemplars):
        x = _EDGE + number % across * step_x
        y = 100 + number // across * step_y
        figure.stencil(x + _GAP, y, side, exemplar.coverage)
        collection, name = exemplar.id.split(":", 1)
        middle, width = x + _GAP + side / 2, step_x - 8
        figure.text(
            middle, y + side + 4, f"{collection}:", 13, colour=MUTED, width=width, anchor="ma"
        )
        figure.text(middle, y + side + 21, name, 13, width=width, anchor="ma")
    write_bytes(path, png.encoded(figure.picture))


def gallery_sheet(subjects: Sequence[Subject], across: int = 4) -> Image.Image:
    """Return a cell for each subject: sketch, result, colour code.

    The frames are those of the paper's figure 17: yellow where one existing icon would do, blue
    where only parts of several fit, red where the result is no good.
    """
    side = 150
    step_x, step_y = 3 * side + 5 * _GAP, side + 90
    lines = -(-len(subjects) // across)
    figure = Figure(2 * _EDGE + across * step_x - 2 * _GAP, 2 * _EDGE + lines * step_y + 10)
    for number, subject in enumerate(subjects):
        x = _EDGE + number % across * step_x
        y = _EDGE + number // across * step_y
        named = figure.text(x, y, subject.name, 20, bold=True, width=3 * side)
        figure.text(x + 3 * side + 2 * _GAP, y + 4, subject.remark, 15, colour=MUTED,
                  width=3 * side - named, anchor="ra")  # fmt: skip
        figure.polygon(x, y + 36, subject.polygon.fitted().vertices, side / CANVAS)
        if subject.remix is not None:
            composite, drawing = subject.remix.composite, subject.remix.drawing
            figure.stencil(x + side + _GAP, y + 36, side, drawing.coverage)
            figure.image(x + 2 * (side + _GAP), y + 36, colour_code(composite, drawing, side))
        colour, _ = _VERDICTS[_verdict(subject)]
        figure.frame(x + side + _GAP // 2, y + 30, 2 * side + 2 * _GAP, side + _GAP, colour)
    left, bottom = float(_EDGE), figure.picture.height - _EDGE - 6
    for colour, meaning in _VERDICTS.values():
        figure.frame(left, bottom - 1, 16, 16, colour)
        left += 26 + figure.text(left + 26, bottom, meaning, 16, colour=MUTED) + 36
    return figure.picture


def _verdict(subject: Subject) -> str:
    if subject.failed or subject.remix is None:
        return "failed"
    composite = subject.remix.composite
    owned: defaultdict[str, float] = defaultdict(float)
    for source, share in zip(composite.sources, composite.shares, strict=True):
        owned[source.exemplar.id] += share
    return "existing" if max(owned.values()) >= _WHOLE else "remixed"


def _column_heads(figure: Figure, lambdas: Sequence[float], left: float) -> None:
    if not lambdas:
        return
    right = left + len(lambdas) * (_CELL + _GAP) - _GAP
    y = _HEAD - 66
    if len(lambdas) > 2:
        figure.text(left, y, "closer to the sketch", 22, bold=True)
        figure.text(right, y, "smoother", 22, bold=True, anchor="ra")
        figure.arrow(left + 245, right - 125, y + 14)
    for number, value in enumerate(lambdas):
        x = left + number * (_CELL + _GAP) + _CELL / 2
        figure.text(x, _HEAD - 30, f"λ {value:.2g}", 16, colour=MUTED, anchor="ma")


def _row(figure: Figure, row: Row, lambdas: Sequence[float], left: float, top: float) -> None:
    figure.text(_EDGE, top + 16, row.style.capitalize(), 24, bold=True)
    count = counted(row.retrieved, "icon")
    figure.text(_EDGE + _SIDE - 2 * _GAP, top + 22, count, 16, colour=MUTED, anchor="ra")
    if not row.remixes:
        figure.paragraph(
            left, top + 22, row.skipped, 20, figure.picture.width - left - _EDGE, MUTED
        )
        return
    colours = palette([icon.composite for icon in row.remixes])
    _sources(figure, row, colours, top + 58)
    for icon in row.remixes:
        composite, drawing = icon.composite, icon.drawing
        number = min(range(len(lambdas)), key=lambda i: abs(lambdas[i] - composite.lambda_s))
        x = left + number * (_CELL + _GAP)
        if composite.lambda_s == row.recommended:
            figure.frame(x - 4, top + 24, _CELL + 8, 2 * _CELL + _GAP + 8, ACCENT)
        figure.stencil(x, top + 28, _CELL, drawing.coverage)
        code = colour_code(composite, drawing, _CELL, colours)
        figure.image(x, top + 28 + _CELL + _GAP, code)


@dataclass(frozen=True, slots=True, eq=False)
class _Used:
    """A source in all results of a row."""

    source: Source
    share: float
    """Mean part of the ink."""
    own: NDArray[np.bool_]
    """(CANVAS, CANVAS): what it owns in any result."""


def _sources(figure: Figure, row: Row, colours: Palette, top: float) -> None:
    """Draw the sources with most ink in the row where they lie, what they give in colour."""
    used = _used([icon.composite for icon in row.remixes])
    for number, one in enumerate(used[: 2 * _ACROSS]):
        x = _EDGE + number % _ACROSS * (_THUMB + _GAP)
        y = top + number // _ACROSS * (_THUMB + 62)
        ink, _ = placed_ink(one.source.exemplar, one.source.placement, len(one.own))
        figure.stencil(x, y, _THUMB, grey(ink), PALE)
        figure.stencil(x, y, _THUMB, grey(ink & one.own), colours[key_of(one.source)])
        collection, name = one.source.exemplar.id.split(":", 1)
        share = max(1, round(100 * one.share))
        figure.text(x, y + _THUMB + 4, name, 13, width=_THUMB)
        number_width = figure.text(x, y + _THUMB + 22, f"{share}%", 12, bold=True)
        figure.text(x + number_width + 6, y + _THUMB + 22, collection, 12, colour=MUTED,
                  width=_THUMB - number_width - 6)  # fmt: skip


def _used(composites: Sequence[Composite]) -> list[_Used]:
    """Return the significant sources of the results of a row, most ink first.

    They share their sources, but for mirrored ones: these have more, which come last.
    """
    sources = max((composite.sources for composite in composites), key=len)
    shares = np.zeros((len(composites), len(sources)))
    for row, composite in zip(shares, composites, strict=True):
        row[: len(composite.shares)] = composite.shares
    mean = shares.mean(axis=0)
    found = [
        _Used(source, float(mean[label]), np.any([c.labels == label for c in composites], axis=0))
        for label, source in enumerate(sources)
        if mean[label] >= SIGNIFICANT
    ]
    return sorted(found, key=lambda one: -one.share)


def grey(ink: NDArray[np.bool_]) -> NDArray[np.uint8]:
    """Return a bitmap as coverage, 255 = ink."""
    return np.where(ink, np.uint8(255), np.uint8(0))
