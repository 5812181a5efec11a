"""A mix and its favourites in a project file."""

from collections.abc import Generator
from dataclasses import asdict
from typing import Any

from iconstudio.inputs.fields import Fields, plain_text
from iconstudio.model import CANVAS, Remix
from iconstudio.workflows.hybrids.file import LARGEST_SEED
from iconstudio.workflows.hybrids.hybrids import MOST, MOST_DRAWS
from iconstudio.workflows.hybrids.page import Ask, HybridsPage, Ingredient
from iconstudio.workflows.pages import PageFormat, Parts, StoredParts


class HybridsPages(PageFormat[HybridsPage]):
    """The icons with their pins, how they are mixed, and the favourites."""

    def write(self, page: HybridsPage, parts: Parts) -> dict[str, Any]:
        """Return a page as JSON."""
        return {
            "icons": [
                {"icon": parts.icon(one.exemplar.pictogram), "pins": one.pins}
                for one in page.ingredients
            ],
            "ask": None if page.ask is None else asdict(page.ask),
            "seed": page.seed,
            "draws": page.draws,
            "symmetry": page.symmetry,
            "favourites": [parts.result(one) for one in page.favourites],
            "name": plain_text(page.name),
        }

    def read(self, fields: Fields, parts: StoredParts) -> Generator[None, None, HybridsPage]:
        """Return the page that was written; favourites that are no good are told and left out."""
        mixed: dict[str, Ingredient] = {}
        for entry in fields.objects("icons", "icon"):
            icon = parts.exemplar(parts.icon(entry.reference()))
            mixed[icon.id] = Ingredient(icon, entry.points("pins", CANVAS))
            yield
        if len(mixed) > MOST:
            raise fields.mistake(f"At most {MOST} icons can be mixed.")
        favourites = yield from parts.results(fields.texts("favourites"))
        hybrids = tuple(one for one in favourites if isinstance(one, Remix))
        return HybridsPage(
            tuple(mixed.values()),
            _ask(fields.object("ask")) if fields.has("ask") else None,
            fields.whole("seed", 0, 0, LARGEST_SEED),
            fields.whole("draws", HybridsPage().draws, 1, MOST_DRAWS),
            fields.axis(),
            hybrids,
            fields.text("name"),
        )

    def kept(self, page: HybridsPage) -> tuple[Remix, ...]:
        """Return the favourites."""
        return page.favourites


def _ask(fields: Fields) -> Ask:
    count, group = fields.whole("count", 5, 1, MOST), fields.whole("group", 0, 0, LARGEST_SEED)
    return Ask(fields.text("keyword"), count, fields.axis(), group)
