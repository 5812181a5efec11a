"""Animated drawings (SMIL): where their animations end, they stay.

What goes on without end, and begins with nothing, is shown in the middle of its way.
"""

import copy
import re
import xml.etree.ElementTree as ET
from collections.abc import Sequence

import numpy as np

from iconstudio.svg.lengths import NUMBER, numbers

_ANIMATIONS = ("animate", "animateColor", "animateTransform", "animateMotion", "set")
_BY_HAND = re.compile(r"click|mouse|focus|key|touch|accessKey|indefinite", re.IGNORECASE)
_CHAINED = re.compile(r"\.(?:begin|end)\b")
_ATTRIBUTES = ("d", "points", "href", "xlink:href", "viewBox", "class", "offset")
_SIZES = ("r", "width", "height")
"""Attributes that are 0 unless something else is said."""
_NOTHING_IF_ZERO = (
    *_SIZES, "rx", "ry", "opacity", "fill-opacity", "stroke-opacity", "stroke-width",
)  # fmt: skip
_NO_SCALE = re.compile(
    r"scale\(\s*0*\.?0*\s*[,)\s]|matrix\(\s*0[\s,]+0[\s,]+0[\s,]+0[\s,]", re.IGNORECASE
)
_SMALL = 4
"""How many times larger something becomes that begins far too small."""
_LONG = 0.25
"""How much of a line a dash and its gap are that run along it, and are no dashes to see."""
_MOMENTS = (0.5, 0.25, 0.75, 0.1, 0.9, 0.0, 1.0)
"""Parts of the time that an animation takes, the best first."""
MOVING = "The drawing moves; it is taken as it stands before it does."
ENDED = "The drawing moves; it is taken as it stands at the end."
MIDWAY = "The drawing moves; it is taken as it stands in the middle."
RUNNING = "Lines that run along without end were drawn whole."
IN_PARTS = "The drawing moves; parts of it are taken before they do, in the middle or at the end."


def moves(markup: str) -> bool:
    """Whether a drawing may be animated."""
    return "<animate" in markup or "<set" in markup or "@keyframes" in markup


def as_one(remarks: Sequence[str]) -> list[str]:
    """Return remarks, each once; what is said of parts that stand otherwise is one sentence."""
    moments = {MOVING, MIDWAY, ENDED}
    several = len(moments.intersection(remarks)) > 1
    return list(dict.fromkeys(IN_PARTS if several and one in moments else one for one in remarks))


def finish(root: ET.Element, midway: bool = False) -> list[str]:
    """Give every animated attribute the value that it keeps, in place, and take animations out.

    Animations that repeat without end, or leave nothing behind, are not followed, unless there is
    nothing before they begin. ``midway``, animations that end with nothing are not followed to
    their end either.

    Returns
    -------
    Sentences that say which moment is shown.
    """
    remarks = []
    for target, animations in _animated(root).items():
        going_on = [one for one in animations if not _end(one, target)]
        chained = any(_CHAINED.search(one.get("begin", "")) for one in animations)
        nothing = (going_on or chained or midway) and vanishes(_state(target, animations))
        if any(_runs(one, target) for one in going_on):
            target.set("style", f"{target.get('style', '').rstrip('; ')};stroke-dasharray:none")
            remarks.append(RUNNING)
        elif nothing or _is_best_midway(target, [one for one in going_on if _is_endless(one)]):
            _show_midway(target, animations)
            remarks.append(MIDWAY)
        elif going_on:
            remarks.append(MOVING)
        elif not all(_waits(one) or one.tag == "set" for one in animations):
            remarks.append(ENDED)
    return remarks


def vanishes(state: dict[str, str]) -> bool:
    """Whether something with these values of attributes, or properties, is not seen."""
    dashes, offset = (numbers(state.get(f"stroke-dash{one}", "")) for one in ("array", "offset"))
    return (
        any(name in _NOTHING_IF_ZERO and _is_zero(value) for name, value in state.items())
        or state.get("visibility") in ("hidden", "collapse")
        or state.get("display") == "none"
        or _NO_SCALE.search(state.get("transform", "")) is not None
        or (len(dashes) % 2 == 0 and bool(dashes) and not any(dashes[::2]))
        or (len(dashes) == 1 and bool(offset) and 0 < dashes[0] <= abs(offset[0]))
    )


def _is_zero(value: str) -> bool:
    return numbers(value)[:1] == [0.0]


def _animated(root: ET.Element) -> dict[ET.Element, list[ET.Element]]:
    """Take all animations out; return them by what they animate."""
    ids = {element.get("id"): element for element in root.iter() if element.get("id")}
    for reference in root.iter("mpath"):
        shape = ids.get(reference.get("href", "").removeprefix("#"))
        reference.set("path", "" if shape is None else _outline(shape))
    found: dict[ET.Element, list[ET.Element]] = {}
    for parent in list(root.iter()):
        for animation in [child for child in parent if child.tag in _ANIMATIONS]:
            parent.remove(animation)
            name = animation.get("href", "").removeprefix("#")
            target = ids.get(name) if name else parent
            if target is not None:
                found.setdefault(target, []).append(animation)
    for animations in found.values():
        animations.sort(key=lambda one: one.tag == "animateMotion")  # around all other transforms
    return found


def _state(target: ET.Element, animations: Sequence[ET.Element]) -> dict[str, str]:
    """Return the values that an element has of what is animated."""
    names = {one.get("attributeName", "") for one in animations}
    if "stroke-dashoffset" in names:
        names.add("stroke-dasharray")
    style = dict(
        (name.strip(), value.strip())
        for name, _, value in (one.partition(":") for one in target.get("style", "").split(";"))
    )
    found = {}
    for name in names - {""}:
        value = style.get(name, target.get(name, "0" if name in _SIZES else None))
        if value is not None:
            found[name] = value
    return found


def _end(animation: ET.Element, target: ET.Element) -> bool:
    """Apply an animation's end to its target; false if it has none."""
    if _waits(animation):
        return True  # until someone does something, it stands still
    stays = animation.get("fill") == "freeze" or (
        animation.tag == "set" and not animation.get("dur") and not animation.get("end")
    )
    if _is_endless(animation) or not stays:
        return False
    return _apply(animation, target, 1.0)


def _waits(animation: ET.Element) -> bool:
    """Whether an animation begins only when somebody does something."""
    return _BY_HAND.search(animation.get("begin", "")) is not None


def _is_endless(animation: ET.Element) -> bool:
    return "indefinite" in (animation.get("repeatCount"), animation.get("repeatDur"))


def _is_best_midway(target: ET.Element, endless: Sequence[ET.Element]) -> bool:
    """Whether what goes on without end is no good as it begins.

    It is elsewhere, or it grows out of next to nothing, or into nothing.
    """
    if any(one.tag == "animateMotion" or _grows(one) for one in endless):
        return True
    names = {one.get("attributeName") for one in endless}
    last = copy.copy(target)
    last.attrib = dict(target.attrib)
    for one in endless:
        _apply(one, last, 1.0)
    return len(names) > 1 and vanishes(_state(last, endless))


def _runs(animation: ET.Element, target: ET.Element) -> bool:
    """Whether a long dash runs along an open line without end, as of wind."""
    if not _is_endless(animation) or animation.get("attributeName") != "stroke-dashoffset":
        return False
    if target.tag not in ("path", "line", "polyline") or "z" in target.get("d", "").lower():
        return False
    from iconstudio.svg.geometry import data_length  # loads fontTools

    dashes = numbers(target.get("stroke-dasharray", ""))
    period = sum(dashes) * (1 + len(dashes) % 2)
    return period > _LONG * data_length(_outline(target))


def _grows(animation: ET.Element) -> bool:
    """Whether something begins far smaller than it becomes."""
    if animation.get("attributeName") not in _SIZES and animation.get("type") != "scale":
        return False
    sizes = [numbers(_at(animation, moment) or "")[:1] for moment in sorted(_MOMENTS)]
    return [] not in sizes and abs(sizes[0][0]) * _SMALL < max(abs(one[0]) for one in sizes)


def _show_midway(target: ET.Element, animations: Sequence[ET.Element]) -> None:
    """Apply animations as they are at the first moment at which something may be seen."""
    if _NO_SCALE.search(target.get("transform", "")):
        del target.attrib["transform"]  # to which nothing could be added
    before = target.get("transform")
    for moment in _MOMENTS:
        target.attrib.pop("transform", None)
        if before is not None:
            target.set("transform", before)
        for animation in animations:
            if not _waits(animation):
                _apply(animation, target, moment)
        if not vanishes(_state(target, animations)):
            return


def _apply(animation: ET.Element, target: ET.Element, moment: float) -> bool:
    """Give a target the value at a moment from 0 to 1; false if that is not known."""
    if animation.tag == "animateMotion":
        return _move(animation, target, moment)
    value = _at(animation, moment)
    name = animation.get("attributeName", "")
    if value is None:
        return False
    if animation.tag == "animateTransform":
        added = f"{animation.get('type', 'translate')}({value})"
        before = target.get("transform", "") if animation.get("additive") == "sum" else ""
        target.set("transform", f"{before} {added}".strip())
    elif name in _ATTRIBUTES:
        target.set(name.removeprefix("xlink:"), value)
    elif name:
        # Above style sheets, as animations are.
        target.set("style", f"{target.get('style', '').rstrip('; ')};{name}:{value}".lstrip(";"))
    return True


def _move(animation: ET.Element, target: ET.Element, moment: float) -> bool:
    """Put a target where it is on its way at a moment; false if there is no way."""
    from iconstudio.svg.geometry import along  # loads fontTools

    points = numbers(animation.get("keyPoints", "").replace(";", " "))
    times = numbers(animation.get("keyTimes", "").replace(";", " "))
    if points:
        times = times if len(times) == len(points) else list(np.linspace(0, 1, len(points)))
        moment = float(np.interp(moment, times, points))
    place = along(_way(animation), moment)
    if place is None:
        return False
    x, y, angle = place
    turned = animation.get("rotate", "0")
    if turned.startswith("auto"):
        angle += 180 if turned == "auto-reverse" else 0
    else:
        angle = (numbers(turned) or [0.0])[0]
    before = target.get("transform", "")
    target.set("transform", f"translate({x:.6g} {y:.6g}) rotate({angle:.6g}) {before}".strip())
    return True


def _way(animation: ET.Element) -> str:
    """Return the path data of a motion (SVG 1.1, section 19.2.14)."""
    referred = next((one.get("path", "") for one in animation.iter("mpath")), "")
    if said := referred or animation.get("path", ""):
        return said
    places = [one for one in animation.get("values", "").split(";") if one.strip()]
    if not places:
        to = animation.get("to", animation.get("by"))
        places = [animation.get("from", "0,0"), *([to] if to else [])]
    pairs = (numbers(place) for place in places)
    return "".join(f"{'L' if number else 'M'}{x} {y}" for number, (x, y) in enumerate(pairs))


def _outline(shape: ET.Element) -> str:
    from iconstudio.svg.geometry import path_data

    return path_data(shape, (0.0, 0.0, 100.0, 100.0))


def _at(animation: ET.Element, moment: float) -> str | None:
    """Return the value of an animation at a moment: between two of its values if they allow."""
    values = [one.strip() for one in animation.get("values", "").split(";") if one.strip()]
    if not values:
        values = [one for one in (animation.get("from"), animation.get("to")) if one is not None]
    if moment == 1 or len(values) < 2:
        return values[-1] if values else None
    place = moment * (len(values) - 1)
    before, after = values[int(place)], values[min(int(place) + 1, len(values) - 1)]
    part, ends = place % 1, numbers(after)
    if animation.get("calcMode") == "discrete" or len(numbers(before)) != len(ends):
        return before
    if NUMBER.sub("", before) != NUMBER.sub("", after):
        return before
    mixed = iter([(1 - part) * a + part * b for a, b in zip(numbers(before), ends, strict=True)])
    return NUMBER.sub(lambda _: f"{next(mixed):.6g}", before)
