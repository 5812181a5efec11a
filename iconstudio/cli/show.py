"""``iconstudio show``: one icon on the canvas, as edits are drawn on it."""

from pathlib import Path

import click
from PIL import Image

from iconstudio.cli import running
from iconstudio.cli.rows import row
from iconstudio.files import write_bytes
from iconstudio.output import png
from iconstudio.session import Session


@click.command("show")
@click.argument("icon")
@click.option(
    "--png",
    "picture",
    type=click.Path(dir_okay=False, path_type=Path),
    metavar="FILE.png",
    help=f"Draw it, {png.SIZE} pixels wide: 4 for each unit of an edit's canvas of 256.",
)
def command(icon: str, picture: Path | None) -> None:
    """Say whose ICON (set:name, or the path of an SVG or a scan) is, and draw it on its canvas."""
    if picture is not None:
        png.check_name(picture, icon)
    with Session() as session:
        pictogram = session.icon(icon)
        running.tell_remarks([pictogram])
        exemplar = session.exemplar(pictogram)
        ink = None if picture is None else session.picture(exemplar, png.SIZE)
    if picture is not None and ink is not None:
        write_bytes(picture, png.encoded(Image.fromarray(255 - ink)))
    for one in dict.fromkeys((pictogram, *pictogram.origins)):
        click.echo(row(one.id, one.credit.author, one.credit.license))
