"""CSS colours (CSS Color Module Level 4): the adapter of coloraide."""

import re
from functools import lru_cache

_SYSTEM_PAPER = ("canvas", "field", "buttonface", "background", "window", "highlighttext")
_SYSTEM_INK = ("canvastext", "fieldtext", "buttontext", "buttonborder", "windowtext", "graytext",
               "linktext", "visitedtext", "activetext", "marktext", "highlight", "menutext",
               "infotext", "accentcolor", "selecteditem")  # fmt: skip
"""Names of colours of the user's desktop: of what is written on, and of what is written."""
_ICC = re.compile(r"\s+(?:icc-color|device-cmyk)\s*\(.*\)\s*$", re.IGNORECASE)
_LONGEST = 200


@lru_cache(maxsize=4096)
def colour(text: str) -> str | None:
    """Return a colour as SVG 1.1 writes it: ``#rrggbb``, ``rgba(r,g,b,a)`` or ``currentColor``.

    Colours outside of sRGB are clipped. None if ``text`` is no colour.
    """
    text = _ICC.sub("", text.strip())[:_LONGEST]
    name = text.lower()
    if name == "currentcolor":
        return "currentColor"
    if name in _SYSTEM_PAPER:
        return "#ffffff"
    if name in _SYSTEM_INK:
        return "#000000"
    from coloraide import Color

    match = Color.match(text, fullmatch=True)
    if match is None:
        return None
    found = match.color.convert("srgb").clip()
    red, green, blue = (round(255 * _known(part)) for part in found.coords())
    alpha = min(max(_known(found.alpha()), 0.0), 1.0)
    if alpha < 1:
        return f"rgba({red},{green},{blue},{alpha:.4g})"
    return f"#{red:02x}{green:02x}{blue:02x}"


def _known(part: float) -> float:
    """Return a component, which CSS may leave open (``none``)."""
    return 0.0 if part != part else part
