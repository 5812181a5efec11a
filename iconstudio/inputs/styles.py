"""The line styles that come with the program."""

from difflib import get_close_matches
from functools import cache

from iconstudio.inputs.line_style import read_style
from iconstudio.model import IconstudioError, LineStyle
from iconstudio.resources import resource


@cache
def bundled() -> tuple[LineStyle, ...]:
    """Return the styles that come with the program, by name."""
    some = map(read_style, resource("styles").glob("*.json"))
    return tuple(sorted(some, key=lambda style: style.name.casefold()))


def named(name: str) -> LineStyle:
    """Return the style of a name; upper and lower case are as good.

    Raises
    ------
    IconstudioError
        If there is none.
    """
    known = {style.name.casefold(): style for style in bundled()}
    found = known.get(name.strip().casefold())
    if found is None:
        near = get_close_matches(name.strip().casefold(), known, n=1)
        hint = f"Do you mean “{known[near[0]].name}”?" if near else f"There are {_listed()}."
        raise IconstudioError(f"There is no line style “{name}”. {hint}")
    return found


def _listed() -> str:
    return ", ".join(style.name for style in bundled())
