"""What a montage leaves in a folder: the icon, ``sheet.png`` and ``results.json``."""

from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path

from iconstudio.model import Montage, Remix
from iconstudio.output import record
from iconstudio.output.folder import ResultsFolder
from iconstudio.output.overviews import montage_overview
from iconstudio.workflows.events import Event, Result

_NAME = "montage"


class MontageReport:
    """Collects the events of one run; the icon is written as soon as it is ready.

    Raises
    ------
    IconstudioError
        On construction and from every method, if the folder cannot be written.
    """

    def __init__(self, folder: Path, montage: Montage) -> None:
        self._folder = ResultsFolder(folder, "montage", f"sheet|{_NAME}")
        self._montage = montage
        self._remixes: list[Remix] = []

    def add(self, event: Event) -> None:
        """Note an event; write the files of a result."""
        match event:
            case Result(icon=Remix() as icon):
                icon = replace(icon, title=_NAME)
                self._folder.write_icon(_NAME, icon)
                self._remixes.append(icon)

    def finish(self, timings: Mapping[str, float]) -> None:
        """Write ``sheet.png`` and ``results.json``; ``timings`` are seconds by stage."""
        for icon in self._remixes:
            self._folder.write_picture("sheet.png", montage_overview(self._montage, icon))
        layers = [
            record.of_placed(layer.icon.id, layer.placement) | {"strokes": len(layer.strokes)}
            for layer in self._montage.layers
        ]
        results = [record.of_remix(_NAME, icon) for icon in self._remixes]
        head = record.remix_head(None, timings)
        self._folder.write_report(head | {"layers": layers, "results": results})
