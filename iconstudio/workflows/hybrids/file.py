"""HYBRIDS.json: which icons to mix (section 4.3)."""

from collections.abc import Generator
from pathlib import Path
from typing import Annotated, Self

from msgspec import Meta

from iconstudio.inputs.formats import MOST_IN_LIST, Many, Reference, Text
from iconstudio.inputs.lines import rounded
from iconstudio.model import CANVAS, Axis, IconstudioError, Mix, Pictogram
from iconstudio.model.mix import DRAWS
from iconstudio.workflows.events import Event
from iconstudio.workflows.files import open_file
from iconstudio.workflows.hybrids.hybrids import FEWEST, MOST, MOST_DRAWS
from iconstudio.workflows.workflow import File, Find, Refer, Resources

LARGEST_SEED = 2**63 - 1
COUNT = 5
"""Icons that are picked if the file does not say how many."""

Draws = Annotated[int, Meta(ge=1, le=MOST_DRAWS)]
Seed = Annotated[int, Meta(ge=0, le=LARGEST_SEED)]
_Coordinate = Annotated[float, Meta(ge=-CANVAS, le=CANVAS)]
Pins = Many[tuple[_Coordinate, _Coordinate]]


class HybridsFile(File[Mix], frozen=True):
    """A HYBRIDS.json: either ``icons``, or a ``keyword`` that the program picks some by."""

    icons: Many[Reference] | None = None
    keyword: Text = ""
    count: Annotated[int, Meta(ge=FEWEST, le=MOST)] | None = None
    """How many are picked."""
    draws: Draws = DRAWS
    seed: Seed = 0
    symmetry: Axis | None = None
    pins: Many[Pins] = ()
    """For each of the given icons, points that every hybrid keeps; empty if there are none."""

    @classmethod
    def of(cls, mix: Mix, refer: Refer) -> Self:
        """Return the file of a mix."""
        return cls(
            icons=tuple(map(refer, mix.icons)),
            draws=mix.draws,
            seed=mix.seed,
            symmetry=mix.symmetry,
            pins=tuple(map(rounded, mix.pins)),
        )

    @property
    def word(self) -> str:
        """What the icons are picked by; empty if they are given."""
        return self.keyword.strip()

    def resolved(self, find: Find) -> Mix:
        """Return the mix of the icons that are given, found by ``find``."""
        return self.mix(tuple(map(find, self.icons or ())))

    def resolving(self, resources: Resources) -> Generator[Event, None, Mix]:
        """Return the mix; pick its icons if they are not given: the seed says which group."""
        if self.icons is not None:
            return self.resolved(resources.icon)
        count = self.count or COUNT
        picked = yield from resources.choose(self.word, count, self.symmetry, self.seed)
        return self.mix(picked)

    def mix(self, icons: tuple[Pictogram, ...]) -> Mix:
        """Return the mix of these icons."""
        return Mix(icons, self.draws, self.seed, self.symmetry, self.pins)

    def check(self) -> None:
        """Refuse what is neither given nor to be picked, or both."""
        if (self.icons is None) == (not self.word):
            nor = "; not both" if self.word else ""
            raise IconstudioError(
                f'Give either "icons", a list, or a "keyword" to pick them by{nor}.'
            )
        if self.icons is not None and self.count is not None:
            raise IconstudioError('"count" goes with "keyword"; with "icons", all are mixed.')
        if sum(map(len, self.pins)) > MOST_IN_LIST:
            raise IconstudioError(
                f'"pins" holds too many points; at most {MOST_IN_LIST:,} are read.'
            )


def read_hybrids(path: Path) -> HybridsFile:
    """Read a HYBRIDS.json.

    Raises
    ------
    IconstudioError
        If the file cannot be read or does not say what to mix.
    """
    return open_file(path, HybridsFile)
