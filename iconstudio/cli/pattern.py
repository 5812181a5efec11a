"""``iconstudio pattern``: an exemplar continued as a pattern, without a window."""

import re
from collections.abc import Generator
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import click

from iconstudio.cli import running
from iconstudio.cli.line_styles import Between
from iconstudio.cli.progress import ProgressBar
from iconstudio.cli.timing import Stopwatch, profile_option, profiled
from iconstudio.files import check_writable, is_address
from iconstudio.model import IconstudioError, Patterning
from iconstudio.output.pattern import check_name, write
from iconstudio.reading import is_path
from iconstudio.session import Session
from iconstudio.workflows.events import Event, Progress, Remark, Result
from iconstudio.workflows.files import read_file
from iconstudio.workflows.pattern.bounds import LARGER, LARGEST, LARGEST_SEED, SMALLER, SMALLEST
from iconstudio.workflows.pattern.file import ground_of
from iconstudio.workflows.pattern.imaging import reduction_of, unheeded
from iconstudio.workflows.pattern.spec import PATTERN


class _Ground(click.ParamType):  # type: ignore[type-arg]  # generic only since Click 8.5
    """An opaque colour, or ``none``."""

    name = "ground"

    def convert(self, value: Any, param: click.Parameter | None, ctx: click.Context | None) -> str:
        """Read it."""
        try:
            return ground_of(value)
        except IconstudioError as error:
            self.fail(f"{error} For a transparent ground, write none.", param, ctx)


class _Size(click.ParamType):  # type: ignore[type-arg]  # generic only since Click 8.5
    """A width and a height, as in ``512x256``."""

    name = "size"

    def convert(
        self, value: Any, param: click.Parameter | None, ctx: click.Context | None
    ) -> tuple[int, int]:
        """Read both."""
        found = re.fullmatch(r"\s*(\d{1,9})\s*[x×X,]\s*(\d{1,9})\s*", value)
        if found is None:
            self.fail(f"{value!r} is no size; write one as 512x512", param, ctx)
        width, height = map(int, found.groups())
        if not all(SMALLEST <= side <= LARGEST for side in (width, height)):
            self.fail(f"give a width and a height from {SMALLEST} to {LARGEST}", param, ctx)
        return width, height


@dataclass(frozen=True)
class _Asked:
    """What the command line asks for, beside the exemplar: what is None is as the file says."""

    size: tuple[int, int] | None
    tile: bool | None
    seed: int | None
    scale: float | None
    density: float | None
    turn: float | None
    ground: str | None
    fill: str | None

    def of(self, work: Patterning, session: Session) -> Patterning:
        """Return some work as the options change it."""
        given = {
            name: value
            for name in ("tile", "seed", "scale", "density", "turn", "ground")
            if (value := getattr(self, name)) is not None
        }
        if self.size is not None:
            given["width"], given["height"] = self.size
        if self.fill is not None:
            given["fill"] = session.icon(self.fill)
            running.tell_remarks([given["fill"]])
        return replace(work, **given)


@click.command("pattern")
@click.argument("exemplar", metavar="EXEMPLAR")
@click.option("--size", type=_Size(), metavar="WxH", help="Of the pattern. Default: 512x512.")
@click.option("--tile/--no-tile", default=None, help="Whether it continues itself. Default: yes.")
@click.option(
    "--seed",
    type=click.IntRange(0, LARGEST_SEED),
    metavar="N",
    help="The same seed gives the same pattern. Default: 0.",
)
@click.option("--scale", type=Between(SMALLER, LARGER), metavar="S", help="Of its elements.")
@click.option("--density", type=Between(SMALLER, LARGER), metavar="D", help="How dense icons lie.")
@click.option("--turn", type=Between(-360, 360), metavar="DEGREES", help="Turn every icon.")
@click.option(
    "--ground", type=_Ground(), metavar="COLOUR", help="#rrggbb, or none: a transparent ground."
)
@click.option("--fill", metavar="SHAPE.svg", help="Fill this shape only: a file, or set:name.")
@click.option("--out", required=True, metavar="FILE", help="A file .svg, .png or .css.")
@profile_option
def command(exemplar: str, out: str, profile: bool, **options: Any) -> None:
    """Continue EXEMPLAR as a pattern: a PATTERN.json, a drawing (SVG, PNG, ...), or set:name."""
    if not out:
        raise IconstudioError("The name behind --out is empty. Give one.")
    path = check_name(Path(out))
    check_writable(path, (exemplar, options["fill"]))
    with profiled(profile) as stopwatch, Session() as session:
        events = _reading_and_running(session, exemplar, _Asked(**options))
        write(_only(events, stopwatch), path)


def _reading_and_running(session: Session, exemplar: str, asked: _Asked) -> Generator[Event]:
    work = yield from _work(session, exemplar)
    if work.image is not None:
        if reduced := reduction_of(work.image.photo):
            running.tell(reduced)
        running.tell_remarks(work.image.credits)
    running.tell_remarks(one.icon for one in work.motifs)
    wanted = asked.of(work, session)
    if passed_over := unheeded(wanted):
        running.tell(passed_over)
    yield from session.run(PATTERN, wanted)


def _work(session: Session, exemplar: str) -> Generator[Event, None, Patterning]:
    if Path(exemplar).suffix.lower() == ".json":
        return (yield from read_file(Path(exemplar), PATTERN, session, running.tell))
    if is_path(exemplar) and not is_address(exemplar):
        return Patterning(image=(yield from session.artwork(Path(exemplar))))
    assert PATTERN.with_icons is not None
    return PATTERN.with_icons(Patterning(), (session.icon(exemplar),))


def _only(events: Generator[Event], stopwatch: Stopwatch) -> Any:
    """Return the pattern that is made."""
    found: Any = None
    with ProgressBar() as bar:
        for event in events:
            stopwatch.note(event)
            match event:
                case Progress():
                    bar.show(event.done, event.message, event.remaining)
                case Remark():
                    bar.say(event.sentence)
                case Result(preview=False):
                    found = event.icon
    return found
