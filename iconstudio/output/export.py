"""An icon as the files that it can be exported to. What makes them is loaded when it is needed."""

from typing import TYPE_CHECKING

from iconstudio.model import Icon, Remix, Restyled

if TYPE_CHECKING:
    from iconstudio.output.colours import Palette


def svg(icon: Icon) -> bytes:
    """Return an icon as SVG with its credits; strokes are outlined."""
    from iconstudio.output.svg import svg_document

    return svg_document(icon).encode()


def svg_of_strokes(icon: Restyled) -> bytes:
    """Return a restyled icon as SVG with its credits, in which strokes are strokes."""
    from iconstudio.algorithms.curves.outline import strokes_of
    from iconstudio.output.svg import document

    return document(icon.title, icon.credits, strokes_of(icon.lines)).encode()


def png(icon: Icon, side: int) -> bytes:
    """Return an icon as PNG on nothing, in its colours or black, the longer side ``side``."""
    from iconstudio.output.png import encoded, icon_pixels

    return encoded(icon_pixels(icon, side))


def colour_code_png(icon: Remix, side: int, colours: "Palette | None" = None) -> bytes:
    """Return the colour code of a remix as PNG, ``side`` pixels wide."""
    from iconstudio.output.colours import colour_code
    from iconstudio.output.png import encoded

    return encoded(colour_code(icon.composite, icon.drawing, side, colours))
