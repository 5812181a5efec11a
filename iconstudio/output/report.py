"""What a modelling run leaves in a folder: icons, pictures, ``grid.png`` and ``results.json``."""

import io
import json
import tempfile
from collections.abc import Iterable, Mapping
from pathlib import Path
from typing import Any

import numpy as np

from iconstudio import __version__
from iconstudio.algorithms.raster import fill_polygon, interior, placed_ink, solid
from iconstudio.model import (
    CANVAS,
    Composite,
    Exemplar,
    IconstudioError,
    Point,
    Sketch,
    Source,
)
from iconstudio.output import png
from iconstudio.output.colours import colour_code, significant_sources
from iconstudio.output.sheet import Row, grid_sheet
from iconstudio.output.svg import svg_document
from iconstudio.workflows.events import (
    Event,
    RegionsFound,
    Result,
    Retrieved,
    StyleMatched,
    StyleSkipped,
)

STAGES = ("search", "prepare", "match", "remix", "vectorize", "total")


class Report:
    """Collects the events of one run; each icon is written as soon as it is ready.

    Raises
    ------
    IconstudioError
        On construction and from every method, if the folder cannot be written.
    """

    def __init__(self, folder: Path, sketch: Sketch, lambdas: Iterable[float]) -> None:
        self._folder = folder
        self._sketch = sketch
        self._lambdas = sorted(set(lambdas))
        self._retrieved: tuple[Exemplar, ...] = ()
        self._centres: tuple[Point, ...] = ()
        self._styles: dict[str, StyleMatched | StyleSkipped] = {}
        self._results: list[Result] = []
        _make(folder)

    def add(self, event: Event) -> None:
        """Note an event; write the files of a result."""
        match event:
            case Retrieved():
                self._retrieved = event.exemplars
            case RegionsFound():
                self._centres = event.centres
            case StyleMatched() | StyleSkipped():
                self._styles[event.style] = event
            case Result():
                self._write_result(event)
                self._results.append(event)

    def finish(self, timings: Mapping[str, float], *, dump: bool = False) -> None:
        """Write ``grid.png``, ``results.json`` and, if ``dump``, ``STYLE.npz``.

        Parameters
        ----------
        timings
            Seconds by stage; missing stages count as 0.
        """
        if dump:
            for style in self._styles:
                self._dump(style)
        sheet = grid_sheet(
            self._sketch.keyword,
            self._sketch.polygon,
            self._lambdas,
            [self._row(style) for style in self._styles],
        )
        png.write(self._folder / "grid.png", png.encoded(sheet))
        text = json.dumps(self._json(timings), indent=1, ensure_ascii=False, allow_nan=False)
        png.write(self._folder / "results.json", text.encode())

    def _name(self, composite: Composite) -> str:
        distances = [abs(value - composite.lambda_s) for value in self._lambdas]
        return f"{composite.style}-{distances.index(min(distances)) + 1}"

    def _write_result(self, result: Result) -> None:
        composite, drawing = result.composite, result.drawing
        name = self._name(composite)
        title = f"{self._sketch.keyword} ({composite.style})"
        document = svg_document(drawing, composite, title).encode()
        png.write(self._folder / f"{name}.svg", document)
        png.write(self._folder / f"{name}.png", png.encoded(png.drawing_pixels(drawing, png.SIZE)))
        code = colour_code(composite, drawing, png.SIZE // 2)
        png.write(self._folder / f"{name}-sources.png", png.encoded(code))

    def _of(self, style: str) -> list[Result]:
        """Return the results of a style by rising lambda_S."""
        found = [result for result in self._results if result.composite.style == style]
        return sorted(found, key=lambda result: result.composite.lambda_s)

    def _row(self, style: str) -> Row:
        event = self._styles[style]
        results = tuple((result.composite, result.drawing) for result in self._of(style))
        reason = event.reason if isinstance(event, StyleSkipped) else ""
        return Row(style, event.retrieved, results, reason)

    def _json(self, timings: Mapping[str, float]) -> dict[str, Any]:
        return {
            "version": __version__,
            "keyword": self._sketch.keyword,
            "canvas": CANVAS,
            "retrieved": len(self._retrieved),
            "timings": {stage: round(timings.get(stage, 0.0), 4) for stage in STAGES},
            "regions": [[float(x), float(y)] for x, y in self._centres],
            "styles": {style: _style_json(event) for style, event in self._styles.items()},
            "results": [
                self._result_json(result.composite)
                for style in self._styles
                for result in self._of(style)
            ],
        }

    def _result_json(self, composite: Composite) -> dict[str, Any]:
        name = self._name(composite)
        return {
            "style": composite.style,
            "lambda_s": float(composite.lambda_s),
            "energy": float(composite.energy),
            "data_cost": float(composite.data_cost),
            "smoothness_cost": float(composite.smoothness_cost),
            "iou": float(composite.iou),
            "svg": f"{name}.svg",
            "png": f"{name}.png",
            "sources_png": f"{name}-sources.png",
            "sources": [
                _source_json(label, composite) for label in significant_sources(composite, least=0)
            ],
        }

    def _dump(self, style: str) -> None:
        """Write all that is needed to check a style's results independently."""
        results = [result.composite for result in self._of(style)]
        if not results:
            return
        placed = [placed_ink(source.exemplar, source.placement) for source in results[0].sources]
        ink, filled = (np.stack(layer) for layer in zip(*placed, strict=True))
        matched = self._styles[style]
        exemplars = matched.exemplars if isinstance(matched, StyleMatched) else ()
        whole = [solid(exemplar.ink) for exemplar in exemplars]
        buffer = io.BytesIO()
        np.savez_compressed(
            buffer,
            ink=ink,
            solid=filled,
            interior=interior(ink, filled),
            sketch=fill_polygon(self._sketch.polygon.fitted()),
            labels=np.stack([composite.labels for composite in results]),
            lambda_s=np.array([composite.lambda_s for composite in results]),
            energy=np.array([composite.energy for composite in results]),
            exemplar_solid=np.array(whole, dtype=bool).reshape(-1, CANVAS, CANVAS),
            exemplar_id=np.array([exemplar.id for exemplar in exemplars], dtype=np.str_),
        )
        png.write(self._folder / f"{style}.npz", buffer.getvalue())


def _make(folder: Path) -> None:
    """Make sure, before any work, that files can be written into ``folder``."""
    try:
        folder.mkdir(parents=True, exist_ok=True)
        with tempfile.TemporaryFile(dir=folder) as file:
            file.write(b"0")
    except OSError as error:
        raise IconstudioError(
            f"The folder “{folder}” cannot be written: {error.strerror}. Choose another one."
        ) from None
    if (folder / "results.json").is_dir():
        raise IconstudioError(
            f"“{folder / 'results.json'}” is a folder. Choose another output folder."
        )


def _style_json(event: StyleMatched | StyleSkipped) -> dict[str, Any]:
    if isinstance(event, StyleSkipped):
        return {"retrieved": event.retrieved, "matches": [], "skipped": event.reason}
    rows = [[_placed_json(s) | {"error": float(s.error)} for s in row] for row in event.matches]
    return {"retrieved": event.retrieved, "matches": rows}


def _placed_json(source: Source) -> dict[str, Any]:
    placement = source.placement
    return {
        "icon": source.exemplar.id,
        "scale": float(placement.scale),
        "flip": bool(placement.flip),
        "dx": int(placement.dx),
        "dy": int(placement.dy),
    }


def _source_json(label: int, composite: Composite) -> dict[str, Any]:
    """Describe a source; ``label`` is its number in the dump's ``ink`` and ``labels``."""
    source = composite.sources[label]
    credit = source.exemplar.pictogram.credit
    thanks = {"author": credit.author, "license": credit.license, "url": credit.url}
    return _placed_json(source) | thanks | {"share": composite.shares[label], "label": label}
