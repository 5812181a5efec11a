"""Read and write what is mixed, in a thread of their own."""

from collections.abc import Generator
from pathlib import Path

from iconstudio.session import Session
from iconstudio.workflows.events import Event
from iconstudio.workflows.hybrids.file import COUNT, read_hybrids
from iconstudio.workflows.hybrids.hybrids import check
from iconstudio.workflows.hybrids.page import Ask, HybridsPage, Ingredient


def read_page(session: Session, path: Path) -> Generator[Event, None, HybridsPage]:
    """Return the page that a file describes; yield the progress of picking its icons.

    Raises
    ------
    IconstudioError
        If the file is no good, an icon is not there, or the icons cannot be mixed.
    """
    file = read_hybrids(path)
    ask = None
    if file.icons is None:
        # As without the window: the seed picks the group, too.
        ask = Ask(file.word, file.count or COUNT, file.symmetry, file.seed)
        icons = yield from session.choose(ask.keyword, ask.count, ask.symmetry, ask.group)
        mix = file.mix(icons)
    else:
        mix = file.resolved(session.icon)
    check(mix)
    pins = mix.pins or ((),) * len(mix.icons)
    ingredients = tuple(
        Ingredient(session.exemplar(icon), points)
        for icon, points in zip(mix.icons, pins, strict=True)
    )
    name = file.title or path.stem
    return HybridsPage(ingredients, ask, mix.seed, mix.draws, mix.symmetry, name=name)
