"""A montage in a project file."""

from collections.abc import Generator
from dataclasses import asdict, replace
from typing import Any

from iconstudio.inputs.fields import Fields
from iconstudio.inputs.placements import placement_in
from iconstudio.model import CANVAS, Stroke
from iconstudio.workflows.montage.montage import MOST
from iconstudio.workflows.montage.page import Icon, MontagePage, PlacedIcon
from iconstudio.workflows.pages import PageFormat, Parts, StoredParts


class MontagePages(PageFormat[MontagePage]):
    """The icons from back to front, wherever they lie, with all their strokes."""

    def write(self, page: MontagePage, parts: Parts) -> dict[str, Any]:
        """Return a page as JSON."""
        return {"chosen": page.chosen, "layers": [_written(one, parts) for one in page.layers]}

    def read(self, fields: Fields, parts: StoredParts) -> Generator[None, None, MontagePage]:
        """Return the page that was written."""
        layers: dict[int, PlacedIcon] = {}
        for entry in fields.objects("layers", "layer"):
            number = entry.whole("number", len(layers), 0, MOST - 1)
            if number in layers:
                raise entry.mistake(f"There is a layer of number {number} already.")
            icon = Icon(parts.exemplar(parts.icon(entry.reference())))
            strokes = tuple(map(_stroke, entry.objects("strokes", "stroke")))
            layers[number] = PlacedIcon(
                number, icon, placement_in(entry), strokes, entry.flag("hidden")
            )
            yield
        return MontagePage(tuple(layers.values()), fields.whole("chosen", -1, -1, MOST - 1))

    def alike(self, page: MontagePage, other: MontagePage) -> bool:
        """Whether the layers are the same; to choose one of them is no edit."""
        return page == replace(other, chosen=page.chosen)


def _written(layer: PlacedIcon, parts: Parts) -> dict[str, Any]:
    return {
        "number": layer.number,
        "icon": parts.icon(layer.icon.pictogram),
        **asdict(layer.placement),
        "hidden": layer.hidden,
        "strokes": [{"width": one.width, "points": one.points} for one in layer.strokes],
    }


def _stroke(fields: Fields) -> Stroke:
    points = fields.points("points")
    if not points:
        raise fields.mistake("The stroke has no point.")
    return Stroke(fields.number("width", None, 0, 2 * CANVAS, above=True), points)
