"""Rasterising (section 3.4): a pictogram becomes an exemplar on the canvas of side m = 256."""

import numpy as np
import scipy
from numpy.typing import NDArray

from iconstudio.model import CANVAS, MARGIN, Frame, IconstudioError
from iconstudio.svg.check import check
from iconstudio.svg.lengths import Box
from iconstudio.svg.resvg import page_of, render_coverage, view_box

_COARSE = 128
_FINE = 4 * CANVAS
"""Side of a picture that shows all lines of at least a quarter of a canvas pixel."""
_TRACE = 12
"""Darkness of a pixel of the coarse picture that such a line may cross."""
_BEYOND = 3
"""Pixels of the coarse picture that the point of a thick shape may reach beyond its ink."""
_BLOCK = np.ones((3, 3), bool)
"""Thin lines are narrower there."""
_TOLERANCE = 1 / 5
"""How far the bounding box may be off, in canvas pixels."""
_ROUNDS = 4
"""Most pictures by which a frame is fitted."""


def rasterise(svg: str) -> tuple[Frame, NDArray[np.uint8]]:
    """Draw a document so that its ink's tight bounding box fits the canvas, centred.

    Ink is what is more than half dark; a paler layer neither counts nor sets the
    bounding box. The document is hostile: call this in a worker process.

    Returns
    -------
    frame, coverage:
        The square of user space that fills the canvas, and its (CANVAS, CANVAS) uint8 picture.

    Raises
    ------
    IconstudioError
        If the document is refused, cannot be drawn, or has no ink.
    """
    check(svg)
    frame, side = _around_ink(svg, _square(view_box(svg)))
    coverage = render_coverage(svg, frame, side)
    if side == CANVAS and (wider := _around_thin_lines(svg, frame, coverage)):
        frame, coverage = wider, render_coverage(svg, wider, _FINE)
    frame, coverage = _fitted(svg, frame, coverage)
    if ink_bounds(coverage) is None:
        raise IconstudioError(
            "It has no dark ink: it is empty, white, or pale all over. "
            "Fill its shapes with a dark colour; turn text into shapes."
        )
    return frame, coverage if len(coverage) == CANVAS else render_coverage(svg, frame, CANVAS)


def _around_ink(svg: str, frame: Frame) -> tuple[Frame, int]:
    """Return a frame roughly around the ink within a frame, and the side at which all of it shows.

    If the coarse picture shows no ink, that is the frame itself: a finer one may.
    """
    coverage = render_coverage(svg, frame, _COARSE)
    if wider := _around_thin_lines(svg, frame, coverage):
        return wider, _FINE
    bounds = ink_bounds(coverage)
    return frame if bounds is None else _zoom(frame, bounds, _COARSE), CANVAS


def _fitted(svg: str, frame: Frame, coverage: NDArray[np.uint8]) -> tuple[Frame, NDArray[np.uint8]]:
    """Return the frame that the ink fits, and its picture; ``coverage`` is that of a rough frame.

    All pictures are of one side. The first may show thin parts that a coarse one has missed.
    """
    side = len(coverage)
    for _ in range(_ROUNDS - 1):
        bounds = ink_bounds(coverage)
        if bounds is None or _fits(_scaled(bounds, CANVAS / side)):
            break
        frame = _zoom(frame, bounds, side)
        coverage = render_coverage(svg, frame, side)
    return frame, coverage


def _around_thin_lines(svg: str, frame: Frame, coverage: NDArray[np.uint8]) -> Frame | None:
    """Return the frame around the ink as a fine picture shows it; None if it is as ``coverage`` is.

    It is drawn only if something leaves traces beyond the ink.
    """
    bounds = ink_bounds(coverage)
    if bounds is None or not _leaves_traces(coverage, bounds):
        return None
    fine = ink_bounds(render_coverage(svg, frame, _FINE))
    if fine is None or not _differ(_scaled(fine, len(coverage) / _FINE), bounds):
        return None
    return _zoom(frame, fine, _FINE)


def rasterise_page(svg: str) -> tuple[Frame, NDArray[np.uint8]]:
    """Draw a document so that its page fits the canvas: icons of a set keep their common scale.

    What is too thin to show there, in the corner of a large page, is drawn as by ``rasterise``. So
    are the returned values and the errors.
    """
    check(svg)
    frame = page_frame(svg)
    coverage = render_coverage(svg, frame, CANVAS)
    return (frame, coverage) if (coverage > 127).any() else rasterise(svg)


def page_frame(svg: str) -> Frame:
    """Return the square around a document's page, which is in its middle."""
    return _square(page_of(svg))


def ink_bounds(coverage: NDArray[np.uint8]) -> tuple[float, float, float, float] | None:
    """Return left, top, right, bottom of the ink in pixels; None if there is none.

    A pixel's coverage says how far an edge reaches into it, so bounds are fractions
    of a pixel.
    """
    left, right = _extent(coverage.max(axis=0))
    top, bottom = _extent(coverage.max(axis=1))
    return None if left == right else (left, top, right, bottom)


def _extent(profile: NDArray[np.uint8]) -> tuple[float, float]:
    """Return where ``profile`` crosses half dark for the first and the last time."""
    dark = np.flatnonzero(profile > 127)
    if not len(dark):
        return 0.0, 0.0
    first, last = int(dark[0]), int(dark[-1])
    return first + 1 - _reach(profile, first, -1), last + _reach(profile, last, 1)


def _reach(profile: NDArray[np.uint8], end: int, step: int) -> float:
    """Return how far ink reaches from the inner side of the pixel ``end`` outwards, in pixels."""

    def at(i: int) -> float:
        return int(profile[i]) / 255 if 0 <= i < len(profile) else 0.0

    # What lies two pixels out is no part of the edge but a paler layer.
    pale = at(end + 2 * step)
    return at(end) + max(0.0, at(end + step) - pale)


def _leaves_traces(coverage: NDArray[np.uint8], bounds: Box) -> bool:
    """Whether something lies beyond the ink that may be too thin to be dark, and no paler area."""
    faint = coverage >= _TRACE
    if not _is_beyond(faint, bounds):
        return False
    areas = scipy.ndimage.binary_dilation(scipy.ndimage.binary_erosion(faint, _BLOCK), _BLOCK, 2)
    return _is_beyond(faint & ~areas, bounds)


def _is_beyond(faint: NDArray[np.bool_], bounds: Box) -> bool:
    rows, columns = (np.flatnonzero(faint.any(axis=axis)) for axis in (1, 0))
    if not len(rows):
        return False
    left, top, right, bottom = bounds
    beyond = (left - columns[0], top - rows[0], columns[-1] + 1 - right, rows[-1] + 1 - bottom)
    return float(max(beyond)) > _BEYOND


def _differ(one: Box, other: Box) -> bool:
    """Whether two bounds are others, but for the points of thick shapes."""
    return max(abs(a - b) for a, b in zip(one, other, strict=True)) > _BEYOND


def _scaled(bounds: Box, factor: float) -> Box:
    left, top, right, bottom = bounds
    return left * factor, top * factor, right * factor, bottom * factor


def _fits(bounds: tuple[float, float, float, float]) -> bool:
    left, top, right, bottom = bounds
    errors = (
        max(right - left, bottom - top) - (CANVAS - 2 * MARGIN),
        (left + right - CANVAS) / 2,
        (top + bottom - CANVAS) / 2,
    )
    return max(map(abs, errors)) <= _TOLERANCE


def _square(box: Box) -> Frame:
    x, y, width, height = box
    size = max(width, height)
    return Frame(x + (width - size) / 2, y + (height - size) / 2, size)


def _zoom(frame: Frame, bounds: tuple[float, float, float, float], resolution: int) -> Frame:
    """Return the frame in which ``bounds`` fill the canvas but for its margin."""
    left, top, right, bottom = bounds
    unit = frame.size / resolution
    size = max(right - left, bottom - top) * unit * CANVAS / (CANVAS - 2 * MARGIN)
    x = frame.x + (left + right) / 2 * unit - size / 2
    y = frame.y + (top + bottom) / 2 * unit - size / 2
    return Frame(x, y, size)
