"""What hybrids leave in a folder: icons in rank order, ``sheet.png`` and ``results.json``."""

from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path
from typing import Any

from iconstudio.grammar import counted
from iconstudio.model import Axis, Remix
from iconstudio.output import record
from iconstudio.output.colours import palette
from iconstudio.output.folder import ResultsFolder
from iconstudio.output.overviews import hybrids_overview
from iconstudio.workflows.events import Event, Result


class HybridsReport:
    """Collects the events of one run; when it is over, writes the results from the best down.

    Raises
    ------
    IconstudioError
        On construction and from every method, if the folder cannot be written.

    Parameters
    ----------
    keyword
        What the icons were picked by; empty if they were given.
    """

    def __init__(
        self, folder: Path, keyword: str, draws: int, seed: int, symmetry: Axis | None
    ) -> None:
        self._folder = ResultsFolder(folder, "hybrids", r"sheet|hybrid-\d+")
        self._keyword = keyword
        self._draws = draws
        self._seed = seed
        self._symmetry = symmetry
        self._remixes: list[Remix] = []

    def add(self, event: Event) -> None:
        """Note an event."""
        match event:
            case Result(icon=Remix() as icon):
                self._remixes.append(icon)

    def finish(self, timings: Mapping[str, float]) -> None:
        """Write the icons, ``sheet.png`` and ``results.json``; nothing if there is no icon."""
        if not self._remixes:
            return
        ranked = sorted(self._remixes, key=lambda icon: (-icon.score.total, icon.draw))
        colours = palette([icon.composite for icon in ranked])
        entries = []
        for rank, icon in enumerate(ranked, start=1):
            name = f"hybrid-{rank:02d}"
            self._folder.write_icon(name, replace(icon, title=self._title(rank)), colours)
            entries.append(_entry(rank, name, icon))
        said = f"{counted(self._draws, 'draw')}, {len(ranked)} kept, seed {self._seed}" + (
            f", {self._symmetry} symmetry" if self._symmetry else ""
        )
        overview = hybrids_overview(self._keyword or "Hybrids", said, ranked, colours)
        self._folder.write_picture("sheet.png", overview)
        asked = {"keyword": self._keyword} | record.remix_head(self._symmetry, timings)
        drawn = {"seed": self._seed, "draws": self._draws, "kept": len(ranked)}
        self._folder.write_report(asked | drawn | {"icons": self._icons(), "results": entries})

    def _title(self, rank: int) -> str:
        return f"{self._keyword} hybrid {rank}".strip()

    def _icons(self) -> list[str]:
        """Return the identifiers of the icons that were mixed."""
        sources = self._remixes[0].composite.sources if self._remixes else ()
        return [source.exemplar.id for source in sources]


def _entry(rank: int, name: str, icon: Remix) -> dict[str, Any]:
    seeds = [[[float(x), float(y)] for x, y in points] for points in icon.seeds]
    drawn = {"rank": rank, "draw": icon.draw, "seeds": seeds}
    return drawn | record.of_remix(name, icon)
