"""Where an icon that is dragged comes to lie: snapped to the canvas and to the other icons."""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace

from PySide6.QtCore import QPointF, QRectF

from iconstudio.gui.workspaces.montage.appearance import rect_of, transform_of
from iconstudio.model import CANVAS, MARGIN, Placement
from iconstudio.workflows.montage.page import IconShape

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
    def of(cls, boxes: Iterable[QRectF]) -> "Guides":
        """Return the canvas's edges, margins and centre lines, and those of other icons' boxes."""
        sheet = (CANVAS / 2, MARGIN, CANVAS - MARGIN, 0, CANVAS)
        boxes = list(boxes)
        xs = [x for one in boxes for x in (one.center().x(), one.left(), one.right())]
        ys = [y for one in boxes for y in (one.center().y(), one.top(), one.bottom())]
        return cls((*sheet, *xs), (*sheet, *ys))


@dataclass(frozen=True, slots=True)
class Snapped:
    """A placement, and the guides that it keeps to."""

    placement: Placement
    guides: Guides = Guides()


def moved(
    icon: IconShape, start: Placement, by: QPointF, guides: Guides = Guides(), grip: float = 0.0
) -> Snapped:
    """Return where an icon comes to lie that is moved ``by`` canvas pixels.

    ``grip`` is the distance, in canvas pixels, at which its centre lines and edges snap.
    """
    free = replace(start, dx=round(start.dx + by.x()), dy=round(start.dy + by.y()))
    box = rect_of(icon.placed_box(free))
    step_x = _step((box.center().x(), box.left(), box.right()), guides.xs, grip)
    step_y = _step((box.center().y(), box.top(), box.bottom()), guides.ys, grip)
    snapped = replace(free, dx=free.dx + round(step_x), dy=free.dy + round(step_y))
    return _told(icon, snapped, guides, grip)


def scaled(
    icon: IconShape,
    start: Placement,
    corner: int,
    to: QPointF,
    centred: bool = False,
    guides: Guides = Guides(),
    grip: float = 0.0,
) -> Snapped:
    """Return where an icon comes to lie whose ``corner`` is dragged to a point of the canvas.

    Corners are numbered from the top left, clockwise. The opposite one stays, or the
    centre if ``centred``.
    """
    box = rect_of(icon.placed_box(start))
    fixed = box.center() if centred else corners(box)[(corner + 2) % 4]
    arm = corners(box)[corner] - fixed
    factor = QPointF.dotProduct(to - fixed, arm) / max(QPointF.dotProduct(arm, arm), 1e-9)
    candidates = [(guide - fixed.x()) / arm.x() for guide in guides.xs if abs(arm.x()) > 1]
    candidates += [(guide - fixed.y()) / arm.y() for guide in guides.ys if abs(arm.y()) > 1]
    reach = max(abs(arm.x()), abs(arm.y()))
    nearest = min(candidates, key=lambda one: abs(one - factor), default=factor)
    if abs(nearest - factor) * reach <= grip:
        factor = nearest
    scale = min(max(start.scale * factor, SMALLEST), LARGEST)
    # The fixed point of the icon must come out where it was.
    inverse, _ = transform_of(start).inverted()
    there = transform_of(replace(start, scale=scale)).map(inverse.map(fixed))
    shift = fixed - there
    placement = replace(
        start, scale=scale, dx=round(start.dx + shift.x()), dy=round(start.dy + shift.y())
    )
    return _told(icon, placement, guides, grip)


def corners(box: QRectF) -> tuple[QPointF, ...]:
    """Return the corners of a box from the top left, clockwise."""
    return box.topLeft(), box.topRight(), box.bottomRight(), box.bottomLeft()


def kept_in(icon: IconShape, placement: Placement) -> Placement:
    """Return the nearest placement at which some of the icon's box lies on the canvas."""
    box = rect_of(icon.placed_box(placement))
    right, left = max(0.0, _KEPT_IN - box.right()), max(0.0, box.left() - CANVAS + _KEPT_IN)
    down, up = max(0.0, _KEPT_IN - box.bottom()), max(0.0, box.top() - CANVAS + _KEPT_IN)
    dx, dy = round(placement.dx + right - left), round(placement.dy + down - up)
    return replace(placement, dx=dx, dy=dy)


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
    box = rect_of(icon.placed_box(placement))
    xs, ys = (
        (box.center().x(), box.left(), box.right()),
        (box.center().y(), box.top(), box.bottom()),
    )
    return Snapped(placement, Guides(_met(xs, guides.xs), _met(ys, guides.ys)))


def _met(lines: Sequence[float], guides: Sequence[float]) -> tuple[float, ...]:
    return tuple({guide for guide in guides if any(abs(guide - line) <= 0.5 for line in lines)})
