"""Entities that a document declares within itself, written out, within bounds.

Their number, length and depth do not matter, but what they make together does: expat's own bounds
come too late. What is outside of the document is never read.
"""

import contextlib
import re
from xml.parsers import expat

from iconstudio.model import IconstudioError

MOST = 1_000_000
"""Characters that all entities of a document may make together."""
DEEPEST = 8

TOO_MUCH = (
    f"Its entities make more than {MOST:,} characters, or are nested more than {DEEPEST} deep. "
    "Save it as plain SVG."
)
_PIECE = re.compile(r"<!\[CDATA\[.*?\]\]>|<!--.*?-->|<[^<>]*>|&[A-Za-z_][\w.-]*;", re.DOTALL)
_REFERENCE = re.compile(r"&([A-Za-z_][\w.-]*);")
_OF_ATTRIBUTES = str.maketrans({"<": "&lt;", '"': "&quot;", "'": "&apos;"})
OF_XML = ("amp", "lt", "gt", "quot", "apos")
"""Entities that every document has."""


def written_out(text: str) -> str:
    """Return a document in which the entities that it declares are written out.

    Raises
    ------
    IconstudioError
        If one lies outside of the document, or they make too much.
    """
    if "<!ENTITY" not in text:
        return text
    entities, start = _declared(text)
    return text[:start] + _Writer(entities).written(text[start:], 0)


def _declared(text: str) -> tuple[dict[str, str], int]:
    """Return the entities that a document declares, and where its content begins."""
    data = text.encode()
    entities: dict[str, str] = {}
    ends = [0]
    parser = expat.ParserCreate("utf-8")

    def declare(
        name: str, parameter: int, value: str | None, _base: object, _system: str | None,
        _public: str | None, _notation: object,
    ) -> None:  # fmt: skip
        if value is None:
            raise IconstudioError(
                f"It takes the entity {name!r} from outside itself. Save it as plain SVG."
            )
        if not parameter and name not in OF_XML:
            entities.setdefault(name, value)

    def end() -> None:
        ends.append(parser.CurrentByteIndex)
        parser.StartElementHandler = stop

    def stop(_name: str, _attributes: dict[str, str]) -> None:
        raise _FoundError

    parser.EntityDeclHandler = declare
    parser.EndDoctypeDeclHandler = end
    # What is amiss is told where all of it is read.
    with contextlib.suppress(expat.ExpatError, _FoundError):
        parser.Parse(data, True)
    return entities, len(data[: ends[-1]].decode())


class _FoundError(Exception):
    """The content has begun."""


class _Writer:
    def __init__(self, entities: dict[str, str]) -> None:
        self._entities = entities
        self._left = MOST

    def written(self, text: str, depth: int) -> str:
        """Return a text in which entities are written out; markup within attributes is quoted."""

        def of_attribute(found: re.Match[str]) -> str:
            return self._value(found, depth).translate(_OF_ATTRIBUTES)

        def of_piece(found: re.Match[str]) -> str:
            piece = found[0]
            if piece[0] == "<":
                return piece if piece[1] == "!" else _REFERENCE.sub(of_attribute, piece)
            return _REFERENCE.sub(lambda one: self._value(one, depth), piece)

        return _PIECE.sub(of_piece, text)

    def _value(self, found: re.Match[str], depth: int) -> str:
        value = self._entities.get(found[1])
        if value is None:
            return found[0]
        self._left -= len(value) + 1
        if depth >= DEEPEST or self._left < 0:
            raise IconstudioError(TOO_MUCH)
        return self.written(value, depth + 1)
