"""The exact outline of a drawing: the curves of its own shapes, not of its picture."""

from collections.abc import Iterator

from iconstudio.algorithms import regions
from iconstudio.algorithms.regions import Region, RegionError
from iconstudio.model import Frame, IconstudioError
from iconstudio.model.path import Path
from iconstudio.svg.lengths import Box
from iconstudio.svg.shapes import Clip, NotOfShapesError, Shape, shapes_on_canvas


def outline_of(svg: str, frame: Frame) -> Path:
    """Return the outline of a document's ink in units of the canvas that ``frame`` fills.

    It is filled with the nonzero rule and overlaps itself nowhere. It is empty if the document is
    painted by more than plain fills and strokes, or if its curves touch in too many places.
    The document is hostile: call this in a worker process.
    """
    try:
        page, drawn = shapes_on_canvas(svg, frame)
        return regions.outline(_on_page(_painted(drawn), page))
    except (NotOfShapesError, IconstudioError, RegionError):
        return Path()


def _painted(drawn: Iterator[Shape]) -> Region:
    """Return what is ink after all shapes have been painted one over the other."""
    parts: list[Region] = []
    for shape in drawn:
        clips = [_clipping(clip) for clip in shape.clips]
        for tone, region in _painted_by(shape):
            for clip in clips:
                region = regions.common(region, clip)
            if tone == "ink":
                parts.append(region)
            elif parts:
                parts = [regions.without(regions.united(parts), region)]
    return regions.united(parts)


def _painted_by(shape: Shape) -> Iterator[tuple[str, Region]]:
    if shape.fill != "none":
        yield shape.fill, regions.filled(shape.path, shape.matrix, shape.even_odd)
    if shape.stroke != "none":
        pen = shape.pen
        yield (
            shape.stroke,
            regions.stroked(
                shape.path, shape.matrix, pen.width, pen.cap, pen.join, pen.mitre,
                pen.dashes, pen.offset,
            ),
        )  # fmt: skip


def _clipping(clip: Clip) -> Region:
    return regions.united([regions.filled(path, even_odd=rule) for path, rule in clip.paths])


def _on_page(ink: Region, page: Box) -> Region:
    """Cut off what lies outside of the page."""
    left, top, right, bottom = ink.bounds
    x, y, width, height = page
    if x <= left and y <= top and right <= x + width and bottom <= y + height:
        return ink
    return regions.common(ink, regions.rectangle(x, y, width, height))
