"""What templates of drawings repeat: over lists that are written out, turn by turn.

The notations of Vue, Alpine, Angular, Svelte, Jinja, Twig and Liquid are known.
"""

import re

from iconstudio.svg.javascript import Function, Names, within
from iconstudio.svg.methods import MOST, Value
from iconstudio.svg.syntax import UnknownError

_IN = re.compile(
    r"\s*(?:let\s+|const\s+)?(?P<name>.+?)\s+(?:in|of)\s+(?P<list>[^;]+)(?P<rest>.*)", re.DOTALL
)
_AS = re.compile(
    r"(?P<list>.+?)\s+as\s+(?P<name>.+?)(?:\s*\((?:[^()]|\([^()]*\))*\))?\s*", re.DOTALL
)
_INDEX = re.compile(r"\blet\s+(\w+)\s*=\s*\$?index\b|\$?index\s+as\s+(\w+)")
_RANGE = re.compile(r"range\(\s*([\d.-]+)\s*(?:,\s*([\d.-]+)\s*)?(?:,\s*([\d.-]+)\s*)?\)")
_DOTS = re.compile(r"\(?\s*(-?\d+)\s*\.\.\s*(-?\d+)\s*\)?")


def is_loop(said: str) -> bool:
    """Whether a directive says of what list each entry is to be drawn."""
    return bool(_IN.fullmatch(said) or _AS.fullmatch(said))


def turns(said: str, names: Names) -> list[Names]:
    """Return what names mean in every turn of a loop.

    Raises
    ------
    UnknownError
        If its list is not written out.
    """
    _, items = _parts(said)
    function = _function(said, names)
    return [within(function, *turn) for turn in _turns(items, names)]


def unknown_turn(said: str, names: Names) -> Names:
    """Return what names mean in a loop over a list that is not known: its own mean nothing."""
    try:
        return within(_function(said, names))
    except UnknownError:
        return names


def _parts(said: str) -> tuple[str, str]:
    """Return the parameters of a loop as JavaScript writes them, and its list."""
    as_ = _AS.fullmatch(said) if " as " in said else None
    match = as_ or _IN.fullmatch(said)
    if match is None:
        raise UnknownError
    name = match["name"].strip()
    if name.startswith("("):
        name = name[1:-1]
    index = None if as_ else _INDEX.search(match["rest"])
    if index is not None:
        name += f", {index[1] or index[2]}"
    return name, match["list"].split("|")[0].strip()


def _function(said: str, names: Names) -> Function:
    found = names.value(f"(({_parts(said)[0]}) => 0)")
    if not isinstance(found, Function):
        raise UnknownError
    return found


def _turns(items: str, names: Names) -> list[tuple[Value, ...]]:
    found: Value
    if match := _RANGE.fullmatch(items):
        found = range(*(int(float(one)) for one in match.groups() if one))
    elif match := _DOTS.fullmatch(items):
        found = range(int(match[1]), int(match[2]) + 1)
    else:
        found = names.value(items)
    if isinstance(found, float):
        found = range(1, int(found) + 1)
    if isinstance(found, dict):
        return [(one, key, float(at)) for at, (key, one) in enumerate(found.items())]
    if not isinstance(found, list | range) or len(found) > MOST:
        raise UnknownError
    return [(one, float(number)) for number, one in enumerate(found)]
