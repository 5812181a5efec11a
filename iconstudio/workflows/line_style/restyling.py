"""Restyling the lines of an icon (*Curve Analogies*, section 4)."""

from collections.abc import Generator, Sequence
from dataclasses import dataclass, replace
from functools import partial

from iconstudio.model import (
    CANVAS,
    Credit,
    Icon,
    IconstudioError,
    Line,
    LineStyle,
    Path,
    Pictogram,
    Restyled,
    Restyling,
    StylePair,
    Transform,
)
from iconstudio.model.path import OVERHANG
from iconstudio.svg.lines import said_of_pale_parts
from iconstudio.workflows.events import Event, Progress, Result
from iconstudio.workflows.previewing import Answer, answers
from iconstudio.workflows.workflow import Resources

WEAKEST, STRONGEST = 0.1, 3.0
SMALLEST, LARGEST = 0.25, 4.0
STRENGTHS = (1.0, 0.6, 1.5)
"""Of variations, over the one that is wanted: a row each."""
LARGEST_SEED = 2**53
"""More would not be the same number everywhere in JSON."""
SEEDS = 4
"""Of variations: a column each."""
_SMALL = 0.25
"""Of the canvas: what is no larger is small on its page."""
SECONDS, MEMORY = 60.0, 2 << 30
Sides = tuple[float, float]
"""Width and height, in canvas units."""


@dataclass(frozen=True, slots=True, kw_only=True)
class RestyleSettings:
    """Which results to make."""

    variations: bool = False
    """Whether other seeds and strengths follow the one that is wanted."""
    previews: bool = False
    """Whether a coarse result may come before the finished one, if that takes longer."""
    coarse: bool = False
    """Whether results may be coarse, for small pictures: they take less than half the time."""


def run(
    resources: Resources, work: Restyling, settings: RestyleSettings | None = None
) -> Generator[Event]:
    """Restyle lines: yield the icon that is wanted, and what else ``settings`` ask for.

    Raises
    ------
    IconstudioError
        If there is no style, or there are no lines.
    """
    yield Progress("remix", 0.0, "Reading the lines")
    lines = lines_of(resources, work)
    styles = [_style_of(work, number) for number in range(len(lines))]
    settings = settings or RestyleSettings()
    wanted = variations(work) if settings.variations else [work]
    ticket = resources.workers.ticket()
    try:
        submit = partial(
            resources.workers.submit, restyled_path, lines, styles,
            timeout=SECONDS, memory=MEMORY, ticket=ticket,
        )  # fmt: skip
        coarse = submit(work.strength, work.size, work.seed, True) if settings.previews else None
        tasks = [submit(one.strength, one.size, one.seed, settings.coarse) for one in wanted]
        for event in answers(tasks, coarse, "remix", "Restyling the lines"):
            if isinstance(event, Answer):
                icon = icon_of(wanted[event.number], *event.value, styles)
                yield Result(icon, preview=event.preview)
            else:
                yield event
    finally:
        ticket.stop()


def lines_of(resources: Resources, work: Restyling) -> tuple[Line, ...]:
    """Return the lines to restyle: the icon's, then those drawn beside them.

    Raises
    ------
    IconstudioError
        If there are none.
    """
    own = resources.lines(work.icon) if work.icon is not None else ()
    if not (own or work.strokes):
        raise IconstudioError("There are no lines yet. Choose an icon, or draw some.")
    return (*own, *work.strokes)


def said_of(resources: Resources, icon: Pictogram) -> str:
    """Return what a user should know of its lines: what they do not show, and whether they are so
    small that textures are large beside them. Empty if there is nothing.
    """
    pale = said_of_pale_parts(resources.exemplar(icon).coverage)
    return " ".join(filter(None, [pale, _said_of_size(resources.lines(icon))]))


def _said_of_size(lines: Sequence[Line]) -> str:
    """Return a sentence about lines that are small and thin: a dot of a set is not."""
    xs, ys = zip(*(point for line in lines for point in line.points), strict=True)
    side = max(max(xs) - min(xs), max(ys) - min(ys))
    if side > _SMALL * CANVAS or max(line.width for line in lines) > side / 2:
        return ""
    return (
        f"It is small on its page, {side / CANVAS:.0%} of it, and textures are as large as on "
        "others. Crop the page to it, or make the texture smaller."
    )


def variations(work: Restyling) -> list[Restyling]:
    """Return the work itself, and the same in other strengths and with other seeds."""
    return [
        replace(
            work,
            strength=min(max(factor * work.strength, WEAKEST), STRONGEST),
            seed=(work.seed + number) % (LARGEST_SEED + 1),
        )
        for factor in STRENGTHS
        for number in range(SEEDS)
    ]


def restyled_path(
    lines: Sequence[Line],
    styles: Sequence[LineStyle],
    strength: float,
    size: float,
    seed: int,
    coarse: bool = False,
    page: Sides = (CANVAS, CANVAS),
) -> tuple[Path, tuple[Line, ...], float]:
    """Return what lines in their styles draw, these lines, and their scale, 1 mostly.

    If the given lines do not reach as far out of a ``page`` in the middle of the canvas, all
    shrinks towards its middle. Runs in a worker process.
    """
    from iconstudio.algorithms.curves.outline import path_of
    from iconstudio.algorithms.curves.restyle import prepare, restyled

    prepared = [prepare(style, strength, size) for style in styles]
    drawn = tuple(restyled(zip(lines, prepared, strict=True), seed, coarse))
    path = path_of(drawn)
    overhang = _overhang(path, page)
    allowed = _overhang(path_of(lines), page) if overhang > OVERHANG else 0.0
    if overhang <= allowed + OVERHANG:
        return path, drawn, 1.0
    half = min(page) / 2
    scale = (half + allowed) / (half + overhang)
    return path.transformed(_scaling(scale)), scaled(drawn, scale), scale


def _overhang(path: Path, page: Sides) -> float:
    """Return by how much a path reaches out of a page in the middle of the canvas, at most."""
    if not path:
        return 0.0
    left, top, right, bottom = path.bounds
    x, y = ((CANVAS - side) / 2 for side in page)
    return max(0.0, x - left, y - top, right - CANVAS + x, bottom - CANVAS + y)


def scaled(lines: Sequence[Line], scale: float) -> tuple[Line, ...]:
    """Return lines larger or smaller, about the middle of the canvas."""
    transform = _scaling(scale)
    return tuple(
        replace(
            one,
            points=tuple(map(transform.transformPoint, one.points)),
            width=scale * one.width,
            widths=tuple(scale * width for width in one.widths),
        )
        for one in lines
    )


def _scaling(scale: float) -> Transform:
    off = (1 - scale) * CANVAS / 2
    return Transform(scale, 0, 0, scale, off, off)


def warm_up() -> None:
    """Load what restyles, and compile it if it never was, on a line of nothing."""
    stroke = StylePair(((0.0, 0.0), (30.0, 4.0), (60.0, 0.0)))
    bar = Line(((20.0, 20.0), (60.0, 20.0)), width=4.0)
    restyled_path([bar], [LineStyle("", (stroke,))], 1.0, 1.0, 0)


def icon_of(
    work: Restyling,
    path: Path,
    lines: tuple[Line, ...],
    scale: float,
    styles: Sequence[LineStyle],
) -> Icon:
    """Return a restyled icon."""
    title, credits = signed(work.icon, styles)
    return Restyled(path, title, credits, lines=lines, scale=scale)


def signed(
    icon: Pictogram | None, styles: Sequence[LineStyle]
) -> tuple[str, tuple[Pictogram, ...]]:
    """Return what a restyled icon is called, and its credits: its makers, and the styles'."""
    subject, own = ("lines", ()) if icon is None else (icon.credit.title, icon.origins)
    authors = dict.fromkeys(map(thanks, filter(lambda style: style.author, styles)))
    return f"{subject}, {styles[0].name}", (*own, *authors)


def _style_of(work: Restyling, number: int) -> LineStyle:
    style = work.style_of(number)
    if style is None:
        raise IconstudioError(
            "There is no style yet. Choose one, by --style or in the file, or draw an example."
        )
    return style


def thanks(style: LineStyle) -> Pictogram:
    """Return a line style as what an icon was made of."""
    credit = Credit(f"{style.name} (line style)", style.author, style.license, "", "")
    return Pictogram(f"style:{style.name}", "", credit)
