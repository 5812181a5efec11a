"""``iconstudio model``: sketch-based modelling without a window."""

from dataclasses import replace
from pathlib import Path

import click

from iconstudio.cli import grid
from iconstudio.inputs.sketch import read_sketch
from iconstudio.model import Sketch
from iconstudio.output.wish import sketched
from iconstudio.session import Session
from iconstudio.workflows.grid import ModelSettings


@grid.grid_command("model", "SKETCH.json", "all four")
def command(
    file: Path,
    folder: Path,
    keyword: str | None,
    exclude: tuple[str, ...],
    styles: tuple[str, ...],
    lambdas: tuple[float, ...],
    scales: tuple[float, ...],
    dump: bool,
) -> None:
    """Make icons in the shape of the polygon in SKETCH.json out of parts of real ones."""
    sketch = read_sketch(file).sketch
    sketch = replace(
        sketch,
        keyword=sketch.keyword if keyword is None else keyword,
        exclude=sketch.exclude | frozenset(exclude),
    )
    settings = ModelSettings(styles or ModelSettings().styles, lambdas, scales)
    with Session() as session:
        run(session, sketch, settings, folder, dump=dump)


def run(
    session: Session, sketch: Sketch, settings: ModelSettings, folder: Path, *, dump: bool = False
) -> None:
    """Model a sketch, write everything into ``folder``, and say what is there."""
    settings.chosen_styles()
    wish = sketched(sketch)
    grid.need_keyword(sketch.keyword)
    if sketch.polygon.crosses_itself:
        click.echo("The outline crosses itself: all that it encloses counts as inside.", err=True)
    grid.run(session, session.model(sketch, settings), wish, settings, folder, dump=dump)
