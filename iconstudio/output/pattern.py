"""A pattern as a file: SVG, PNG, or a style sheet whose background it is."""

import re
from pathlib import Path
from urllib.parse import quote

from iconstudio.files import write_bytes
from iconstudio.model import IconstudioError, Patterned
from iconstudio.output import png
from iconstudio.output.svg import svg_document

SUFFIXES = ".svg", ".png", ".css"
_NO_NAME = re.compile(r"[^a-z0-9]+")
_SAFE = " !#$&'()*+,-./:;=?@[]_~"
"""Characters that stay as they are in the address of a style sheet, in double quotes."""


def check_name(path: Path) -> Path:
    """Return the path of a file for a pattern.

    Raises
    ------
    IconstudioError
        If its name does not say which kind of file it is.
    """
    if path.suffix.lower() not in SUFFIXES:
        raise IconstudioError(
            f"Patterns are written as SVG, PNG or CSS, and “{path.name}” says none of them. "
            f"Call it “{path.stem or 'pattern'}.svg”."
        )
    return path


def write(icon: Patterned, path: Path) -> None:
    """Write a pattern in one step, as the name of its file says.

    Raises
    ------
    IconstudioError
        If it cannot be written.
    """
    match check_name(path).suffix.lower():
        case ".svg":
            content = svg_document(icon).encode()
        case ".png":
            content = png.encoded(png.icon_pixels(icon, max(icon.size)))
        case _:
            content = style_sheet(icon, path.stem).encode()
    write_bytes(path, content)


def style_sheet(icon: Patterned, name: str) -> str:
    """Return a rule of CSS for the class ``name``, with the pattern as its background."""
    from iconstudio.output.svg import credits_text

    called = _NO_NAME.sub("-", name.casefold()).strip("-") or "pattern"
    width, height = icon.size
    thanks = credits_text(icon).replace("*/", "* /")
    drawing = quote(" ".join(svg_document(icon).split()).replace('"', "'"), safe=_SAFE)
    repeat = "repeat" if icon.tile else "no-repeat"
    return (
        f"/* {thanks} */\n"
        f".{called} {{\n"
        f'  background: url("data:image/svg+xml,{drawing}") {repeat};\n'
        f"  background-size: {width}px {height}px;\n"
        "}\n"
    )
