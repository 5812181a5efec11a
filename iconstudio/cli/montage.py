"""``iconstudio montage``: the scribbled parts of icons joined, without a window."""

from pathlib import Path

import click

from iconstudio.cli import running
from iconstudio.cli.timing import profile_option, profiled
from iconstudio.output.montage import MontageReport
from iconstudio.session import Session
from iconstudio.workflows.montage.file import read_montage
from iconstudio.workflows.montage.spec import MONTAGE
from iconstudio.workflows.remixing import CutSettings


@click.command("montage")
@running.input_file("MONTAGE.json")
@running.output_folder("sheet.png")
@running.fine_option
@profile_option
def command(file: Path, folder: Path, fine: bool, profile: bool) -> None:
    """Join the parts of icons that are scribbled over in MONTAGE.json."""
    read = read_montage(file)
    for remark in read.remarks:
        running.tell(f"In “{file.name}”: {remark}")
    with profiled(profile) as stopwatch, Session() as session:
        montage = read.resolved(session.icon)
        running.tell_remarks(layer.icon for layer in montage.layers)
        report = MontageReport(folder, montage)
        events = session.run(MONTAGE, montage, CutSettings(side=running.side_of(fine)))
        results = running.run(session, events, report, stopwatch)
    running.tell_results(results, "icon", folder / "sheet.png")
