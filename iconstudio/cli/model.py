"""``iconstudio model``: sketch-based modelling without a window."""

from dataclasses import replace
from pathlib import Path

import click

from iconstudio.algorithms.expansion import LAMBDAS
from iconstudio.algorithms.matching import SCALES
from iconstudio.algorithms.style import STYLES
from iconstudio.cli.lists import ListCommand, Numbers, Words, flat, is_number
from iconstudio.cli.progress import ProgressBar
from iconstudio.cli.timing import Stopwatch
from iconstudio.inputs.sketch import read_sketch
from iconstudio.model import IconstudioError, Sketch
from iconstudio.output.report import Report
from iconstudio.session import Session
from iconstudio.workflows.events import Progress, Result, Retrieved, StyleSkipped
from iconstudio.workflows.grid import ModelSettings

_STYLES = tuple(style.name for style in STYLES)


@click.command(
    "model",
    cls=ListCommand,
    goes_on={"--styles": _STYLES.__contains__, "--lambdas": is_number, "--scales": is_number},
)
@click.argument("sketch_file", metavar="SKETCH.json", type=click.Path(path_type=Path))
@click.option(
    "--out",
    "folder",
    type=click.Path(path_type=Path),
    required=True,
    metavar="DIR",
    help="Folder for the icons, results.json and the contact sheet grid.png.",
)
@click.option(
    "--keyword", metavar="K", help="What the sketch shows; instead of the file's keyword."
)
@click.option(
    "--exclude", multiple=True, metavar="ID", help="Do not use this icon; may be repeated."
)
@click.option(
    "--styles",
    type=Words(),
    multiple=True,
    default=(_STYLES,),
    help=f"Some of {', '.join(_STYLES)}. Default: all four.",
)
@click.option(
    "--lambdas",
    type=Numbers(1000),
    multiple=True,
    default=(LAMBDAS,),
    help="Values of lambda_S. Default: 8 from 0.03 (closer to the sketch) to 0.75 (smoother).",
)
@click.option(
    "--scales",
    type=Numbers(3),
    multiple=True,
    default=(SCALES,),
    help="Scale factors to try. Default: 0.9,1,1.1; more daring: 0.8,0.9,1,1.1,1.25.",
)
@click.option(
    "--dump", is_flag=True, help="Write STYLE.npz too: all that a result can be checked by."
)
def command(
    sketch_file: Path,
    folder: Path,
    keyword: str | None,
    exclude: tuple[str, ...],
    styles: tuple[tuple[str, ...], ...],
    lambdas: tuple[tuple[float, ...], ...],
    scales: tuple[tuple[float, ...], ...],
    dump: bool,
) -> None:
    """Make icons in the shape of the polygon in SKETCH.json out of parts of real ones."""
    sketch = read_sketch(sketch_file).sketch
    sketch = replace(
        sketch,
        keyword=sketch.keyword if keyword is None else keyword,
        exclude=sketch.exclude | frozenset(exclude),
    )
    settings = ModelSettings(
        flat(styles), tuple(sorted({*flat(lambdas)})), tuple(sorted({*flat(scales)}))
    )
    with Session() as session:
        run(session, sketch, settings, folder, dump=dump)


def run(
    session: Session, sketch: Sketch, settings: ModelSettings, folder: Path, *, dump: bool = False
) -> None:
    """Model a sketch, write everything into ``folder``, and say what is there."""
    settings.chosen_styles()
    sketch.polygon.fitted()
    if not sketch.keyword.strip():
        raise IconstudioError(
            "There is no keyword. Say what the sketch shows: "
            '--keyword dog, or "keyword" in the file.'
        )
    if sketch.polygon.crosses_itself:
        click.echo("The outline crosses itself: all that it encloses counts as inside.", err=True)
    report = Report(folder, sketch, settings.lambdas)
    stopwatch = Stopwatch()
    results = 0
    with ProgressBar() as bar:
        for event in session.model(sketch, settings):
            stopwatch.note(event)
            report.add(event)
            if isinstance(event, Progress):
                bar.show(event.done, event.message)
            elif isinstance(event, StyleSkipped):
                bar.say(event.reason)
            elif isinstance(event, Retrieved):
                bar.say(f"{len(event.exemplars)} different icons of “{sketch.keyword}”")
            results += isinstance(event, Result)
        bar.show(1.0, "Drawing the contact sheet")
        report.finish(stopwatch.timings(), dump=dump)
    if session.trouble:
        click.echo(session.trouble, err=True)
    if not results:
        raise IconstudioError(
            f"No style has enough icons of “{sketch.keyword}”. Try a more common word; "
            f"iconstudio search {sketch.keyword!r} shows what there is."
        )
    click.echo(f"{results} icons; see {folder / 'grid.png'}")
