"""Overviews: hybrids with the icons that they mix, and a montage with its scribbles."""

from collections.abc import Sequence

from PIL import Image

from iconstudio.algorithms.iconification.guidance import carried, scribble
from iconstudio.algorithms.raster import placed_ink
from iconstudio.model import Montage, Remix, Source
from iconstudio.output.colours import RGB, Palette, colour_code, key_of, palette
from iconstudio.output.figure import MUTED, PALE, Figure
from iconstudio.output.png import coverage
from iconstudio.output.sheet import grey

_EDGE, _GAP = 40, 24
_ACROSS, _SHOWN = 4, 12
_LARGE, _CODE = 240, 120
"""Sides of a hybrid and of the colour code beside it, in pixels."""
_THUMB = 104
_LAYER = 240
_FINAL = 480
_PER_LINE = 6
_FINE = 4
"""So many pixels of black and white, each way, make one with smooth edges."""


def hybrids_overview(
    title: str, said: str, remixes: Sequence[Remix], colours: Palette
) -> Image.Image:
    """Return the icons in their colours, and beneath them the best hybrids, coded by these.

    Parameters
    ----------
    remixes
        From the best down; all of the same icons.
    """
    cell = _LARGE + _CODE + 2 * _GAP
    width = 2 * _EDGE + _ACROSS * cell - _GAP
    shown = remixes[:_SHOWN]
    lines = -(-len(shown) // _ACROSS)
    top = 300
    figure = Figure(width, top + _EDGE // 2 + lines * (_LARGE + 2 * _GAP))
    figure.text(_EDGE, 32, title, 34, bold=True, width=width - 2 * _EDGE - 500)
    figure.text(width - _EDGE, 44, said, 18, colour=MUTED, anchor="ra")
    sources = remixes[0].composite.sources if remixes else ()
    step = min(_THUMB + 2 * _GAP, (width - 2 * _EDGE) / max(1, len(sources)))
    for number, source in enumerate(sources):
        _source(figure, _EDGE + number * step, 100, source, colours[key_of(source)], step - 8)
    figure.rule(top - 28, _EDGE, width - _EDGE)
    for number, icon in enumerate(shown):
        x = _EDGE + number % _ACROSS * cell
        y = top + number // _ACROSS * (_LARGE + 2 * _GAP)
        composite, drawing = icon.composite, icon.drawing
        figure.stencil(x, y, _LARGE, coverage(drawing.path, _LARGE))
        beside = x + _LARGE + _GAP // 2
        figure.text(beside, y + 8, str(number + 1), 24, bold=True)
        figure.text(beside, y + 40, f"score {icon.score.total:.2f}", 14, colour=MUTED)
        figure.text(beside, y + 60, f"draw {icon.draw}", 14, colour=MUTED)
        code = colour_code(composite, drawing, _CODE, colours)
        figure.image(beside, y + _LARGE - _CODE - 8, code)
    return figure.picture


def montage_overview(montage: Montage, icon: Remix) -> Image.Image:
    """Return the layers with their scribbles, and beneath them the result and its colour code."""
    composite, drawing = icon.composite, icon.drawing
    colours = palette([composite])
    step = _LAYER + _GAP
    across = min(_PER_LINE, max(4, len(montage.layers)))
    lines = -(-len(montage.layers) // across)
    width = 2 * _EDGE + across * step - _GAP
    top = 100 + lines * (step + 24)
    figure = Figure(width, top + _FINAL + 2 * _EDGE)
    figure.text(_EDGE, 32, "Montage", 34, bold=True)
    for number, (layer, source) in enumerate(zip(montage.layers, composite.sources, strict=True)):
        x, y = _EDGE + number % across * step, 100 + number // across * (step + 24)
        ink, _ = placed_ink(source.exemplar, source.placement, _FINE * _LAYER)
        figure.stencil(x, y, _LAYER, grey(ink), PALE)
        strokes = [carried(one, layer.placement, source.placement) for one in layer.strokes]
        figure.stencil(
            x, y, _LAYER, grey(scribble(strokes, _FINE * _LAYER)), colours[key_of(source)]
        )
        figure.frame(x, y, _LAYER, _LAYER, PALE)
        figure.text(x, y + _LAYER + 6, layer.icon.id, 13, colour=MUTED, width=_LAYER)
    figure.rule(top, _EDGE, width - _EDGE)
    left = (width - 2 * _FINAL - _GAP) / 2
    figure.stencil(left, top + _EDGE, _FINAL, coverage(drawing.path, _FINAL))
    code = colour_code(composite, drawing, _FINAL, colours)
    figure.image(left + _FINAL + _GAP, top + _EDGE, code)
    return figure.picture


def _source(figure: Figure, x: float, y: float, source: Source, colour: RGB, width: float) -> None:
    """Draw an icon in its colour, with its name beneath."""
    ink, _ = placed_ink(source.exemplar, source.placement, _FINE * _THUMB)
    figure.stencil(x, y, _THUMB, grey(ink), colour)
    collection, name = source.exemplar.id.split(":", 1)
    middle = x + _THUMB / 2
    figure.text(middle, y + _THUMB + 6, name, 13, width=width, anchor="ma")
    figure.text(middle, y + _THUMB + 24, collection, 12, colour=MUTED, width=width, anchor="ma")
