"""What modelling and editing leave in a folder: icons, pictures, ``grid.png``, ``results.json``."""

import io
from collections.abc import Iterable, Mapping
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np

from iconstudio.algorithms.iconification.energy import distance_field, joining, placed_sources
from iconstudio.algorithms.iconification.style import STYLES
from iconstudio.algorithms.raster import interior, solid
from iconstudio.model import CANVAS, Composite, Exemplar, Point, Remix
from iconstudio.output import record
from iconstudio.output.folder import ResultsFolder
from iconstudio.output.request import Request
from iconstudio.output.sheet import Row, grid_sheet
from iconstudio.workflows.events import (
    Event,
    Recommended,
    RegionsFound,
    Result,
    Retrieved,
    StyleMatched,
    StyleSkipped,
)


class GridReport:
    """Collects the events of one run; each icon is written as soon as it is ready.

    Raises
    ------
    IconstudioError
        On construction and from every method, if the folder cannot be written.

    Parameters
    ----------
    dump
        Whether to write ``STYLE.npz`` too.
    """

    def __init__(
        self, folder: Path, request: Request, lambdas: Iterable[float], *, dump: bool = False
    ) -> None:
        kind = "model" if request.change is None else "edit"
        styles = "|".join(style.name for style in STYLES)
        self._folder = ResultsFolder(folder, kind, rf"grid|(?:{styles})(?:-\d+)?")
        self._request = request
        self._lambdas = sorted(set(lambdas))
        self._dumping = dump
        self._retrieved: tuple[Exemplar, ...] = ()
        self._centres: tuple[Point, ...] = ()
        self._styles: dict[str, StyleMatched | StyleSkipped] = {}
        self._remixes: dict[tuple[str, float], Remix] = {}
        self._recommended: dict[str, float] = {}

    def add(self, event: Event) -> None:
        """Note an event; write the files of a result."""
        match event:
            case Retrieved():
                self._retrieved = event.exemplars
            case RegionsFound():
                self._centres = event.centres
            case StyleMatched() | StyleSkipped():
                self._styles[event.style] = event
            case Result(icon=Remix() as icon):
                icon = replace(icon, title=f"{self._request.keyword} ({icon.composite.style})")
                self._folder.write_icon(self._name(icon.composite), icon)
                one = icon.composite  # a symmetric one takes the place of another
                self._remixes[one.style, one.lambda_s] = icon
            case Recommended():
                if event.lambda_s is not None:
                    self._recommended[event.style] = event.lambda_s

    def finish(self, timings: Mapping[str, float]) -> None:
        """Write ``grid.png``, ``results.json`` and the dumps; ``timings`` are seconds by stage."""
        if self._dumping:
            for style in self._styles:
                self._dump(style)
        sheet = grid_sheet(
            self._request, self._lambdas, [self._row(style) for style in self._styles]
        )
        self._folder.write_picture("grid.png", sheet)
        self._folder.write_report(self._json(timings))

    def _name(self, composite: Composite) -> str:
        distances = [abs(value - composite.lambda_s) for value in self._lambdas]
        return f"{composite.style}-{distances.index(min(distances)) + 1}"

    def _of(self, style: str) -> list[Remix]:
        """Return the icons of a style by rising lambda_S."""
        found = [icon for icon in self._remixes.values() if icon.composite.style == style]
        return sorted(found, key=lambda icon: icon.composite.lambda_s)

    def _row(self, style: str) -> Row:
        event = self._styles[style]
        remixes = tuple(self._of(style))
        reason = event.reason if isinstance(event, StyleSkipped) else ""
        return Row(style, event.retrieved, remixes, reason, self._recommended.get(style))

    def _json(self, timings: Mapping[str, float]) -> dict[str, Any]:
        request = self._request
        asked: dict[str, Any] = {"keyword": request.keyword}
        if request.change is not None:
            asked["base"] = record.of_source(request.change.base)
        found = {
            "retrieved": len(self._retrieved),
            "regions": [[float(x), float(y)] for x, y in self._centres],
            "styles": {style: _style_json(event) for style, event in self._styles.items()},
            "results": [
                self._remix_json(icon) for style in self._styles for icon in self._of(style)
            ],
        }
        return asked | record.remix_head(request.symmetry, timings) | found

    def _remix_json(self, icon: Remix) -> dict[str, Any]:
        composite = icon.composite
        extra: dict[str, Any] = {
            "recommended": self._recommended.get(composite.style) == composite.lambda_s
        }
        if icon.unchanged is not None:
            extra["unchanged"] = icon.unchanged
        return record.of_remix(self._name(composite), icon) | extra

    def _dump(self, style: str) -> None:
        """Write all that is needed to check a style's results independently, as it was solved.

        The energy is the data cost plus lambda_S m / 256 times the smoothness cost.
        """
        results = [icon.composite for icon in self._of(style)]
        if not results:
            return
        side = len(results[0].labels)
        # Mirrored results have mirror images of sources after those of all results.
        sources = max((one.sources for one in results), key=len)
        ink, filled = placed_sources(sources, side)
        request = self._request.on(side)
        matched = self._styles[style]
        exemplars = matched.exemplars if isinstance(matched, StyleMatched) else ()
        whole = [solid(exemplar.ink) for exemplar in exemplars]
        arrays = {
            "ink": ink,
            "solid": filled,
            "interior": interior(ink, filled),
            "m": np.array(side),
            "sketch": request.outline,
            "labels": np.stack([composite.labels for composite in results]),
            "lambda_s": np.array([composite.lambda_s for composite in results]),
            "energy": np.array([composite.energy for composite in results]),
            "exemplar_solid": np.array(whole, dtype=bool).reshape(-1, CANVAS, CANVAS),
            "exemplar_id": np.array([exemplar.id for exemplar in exemplars], dtype=np.str_),
        }
        if request.change is not None:
            arrays["change"] = request.change.mask == 0
            problem = joining(distance_field(request.outline), ink, filled)
            data = request.guide.guided(problem)
            arrays["penalty"] = request.change.penalty(data, sources)
        if request.guide.weight is not None:
            arrays["weight"] = request.guide.weight
        for aim in request.guide.aims:
            channel = aim.channel.value
            arrays |= {f"{channel}_field": aim.field, f"{channel}_weight": aim.weight}
        buffer = io.BytesIO()
        np.savez_compressed(buffer, **arrays)  # type: ignore[arg-type]  # none is `allow_pickle`
        self._folder.write({f"{style}.npz": buffer.getvalue()})


def _style_json(event: StyleMatched | StyleSkipped) -> dict[str, Any]:
    if isinstance(event, StyleSkipped):
        return {"retrieved": event.retrieved, "matches": [], "skipped": event.reason}
    *rows, whole = [
        [record.of_source(source) | {"error": float(source.error)} for source in row]
        for row in (*event.matches, event.whole)
    ]
    return {"retrieved": event.retrieved, "matches": rows, "whole": whole}
