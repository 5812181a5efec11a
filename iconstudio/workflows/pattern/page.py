"""The page of patterns: an exemplar, the pattern that is wanted, and which motifs are chosen."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field, replace
from itertools import chain
from math import hypot

from iconstudio.model import (
    CANVAS,
    Correction,
    IconstudioError,
    Motif,
    Patterning,
    Photo,
    Pictogram,
    Point,
    Separation,
    Stroke,
)
from iconstudio.workflows.pages import Document
from iconstudio.workflows.pattern.bounds import (
    LARGER,
    LARGEST,
    MOST_MOTIFS,
    SMALLER,
    SMALLEST,
    SMALLEST_MOTIF,
)
from iconstudio.workflows.pattern.scattering import PALETTE, scattered, scattered_anew

_STEPS = 12
"""A free place is looked for in so many columns and rows."""
_LARGEST_MOTIF = 4.0 * CANVAS
_APART = 12.0
"""By how much a copy is moved."""


@dataclass(frozen=True, slots=True)
class PatternPage:
    """An exemplar, and the motifs that are worked on, by their numbers from back to front."""

    work: Patterning = field(default_factory=Patterning)
    chosen: frozenset[int] = frozenset()

    @property
    def empty(self) -> bool:
        """Whether there is no exemplar."""
        return not self.work.motifs and self.work.image is None

    @property
    def icons(self) -> tuple[Pictogram, ...]:
        """The icons of the motifs, each once."""
        return tuple(dict.fromkeys(one.icon for one in self.work.motifs))

    def elsewhere(self, before: "PatternPage") -> bool:
        """Whether so much differs from ``before`` that the view should be fitted anew."""
        photos = [page.work.image and page.work.image.photo for page in (self, before)]
        return self.empty != before.empty or photos[0] is not photos[1]


PatternDocument = Document[PatternPage]


# -- the exemplar ----------------------------------------------------------------------------------


def add_icons(document: PatternDocument, icons: Sequence[Pictogram]) -> None:
    """Put icons on the canvas.

    As long as nobody has arranged them, all are scattered over it; then others go where there is
    room.

    Raises
    ------
    IconstudioError
        If there are more than a canvas can have.
    """
    work, before = document.page.work, document.page.icons
    if work.motifs == scattered(before) and set(icons) - set(before):
        together = tuple(dict.fromkeys((*before, *icons)))
        everywhere = scattered(together)
        _check_count(everywhere)
        _change(document, "add icons", motifs=everywhere, image=None)
        return
    motifs = list(work.motifs)
    for icon in icons:
        motifs.append(_beside(motifs, icon))
    _check_count(motifs)
    chosen = frozenset(range(len(work.motifs), len(motifs)))
    _put(document, "add icons", PatternPage(replace(work, motifs=tuple(motifs)), chosen))


def scatter(document: PatternDocument, seed: int) -> None:
    """Scatter the icons over the canvas anew, with their colours, sizes and what lies on them."""
    _change(document, "scatter icons", motifs=scattered_anew(document.page.work.motifs, seed))


def remove_chosen(document: PatternDocument) -> None:
    """Take the chosen motifs away."""
    page = document.page
    motifs = tuple(one for n, one in enumerate(page.work.motifs) if n not in page.chosen)
    _change(document, "remove icons", motifs=motifs)


def clear(document: PatternDocument) -> None:
    """Take the exemplar away."""
    _change(document, "clear exemplar", motifs=(), image=None)


def move_chosen(document: PatternDocument, dx: float, dy: float, gesture: object = None) -> None:
    """Move the chosen motifs; their middles stay on the canvas."""

    def moved(motif: Motif) -> Motif:
        return replace(
            motif, x=_within(motif.x + dx, 0, CANVAS), y=_within(motif.y + dy, 0, CANVAS)
        )

    _alter(document, "move icons", moved, gesture)


def resize_chosen(document: PatternDocument, factor: float, gesture: object = None) -> None:
    """Make the chosen motifs larger or smaller, each about its own middle."""
    _alter(
        document, "resize icons", lambda one: replace(one, size=_size(one.size * factor)), gesture
    )


def turn_chosen(document: PatternDocument, degrees: float, gesture: object = None) -> None:
    """Turn the chosen motifs, each about its own middle."""
    _alter(
        document,
        "turn icons",
        lambda one: replace(one, turn=(one.turn + degrees + 180) % 360 - 180),
        gesture,
    )


def flip_chosen(document: PatternDocument) -> None:
    """Mirror the chosen motifs, left to right."""
    _alter(document, "mirror icons", lambda one: replace(one, flip=not one.flip, turn=-one.turn))


def colour_chosen(document: PatternDocument, colour: str, gesture: object = None) -> None:
    """Give the chosen motifs another colour."""
    _alter(document, "colour icons", lambda one: replace(one, colour=colour), gesture)


def duplicate_chosen(document: PatternDocument) -> None:
    """Put a copy of each chosen motif beside it; the copies are then chosen.

    Raises
    ------
    IconstudioError
        If there are more than a canvas can have.
    """
    page = document.page
    copies = tuple(
        replace(one, x=_within(one.x + _APART, 0, CANVAS), y=_within(one.y + _APART, 0, CANVAS))
        for n, one in enumerate(page.work.motifs)
        if n in page.chosen
    )
    motifs = (*page.work.motifs, *copies)
    _check_count(motifs)
    chosen = frozenset(range(len(page.work.motifs), len(motifs)))
    _put(document, "duplicate icons", PatternPage(replace(page.work, motifs=motifs), chosen))


def raise_chosen(document: PatternDocument) -> None:
    """Bring the chosen motifs to the front."""
    _reorder(document, "bring to front", lambda others, chosen: [*others, *chosen])


def lower_chosen(document: PatternDocument) -> None:
    """Put the chosen motifs behind all others."""
    _reorder(document, "send to back", lambda others, chosen: [*chosen, *others])


def choose(document: PatternDocument, motifs: frozenset[int]) -> None:
    """Choose motifs; that is no edit."""
    document.show(replace(document.page, chosen=motifs))


def take_image(
    document: PatternDocument, photo: Photo, credits: tuple[Pictogram, ...] = ()
) -> None:
    """Let an image be the exemplar, in place of all icons."""
    _change(document, "open image", motifs=(), image=Separation(photo, credits=credits))


def set_colours(document: PatternDocument, colours: int | None) -> None:
    """Separate the image into so many colours; None for as many as there are."""
    image = document.page.work.image
    if image is not None:
        _change(document, "separate colours", image=replace(image, colours=colours, corrections=()))


def correct(document: PatternDocument, layer: int, stroke: Stroke) -> None:
    """Say by a stroke of the brush which layer a part of the image is of."""
    image = document.page.work.image
    if image is not None:
        corrections = (*image.corrections, Correction(layer, stroke))
        _change(document, "correct layer", image=replace(image, corrections=corrections))


def clear_corrections(document: PatternDocument) -> None:
    """Take all strokes of the brush back."""
    image = document.page.work.image
    if image is not None:
        _change(document, "clear corrections", image=replace(image, corrections=()))


# -- the pattern -----------------------------------------------------------------------------------


def set_ground(document: PatternDocument, colour: str, gesture: object = None) -> None:
    """Set the colour behind all motifs; empty for none."""
    _change(document, "change ground", gesture, ground=colour)


def set_size(document: PatternDocument, width: int, height: int, gesture: object = None) -> None:
    """Set how large the pattern is."""
    sides = (round(_within(side, SMALLEST, LARGEST)) for side in (width, height))
    width, height = sides
    _change(document, "change size", gesture, width=width, height=height)


def set_tile(document: PatternDocument, tile: bool) -> None:
    """Let the pattern continue itself, or not."""
    _change(document, "tile", tile=tile)


def set_seed(document: PatternDocument, seed: int, gesture: object = None) -> None:
    """Set what random choices depend on."""
    _change(document, "change seed", gesture, seed=seed)


def set_scale(document: PatternDocument, scale: float, gesture: object = None) -> None:
    """Set how large elements are, over those of the exemplar."""
    _change(document, "change scale", gesture, scale=_within(scale, SMALLER, LARGER))


def set_density(document: PatternDocument, density: float, gesture: object = None) -> None:
    """Set how dense motifs lie, over those of the exemplar."""
    _change(document, "change density", gesture, density=_within(density, SMALLER, LARGER))


def set_turn(document: PatternDocument, degrees: float, gesture: object = None) -> None:
    """Turn every motif, about its own middle."""
    _change(document, "turn motifs", gesture, turn=_within(degrees, -180, 180))


def set_fill(document: PatternDocument, shape: Pictogram | None) -> None:
    """Fill a shape with the pattern; None for all of its rectangle."""
    _change(document, "fill shape", fill=shape)


# --------------------------------------------------------------------------------------------------


def _beside(motifs: Sequence[Motif], icon: Pictogram) -> Motif:
    """Return a motif where most room is, as large as the others, in the colour of its like."""
    size = sorted(one.size for one in motifs)[len(motifs) // 2]
    known = {one.icon: one.colour for one in motifs}
    new = PALETTE[len(known) % len(PALETTE)]
    half = size / 2
    places = [
        half + (CANVAS - size) * n / (_STEPS - 1) if size < CANVAS else CANVAS / 2
        for n in range(_STEPS)
    ]
    spots = list(chain.from_iterable(((x, y) for x in places) for y in places))
    x, y = max(spots, key=lambda spot: min(_room(spot, one) for one in motifs))
    return Motif(icon, round(x, 1), round(y, 1), size, colour=known.get(icon, new))


def _room(spot: Point, motif: Motif) -> float:
    return hypot(spot[0] - motif.x, spot[1] - motif.y) - motif.size / 2


def _check_count(motifs: Sequence[Motif]) -> None:
    if len(motifs) > MOST_MOTIFS:
        raise IconstudioError(
            f"An exemplar takes at most {MOST_MOTIFS} icons. Remove one that is not needed first."
        )


def _alter(
    document: PatternDocument, text: str, altered: Callable[[Motif], Motif], gesture: object = None
) -> None:
    """Change the chosen motifs; they stay chosen."""
    page = document.page
    motifs = tuple(
        altered(one) if n in page.chosen else one for n, one in enumerate(page.work.motifs)
    )
    _put(document, text, replace(page, work=replace(page.work, motifs=motifs)), gesture)


def _reorder(
    document: PatternDocument,
    text: str,
    ordered: Callable[[list[Motif], list[Motif]], list[Motif]],
) -> None:
    page = document.page
    numbered = list(enumerate(page.work.motifs))
    chosen = [one for n, one in numbered if n in page.chosen]
    others = [one for n, one in numbered if n not in page.chosen]
    motifs = ordered(others, chosen)
    first = 0 if motifs[: len(chosen)] == chosen and others else len(others)
    numbers = frozenset(range(first, first + len(chosen)))
    _put(document, text, PatternPage(replace(page.work, motifs=tuple(motifs)), numbers))


def _size(side: float) -> float:
    return _within(side, SMALLEST_MOTIF, _LARGEST_MOTIF)


def _within(value: float, least: float, most: float) -> float:
    return min(max(value, least), most)


def _change(document: PatternDocument, text: str, gesture: object = None, **fields: object) -> None:
    """Change the work; if motifs are taken away or added, none is chosen."""
    page = document.page
    work = replace(page.work, **fields)  # type: ignore[arg-type]  # as their callers say
    chosen = page.chosen if len(work.motifs) == len(page.work.motifs) else frozenset()
    _put(document, text, PatternPage(work, chosen), gesture)


def _put(document: PatternDocument, text: str, page: PatternPage, gesture: object = None) -> None:
    if page.work != document.page.work:
        document.change(text, page, gesture)
