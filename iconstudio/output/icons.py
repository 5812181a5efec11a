"""What any workflow can leave in a folder: its icons, ``sheet.png`` and ``results.json``."""

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

from PIL import Image

from iconstudio.model import Icon
from iconstudio.output import png, record
from iconstudio.output.figure import MUTED, Figure
from iconstudio.output.folder import ResultsFolder
from iconstudio.workflows.events import Event, Result

_EDGE, _GAP, _SIDE, _ACROSS = 40, 24, 240, 6


class IconsReport:
    """Collects the icons of one run; each is written as soon as it is ready.

    Raises
    ------
    IconstudioError
        On construction and from every method, if the folder cannot be written.
    """

    def __init__(self, folder: Path, name: str) -> None:
        self._folder = ResultsFolder(folder, name, rf"sheet|{name}-\d+")
        self._name = name
        self._icons: list[Icon] = []

    def add(self, event: Event) -> None:
        """Note an event; write the files of a finished icon."""
        match event:
            case Result(icon=icon, preview=False):
                self._icons.append(icon)
                self._folder.write_icon(f"{self._name}-{len(self._icons)}", icon)

    def finish(self, timings: Mapping[str, float]) -> None:
        """Write ``sheet.png`` and ``results.json``; ``timings`` are seconds by stage."""
        self._folder.write_picture("sheet.png", icons_sheet(self._name, self._icons))
        results = [
            _entry(f"{self._name}-{number}", icon)
            for number, icon in enumerate(self._icons, start=1)
        ]
        self._folder.write_report(record.head(timings) | {"results": results})


def icons_sheet(title: str, icons: Sequence[Icon]) -> Image.Image:
    """Return icons side by side, each with its title beneath."""
    step, lines = _SIDE + _GAP, -(-len(icons) // _ACROSS)
    figure = Figure(2 * _EDGE + _ACROSS * step - _GAP, 100 + lines * (step + _GAP) + _EDGE)
    figure.text(_EDGE, 32, title.capitalize(), 34, bold=True)
    for number, icon in enumerate(icons):
        x, y = _EDGE + number % _ACROSS * step, 100 + number // _ACROSS * (step + _GAP)
        figure.stencil(x, y, _SIDE, png.coverage(icon.path, 2 * _SIDE))
        figure.text(x, y + _SIDE + 4, icon.title, 16, colour=MUTED, width=_SIDE)
    return figure.picture


def _entry(name: str, icon: Icon) -> dict[str, Any]:
    """Describe an icon whose files are called ``name``."""
    thanks = [{"icon": one.id} | record.thanks(one) for one in icon.credits]
    return {"title": icon.title, "svg": f"{name}.svg", "png": f"{name}.png", "credits": thanks}
