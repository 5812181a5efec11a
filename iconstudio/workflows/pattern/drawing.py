"""A pattern is synthesised and traced, in a worker process."""

from concurrent.futures import CancelledError
from dataclasses import dataclass

from iconstudio.model import ColouredLayer, Path
from iconstudio.tasks import remembered, stopped
from iconstudio.workflows.pattern.imaging import ImageExemplar
from iconstudio.workflows.pattern.layout import Arrangement, Layout, rasterised

Source = Arrangement | ImageExemplar

SAMPLES = 0.5
"""Pixels in which a canvas is synthesised, to a unit: its contours are finer."""

_TRIES = 3
"""So many seeds are tried at most while something is torn."""


@dataclass(frozen=True, slots=True)
class Drawn:
    """The layers of a pattern, in pixels, from back to front, and a colour behind them, or none."""

    size: tuple[int, int]
    """Rows and columns."""
    layers: tuple[ColouredLayer, ...]
    ground: str
    torn: float
    remark: str = ""
    """A sentence for the user about how the exemplar was read, if there is anything to say."""


def draw(
    source: Source,
    fill: Path | None,
    size: tuple[int, int],
    tile: bool,
    seed: int,
    coarse: bool,
) -> Drawn:
    """Return a pattern of so many rows and columns, or, of a tile, hardly more or fewer.

    Rows of elements are then even: a tile fits their period.

    Parameters
    ----------
    fill
        The shape that it fills, in its pixels.
    coarse
        Whether the first preview is wanted.
    """
    from iconstudio.algorithms.patterns.periods import fitting_size
    from iconstudio.algorithms.patterns.prepared import Prepared
    from iconstudio.algorithms.patterns.selection import best
    from iconstudio.algorithms.patterns.synthesis import Settings, synthesised
    from iconstudio.algorithms.patterns.vector import vectorise

    def prepare() -> tuple[Layout, Prepared]:
        layout = source.layout(SAMPLES)
        return layout, Prepared.of(layout.exemplar)

    found, prepared = remembered(("exemplar", source), prepare)
    if tile:
        size = fitting_size(size, found.period)
    rows, columns = size
    guidance = None if fill is None else rasterised(fill, columns, rows)
    settings = Settings(size, tile, seed, guidance=guidance)
    if coarse:
        pattern = next(synthesised(prepared, settings, _ask))
    else:
        *_, pattern = best(prepared, settings, _TRIES, _ask)
    layers = vectorise(pattern, found.elements or None, _ask, curves=not coarse)
    return Drawn(size, layers, found.ground, pattern.torn, found.remark)


def _ask() -> None:
    if stopped():
        raise CancelledError
