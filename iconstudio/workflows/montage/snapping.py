"""Where an icon that is dragged comes to lie: snapped to the canvas and to the other icons."""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace

from iconstudio.model import CANVAS, MARGIN, Placement, Point
from iconstudio.workflows.montage.page import Box, IconShape

SMALLEST, LARGEST = 0.1, 8.0
"""Range of the scale that dragging can give."""

_KEPT_IN = 8
"""At least so many canvas pixels of an icon's box stay on the canvas."""


@dataclass(frozen=True, slots=True)
class Guides:
    """The lines that icons snap to: upright ones at ``xs``, level ones at ``ys``."""

    xs: tuple[float, ...] = ()
    ys: tuple[float, ...] = ()

    @classmethod
    def of(cls, boxes: Iterable[Box]) -> "Guides":
        """Return the canvas's edges, margins and centre lines, and those of other icons' boxes."""
        sheet = (CANVAS / 2, MARGIN, CANVAS - MARGIN, 0, CANVAS)
        lines = [_lines(one) for one in boxes]
        xs, ys = (tuple(at for one in lines for at in one[axis]) for axis in (0, 1))
        return cls((*sheet, *xs), (*sheet, *ys))


@dataclass(frozen=True, slots=True)
class Snapped:
    """A placement, and the guides that it keeps to."""

    placement: Placement
    guides: Guides = Guides()


def moved(
    icon: IconShape, start: Placement, by: Point, guides: Guides = Guides(), grip: float = 0.0
) -> Snapped:
    """Return where an icon comes to lie that is moved ``by`` canvas pixels.

    ``grip`` is the distance, in canvas pixels, at which its centre lines and edges snap.
    """
    free = replace(start, dx=round(start.dx + by[0]), dy=round(start.dy + by[1]))
    xs, ys = _lines(icon.placed_box(free))
    step_x, step_y = _step(xs, guides.xs, grip), _step(ys, guides.ys, grip)
    snapped = replace(free, dx=free.dx + round(step_x), dy=free.dy + round(step_y))
    return _told(icon, snapped, guides, grip)


def scaled(
    icon: IconShape,
    start: Placement,
    corner: int,
    to: Point,
    centred: bool = False,
    guides: Guides = Guides(),
    grip: float = 0.0,
) -> Snapped:
    """Return where an icon comes to lie whose ``corner`` is dragged to a point of the canvas.

    Corners are numbered from the top left, clockwise. The opposite one stays, or the
    centre if ``centred``.
    """
    box = icon.placed_box(start)
    fixed = centre(box) if centred else corners(box)[(corner + 2) % 4]
    arm, pulled = _from(fixed, corners(box)[corner]), _from(fixed, to)
    square = arm[0] * arm[0] + arm[1] * arm[1]
    factor = (pulled[0] * arm[0] + pulled[1] * arm[1]) / max(square, 1e-9)
    candidates = [
        (guide - fixed[axis]) / arm[axis]
        for axis, some in enumerate((guides.xs, guides.ys))
        for guide in some
        if abs(arm[axis]) > 1
    ]
    nearest = min(candidates, key=lambda one: abs(one - factor), default=factor)
    if abs(nearest - factor) * max(abs(arm[0]), abs(arm[1])) <= grip:
        factor = nearest
    scale = min(max(start.scale * factor, SMALLEST), LARGEST)
    # The fixed point of the icon must come out where it was.
    own = start.transform.inverse().transformPoint(fixed)
    dx, dy = _from(replace(start, scale=scale).transform.transformPoint(own), fixed)
    placement = replace(start, scale=scale, dx=round(start.dx + dx), dy=round(start.dy + dy))
    return _told(icon, placement, guides, grip)


def corners(box: Box) -> tuple[Point, ...]:
    """Return the corners of a box from the top left, clockwise."""
    left, top, right, bottom = box
    return (left, top), (right, top), (right, bottom), (left, bottom)


def centre(box: Box) -> Point:
    """Return the middle of a box."""
    left, top, right, bottom = box
    return (left + right) / 2, (top + bottom) / 2


def kept_in(icon: IconShape, placement: Placement) -> Placement:
    """Return the nearest placement at which some of the icon's box lies on the canvas."""
    left, top, right, bottom = icon.placed_box(placement)
    dx = max(0.0, _KEPT_IN - right) - max(0.0, left - CANVAS + _KEPT_IN)
    dy = max(0.0, _KEPT_IN - bottom) - max(0.0, top - CANVAS + _KEPT_IN)
    return replace(placement, dx=round(placement.dx + dx), dy=round(placement.dy + dy))


def _from(start: Point, end: Point) -> Point:
    return end[0] - start[0], end[1] - start[1]


def _lines(box: Box) -> tuple[tuple[float, ...], tuple[float, ...]]:
    """Return where the upright and the level centre lines and edges of a box are."""
    (x, y), (left, top, right, bottom) = centre(box), box
    return (x, left, right), (y, top, bottom)


def _step(lines: Sequence[float], guides: Sequence[float], grip: float) -> float:
    """Return the shortest step that brings one of ``lines`` to a guide; 0 if all are far."""
    steps = [guide - line for line in lines for guide in guides]
    nearest = min(steps, key=abs, default=0.0)
    return nearest if abs(nearest) <= grip else 0.0


def _told(icon: IconShape, placement: Placement, guides: Guides, grip: float) -> Snapped:
    """Find the guides that a placement keeps to; an icon lies on whole pixels, guides need not."""
    placement = kept_in(icon, placement)
    if grip <= 0:
        return Snapped(placement)
    xs, ys = _lines(icon.placed_box(placement))
    return Snapped(placement, Guides(_met(xs, guides.xs), _met(ys, guides.ys)))


def _met(lines: Sequence[float], guides: Sequence[float]) -> tuple[float, ...]:
    return tuple({guide for guide in guides if any(abs(guide - line) <= 0.5 for line in lines)})
