"""The colours that Tailwind's classes name: *red-500*, *slate-800/50*.

They are those of its default palette (MIT License), given by hue, lightness and chroma in OKLCH to
within a few hundredths: near enough to tell regions apart.
"""

import re

_HUES = {
    "red": 26, "orange": 48, "amber": 75, "yellow": 92, "lime": 128, "green": 150, "emerald": 162,
    "teal": 183, "cyan": 211, "sky": 236, "blue": 260, "indigo": 276, "violet": 293, "purple": 304,
    "fuchsia": 322, "pink": 354, "rose": 15,
}  # fmt: skip
_GREYS = {
    "slate": (257, 0.04), "gray": (260, 0.03), "zinc": (286, 0.015), "neutral": (0, 0.0),
    "stone": (60, 0.01),
}  # fmt: skip
"""Hue and greatest chroma."""
_SHADES = {
    "50": (0.98, 0.02), "100": (0.95, 0.045), "200": (0.90, 0.085), "300": (0.83, 0.13),
    "400": (0.74, 0.17), "500": (0.66, 0.20), "600": (0.58, 0.21), "700": (0.50, 0.18),
    "800": (0.43, 0.15), "900": (0.38, 0.12), "950": (0.27, 0.08),
}  # fmt: skip
"""Lightness and chroma."""
_WARM = "orange", "amber", "yellow", "lime"
"""Hues that are lighter by as much in the middle."""
_LIGHTER = 0.1
_GREY_LIGHTNESS = {"400": 0.71, "500": 0.55, "600": 0.45, "700": 0.37, "800": 0.28, "900": 0.21}
_DARKEST_GREY = 0.14

PALETTE = rf"(?:{'|'.join((*_HUES, *_GREYS))})-(?:{'|'.join(_SHADES)})(?:/\d{{1,3}})?"
"""Pattern of their names."""
_NAME = re.compile(r"([a-z]+)-(\d+)(?:/(\d+))?")


def colour(name: str) -> str:
    """Return a colour of the palette as CSS writes it."""
    match = _NAME.fullmatch(name)
    if match is None:
        raise ValueError(f"{name!r} is not of the palette")
    hue_name, shade, opacity = match.groups("100")
    lightness, chroma = _SHADES[shade]
    if hue_name in _GREYS:
        hue, most = _GREYS[hue_name]
        chroma = min(chroma / 4, most)
        lightness = _GREY_LIGHTNESS.get(shade, _DARKEST_GREY if shade == "950" else lightness)
    else:
        hue = _HUES[hue_name]
        lightness += _LIGHTER * (hue_name in _WARM and shade in ("400", "500", "600"))
    return f"oklch({lightness:.3g} {chroma:.3g} {hue} / {int(opacity) / 100:g})"
