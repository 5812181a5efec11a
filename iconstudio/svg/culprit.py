"""Which part of a drawing it is that cannot be read: what it can be read without."""

import copy
import xml.etree.ElementTree as ET
from collections.abc import Callable, Iterable
from time import perf_counter

_SECONDS = 2.0
"""For looking. Of a drawing that takes long to read, not the smallest part may be found."""
_LONGEST = 60
"""Most characters of a part that are told."""


def culprit(root: ET.Element, is_readable: Callable[[ET.Element], bool]) -> str | None:
    """Return the smallest part that a drawing can be read without, as SVG has it, shortened.

    That is an element, with the one attribute that is to blame if there is one; None if more than
    one are. ``is_readable`` tells of a copy of the drawing, which it may change.
    """
    until = perf_counter() + _SECONDS
    path: list[int] = []

    def readable(leave_out: Callable[[ET.Element], object]) -> bool:
        if perf_counter() > until:
            return False
        changed = copy.deepcopy(root)
        leave_out(_at(changed, path))
        return is_readable(changed)

    def readable_without(first: int, end: int) -> bool:
        return readable(lambda element: element.__delitem__(slice(first, end)))

    while (place := _only(len(_at(root, path)), readable_without)) is not None:
        path.append(place)
    element = _at(root, path)
    for name in element.attrib:
        if readable(lambda changed, name=name: changed.attrib.pop(name)):  # type: ignore[misc]
            return _written(element, [name])
    return _written(element, element.attrib) if path else None


def _only(count: int, readable_without: Callable[[int, int], bool]) -> int | None:
    """Return which one of so many must be left out; None if there is none such, or several."""
    first, end = 0, count
    if not count or not readable_without(first, end):
        return None
    while end - first > 1:
        middle = (first + end) // 2
        if readable_without(first, middle):
            end = middle
        elif readable_without(middle, end):
            first = middle
        else:
            return None
    return first


def _at(root: ET.Element, path: Iterable[int]) -> ET.Element:
    for place in path:
        root = root[place]
    return root


def _written(element: ET.Element, names: Iterable[str]) -> str:
    said = "".join(f' {name}="{element.attrib[name]}"' for name in names)
    text = f"<{element.tag}{said}>"
    return text if len(text) <= _LONGEST else f"{text[:_LONGEST]}…"
