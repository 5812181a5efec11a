"""``iconstudio montage``: the scribbled parts of icons joined, without a window."""

from pathlib import Path

import click

from iconstudio.cli import running
from iconstudio.inputs.montage import read_montage
from iconstudio.output.montage import MontageReport
from iconstudio.session import Session


@click.command("montage")
@running.input_file("MONTAGE.json")
@running.output_folder("sheet.png")
def command(file: Path, folder: Path) -> None:
    """Join the parts of icons that are scribbled over in MONTAGE.json."""
    read = read_montage(file)
    with Session() as session:
        montage = read.resolved(session.icon)
        running.run(session, session.montage(montage), MontageReport(folder, montage))
    click.echo(f"1 icon; see {folder / 'sheet.png'}")
