"""``CREDITS.md``: whom to thank for the icons in a folder."""

import re
from collections.abc import Mapping, Sequence
from dataclasses import replace

from iconstudio.grammar import counted
from iconstudio.model import Credit

_SPECIAL = re.compile(r"([\\`*_\[\]<>#|])")


def credits_page(name: str, style: str, credits: Mapping[str, Sequence[Credit]]) -> str:
    """Return the page, in Markdown; ``credits`` are those of each file.

    Files that have the same author and licence are listed together.
    """
    files: dict[Credit, dict[str, str]] = {}
    for file, those in credits.items():
        for one in those:
            files.setdefault(replace(one, title=""), {})[file] = one.title
    lines = [
        "# Credits",
        "",
        f"The icons in this folder are those of “{_plain(name)}”, restyled with Iconstudio in the "
        f"line style “{_plain(style)}”. They were made of works by:",
        "",
    ]
    for credit, works in sorted(files.items(), key=lambda item: (-len(item[1]), repr(item[0]))):
        titles = set(works.values())
        named = f"“{_plain(titles.pop())}” by " if len(titles) == 1 else ""
        lines.append(f"- {named}{_line(credit)}: {_which(tuple(works), len(credits))}")
    return "\n".join(lines) + "\n"


def _line(credit: Credit) -> str:
    licence = _linked(credit.license, credit.license_url)
    return ", ".join(filter(None, (_linked(credit.author, credit.url), licence)))


def _linked(words: str, address: str) -> str:
    if not address.startswith(("https://", "http://")):
        return _plain(words)
    safe = re.sub(r"[\s<>]", "", address)
    return f"[{_plain(words) or safe}](<{safe}>)"


def _which(files: Sequence[str], count: int) -> str:
    if len(files) == count:
        return f"{'all ' * (count > 1)}{counted(count, 'icon')}"
    return ", ".join(map(_plain, files))


def _plain(text: str) -> str:
    """Return text on one line that Markdown shows as it is."""
    return _SPECIAL.sub(r"\\\1", " ".join(text.split()))
