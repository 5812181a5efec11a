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
from iconstudio.workflows.events import Progress, Recommended, Result
from iconstudio.workflows.grid import LAMBDAS, GridSettings
from iconstudio.workflows.modelling.file import read_sketch
from iconstudio.workflows.modelling.spec import MODELLING


class Choice(StrictRecord, frozen=True):
    """Which of a sketch's results a person found best, and what they think of it.

    Stands in the sketch's file as ``"best"``.
    """

    style: Text = "medium"
    column: Annotated[int, Meta(ge=1, le=len(LAMBDAS))] | None = field(name="lambda", default=None)
    """Of the grid, counted from 1; None: what the program recommends of the style."""
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
            said = {} if file.best is None else file.best
            sketch, choice = file.sketch, json.converted(said, Choice, path, ", best")
            row: dict[float, Remix] = {}
            best = None if choice.column is None else LAMBDAS[choice.column - 1]
            for event in session.run(MODELLING, sketch, _settings(choice)):
                stopwatch.note(event)
                match event:
                    case Result(icon=Remix() as icon):
                        row[icon.composite.lambda_s] = icon
                    case Recommended() if choice.column is None:
                        best = event.lambda_s
                    case Progress():
                        bar.show((number + event.done) / len(files), file.title)
            remix = None if best is None else row.get(best)
            subjects.append(
                Subject(file.title, sketch.polygon, remix, choice.remark, choice.failed)
            )
        write_bytes(out, png.encoded(gallery_sheet(subjects)))
        stopwatch.wrote()
    click.echo(click.format_filename(out))


def _settings(choice: Choice) -> GridSettings:
    """Return the chosen style, and the lambda_S down to the chosen one: each starts the next."""
    if choice.column is None:
        return GridSettings(styles=(choice.style,))
    return GridSettings(
        styles=(choice.style,), lambdas=LAMBDAS[choice.column - 1 :], variants=False
    )
