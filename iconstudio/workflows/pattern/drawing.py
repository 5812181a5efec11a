"""A pattern is synthesised and traced, in a worker process."""

from concurrent.futures import CancelledError
from dataclasses import dataclass

import numpy as np

from iconstudio.model import Fill, Path
from iconstudio.tasks import remembered, stopped
from iconstudio.workflows.pattern import imaging, layout
from iconstudio.workflows.pattern.imaging import ImageExemplar
from iconstudio.workflows.pattern.layout import Arrangement, Layout, rasterised

Source = Arrangement | ImageExemplar

SAMPLES = 0.5
"""Pixels in which a canvas is synthesised, to a unit: its contours are finer."""


@dataclass(frozen=True, slots=True)
class Drawn:
    """The shapes of a pattern, in pixels, from back to front, and what lies behind them."""

    layers: tuple[Fill, ...]
    ground: str
    torn: float


def draw(
    source: Source,
    fill: Path | None,
    size: tuple[int, int],
    tile: bool,
    seed: int,
    coarse: bool,
) -> Drawn:
    """Return a pattern of so many rows and columns.

    Parameters
    ----------
    fill
        The shape that it fills, in its pixels.
    coarse
        Whether the first preview is wanted.
    """
    from iconstudio.algorithms.patterns.prepared import Prepared
    from iconstudio.algorithms.patterns.synthesis import Settings, synthesised

    found = remembered(("layout", source), lambda: _laid_out(source))
    prepared = remembered(("prepared", source), lambda: Prepared.of(found.exemplar))
    rows, columns = size
    guidance = None if fill is None else rasterised(fill, columns, rows)
    settings = Settings(size, tile, seed, guidance=guidance)
    for pattern in synthesised(prepared, settings, _ask):
        if coarse:
            break
    return traced(pattern, found)


def _ask() -> None:
    if stopped():
        raise CancelledError


def _laid_out(source: Source) -> Layout:
    if isinstance(source, ImageExemplar):
        return imaging.laid_out(source, SAMPLES)
    return layout.laid_out(source, SAMPLES)


def traced(pattern, found: Layout) -> Drawn:  # PROVISIONAL
    """Trace."""
    from iconstudio.algorithms.tracing.potrace import traced as potrace

    layers = []
    for m in reversed(range(len(pattern.distances))):
        ink = pattern.distances[m] < -1
        if not ink.any():
            continue
        colour = "#" + bytes((255 * np.median(pattern.colours[ink], axis=0)).astype(np.uint8)).hex()
        layers.append(Fill(potrace(pattern.distances[m] < 0), colour))
    return Drawn(tuple(layers), found.ground, pattern.torn)
