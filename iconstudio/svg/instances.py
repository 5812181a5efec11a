"""Variables of CSS that what is repeated inherits from where it is (SVG 2, section 5.6)."""

import copy
import xml.etree.ElementTree as ET
from collections.abc import Sequence

from iconstudio.svg.stylesheet import Declared

Matched = tuple[ET.Element, list[Declared]]
_MOST = 20_000
"""Elements that are copied."""


def own_copies(
    root: ET.Element, matched: Sequence[Matched], parents: dict[ET.Element, ET.Element]
) -> list[Matched]:
    """Give each ``use`` that hands variables on its own copy of what it repeats.

    ``parents`` comes to say that these copies inherit from their ``use``.

    Returns
    -------
    The elements of the copies with the declarations for them.
    """
    declared = dict(matched)
    ids: dict[str, ET.Element] = {}
    for element in root.iter():
        ids.setdefault(element.get("id", ""), element)
    handing = {one for one, given in matched if any(name.startswith("--") for name, *_ in given)}
    if not handing:
        return []
    added: list[Matched] = []
    home = ET.Element("defs")
    waiting = [one for one, _ in matched if one.tag == "use"]
    for use in waiting:
        target = ids.get(use.get("href", "").removeprefix("#"))
        if target is None or len(added) >= _MOST or not _inherits(use, parents, handing):
            continue
        if not any(
            one.tag == "use" or any("var(" in value for _, value, _ in declared[one])
            for one in target.iter()
        ):
            continue
        own = copy.deepcopy(target)
        own.set("id", f"{target.get('id')} of {len(home)}")
        use.set("href", f"#{own.get('id')}")
        home.append(own)
        for before, after in zip(target.iter(), own.iter(), strict=True):
            given = [one for one in declared[before] if one[0] != "id"]
            declared[after] = [*given, ("id", after.get("id", ""), False)]
            added.append((after, list(declared[after])))
            parents.update((child, after) for child in after)
            if after.tag == "use":
                waiting.append(after)
        parents[own] = use
    if len(home):
        root.append(home)
    return added


def _inherits(
    use: ET.Element, parents: dict[ET.Element, ET.Element], handing: set[ET.Element]
) -> bool:
    """Whether an element, or one around it, has variables."""
    here: ET.Element | None = use
    while here is not None:
        if here in handing:
            return True
        here = parents.get(here)
    return False
