"""CSS colours (CSS Color Module Level 4): the adapter of coloraide."""

import re
from functools import lru_cache
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from coloraide import Color

_SYSTEM_PAPER = ("canvas", "field", "buttonface", "background", "window", "highlighttext")
_SYSTEM_INK = ("canvastext", "fieldtext", "buttontext", "buttonborder", "windowtext", "graytext",
               "linktext", "visitedtext", "activetext", "marktext", "highlight", "menutext",
               "infotext", "accentcolor", "selecteditem")  # fmt: skip
"""Names of colours of the user's desktop: of what is written on, and of what is written."""
_ICC = re.compile(r"\s+(?:icc-color|device-cmyk)\s*\(.*\)\s*$", re.IGNORECASE)
_LONGEST = 400
_CALL = re.compile(r"([a-z-]+)\((.*)\)", re.IGNORECASE | re.DOTALL)
_SHARE = re.compile(r"(?:([\d.]+)%\s+)?(.*?)(?:\s+([\d.]+)%)?", re.DOTALL)
_SPACES = {"xyz": "xyz-d65", "lab": "lab", "lch": "lch", "rgb": "srgb"}
_DEEPEST = 5


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
    try:
        found = _colour(text, 0)
    except (KeyError, ValueError):  # a space that is not known
        found = None
    if found is None:
        return None
    found = found.convert("srgb").clip()
    red, green, blue = (round(255 * _known(part)) for part in found.coords())
    alpha = min(max(_known(found.alpha()), 0.0), 1.0)
    if alpha < 1:
        return f"rgba({red},{green},{blue},{alpha:.4g})"
    return f"#{red:02x}{green:02x}{blue:02x}"


def _colour(text: str, depth: int) -> "Color | None":
    """Return a colour, or what functions of CSS Color Module Level 5 make of others."""
    from coloraide import Color

    text = text.strip()
    call = _CALL.fullmatch(text)
    if call is None or depth > _DEEPEST:
        match = Color.match(text, fullmatch=True)
        if match is not None:
            return match.color
        if text.lower() == "currentcolor":
            return Color("black")  # within a function: as it mostly is
        system = colour(text) if depth and text.isalpha() else None
        return Color(system) if system else None
    name, inner = call[1].lower(), call[2]
    if name == "light-dark":
        return _colour(_parts(inner, ",")[0], depth + 1)
    if name == "color-mix":
        return _mixed(_parts(inner, ","), depth)
    if inner.lower().startswith("from "):
        return _relative(name, _parts(inner[5:].strip(), " "), depth)
    match = Color.match(text, fullmatch=True)
    return None if match is None else match.color


def _mixed(parts: list[str], depth: int) -> "Color | None":
    """Return a mixture (CSS Color 5, section 3): ``in`` a space, two colours with percentages."""
    how = parts.pop(0).lower().split() if parts[0].lower().startswith("in ") else ["in", "oklab"]
    if len(parts) != 2:
        return None
    said = [_SHARE.fullmatch(part.strip()) for part in parts]
    here, there = (_colour(one[2] if one else "", depth + 1) for one in said)
    first, second = (one and (one[1] or one[3]) for one in said)
    if here is None or there is None:
        return None
    one = float(first) if first else 100 - float(second) if second else 50.0
    other = float(second) if second else 100 - one
    whole = one + other
    if whole <= 0 or min(one, other) < 0:
        return None
    hue = how[2] if len(how) > 3 else "shorter"
    space = _SPACES.get(how[1], how[1])
    mixed = here.mix(there, other / whole, space=space, hue=hue, premultiplied=True)
    mixed[-1] = _known(mixed.alpha()) * min(whole / 100, 1.0)
    return mixed


def _relative(name: str, parts: list[str], depth: int) -> "Color | None":
    """Return a colour by the channels of another (CSS Color 5, section 4)."""
    from coloraide import Color

    base = _colour(parts[0], depth + 1)
    words, space = parts[1:], name.removesuffix("a")
    if base is None or not words:
        return None
    if name == "color":
        space, words = words[0], words[1:]
    base = base.convert(_SPACES.get(space, "srgb" if space == "rgb" else space))
    names = map(str, base._space.CHANNELS)
    channels = dict(zip(names, map(_known, base.coords()), strict=True))
    unit = {"rgb": 255.0, "hsl": 100.0, "hwb": 100.0}.get(space, 1.0)
    channels = {key: one * (1.0 if key == "h" else unit) for key, one in channels.items()}
    channels |= {key[0]: one for key, one in channels.items()}
    channels["alpha"] = _known(base.alpha())
    said = " ".join(
        f"{channels[word]:.9g}" if word in channels else word
        for word in " ".join(words).lower().replace("/", " / ").split()
    )
    if "/" not in said:
        said += f" / {channels['alpha']:.6g}"
    match = Color.match(
        f"color({space} {said})" if name == "color" else f"{space}({said})", fullmatch=True
    )
    return Color(match.color) if match else None


def _parts(text: str, sign: str) -> list[str]:
    """Return the parts of a text between signs outside of parentheses."""
    parts, depth = [""], 0
    for letter in text:
        depth += {"(": 1, ")": -1}.get(letter, 0)
        if letter == sign and not depth:
            parts.append("")
        else:
            parts[-1] += letter
    return [part.strip() for part in parts if part.strip()] or [""]


def _known(part: float) -> float:
    """Return a component, which CSS may leave open (``none``)."""
    return 0.0 if part != part else part
