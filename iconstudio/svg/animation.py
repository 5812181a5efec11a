"""Animated drawings (SMIL): where their animations end, they stay.

What goes on without end, and begins with nothing, is shown in the middle of its way.
"""

import re
import xml.etree.ElementTree as ET
from collections.abc import Sequence

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
_MOMENTS = (0.5, 0.25, 0.75, 0.1, 0.9, 0.0, 1.0)
"""Parts of the time that an animation takes, the best first."""
MOVING = "The drawing moves; it is taken as it stands before it does."
MIDWAY = "The drawing moves; it is taken as it stands in the middle."


def moves(markup: str) -> bool:
    """Whether a drawing may be animated."""
    return "<animate" in markup or "<set" in markup or "@keyframes" in markup


def finish(root: ET.Element, midway: bool = False) -> list[str]:
    """Give every animated attribute the value that it keeps, in place, and take animations out.

    Animations that repeat without end, or leave nothing behind, are not followed, unless there is
    nothing before they begin. ``midway``, animations that end with nothing are not followed to
    their end either.

    Returns
    -------
    A sentence if there are some of these.
    """
    remarks = []
    for target, animations in _animated(root).items():
        going_on = [one for one in animations if not _end(one, target)]
        chained = any(_CHAINED.search(one.get("begin", "")) for one in animations)
        if (going_on or chained or midway) and vanishes(_state(target, animations)):
            _show_midway(target, animations)
            remarks.append(MIDWAY)
        elif going_on:
            remarks.append(MOVING)
    return remarks


def vanishes(state: dict[str, str]) -> bool:
    """Whether something with these values of attributes, or properties, is not seen."""
    dashes, offset = (numbers(state.get(f"stroke-dash{one}", "")) for one in ("array", "offset"))
    return (
        any(name in _NOTHING_IF_ZERO and _is_zero(value) for name, value in state.items())
        or state.get("visibility") in ("hidden", "collapse")
        or state.get("display") == "none"
        or _NO_SCALE.search(state.get("transform", "")) is not None
        or (len(dashes) == 1 and bool(offset) and 0 < dashes[0] <= abs(offset[0]))
    )


def _is_zero(value: str) -> bool:
    return numbers(value)[:1] == [0.0]


def _animated(root: ET.Element) -> dict[ET.Element, list[ET.Element]]:
    """Take all animations out; return them by what they animate."""
    ids = {element.get("id"): element for element in root.iter() if element.get("id")}
    found: dict[ET.Element, list[ET.Element]] = {}
    for parent in list(root.iter()):
        for animation in [child for child in parent if child.tag in _ANIMATIONS]:
            parent.remove(animation)
            name = animation.get("href", "").removeprefix("#")
            target = ids.get(name) if name else parent
            if target is not None:
                found.setdefault(target, []).append(animation)
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
    if _BY_HAND.search(animation.get("begin", "")):
        return True  # until someone does so, it stands still
    endless = "indefinite" in (animation.get("repeatCount"), animation.get("repeatDur"))
    stays = animation.get("fill") == "freeze" or (
        animation.tag == "set" and not animation.get("dur") and not animation.get("end")
    )
    if endless or not stays:
        return False
    return _apply(animation, target, 1.0)


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
            if not _BY_HAND.search(animation.get("begin", "")):
                _apply(animation, target, moment)
        if not vanishes(_state(target, animations)):
            return


def _apply(animation: ET.Element, target: ET.Element, moment: float) -> bool:
    """Give a target the value at a moment from 0 to 1; false if that is not known."""
    value = _at(animation, moment)
    name = animation.get("attributeName", "")
    if animation.tag == "animateMotion" or value is None:
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
