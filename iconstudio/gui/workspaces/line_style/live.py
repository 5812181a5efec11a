"""The lines as they are drawn again and again, and the samples of styles."""

from collections.abc import Generator, Iterable
from dataclasses import dataclass
from itertools import repeat

from iconstudio.gui.pictures.picture import Picture
from iconstudio.gui.workspaces.made import Made, made_of
from iconstudio.model import IconstudioError, Line, LineStyle, Restyling
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
    """Draw a sample of each style."""
    for style in styles:
        picture = None
        try:
            settings = RestyleSettings(coarse=True)
            for one in _made(session, Restyling(style, strokes=SAMPLE), settings):
                if isinstance(one, Made):
                    picture = one.picture
                else:
                    yield one
        except IconstudioError:
            pass  # whoever chooses it is told
        yield Sample(style, picture)


SAMPLE = (
    Line(
        ((28.0, 150.0), (128.0, 40.0), (228.0, 150.0)),
        width=8.0,
    ),
    Line(
        ((56.0, 122.0), (56.0, 226.0), (200.0, 226.0), (200.0, 122.0)),
        width=8.0,
    ),
)
"""What samples are drawn of: a house."""
