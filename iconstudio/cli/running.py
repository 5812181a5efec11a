"""Running a workflow without a window: progress on the terminal, everything into a report."""

from collections.abc import Callable, Generator, Iterable, Mapping
from contextlib import closing
from dataclasses import replace
from pathlib import Path
from typing import Any, Protocol

import click

from iconstudio.cli.progress import ProgressBar
from iconstudio.cli.timing import Stopwatch
from iconstudio.grammar import counted
from iconstudio.model import CANVAS, IconstudioError, Pictogram, Remix
from iconstudio.output.folder import check_folder
from iconstudio.output.png import untidied
from iconstudio.session import Session
from iconstudio.workflows.events import Event, Progress, Remark, Result, Retrieved, StyleSkipped
from iconstudio.workflows.remixing import FINE


class Report(Protocol):
    """What a workflow leaves in a folder."""

    def add(self, event: Event) -> None:
        """Note an event; write what can be written."""

    def finish(self, timings: Mapping[str, float]) -> None:
        """Write the rest; ``timings`` are seconds by stage."""


def run(
    session: Session,
    events: Generator[Event],
    report: Report,
    stopwatch: Stopwatch,
    tidy: bool = True,
) -> int:
    """Run a workflow to its end, write all that comes of it, and return how many results did.

    ``tidy``: what seams brought about is put right.
    """
    results = 0
    with closing(events), ProgressBar() as bar:
        for event in events:
            if isinstance(event, Result) and not tidy:
                event = replace(event, icon=untidied(event.icon))
            stopwatch.note(event)
            report.add(event)
            stopwatch.wrote()
            match event:
                case Progress():
                    bar.show(event.done, event.message, event.remaining)
                case StyleSkipped():
                    bar.say(event.reason)
                case Retrieved():
                    icons = counted(len(event.exemplars), "different icon")
                    bar.say(f"{icons} of “{event.keyword}”")
                    if event.remark:
                        bar.say(event.remark)
                case Remark():
                    bar.say(event.sentence)
                case Result(preview=False, icon=icon):
                    results += not (isinstance(icon, Remix) and icon.composite.stands_in)
        bar.show(1.0, "Drawing the contact sheet")
        report.finish(stopwatch.timings())
        stopwatch.wrote()
    if session.trouble:
        click.echo(session.trouble, err=True)
    return results


def tell_results(count: int, noun: str, sheet: Path) -> None:
    """Say how many results there are, and which picture shows them."""
    click.echo(f"{counted(count, noun)}; see {click.format_filename(sheet)}")


def tell(sentence: str) -> None:
    """Say what a user should know, beside the results."""
    click.echo(sentence, err=True)


def tell_remarks(icons: Iterable[Pictogram]) -> None:
    """Say what could not be read of the drawings of icons: a line each, if there is anything."""
    for icon in dict.fromkeys(icons):
        if icon.remarks:
            line = f"“{icon.credit.title or icon.id}”: {' '.join(icon.remarks)}"
            click.echo(" ".join(line.split()), err=True)


def icons_of(option: str, session: Session, identifiers: Iterable[str]) -> frozenset[str]:
    """Return the icons that an ``option`` names, as the collection calls them.

    Raises
    ------
    IconstudioError
        If it has no such icon; the message names what is near.
    """
    try:
        return frozenset(session.collection.get(one).id for one in identifiers)
    except IconstudioError as error:
        raise IconstudioError(f"{option}: {error}") from None


def input_file(metavar: str) -> Callable[..., Any]:
    """Return the argument that names the input file."""
    return click.argument("file", metavar=metavar, type=click.Path(path_type=Path))


def fine_option(function: Callable[..., Any]) -> Callable[..., Any]:
    """Add an option ``--fine``, which gives ``fine``; ``side_of`` says what it means."""
    return click.option(
        "--fine",
        is_flag=True,
        help=f"Join on a canvas of {FINE} x {FINE} sites instead of {CANVAS} x {CANVAS}: finer"
        " seams, about five times the time.",
    )(function)


def tidy_option(function: Callable[..., Any]) -> Callable[..., Any]:
    """Add an option ``--no-tidy``, which gives ``tidy``."""
    return click.option(
        "--no-tidy",
        "tidy",
        is_flag=True,
        flag_value=False,
        default=True,
        help="Leave lines, circles, widths and symmetry as they come out where parts meet.",
    )(function)


def side_of(fine: bool) -> int:
    """Return the sites in a row of the graph cut."""
    return FINE if fine else CANVAS


def output_folder(sheet: str) -> Callable[..., Any]:
    """Return the option that names the folder for everything; it is checked before any work."""

    def checked(_: click.Context, __: click.Parameter, name: str) -> Path:
        if not name:
            raise IconstudioError("The name of the folder for the results is empty. Give one.")
        check_folder(Path(name))
        return Path(name)

    return click.option(
        "--out",
        "folder",
        type=click.Path(),
        required=True,
        metavar="DIR",
        callback=checked,
        help=f"Folder for the icons, results.json and the contact sheet {sheet}.",
    )
