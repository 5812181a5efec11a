"""``iconstudio restyle``: icons and whole sets in a line style, without a window."""

from collections.abc import Generator
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import click

from iconstudio.cli import line_styles, running
from iconstudio.cli.plain import into_folder
from iconstudio.cli.restyled_set import restyle_set
from iconstudio.cli.timing import Stopwatch, profile_option, profiled
from iconstudio.files import write_bytes
from iconstudio.model import IconstudioError, LineStyle, Pictogram, Restyled, Restyling
from iconstudio.output import export
from iconstudio.output.folder import check_folder
from iconstudio.session import Session
from iconstudio.workflows.events import Event, Result
from iconstudio.workflows.files import read_file
from iconstudio.workflows.line_style.restyling import said_of
from iconstudio.workflows.line_style.sets import Manner
from iconstudio.workflows.line_style.spec import LINE_STYLE


@dataclass(frozen=True)
class _Asked:
    """What the command line asks for: one field an option."""

    style: LineStyle | None
    seed: int | None
    strength: float | None
    size: float | None

    def of(self, work: Restyling) -> Restyling:
        """Return some work as the options change it."""
        given = {name: value for name, value in vars(self).items() if value is not None}
        return replace(work, **given)


@click.command("restyle")
@click.argument("reference", metavar="[INPUT]", required=False)
@line_styles.style_option
@click.option(
    "--out",
    required=True,
    metavar="FILE.svg|DIR",
    help="The file for the icon; the folder for a set, or for the results of a RESTYLE.json.",
)
@line_styles.seed_option
@line_styles.strength_option
@line_styles.size_option
@click.option("--strokes", is_flag=True, help="What is a stroke stays one, instead of an outline.")
@click.option(
    "--set",
    "icons",
    metavar="NAME|FOLDER",
    help="Restyle every icon of a set of the collection, such as lucide, or of a folder of SVGs."
    " Stopped, the same command goes on where it was.",
)
@click.option(
    "--scheduler",
    metavar="ADDRESS",
    help="Hand the set to a Dask cluster, tcp://HOST:8786; needs iconstudio[cluster].",
)
@profile_option
def command(
    reference: str | None,
    style: str | None,
    out: str,
    seed: int | None,
    strength: float | None,
    size: float | None,
    strokes: bool,
    icons: str | None,
    scheduler: str | None,
    profile: bool,
) -> None:
    """Draw the lines of INPUT by example: an icon (set:name), an SVG, or a RESTYLE.json.

    With --set, those of every icon of a set.
    """
    if (reference is None) == (icons is None):
        raise IconstudioError("Name one icon or file to restyle, or a whole set with --set.")
    if scheduler is not None and icons is None:
        raise IconstudioError("--scheduler is for whole sets: name one with --set.")
    if not out:
        raise IconstudioError("The name behind --out is empty. Give one.")
    written = reference is not None and Path(reference).suffix.lower() == ".json"
    if not written:
        line_styles.need_style(style)
    with profiled(profile) as stopwatch, Session() as session:
        learned = None if style is None else line_styles.style_of(style, session)
        asked = _Asked(learned, seed, strength, size)
        if icons is not None and learned is not None:
            work = asked.of(Restyling())
            manner = Manner(learned, work.strength, work.size, work.seed, strokes)
            restyle_set(session, icons, manner, Path(out), scheduler, stopwatch)
        elif reference is not None and written:
            _restyle_file(session, Path(reference), asked, out, strokes, stopwatch)
        elif reference is not None:
            path = line_styles.svg_name(out, reference, style)
            icon = session.icon(reference)
            running.tell_remarks([icon])
            _tell_of_lines(session, icon)
            line_styles.get_ready(session.workers, 1)
            events = session.run(LINE_STYLE, asked.of(Restyling(icon=icon)))
            _write(_only(events, stopwatch), path, strokes)


def _restyle_file(
    session: Session, file: Path, asked: _Asked, out: str, strokes: bool, stopwatch: Stopwatch
) -> None:
    """Restyle what a RESTYLE.json says: into a file, or a folder as other workflows do."""
    events = _reading_and_running(session, file, asked)
    if out.lower().endswith(".svg"):
        path = line_styles.svg_name(out)
        _write(_only(events, stopwatch), path, strokes)
        return
    if strokes:
        raise IconstudioError("With --strokes, name a file to write: --out FILE.svg.")
    check_folder(Path(out))
    into_folder(session, events, Path(out), LINE_STYLE.name, stopwatch)


def _reading_and_running(session: Session, file: Path, asked: _Asked) -> Generator[Event]:
    work: Restyling = yield from read_file(file, LINE_STYLE, session, running.tell)
    if work.icon is not None:
        _tell_of_lines(session, work.icon)
    line_styles.get_ready(session.workers, 1)
    yield from session.run(LINE_STYLE, asked.of(work))


def _tell_of_lines(session: Session, icon: Pictogram) -> None:
    if remark := said_of(session, icon):
        running.tell(f"“{icon.credit.title or icon.id}”: {remark}")


def _only(events: Generator[Event], stopwatch: Stopwatch) -> Any:
    """Return the icon that is made."""
    found = None
    for event in events:
        stopwatch.note(event)
        if isinstance(event, Result):
            found = event.icon
    return found


def _write(icon: Restyled, path: Path, strokes: bool) -> None:
    if not icon.path:
        raise IconstudioError("Nothing is left of it in this style. Try a smaller --size.")
    if icon.scale < 1:
        running.tell(f"It had no room on the canvas, and came out {1 - icon.scale:.1%} smaller.")
    write_bytes(path, export.svg_of_strokes(icon) if strokes else export.svg(icon))
