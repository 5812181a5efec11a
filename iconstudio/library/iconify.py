"""Reader of IconifyJSON, the format of the npm package ``@iconify/json``.

Of a set's icons, those with no name of their own but a parent (aliases) are other names of the
parent; aliases that turn or mirror their parent are not other drawings, and are left out.
"""

import json
from collections.abc import Iterator
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from iconstudio.model import IconstudioError


@dataclass(frozen=True, slots=True)
class IconSet:
    """A set: where it comes from, and whom to thank."""

    prefix: str
    name: str
    version: str
    author: str
    author_url: str
    license: str
    """SPDX identifier."""
    license_url: str
    category: str = ""
    tags: tuple[str, ...] = ()
    monochrome: bool = True

    @property
    def url(self) -> str:
        """Address of the set, or else where it can be seen."""
        return self.author_url or f"https://icon-sets.iconify.design/{self.prefix}/"


@dataclass(frozen=True, slots=True)
class RawIcon:
    """An icon as its set has it."""

    prefix: str
    name: str
    body: str
    """What stands inside of ``<svg>``."""
    view_box: str
    """``left top width height``"""
    aliases: tuple[str, ...] = ()
    categories: tuple[str, ...] = field(default=())

    @property
    def id(self) -> str:
        """``set:name``"""
        return f"{self.prefix}:{self.name}"


def document(body: str, view_box: str) -> str:
    """Return the complete SVG document of an icon."""
    xlink = ' xmlns:xlink="http://www.w3.org/1999/xlink"' if "xlink:" in body else ""
    return f'<svg xmlns="http://www.w3.org/2000/svg"{xlink} viewBox="{view_box}">{body}</svg>'


def read_set(path: Path) -> tuple[IconSet, tuple[RawIcon, ...]]:
    """Return a set and its visible icons, in the order of their names.

    Raises
    ------
    IconstudioError
        If the file is not IconifyJSON.
    """
    try:
        data = json.loads(path.read_text(encoding="utf-8"))
        return _set(data), tuple(_icons(data))
    except (OSError, ValueError, KeyError, TypeError, AttributeError) as error:
        raise IconstudioError(f"{path} is not an IconifyJSON file: {error!r}.") from None


def _set(data: dict[str, Any]) -> IconSet:
    info = data["info"]
    licence = info["license"]
    return IconSet(
        prefix=data["prefix"],
        name=info["name"],
        version=info.get("version", ""),
        author=info["author"]["name"],
        author_url=info["author"].get("url", ""),
        license=licence.get("spdx", ""),
        license_url=licence.get("url", ""),
        category=info.get("category", ""),
        tags=tuple(info.get("tags", ())),
        monochrome=not info.get("palette", True) and not info.get("hidden", False),
    )


def _icons(data: dict[str, Any]) -> Iterator[RawIcon]:
    icons: dict[str, dict[str, Any]] = data["icons"]
    names = other_names(data)
    categories: dict[str, list[str]] = {}
    for category, members in sorted(data.get("categories", {}).items()):
        for member in members:
            categories.setdefault(member, []).append(category)
    for name, icon in sorted(icons.items()):
        if icon.get("hidden") or _transforms(icon):
            continue
        left, top, width, height = (
            icon.get(key, data.get(key, default))
            for key, default in (("left", 0), ("top", 0), ("width", 16), ("height", 16))
        )
        yield RawIcon(
            prefix=data["prefix"],
            name=name,
            body=icon["body"],
            view_box=f"{left} {top} {width} {height}",
            aliases=tuple(names.get(name, ())),
            categories=tuple(categories.get(name, ())),
        )


def other_names(data: dict[str, Any]) -> dict[str, list[str]]:
    """Return each icon's aliases that neither turn, mirror nor hide it; parents may be chained."""
    aliases: dict[str, dict[str, Any]] = data.get("aliases", {})
    names: dict[str, list[str]] = {}
    for alias in sorted(aliases):
        name, seen = alias, set()
        while name in aliases and name not in seen and not _transforms(aliases[name]):
            seen.add(name)
            name = aliases[name]["parent"]
        if name in data["icons"] and not aliases[alias].get("hidden"):
            names.setdefault(name, []).append(alias)
    return names


def _transforms(icon: dict[str, Any]) -> bool:
    return bool(icon.get("rotate", 0) % 4 or icon.get("hFlip") or icon.get("vFlip"))
