"""Names of files that every system takes, from names that may be anything."""

import hashlib
import re
import unicodedata
from collections import Counter
from collections.abc import Mapping

_UNSAFE = re.compile(r"[^\w.+=@~()-]+|^[.-]+|[.-]+$")
_RESERVED = re.compile(r"(con|prn|aux|nul|com\d|lpt\d)(\..*)?", re.IGNORECASE)
"""Devices of Windows, whatever their suffix."""
_DIGESTED = re.compile(r"-[0-9a-f]{8}$", re.IGNORECASE)
_DIGITS = 8
_LONGEST = 60
"""Characters; most systems take 255 bytes."""


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


def _digest(identifier: str) -> str:
    return hashlib.sha256(identifier.encode(errors="replace")).hexdigest()[:_DIGITS]


def _safe(name: str) -> str:
    composed = unicodedata.normalize("NFC", name)
    name = _UNSAFE.sub("-", composed)[:_LONGEST].strip("-. ") or "icon"
    return f"icon-{name}" if _RESERVED.fullmatch(name) else name
