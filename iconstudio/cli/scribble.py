"""``iconstudio scribble``: a new line in a style, along nothing."""

import click

from iconstudio.cli import line_styles
from iconstudio.files import write_bytes
from iconstudio.output.svg import document
from iconstudio.session import Session
from iconstudio.workers import answer
from iconstudio.workflows.line_style.restyling import MEMORY, SECONDS, thanks
from iconstudio.workflows.line_style.scribbling import LONGEST, SHORTEST, scribbled


@click.command("scribble")
@line_styles.style_option
@click.option(
    "--length",
    type=line_styles.Between(SHORTEST, LONGEST),
    metavar="N",
    required=True,
    help="How long the line is, about, in units of a canvas of 256.",
)
@click.option("--out", required=True, metavar="FILE.svg", help="The file for the line.")
@line_styles.seed_option
def command(style: str | None, length: float, out: str, seed: int | None) -> None:
    """Draw a new line in a line style: the picture is as large as the line becomes."""
    from iconstudio.algorithms.curves.outline import strokes_of

    reference = line_styles.need_style(style)
    path = line_styles.svg_name(out, style)
    with Session() as session:
        learned = line_styles.style_of(reference, session)
        line_styles.get_ready(session.workers, 1)
        task = scribbled, learned, length, seed or 0
        drawing = session.workers.submit(*task, timeout=SECONDS, memory=MEMORY)
        line, size = answer(drawing, "Drawing the line", "Ask for a shorter one.")
    credits = [thanks(learned)] if learned.author else []
    svg = document(f"scribble, {learned.name}", credits, strokes_of([line]), size)
    write_bytes(path, svg.encode())
