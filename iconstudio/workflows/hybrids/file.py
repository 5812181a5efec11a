"""HYBRIDS.json: which icons to mix (section 4.3).

``{"icons": ["set:name", ...], "draws": 40, "seed": 0, "symmetry": "horizontal"}``, or, for icons
that the program picks, ``{"keyword": "lamp", "count": 5, ...}``. An icon may be the path of an
SVG or a scan, from the file's folder. ``"pins": [[[x, y], ...], ...]``, a list for each icon, are
points that every hybrid keeps. There may be a ``title``.
"""

from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

from iconstudio.inputs.fields import Fields, written
from iconstudio.model import CANVAS, Axis, Mix, Pictogram, Seeds
from iconstudio.workflows.files import open_file
from iconstudio.workflows.hybrids.hybrids import FEWEST, MOST, MOST_DRAWS

LARGEST_SEED = 2**63 - 1


@dataclass(frozen=True, slots=True)
class HybridsFile:
    """What a HYBRIDS.json says; ``icons`` are references, ``set:name`` or a path."""

    icons: tuple[str, ...] = ()
    keyword: str = ""
    """What the icons are picked by; empty if they are given."""
    count: int = 5
    """How many are picked."""
    draws: int = 40
    seed: int = 0
    symmetry: Axis | None = None
    pins: Seeds = ()
    """For each of the given icons, positions that every draw keeps; empty if there are none."""
    title: str = ""

    @classmethod
    def of(cls, mix: Mix, refer: Callable[[Pictogram], str], title: str = "") -> "HybridsFile":
        """Return the file of a mix; ``refer`` returns the reference of an icon."""
        return cls(
            tuple(map(refer, mix.icons)),
            draws=mix.draws,
            seed=mix.seed,
            symmetry=mix.symmetry,
            pins=mix.pins,
            title=title,
        )

    def resolved(self, find: Callable[[str], Pictogram]) -> Mix:
        """Return the mix of the icons that are given, found by ``find``."""
        return self.mix(tuple(map(find, self.icons)))

    def mix(self, icons: tuple[Pictogram, ...]) -> Mix:
        """Return the mix of these icons."""
        return Mix(icons, self.draws, self.seed, self.symmetry, self.pins)


def read_hybrids(path: Path) -> HybridsFile:
    """Read a HYBRIDS.json.

    Raises
    ------
    IconstudioError
        If the file cannot be read or does not say what to mix.
    """
    return hybrids_in(open_file(path, "hybrids"))


def hybrids_in(fields: Fields) -> HybridsFile:
    """Return what the fields of a HYBRIDS.json say.

    Raises
    ------
    IconstudioError
        If they are not what they must be.
    """
    fields.check_keys(("icons", "keyword", "count", "draws", "seed", "symmetry", "pins", "title"))
    keyword = fields.text("keyword").strip()
    if fields.has("icons") == bool(keyword):
        raise fields.mistake(
            'Give either "icons", a list, or a "keyword" to pick them by; not both.'
        )
    if fields.has("icons") and fields.has("count"):
        raise fields.mistake('"count" goes with "keyword"; with "icons", all are mixed.')
    return HybridsFile(
        () if keyword else fields.references("icons"),
        keyword,
        fields.whole("count", 5, FEWEST, MOST),
        fields.whole("draws", 40, 1, MOST_DRAWS),
        fields.whole("seed", 0, 0, LARGEST_SEED),
        fields.axis(),
        fields.point_lists("pins", CANVAS),
        fields.text("title"),
    )


def hybrids_data(hybrids: HybridsFile) -> dict[str, object]:
    """Return what the file of a mix says."""
    picked: dict[str, object] = {"keyword": hybrids.keyword, "count": hybrids.count}
    given: dict[str, object] = {"icons": list(hybrids.icons)}
    pins = [written(points) for points in hybrids.pins] or None
    data = {
        "draws": hybrids.draws,
        "seed": hybrids.seed,
        "symmetry": hybrids.symmetry,
        "pins": pins,
    }
    title = {"title": hybrids.title or None}
    return title | (given if hybrids.icons else picked) | data
