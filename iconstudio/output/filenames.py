"""Names of files that every system takes, from names that may be anything."""

import hashlib
import itertools
import os
import re
import unicodedata
from collections import Counter
from collections.abc import Mapping
from pathlib import Path

from iconstudio.model import IconstudioError

_UNSAFE = re.compile(r"[^\w.+=@~()-]+|^[.-]+|[.-]+$")
_RESERVED = re.compile(r"(con|prn|aux|nul|com\d|lpt\d)(\..*)?", re.IGNORECASE)
"""Devices of Windows, whatever their suffix."""
_DIGESTED = re.compile(r"-[0-9a-f]{8}$", re.IGNORECASE)
_DIGITS = 8
_LONGEST = 60
"""Characters; most systems take 255 bytes."""
_TITLE = 150
"""Most bytes of a name that come from a title; what is added needs room, too."""


def file_stems(names: Mapping[str, str]) -> dict[str, str]:
    """Return a file name without suffix for each identifier, made of its name, no two alike.

    They differ also where upper and lower case are the same. A name that cannot be kept as it
    is, or that others have, ends with a digest of the identifier.

    >>> file_stems({"set:arrow": "arrow", "set:a/b": "a/b"})
    {'set:arrow': 'arrow', 'set:a/b': 'a-b-3c7d5158'}
    """
    safe = {identifier: _safe(name) for identifier, name in names.items()}
    alike = Counter(name.casefold() for name in safe.values())

    def kept(identifier: str) -> bool:
        name = safe[identifier]
        alone = alike[name.casefold()] == 1 and not _DIGESTED.search(name)
        return alone and name == names[identifier]

    return {
        identifier: name if kept(identifier) else f"{name}-{_digest(identifier)}"
        for identifier, name in safe.items()
    }


def file_name(title: str) -> str:
    """Return a title as the beginning of a file name.

    >>> file_name("Dog & cat, medium")
    'dog---cat--medium'
    """
    words = "".join(c if c.isalnum() else "-" for c in title.strip().lower()).strip("-")
    short = words.encode()[:_TITLE].decode(errors="ignore").strip("-")
    return short or "icon"


def free_path(folder: Path, name: str, suffix: str) -> Path:
    """Return a path in ``folder`` at which there is nothing yet."""
    names = itertools.chain([name], (f"{name}-{number}" for number in itertools.count(2)))
    return next(path for one in names if not os.path.lexists(path := folder / f"{one}{suffix}"))


def suffixed(path: Path, suffix: str) -> Path:
    """Return a chosen path with the right suffix: no SVG is called “dog.png”, or “dog 1.2”.

    Raises
    ------
    IconstudioError
        If that would replace a file of which nobody was asked.
    """
    if path.suffix.lower() == suffix:
        return path
    path = path.with_name(f"{path.name}{suffix}")
    if os.path.lexists(path):
        raise IconstudioError(f"“{path}” is there already. Save under another name.")
    return path


def _digest(identifier: str) -> str:
    return hashlib.sha256(identifier.encode(errors="replace")).hexdigest()[:_DIGITS]


def _safe(name: str) -> str:
    composed = unicodedata.normalize("NFC", name)
    name = _UNSAFE.sub("-", composed)[:_LONGEST].strip("-. ") or "icon"
    return f"icon-{name}" if _RESERVED.fullmatch(name) else name
