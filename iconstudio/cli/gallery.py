"""``iconstudio gallery``: one picture of many subjects, in the manner of the paper's figure 17."""

from pathlib import Path
from typing import Annotated

import click
from msgspec import Meta, field

from iconstudio.cli.progress import ProgressBar
from iconstudio.cli.timing import profile_option, profiled
from iconstudio.files import write_bytes
from iconstudio.inputs import json
from iconstudio.inputs.formats import StrictRecord, Text
from iconstudio.model import IconstudioError, Remix
from iconstudio.output import png
from iconstudio.output.sheet import Subject, gallery_sheet
from iconstudio.resources import resource
from iconstudio.session import Session
from iconstudio.workflows.events import Progress, Result
from iconstudio.workflows.grid import LAMBDAS, GridSettings
from iconstudio.workflows.modelling.file import read_sketch
from iconstudio.workflows.modelling.spec import MODELLING


class Choice(StrictRecord, frozen=True):
    """Which of a sketch's results a person found best, and what they think of it.

    Stands in the sketch's file as ``"best"``; without it, the middle of the grid is shown.
    """

    style: Text = "medium"
    column: Annotated[int, Meta(ge=1, le=len(LAMBDAS))] = field(name="lambda", default=4)
    """Of the grid, counted from 1."""
    remark: Text = ""
    failed: bool = False


@click.command("gallery")
@click.option(
    "--sketches",
    type=click.Path(exists=True, file_okay=False, path_type=Path),
    help="Folder of SKETCH.json files. Default: the sixteen that come with the program.",
)
@click.option(
    "--out",
    type=click.Path(dir_okay=False, path_type=Path),
    default=Path("gallery.png"),
    show_default=True,
    metavar="FILE.png",
)
@profile_option
def command(sketches: Path | None, out: Path, profile: bool) -> None:
    """Draw each sketch with its chosen result and its colour code."""
    png.check_name(out)
    files = sorted((sketches or resource("examples/gallery")).glob("*.json"))
    if not files:
        raise IconstudioError(f"There are no sketches (*.json) in “{sketches}”.")
    subjects = []
    with profiled(profile) as stopwatch, Session() as session, ProgressBar() as bar:
        for number, path in enumerate(files):
            file = read_sketch(path)
            best = {} if file.best is None else file.best
            sketch, choice = file.sketch, json.converted(best, Choice, path, ", best")
            remix = None
            for event in session.run(MODELLING, sketch, _settings(choice)):
                stopwatch.note(event)
                match event:
                    case Result(icon=Remix() as icon):
                        remix = icon  # the last one has the lambda_S that was chosen
                    case Progress():
                        bar.show((number + event.done) / len(files), file.title)
            subjects.append(
                Subject(file.title, sketch.polygon, remix, choice.remark, choice.failed)
            )
        write_bytes(out, png.encoded(gallery_sheet(subjects)))
        stopwatch.wrote()
    click.echo(click.format_filename(out))


def _settings(choice: Choice) -> GridSettings:
    """Return the chosen style, and the lambda_S down to the chosen one: each starts the next."""
    return GridSettings(
        styles=(choice.style,), lambdas=LAMBDAS[choice.column - 1 :], variants=False
    )
