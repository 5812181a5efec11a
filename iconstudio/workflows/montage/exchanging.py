"""The montage of a result in which a part is another icon's, and all the rest stays as it is.

Of a result that takes another one's place, as a symmetric one does, the page makes no such result
once a part is pinned. So there the rest is held as in a montage.
"""

from collections import Counter
from dataclasses import replace

from iconstudio.algorithms.iconification.guidance import mirror_image
from iconstudio.model import CANVAS, Axis, Composite, Layer, Montage, Placement, Stroke
from iconstudio.workflows.montage.montage import MOST
from iconstudio.workflows.montage.reproducing import reproduction
from iconstudio.workflows.montage.strokes import cut


def exchanged(composite: Composite, pin: Layer) -> Montage:
    """Return the montage that reproduces a composite, where what ``pin`` marks is its icon's.

    If the composite is symmetric, what is exchanged is so, too.
    """
    new = _with_mirror_image(composite, pin)
    clear: list[Layer] = []
    for layer in (*new, *reproduction(composite).layers[: MOST - len(new)]):
        above = [stroke for one in clear for stroke in one.strokes]
        if strokes := cut(layer.strokes, above):
            clear.append(replace(layer, strokes=strokes))
    return Montage(tuple(reversed(clear)))


def _with_mirror_image(composite: Composite, pin: Layer) -> tuple[Layer, ...]:
    """Return a pin, and its mirror image where the composite has an axis of symmetry."""
    match composite.symmetry:
        case None:
            return (pin,)
        case Axis.HORIZONTAL:
            return _halves(pin, _aside(composite))
        case axis:  # places that mirror each other have one source, as it lies
            both = tuple(_mirrored(stroke, axis, 0) for stroke in pin.strokes)
            return (replace(pin, strokes=pin.strokes + both),)


def _halves(pin: Layer, aside: int) -> tuple[Layer, ...]:
    """Return a pin in the half where most of it lies, and the mirror image of that."""
    axis = (CANVAS + aside) / 2
    xs = [x - axis for stroke in pin.strokes for x, _ in stroke.points]
    sign = 1 if sum(xs) > 0 else -1
    beyond = axis - sign * CANVAS / 2
    other = Stroke(float(CANVAS), ((beyond, -CANVAS / 2), (beyond, 1.5 * CANVAS)))
    strokes = cut(pin.strokes, [other])
    if not strokes:  # nothing but the axis is marked
        return (pin,)
    place = pin.placement
    twin = Placement(place.scale, not place.flip, aside - place.dx, place.dy)
    mirrored = tuple(_mirrored(stroke, Axis.HORIZONTAL, aside) for stroke in strokes)
    return replace(pin, strokes=strokes), Layer(pin.icon, twin, mirrored)


def _mirrored(stroke: Stroke, axis: Axis, aside: int) -> Stroke:
    points = (mirror_image(point, axis) for point in stroke.points)
    return Stroke(stroke.width, tuple((x + aside, y) for x, y in points))


def _aside(composite: Composite) -> int:
    """Return twice by how much the axis lies to the right of the canvas's, in canvas pixels.

    Sources and their mirror images tell.
    """
    told: Counter[int] = Counter()
    some = [composite.sources[label] for label in composite.owners()]
    for one in some:
        for other in some:
            a, b = one.placement, other.placement
            same = one.exemplar.id == other.exemplar.id
            if same and a.flip < b.flip and (a.scale, a.dy) == (b.scale, b.dy):
                told[a.dx + b.dx] += 1
    return told.most_common(1)[0][0] if told else 0
