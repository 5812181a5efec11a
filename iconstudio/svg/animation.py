"""Animated drawings (SMIL): where their animations end, they stay."""

import re
import xml.etree.ElementTree as ET

_ANIMATIONS = ("animate", "animateColor", "animateTransform", "animateMotion", "set")
_BY_HAND = re.compile(r"click|mouse|focus|key|touch|accessKey|indefinite", re.IGNORECASE)
MOVING = "The drawing moves; it is taken as it stands before it does."


def finish(root: ET.Element) -> list[str]:
    """Give every animated attribute the value that it keeps, in place, and take animations out.

    Animations that repeat without end, or leave nothing behind, are not followed.

    Returns
    -------
    A sentence if there are some of these.
    """
    remarks = []
    ids = {element.get("id"): element for element in root.iter() if element.get("id")}
    for parent in list(root.iter()):
        for animation in [child for child in parent if child.tag in _ANIMATIONS]:
            parent.remove(animation)
            name = animation.get("href", "").removeprefix("#")
            target = ids.get(name) if name else parent
            if target is not None and not _end(animation, target):
                remarks.append(MOVING)
    return remarks


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
    value = _last(animation)
    name = animation.get("attributeName", "")
    if animation.tag == "animateMotion" or value is None:
        return False
    if animation.tag == "animateTransform":
        added = f"{animation.get('type', 'translate')}({value})"
        before = target.get("transform", "") if animation.get("additive") == "sum" else ""
        target.set("transform", f"{before} {added}".strip())
    elif name in ("d", "points", "href", "xlink:href", "viewBox", "class", "offset"):
        target.set(name.removeprefix("xlink:"), value)
    elif name:
        # Above style sheets, as animations are.
        target.set("style", f"{target.get('style', '').rstrip('; ')};{name}:{value}".lstrip(";"))
    return True


def _last(animation: ET.Element) -> str | None:
    values = [one.strip() for one in animation.get("values", "").split(";") if one.strip()]
    return values[-1] if values else animation.get("to")
