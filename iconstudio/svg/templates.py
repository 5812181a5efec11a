"""Templates of SF Symbols: a symbol in many weights and sizes, with guides and notes around it."""

import re
import xml.etree.ElementTree as ET

CHOSEN = "It is a template of SF Symbols, of which “{}” was read."

_GROUPS = {"Guides", "Symbols"}
_WEIGHTS = (
    "Ultralight", "Thin", "Light", "Regular", "Medium", "Semibold", "Bold", "Heavy", "Black",
)  # fmt: skip
_SIZES = "SML"
_NAME = re.compile(rf"({'|'.join(_WEIGHTS)})-([{_SIZES}])")


def usual(root: ET.Element) -> str | None:
    """Return the name of the symbol that a template is read as; None if it is none.

    That is “Regular-M”, or else the one of the nearest weight and size.
    """
    groups = {one.get("id"): one for one in root.iter("g")}
    if not groups.keys() >= _GROUPS:
        return None
    found = (_NAME.fullmatch(one.get("id", "")) for one in groups["Symbols"])
    names = [match for match in found if match]
    if not names:
        return None
    return min(names, key=_oddity)[0]


def _oddity(name: re.Match[str]) -> tuple[int, int]:
    """Return how far a weight, and a size, is from the usual one."""
    weight, size = _WEIGHTS.index(name[1]), _SIZES.index(name[2])
    return abs(weight - _WEIGHTS.index("Regular")), abs(size - _SIZES.index("M"))
