"""The command of a workflow that has no options of its own: it reads, runs and writes."""

from collections.abc import Generator
from pathlib import Path
from typing import Any

import click

from iconstudio.cli import running
from iconstudio.cli.timing import Stopwatch, profile_option, profiled
from iconstudio.model import IconstudioError
from iconstudio.output.icons import IconsReport
from iconstudio.session import Session
from iconstudio.workflows.events import Event
from iconstudio.workflows.files import read_file
from iconstudio.workflows.workflow import Workflow


def command_of(workflow: Workflow[Any]) -> click.Command:
    """Return the command of a workflow: a file in, a folder of icons out."""

    @click.command(workflow.name, help=workflow.help)
    @running.input_file(f"{workflow.name.upper()}.json")
    @running.output_folder("sheet.png")
    @profile_option
    def command(file: Path, folder: Path, profile: bool) -> None:
        with profiled(profile) as stopwatch, Session() as session:
            events = _reading_and_running(session, workflow, file)
            into_folder(session, events, folder, workflow.name, stopwatch)

    return command


def into_folder(
    session: Session, events: Generator[Event], folder: Path, name: str, stopwatch: Stopwatch
) -> None:
    """Run a workflow, write its icons into a folder, and say what is there."""
    results = running.run(session, events, IconsReport(folder, name), stopwatch)
    running.tell_results(results, "icon", folder / "sheet.png")


def _reading_and_running(session: Session, workflow: Workflow[Any], file: Path) -> Generator[Event]:
    work = yield from read_file(file, workflow, session, running.tell)
    if workflow.work is not None and work == workflow.work():
        raise IconstudioError(
            f"There is nothing to run: the {workflow.noun} in “{file.name}” is empty. "
            "Fill it first."
        )
    running.tell_remarks(workflow.icons(work))
    yield from session.run(workflow, work)
