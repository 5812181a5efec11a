"""What is mixed, and what was kept of it; and the edits of both."""

from collections.abc import Generator, Sequence
from dataclasses import dataclass, replace
from functools import lru_cache

import numpy as np

from iconstudio.model import Axis, Exemplar, IconstudioError, Mix, Point, Remix, Score, Seeds
from iconstudio.model.mix import DRAWS
from iconstudio.workflows.events import Event
from iconstudio.workflows.hybrids.file import COUNT, HybridsFile
from iconstudio.workflows.hybrids.hybrids import FEWEST, MOST, check
from iconstudio.workflows.pages import Document
from iconstudio.workflows.workflow import Resources


@dataclass(frozen=True, slots=True)
class PickRequest:
    """What the program picks icons by: the ``group``-th best of ``count`` icons of a keyword."""

    keyword: str
    count: int
    symmetry: Axis | None
    group: int = 0

    @property
    def next(self) -> "PickRequest":
        """The request for the icons that are next best."""
        return replace(self, group=self.group + 1)


@dataclass(frozen=True, slots=True)
class Ingredient:
    """An icon to mix, and the points on it, in canvas pixels, that every hybrid keeps."""

    exemplar: Exemplar
    pins: tuple[Point, ...] = ()
    picked: bool = False
    """Whether the program picked it: then others may take its place, unless it has pins."""

    @property
    def id(self) -> str:
        """The icon's identifier."""
        return self.exemplar.id

    @property
    def name(self) -> str:
        """What to call the icon."""
        return self.exemplar.name


@dataclass(frozen=True, slots=True)
class HybridsPage:
    """Icons to mix, how to mix them, and the favourites among the hybrids."""

    ingredients: tuple[Ingredient, ...] = ()
    ask: PickRequest | None = None
    """How the program picked the icons; None if the user chose them all."""
    seed: int = 0
    draws: int = DRAWS
    """How many are drawn in one go."""
    symmetry: Axis | None = None
    favourites: tuple[Remix, ...] = ()
    name: str = ""
    """What the user's file is called; empty if there is none."""

    def elsewhere(self, before: "HybridsPage") -> bool:
        """Whether none of the icons is the same."""
        return self.ids.isdisjoint(before.ids)

    @property
    def ids(self) -> frozenset[str]:
        """The identifiers of the icons."""
        return frozenset(one.id for one in self.ingredients)

    @property
    def mix(self) -> Mix:
        """The first draws of what is to be mixed."""
        pins: Seeds = tuple(one.pins for one in self.ingredients)
        icons = tuple(one.exemplar.pictogram for one in self.ingredients)
        return Mix(icons, self.draws, self.seed, self.symmetry, pins if any(pins) else ())

    @property
    def title(self) -> str:
        """What to call the hybrids: by the word that the icons were found with, or by the file."""
        return self.ask.keyword if self.ask is not None else self.name or "mix"


HybridsDocument = Document[HybridsPage]


def page_of(
    file: HybridsFile, name: str, resources: Resources
) -> Generator[Event, None, HybridsPage]:
    """Return the page that a file describes, called ``name`` if it does not say; yield progress.

    Raises
    ------
    IconstudioError
        If an icon is not there, or the icons cannot be mixed.
    """
    mix = yield from file.resolving(resources)
    check(mix)
    ask = None
    if file.icons is None:
        ask = PickRequest(file.word, file.count or COUNT, file.symmetry, file.seed)
    pins = mix.pins or ((),) * len(mix.icons)
    ingredients = tuple(
        Ingredient(resources.exemplar(icon), points, picked=ask is not None)
        for icon, points in zip(mix.icons, pins, strict=True)
    )
    title = file.title or name
    return HybridsPage(ingredients, ask, mix.seed, mix.draws, mix.symmetry, name=title)


_FULL = f"At most {MOST} icons can be mixed. Remove one first."


def add_icons(document: HybridsDocument, icons: Sequence[Exemplar]) -> tuple[Exemplar, ...]:
    """Mix more icons, as many as there is room for, and return the others.

    Nothing happens to those that are among them already.

    Raises
    ------
    IconstudioError
        If there is no room at all.
    """
    page = document.page
    new = tuple({one.id: one for one in icons if one.id not in page.ids}.values())
    room = MOST - len(page.ingredients)
    if new and room <= 0:
        raise IconstudioError(_FULL)
    if new:
        more = (*page.ingredients, *map(Ingredient, new[:room]))
        text = "add icon" if len(new[:room]) == 1 else "add icons"
        document.change(text, replace(page, ingredients=more))
    return new[room:]


def remove_icon(document: HybridsDocument, identifier: str) -> None:
    """Mix one icon fewer."""
    page = document.page
    left = tuple(one for one in page.ingredients if one.id != identifier)
    if left != page.ingredients:
        ask = page.ask if left else None
        document.change("remove icon", replace(page, ingredients=left, ask=ask))


def next_pick(page: HybridsPage, keyword: str, count: int) -> PickRequest:
    """Return how the program should pick icons; once more the same, the next best ones."""
    ask = PickRequest(keyword, count, page.symmetry)
    if page.ask is not None and ask == replace(page.ask, group=0):
        return page.ask.next
    return ask


def set_picked(
    document: HybridsDocument, icons: tuple[Exemplar, ...], ask: PickRequest
) -> tuple[Exemplar, ...]:
    """Mix the icons that the program picked in place of those that it had picked before.

    Those that the user chose, or pinned parts of, stay. Return the icons for which that leaves no
    room.

    Raises
    ------
    IconstudioError
        If there is no room at all.
    """
    page = document.page
    kept = tuple(one for one in page.ingredients if one.pins or not one.picked)
    names = {one.id for one in kept}
    new = [icon for icon in icons if icon.id not in names]
    room = MOST - len(kept)
    if new and not room:
        raise IconstudioError(_FULL)
    picked = (Ingredient(icon, picked=True) for icon in new[:room])
    document.change("pick icons", replace(page, ingredients=(*kept, *picked), ask=ask))
    return tuple(new[room:])


def clear_icons(document: HybridsDocument) -> None:
    """Mix nothing."""
    document.change("remove all icons", replace(document.page, ingredients=(), ask=None))


def set_pins(document: HybridsDocument, identifier: str, pins: tuple[Point, ...]) -> None:
    """Say which points of an icon every hybrid keeps."""
    page = document.page
    changed = tuple(
        replace(one, pins=pins) if one.id == identifier else one for one in page.ingredients
    )
    before = next(one.pins for one in page.ingredients if one.id == identifier)
    text = "pin a part" if len(pins) > len(before) else "remove pin"
    document.change(text, replace(page, ingredients=changed))


def on_shape(exemplar: Exemplar, point: Point) -> Point:
    """Return the centre of the pixel of an icon's solid shape that is nearest to ``point``."""
    from iconstudio.algorithms.raster import solid

    ys, xs = np.nonzero(solid(exemplar.ink))
    nearest = int(np.hypot(xs + 0.5 - point[0], ys + 0.5 - point[1]).argmin())
    return float(xs[nearest]) + 0.5, float(ys[nearest]) + 0.5


def set_seed(document: HybridsDocument, seed: int, gesture: object = None) -> None:
    """Draw by another random seed. Digits that are typed in one ``gesture`` are undone together."""
    if seed != document.page.seed:
        document.change("change seed", replace(document.page, seed=seed), gesture)


def set_symmetry(document: HybridsDocument, axis: Axis | None) -> None:
    """Say which halves of the hybrids must mirror each other."""
    if axis != document.page.symmetry:
        text = "hold to symmetry" if axis else "drop symmetry"
        document.change(text, replace(document.page, symmetry=axis))


def set_favourites(document: HybridsDocument, favourites: tuple[Remix, ...]) -> None:
    """Keep these hybrids."""
    page = document.page
    if favourites != page.favourites:
        more = len(favourites) > len(page.favourites)
        text = "add favourite" if more else "remove favourite"
        document.change(text, replace(page, favourites=favourites))


def problem(mix: Mix) -> str:
    """Return what is missing before ``mix`` can be drawn, as a sentence; else nothing."""
    if len(mix.icons) < FEWEST:
        more = "two icons" if not mix.icons else "one more icon"
        return f"Choose at least {more} to mix: look some up on the left, or let the program pick."
    return ""


def terms(score: Score) -> str:
    """Say what the rank score of a hybrid is made of."""
    plausible = {} if score.plausible is None else {"plausible": score.plausible}
    parts = plausible | {
        "smooth seams": score.seam,
        "in one piece": score.whole,
        "symmetry": score.symmetry,
        "shared by several icons": score.sharing,
    }
    lines = [f"{name} {value:.0%}" for name, value in parts.items()]
    return f"Rank score {score.total:.2f}: " + ", ".join(lines)


def shared_axis(page: HybridsPage) -> Axis | None:
    """Return an axis about which all icons of a page are nearly symmetric, if there is one."""
    axes = [_axes(one.exemplar) for one in page.ingredients]
    return next((axis for axis in Axis if axes and all(axis in some for some in axes)), None)


@lru_cache(64)
def _axes(exemplar: Exemplar) -> frozenset[Axis]:
    """Return the axes about which an icon's solid shape is nearly symmetric."""
    from iconstudio.algorithms.iconification.symmetry import NEARLY, likeness
    from iconstudio.algorithms.raster import solid

    shape = solid(exemplar.ink)
    return frozenset(axis for axis in Axis if likeness(shape, axis) >= NEARLY)
