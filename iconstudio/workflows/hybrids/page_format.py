"""A mix and its favourites in a project file."""

from collections.abc import Generator
from dataclasses import asdict
from typing import Annotated

from msgspec import Meta, structs

from iconstudio.inputs.formats import Many, Record, Text, plain_text
from iconstudio.model import Axis, IconstudioError, Remix
from iconstudio.model.mix import DRAWS
from iconstudio.workflows.hybrids.file import COUNT, Draws, Pins, Seed
from iconstudio.workflows.hybrids.hybrids import MOST
from iconstudio.workflows.hybrids.page import HybridsPage, Ingredient, PickRequest
from iconstudio.workflows.pages import PageFormat, Parts, StoredParts


class StoredIngredient(Record, frozen=True):
    """An icon to mix, and what is pinned on it."""

    icon: Text
    pins: Pins = ()
    picked: bool = False


class StoredAsk(Record, frozen=True):
    """How the program picked the icons."""

    keyword: Text = ""
    count: Annotated[int, Meta(ge=1, le=MOST)] = COUNT
    symmetry: Axis | None = None
    group: Seed = 0


class StoredMix(Record, frozen=True):
    """The page of hybrids."""

    icons: Many[StoredIngredient] = ()
    ask: StoredAsk | None = None
    seed: Seed = 0
    draws: Draws = DRAWS
    symmetry: Axis | None = None
    favourites: Many[Text] = ()
    name: Text = ""

    def check(self) -> None:
        """Refuse more icons than can be mixed."""
        if len({one.icon for one in self.icons}) > MOST:
            raise IconstudioError(f"At most {MOST} icons can be mixed.")


class HybridsPages(PageFormat[HybridsPage, StoredMix]):
    """The icons with their pins, how they are mixed, and the favourites."""

    stored = StoredMix

    def write(self, page: HybridsPage, parts: Parts) -> StoredMix:
        """Return a page as it is stored."""
        return StoredMix(
            tuple(
                StoredIngredient(parts.icon(one.exemplar.pictogram), one.pins, one.picked)
                for one in page.ingredients
            ),
            None if page.ask is None else StoredAsk(**asdict(page.ask)),
            page.seed,
            page.draws,
            page.symmetry,
            tuple(map(parts.result, page.favourites)),
            plain_text(page.name),
        )

    def read(self, stored: StoredMix, parts: StoredParts) -> Generator[None, None, HybridsPage]:
        """Return the page that was written; favourites that are no good are told and left out."""
        mixed: dict[str, Ingredient] = {}
        for one in stored.icons:
            icon = parts.exemplar(parts.icon(one.icon))
            mixed[icon.id] = Ingredient(icon, one.pins, one.picked)
            yield
        favourites = yield from parts.results(stored.favourites)
        return HybridsPage(
            tuple(mixed.values()),
            None if stored.ask is None else PickRequest(**structs.asdict(stored.ask)),
            stored.seed,
            stored.draws,
            stored.symmetry,
            tuple(one for one in favourites if isinstance(one, Remix)),
            stored.name,
        )

    def kept(self, page: HybridsPage) -> tuple[Remix, ...]:
        """Return the favourites."""
        return page.favourites
