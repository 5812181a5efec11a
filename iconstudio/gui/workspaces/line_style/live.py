"""The lines as they are drawn again and again, and the samples of styles."""

from collections.abc import Generator, Iterable
from dataclasses import dataclass
from itertools import repeat

from iconstudio.gui.pictures.picture import Picture, picture_of
from iconstudio.gui.workspaces.made import Made, made_of
from iconstudio.model import Icon, IconstudioError, LineStyle, Path, Restyling
from iconstudio.session import Session
from iconstudio.workflows.events import Event
from iconstudio.workflows.line_style.restyling import RestyleSettings, variations
from iconstudio.workflows.line_style.spec import LINE_STYLE

Shown = Generator[Event | Made[Restyling]]


def made(session: Session, work: Restyling) -> Shown:
    """Run some work: its result as a picture, after a coarse one if that is there before."""
    return _made(session, work, RestyleSettings(previews=True))


def made_variations(session: Session, work: Restyling) -> Shown:
    """Run the variations of some work, which comes first."""
    return _made(session, work, RestyleSettings(variations=True))


def _made(session: Session, work: Restyling, settings: RestyleSettings) -> Shown:
    works = variations(work) if settings.variations else repeat(work)
    return made_of(session.run(LINE_STYLE, work, settings), works)


@dataclass(frozen=True, slots=True, eq=False)
class Sample:
    """A style, and what it makes of a few lines; None if nothing."""

    style: LineStyle
    picture: Picture | None


def samples(session: Session, styles: Iterable[LineStyle]) -> Generator[Event | Sample]:
    """Yield a sample of each style, those that are kept from earlier first."""
    missing = []
    for style in styles:
        kept = session.kept_sample(style)
        if kept is None:
            missing.append(style)
        else:
            yield _sample(style, kept)
    for style in missing:
        try:
            path = yield from session.sample(style)
        except IconstudioError:
            path = Path()  # whoever chooses it is told
        yield _sample(style, path)


def _sample(style: LineStyle, path: Path) -> Sample:
    return Sample(style, picture_of(Icon(path, style.name)) if path else None)
