"""``iconstudio search``: list what a keyword retrieves."""

from pathlib import Path

import click

from iconstudio.cli import running
from iconstudio.cli.progress import ProgressBar
from iconstudio.cli.rows import row
from iconstudio.cli.timing import Stopwatch, profile_option, profiled
from iconstudio.model import Exemplar, Pictogram
from iconstudio.session import Session
from iconstudio.workflows.events import Progress


@click.command("search")
@click.argument("words", nargs=-1, required=True, metavar="WORD...")
@click.option(
    "--exclude", multiple=True, metavar="ID", help="Leave out this icon; may be repeated."
)
@click.option(
    "--sheet",
    type=click.Path(dir_okay=False, path_type=Path),
    metavar="FILE.png",
    help="Draw the icons as well.",
)
@profile_option
def command(
    words: tuple[str, ...], exclude: tuple[str, ...], sheet: Path | None, profile: bool
) -> None:
    """List the icons that a word, or words, retrieve, best first: identifier, author, licence."""
    word = " ".join(words)
    if sheet is not None:
        from iconstudio.output import png

        png.check_name(sheet, *exclude)
    with profiled(profile) as stopwatch, Session() as session:
        with ProgressBar() as bar:
            for step in session.open():
                bar.show(step.done, step.message)
        pictograms = session.search(word, running.icons_of("--exclude", session, exclude))
        stopwatch.note(Progress("search", 1.0, word))
        if sheet is not None:
            _draw(session, pictograms, word, sheet, stopwatch)
        for pictogram in pictograms:
            credit = pictogram.credit
            click.echo(row(pictogram.id, credit.author, credit.license))
        if remark := session.collection.remark(word):
            click.echo(remark, err=True)


def _draw(
    session: Session,
    pictograms: tuple[Pictogram, ...],
    word: str,
    sheet: Path,
    stopwatch: Stopwatch,
) -> None:
    from iconstudio.output.sheet import search_sheet

    exemplars: tuple[Exemplar, ...] = ()
    with ProgressBar() as bar:
        steps = session.rasterise(pictograms)
        try:
            while True:
                step = next(steps)
                stopwatch.note(step)
                bar.show(step.done, step.message)
        except StopIteration as end:
            exemplars = end.value
    search_sheet(exemplars, word, sheet)
    stopwatch.wrote()
