"""Drawing a labelling from the SVG of its sources (section 3.4, post-processing), in a process.

A source is drawn only where it is needed: a renderer takes longer the more pixels there are.
"""

import math
from collections.abc import Mapping, Sequence
from concurrent.futures import Future
from contextlib import suppress
from dataclasses import dataclass, field
from functools import lru_cache
from typing import TYPE_CHECKING, Protocol

import numpy as np
from numpy.typing import NDArray

from iconstudio.algorithms.extremes import maximum_filter
from iconstudio.algorithms.iconification.energy import Labels, placed_sources
from iconstudio.algorithms.iconification.fragments import fragments
from iconstudio.algorithms.iconification.overhang import (
    continued,
    cropped,
    framed,
    overhang,
    owned_throughout,
)
from iconstudio.algorithms.iconification.redraw import (
    FAR,
    REACH,
    SCALE,
    binarised,
    erase,
    redraw,
    restore,
)
from iconstudio.algorithms.raster import Bitmap, inked_tiles, shifted
from iconstudio.model import CANVAS, Drawing, Exemplar, Frame, Placement, Source, Transform
from iconstudio.model.composite import WHOLE
from iconstudio.model.path import Path
from iconstudio.workers import Workers

if TYPE_CHECKING:
    from iconstudio.algorithms.tidying.sides import Sides

SECONDS = 30.0
MEMORY = 1 << 30
"""What drawing may take: in bytes, more than the process has when it begins."""
PREVIEW = 2
"""Drawn pixels to a canvas pixel, in previews."""
_TILES = 64
"""What is needed of a source is told by tiles, so many to a side of the canvas."""
_BLOCK = 32
"""Sources are drawn by blocks of so many units: larger ones have more than is needed, and of
smaller ones each costs half a millisecond."""
_LARGE = 1.5
"""Up to this scale an exemplar is drawn once for all its placements."""
_AROUND = -(-(REACH + FAR) * _TILES // CANVAS)
"""Tiles around a region in which its owner's drawing counts."""
_COVERAGE = 2 * CANVAS
"""Side of a drawing's coverage, in pixels."""
_OTHER, _FEW = 64, 8
"""Shades by which a pixel is another one, and how many of a path may be so by another rule of
filling: with more, its contours overlap."""
_MOST = 2048
"""Side of the largest drawing that is traced, in pixels."""


class Render(Protocol):
    """Draws exemplars at their placement. It can be a key."""

    def __hash__(self) -> int: ...

    def __call__(
        self,
        svg: str,
        frame: Frame,
        placement: Placement,
        size: int,
        window: tuple[int, int, int, int] | None = None,
    ) -> NDArray[np.uint8]:
        """Draw the canvas, (size, size) uint8, or a window of it.

        ``window`` is left, top, right and bottom in pixels, and may reach beyond the canvas.
        """
        ...

    def outline(self, svg: str, frame: Frame) -> Path:
        """Return what the ink of an exemplar is enclosed by; empty if its shapes do not tell."""
        ...


def draw(
    labels: Labels,
    ink: NDArray[np.bool_],
    sources: Sequence[Source],
    render: Render,
    scale: int = SCALE,
    marked: Bitmap | None = None,
    exact: bool = True,
    heal: bool = True,
) -> Drawing:
    """Redraw a labelling from its owners' SVG without its crumbs, and trace it.

    Parameters
    ----------
    labels
        (m, m): index of each pixel's owner.
    ink
        (K, m, m) bool: the sources on the canvas.
    scale
        Drawn pixels to a canvas pixel: 2, 4 or 8, and no fewer than there are labels.
    marked
        (m, m) bool: what the user wants to keep; nothing of it goes.
    exact
        Whether the path takes the sources' own curves where it runs along them.
    heal
        Whether sources are moved to meet, seams made anew, and what these bring about is put
        right, unless something is marked.
    """
    from iconstudio.algorithms.iconification.joined_path import joined_sides, path_along
    from iconstudio.algorithms.tracing.vectorize import trace

    m, nobody = len(labels), len(sources)
    pad = overhang(labels, ink, sources)
    if pad:
        scale = scale // 2 if scale * (CANVAS + 2 * pad) > _MOST else scale
        ink, _ = placed_sources(sources, m, pad * m // CANVAS)
        labels = continued(labels, ink)
        ink = np.concatenate([ink, np.zeros_like(ink[:1])])
        marked = None if marked is None else np.pad(marked, pad * m // CANVAS)
    coverages = _drawn(labels, sources, render, scale, pad)
    coverage = redraw(labels, coverages)
    erase(coverage, fragments(labels, ink, marked=marked), marked)
    if marked is not None:
        restore(coverage, labels, coverages, marked)
    owners, frame = None, WHOLE
    if pad:
        frame = framed(coverage, pad)
        coverage = cropped(coverage, pad, frame)
        owners = owned_throughout(cropped(labels, pad, frame, nobody), nobody)
    if exact:
        outlines = [
            _outline(one, frame, render) if number in coverages else Path()
            for number, one in enumerate(sources)
        ]
        heal = heal and marked is None
        contours = joined_sides(coverage, outlines, heal)
        plain = path_along(contours)
        tidy = _tidied(contours, _pens(contours, sources, frame, render), plain) if heal else plain
        for path in (tidy, plain) if tidy != plain else (plain,):
            drawn = _picture(path, "nonzero", render)
            if _is_plain(path, drawn, render):
                return Drawing(path, drawn, owners, frame, None if path is plain else plain)
    return Drawing(trace(coverage), _reduced(coverage), owners, frame)


def _tidied(contours: "Sequence[Sides]", pens: Mapping[int, float], plain: Path) -> Path:
    """Return the path of contours with what seams brought about put right.

    If anything else came of that, it is ``plain``, their path as they are.
    """
    from iconstudio.algorithms.iconification.joined_path import path_along
    from iconstudio.algorithms.tidying.tidying import tidied

    for widths in (pens, {}):
        found = tidied(contours, widths)
        if found == contours:
            return plain
        path = path_along(found)
        if _has_parts(path, plain, len(contours) - len(found)):
            return path
    return plain


def _has_parts(path: Path, other: Path, fewer: int) -> bool:
    """Whether a path has as many pieces and as many holes as another one but for so many."""
    (pieces, holes), (more, most) = (
        np.bincount([Path((one,)).area < 0 for one in some.contours], minlength=2)
        for some in (path, other)
    )
    return bool(pieces <= more and holes <= most and more - pieces + most - holes == fewer)


def _pens(
    contours: "Sequence[Sides]", sources: Sequence[Source], frame: Frame, render: Render
) -> dict[int, float]:
    """Return how wide the pens are that drew the sources of contours, if any did."""
    owners = {side.owner for sides in contours for side in sides if side.owner >= 0}
    if len(owners) < 2:
        return {}
    widths = {owner: _pen(sources[owner].exemplar, render) for owner in owners}
    return {
        owner: width * sources[owner].placement.scale * CANVAS / frame.size
        for owner, width in widths.items()
        if width is not None
    }


def _pen(exemplar: Exemplar, render: Render) -> float | None:
    return _pen_of(render, exemplar.pictogram.svg, exemplar.frame)


@lru_cache(maxsize=256)
def _pen_of(render: Render, svg: str, frame: Frame) -> float | None:
    from iconstudio.algorithms.tidying.pens import pen_of

    return pen_of(_outline_of(render, svg, frame))


def draw_whole(
    source: Source, ink: NDArray[np.bool_], workers: Workers, render: Render
) -> "Future[Drawing]":
    """Begin to draw one source as results are drawn; ``ink`` is its, (CANVAS, CANVAS)."""
    nobody = np.zeros((CANVAS, CANVAS), dtype=np.uint8)
    return workers.submit(draw, nobody, ink[None], [source], render, timeout=SECONDS, memory=MEMORY)


def _drawn(
    labels: Labels, sources: Sequence[Source], render: Render, scale: int, pad: int
) -> Mapping[int, NDArray[np.uint8]]:
    """Draw every owner wherever it counts: the canvas, enlarged by ``pad`` units on each side."""
    units = CANVAS + 2 * pad
    count = units * _TILES // CANVAS
    tile = np.arange(len(labels)) * count // len(labels)
    owned = np.zeros((len(sources) + 1, count, count), dtype=bool)
    owned[labels, tile[:, None], tile] = True
    coverages = {}
    for label in map(int, np.flatnonzero(owned.any(axis=(1, 2)))):
        if label == len(sources):  # nobody
            coverages[label] = np.zeros((units * scale, units * scale), dtype=np.uint8)
            continue
        near = maximum_filter(owned[label], 2 * _AROUND + 1)
        coverages[label] = _placed(sources[label], near, render, scale, pad)
    return coverages


def _placed(
    source: Source, near: Bitmap, render: Render, finer: int, beyond: int
) -> NDArray[np.uint8]:
    """Draw a source, complete in the tiles that are ``near`` at least.

    The canvas is enlarged by ``beyond`` units on each side, of ``finer`` pixels each.
    """
    exemplar, placement = source.exemplar, source.placement
    scale, flip, dx, dy = placement.scale, placement.flip, placement.dx, placement.dy
    picture = render, exemplar.pictogram.svg, exemplar.frame
    unit, side = CANVAS // _TILES, finer * CANVAS
    needed = near.repeat(unit, axis=0).repeat(unit, axis=1)
    if scale > _LARGE:  # too large to be drawn whole
        key = _DrawingKey(*picture, placement, side, beyond, exemplar)
        return _tiled_drawing(key).shown(needed)
    pad = _BLOCK * max(0, math.ceil(CANVAS / 2 * (scale - 1) / _BLOCK))
    drawing = _tiled_drawing(_DrawingKey(*picture, Placement(scale), side, pad, exemplar))
    before = shifted(needed, -dx, -dy, CANVAS + 2 * pad, False)
    coverage = drawing.shown(before[:, ::-1] if flip else before)
    shown = side + 2 * beyond * finer
    return shifted(coverage[:, ::-1] if flip else coverage, dx * finer, dy * finer, shown)


@dataclass(frozen=True)
class _DrawingKey:
    """What tells one drawing from another."""

    render: Render
    svg: str
    frame: Frame
    placement: Placement
    side: int
    pad: int
    """By how many units the canvas is enlarged on each side."""
    exemplar: Exemplar = field(compare=False)


class _TiledDrawing:
    """An exemplar, drawn block by block as they are needed, in two tones.

    A renderer draws a curve a little differently where a window ends. So the blocks are always the
    same: a drawing does not depend on what was drawn before.
    """

    def __init__(self, key: _DrawingKey) -> None:
        self._key = key
        self._units = CANVAS + 2 * key.pad
        pixels = self._units * key.side // CANVAS
        self._coverage = np.zeros((pixels, pixels), dtype=np.uint8)
        tiles = self._units * _TILES // CANVAS
        self._missing = inked_tiles(key.exemplar, key.placement, tiles, key.pad)

    def shown(self, needed: Bitmap) -> NDArray[np.uint8]:
        """Return the drawing, complete where it is ``needed``, a bitmap of canvas units."""
        tiles, blocks = len(self._missing), self._units // _BLOCK
        inked = self._missing.reshape(blocks, tiles // blocks, blocks, tiles // blocks)
        wide = needed.reshape(tiles, self._units // tiles, tiles, -1).any(axis=(1, 3))
        for row, column in np.argwhere((inked & wide.reshape(inked.shape)).any(axis=(1, 3))):
            self._draw(int(row), int(column))
            inked[row, :, column] = False
        return self._coverage

    def _draw(self, row: int, column: int) -> None:
        key = self._key
        finer = key.side // CANVAS
        step = _BLOCK * finer
        top, left = row * step, column * step
        # One more pixel around, for the edges between ink and paper.
        x, y = left - key.pad * finer - 1, top - key.pad * finer - 1
        window = x, y, x + step + 2, y + step + 2
        drawn = key.render(key.svg, key.frame, key.placement, key.side, window)
        self._coverage[top : top + step, left : left + step] = binarised(drawn)[1:-1, 1:-1]


@lru_cache(maxsize=48)
def _tiled_drawing(key: _DrawingKey) -> _TiledDrawing:
    """Remember drawings, 1 to 4 MiB each.

    The results of a style share most of their exemplars, and one often lies at several places.
    """
    return _TiledDrawing(key)


def _is_plain(path: Path, drawn: NDArray[np.uint8], render: Render) -> bool:
    """Whether a path looks the same by both rules of filling; ``drawn`` is it by the nonzero one.

    It is drawn by the other one only if the areas leave a doubt.
    """
    from iconstudio.algorithms.regions import RegionError, doubled

    pixel = (CANVAS / _COVERAGE) ** 2
    with suppress(RegionError):
        if doubled(path) < _FEW * _OTHER / 255 * pixel:
            return True
    other = _picture(path, "evenodd", render)
    return bool((abs(drawn.astype(np.int16) - other) > _OTHER).sum() <= _FEW)


def _picture(path: Path, rule: str, render: Render) -> NDArray[np.uint8]:
    """Draw a path, filled by a rule, as results are drawn."""
    return render(svg_of(path, rule), WHOLE, Placement(), _COVERAGE)


def svg_of(path: Path, rule: str = "nonzero") -> str:
    """Return a document that shows a path, filled by a rule, on the canvas."""
    box = f"0 0 {CANVAS} {CANVAS}"
    shape = f'<path d="{path.svg()}" fill-rule="{rule}"/>'
    return f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="{box}">{shape}</svg>'


def _outline(source: Source, frame: Frame, render: Render) -> Path:
    """Return the outline of a source at its placement, in units of the ``frame`` of the canvas."""
    exemplar, unit = source.exemplar, CANVAS / frame.size
    to_frame = Transform(unit, 0, 0, unit, -frame.x * unit, -frame.y * unit)
    outline = _outline_of(render, exemplar.pictogram.svg, exemplar.frame)
    return outline.transformed(to_frame.transform(source.placement.transform))


@lru_cache(maxsize=256)
def _outline_of(render: Render, svg: str, frame: Frame) -> Path:
    return render.outline(svg, frame)


def _reduced(coverage: NDArray[np.uint8]) -> NDArray[np.uint8]:
    from PIL import Image

    side = len(coverage)
    if side == _COVERAGE:
        return coverage
    image = Image.fromarray(coverage)
    if side % _COVERAGE == 0:
        return np.asarray(image.reduce(side // _COVERAGE))
    return np.asarray(image.resize((_COVERAGE, _COVERAGE), Image.Resampling.BOX))
