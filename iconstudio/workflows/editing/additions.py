"""Whether results show what was added to an icon, and what is said if they do not."""

from collections.abc import Generator, Iterable, Iterator, Sequence
from contextlib import closing
from dataclasses import replace

from iconstudio.algorithms.iconification.overhang import seen
from iconstudio.algorithms.raster import Bitmap, overlap, placed_ink, solid
from iconstudio.model import Placement, Remix
from iconstudio.workflows.editing.fitting import ALIKE
from iconstudio.workflows.events import Event, Remark, Result

_INSIDE = (
    "Added area {} lies inside the icon's outline and adds nothing to it: what results show there, "
    "parts of other icons happen to have. Draw a hole or lines for what is to be seen inside."
)
_SMALLER = (
    "What you added has no room on the canvas, or comes near its border: all is made smaller, to "
    "{} of its size. To keep the size, draw it further inside."
)
_MISSED = (
    "No result shows much of what you added, {:.0%} at most: other icons have little like it "
    "there. Draw it larger or elsewhere, or try another keyword or style."
)
_PARTS = (
    "No icon of “{}” fits what you added as a whole: results show parts of some in its place. "
    "Draw it more like one of them, or larger, or try another keyword."
)
_LEAST, _MUCH, _WHOLE = 0.1, 0.5, 0.8
"""A result that shows less of what was added does not fit the change at all; one that shows so
much shows it; and one that shows so much shows it whole."""


def doubts(placement: Placement, enclosed: Iterable[int]) -> Iterator[str]:
    """Yield what a user should know of additions before they are made.

    ``placement`` is that of the icon with them; those that are ``enclosed`` add nothing to it.
    """
    size = f"{placement.scale:.0%}"
    if placement.scale < 1 and size != "100%":
        yield _SMALLER.format(size)
    yield from map(_INSIDE.format, enclosed)


def judged(icon: Remix, wanted: Bitmap) -> Remix:
    """Return a result, which fits the change the less, the less it shows of what was added.

    ``wanted`` (m, m) is what is to be filled that the icon alone does not fill.
    """
    part = shown(icon, wanted)
    if part >= _WHOLE:
        return icon
    fit = part / _WHOLE if part >= _LEAST else 0.0
    return replace(icon, score=replace(icon.score, likeness=icon.score.likeness * fit))


def shown(icon: Remix, wanted: Bitmap) -> float:
    """Return what part of the wanted area (m, m) a result fills; 1 if nothing is wanted."""
    drawing = icon.drawing
    area = seen(wanted, drawing.frame, len(drawing.coverage), False)
    return float(solid(drawing.coverage > 127)[area].mean()) if area.any() else 1.0


def with_missed(
    events: Generator[Event], wanted: Bitmap, areas: Sequence[Bitmap] = (), name: str = ""
) -> Generator[Event]:
    """Pass events on; say at the end if no result shows much of what was added, or none a whole.

    ``areas`` (m, m) are those in which things of that ``name`` should be as a whole.
    """
    best: float | None = None
    whole = not areas
    with closing(events):
        for event in events:
            yield event
            match event:
                case Result(icon=Remix() as icon, preview=False):
                    best = max(best or 0.0, shown(icon, wanted))
                    whole = whole or _has_whole(icon, areas)
    if best is not None and best < _MUCH:
        yield Remark(_MISSED.format(best))
    elif best is not None and not whole:
        yield Remark(_PARTS.format(name))


def _has_whole(icon: Remix, areas: Sequence[Bitmap]) -> bool:
    """Whether in each of some areas (CANVAS, CANVAS) a result has a source that fits it."""
    composite = icon.composite
    used = [
        placed_ink(source.exemplar, source.placement)[1]
        for source, share in zip(composite.sources, composite.shares, strict=True)
        if share > 0
    ]
    return all(any(overlap(one, area) >= ALIKE for one in used) for area in areas)
