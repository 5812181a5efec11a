"""Path data and lists of points with a mistake: what comes before it is drawn (SVG 2, 9.5.4)."""

import re
import xml.etree.ElementTree as ET
from collections.abc import Iterable

BROKEN = (
    "The outline of a shape holds a mistake, and was drawn only as far as that. "
    "Save or copy the drawing again."
)

_NUMBER = r"[+-]?(?:\d++\.?\d*+|\.\d++)(?:[eE][+-]?\d++)?"
_GAP = r"\s*+,?\s*+"
_FLAG = "[01]"


def _segment(letters: str, *arguments: str) -> str:
    """Return the pattern of one command and all its arguments, which may repeat."""
    first = _GAP.join(arguments)
    # A comma before the next letter is one too many, which nobody minds.
    return rf"[{letters}]\s*+{first}(?:{_GAP}{first})*+(?:\s*+,)?+"


_PAIR = (_NUMBER, _NUMBER)
_MOVE = _segment("Mm", *_PAIR)
_SEGMENT = "|".join(
    (
        "[Zz]",
        _segment("MmLlTt", *_PAIR),
        _segment("HhVv", _NUMBER),
        _segment("Cc", *_PAIR * 3),
        _segment("SsQq", *_PAIR * 2),
        _segment("Aa", _NUMBER, _NUMBER, _NUMBER, _FLAG, _FLAG, *_PAIR),
    )
)
_SOUND = {
    "d": re.compile(rf"\s*+(?:{_MOVE}(?:\s*+(?:{_SEGMENT}))*+)?+"),
    "points": re.compile(rf"\s*+(?:{_GAP.join(_PAIR)}(?:{_GAP}{_GAP.join(_PAIR)})*+)?+"),
}
_NOTHING = re.compile(r"[\s,;]*+|none")


def cut_off_mistakes(drawn: Iterable[ET.Element]) -> list[str]:
    """Let outlines end at their first mistake, in place; return what to say of it."""
    found = False
    for element in drawn:
        for name, sound in _SOUND.items():
            data = element.get(name)
            if data is None:
                continue
            match = sound.match(data)
            assert match is not None  # at least nothing matches
            if not _NOTHING.fullmatch(data, match.end()):
                element.set(name, match[0])
                found = True
    return [BROKEN] if found else []
