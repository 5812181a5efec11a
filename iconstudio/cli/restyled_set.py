"""Restyling whole sets without a window: progress on the terminal, all into a folder."""

from contextlib import closing, nullcontext
from pathlib import Path

import click

from iconstudio.cli.progress import ProgressBar
from iconstudio.cluster import Cluster
from iconstudio.library.sets import is_folder, members
from iconstudio.model import IconstudioError
from iconstudio.output.folder import check_folder
from iconstudio.output.restyled_set import RestyledSet
from iconstudio.session import Session
from iconstudio.workflows.events import Progress
from iconstudio.workflows.line_style import sets
from iconstudio.workflows.line_style.sets import Here, Manner

_TOLD = 20
"""Most skipped icons that are named; the manifest has all."""


def restyle_set(
    session: Session, reference: str, manner: Manner, folder: Path, scheduler: str | None
) -> None:
    """Restyle a set into a folder, here or in a cluster, and say what is there.

    Raises
    ------
    IconstudioError
        If there is no such set, folder or cluster, or no icon could be restyled.
    """
    check_folder(folder)
    icons = members(reference, session.collection)
    if is_folder(reference, session.collection):
        _check_apart(folder, Path(reference))
    name = Path(reference).resolve().name if Path(reference).is_dir() else reference
    written = RestyledSet(folder, name, icons, manner)
    with (
        ProgressBar() as bar,
        nullcontext() if scheduler is None else Cluster(scheduler) as cluster,
    ):
        events = sets.restyle_set(icons, manner, cluster or Here(session.workers), written.is_done)
        try:
            with closing(events):
                for event in events:
                    if isinstance(event, Progress):
                        bar.show(event.done, event.message, event.remaining)
                    else:
                        written.add(event)
        finally:
            written.save()
        for done in written.finish():
            bar.show(done, "Drawing the contact sheet")
    _tell(written, folder)


def _check_apart(folder: Path, source: Path) -> None:
    """Refuse to write into a folder that is read: its drawings might be replaced."""
    if folder.resolve().is_relative_to(source.resolve()):
        raise IconstudioError(
            f"“{folder}” lies in the folder whose icons are restyled. Choose one outside of it."
        )


def _tell(written: RestyledSet, folder: Path) -> None:
    skipped = sorted(written.skipped.items())
    for identifier, reason in skipped[:_TOLD]:
        click.echo(" ".join(f"Skipped {identifier}: {reason}".split()), err=True)
    if len(skipped) > _TOLD:
        click.echo(f"Skipped {len(skipped) - _TOLD} more; all are named in the manifest.", err=True)
    if not len(written):
        raise IconstudioError("No icon of the set could be restyled.")
    count = "1 icon" if len(written) == 1 else f"{len(written):,} icons"
    without = f", {len(skipped):,} skipped" if skipped else ""
    click.echo(f"{count}{without}; see {click.format_filename(folder / 'sheet.png')}")
