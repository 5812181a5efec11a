"""Restyling whole sets without a window: progress on the terminal, all into a folder."""

from collections.abc import Mapping
from contextlib import ExitStack, closing
from pathlib import Path

import click

from iconstudio.cli.line_styles import get_ready
from iconstudio.cli.progress import ProgressBar
from iconstudio.cli.running import tell
from iconstudio.cli.timing import Stopwatch
from iconstudio.cluster import Cluster
from iconstudio.grammar import counted
from iconstudio.library.sets import is_folder, members
from iconstudio.model import IconstudioError
from iconstudio.output.folder import check_folder
from iconstudio.output.restyled_set import MANIFEST, RestyledSet
from iconstudio.session import Session
from iconstudio.workflows.events import Progress
from iconstudio.workflows.line_style import sets
from iconstudio.workflows.line_style.sets import Here, Manner, Processes

_TOLD = 20
"""Most icons of which something is said."""


def restyle_set(
    session: Session,
    reference: str,
    manner: Manner,
    folder: Path,
    scheduler: str | None,
    stopwatch: Stopwatch,
) -> None:
    """Restyle a set into a folder, here or in a cluster, and say what is there.

    Raises
    ------
    IconstudioError
        If there is no such set, folder or cluster, or no icon could be restyled.
    """
    check_folder(folder)
    with ProgressBar() as bar, ExitStack() as closed_at_last:
        for step in session.open():
            bar.show(step.done, step.message)
        icons = members(reference, session.collection)
        if is_folder(reference, session.collection):
            _check_apart(folder, Path(reference))
        name = Path(reference).resolve().name if Path(reference).is_dir() else reference
        written = RestyledSet(folder, name, icons, manner)
        if written.remark:
            bar.say(written.remark)
        processes: Processes = Here(session.workers)
        if scheduler is not None:
            processes = closed_at_last.enter_context(Cluster(scheduler))
        else:
            get_ready(session.workers, session.workers.count)
        events = sets.restyle_set(icons, manner, processes, written.is_done)
        try:
            with closing(events):
                for event in events:
                    if isinstance(event, Progress):
                        stopwatch.note(event)
                        bar.show(event.done, event.message, event.remaining)
                    else:
                        written.add(event)
        finally:
            written.save()
        for done in written.finish() if written else ():
            bar.show(done, "Drawing the contact sheet")
    named = f"; {MANIFEST} names all" if written else ""
    _tell("Skipped ", written.skipped, named)
    _tell("", written.remarks, named)
    if written.shrunk:
        pages = "its page" if len(written.shrunk) == 1 else "their pages"
        subject = f"{counted(len(written.shrunk), 'icon')} had no room on {pages}, and came out"
        tell(f"{subject} smaller, by {1 - min(written.shrunk):.1%} at most{named}.")
    if not written:
        raise IconstudioError("No icon of the set could be restyled.")
    without = f", {len(written.skipped):,} skipped" if written.skipped else ""
    made = counted(len(written), "icon")
    click.echo(f"{made}{without}; see {click.format_filename(folder / 'sheet.png')}")


def _check_apart(folder: Path, source: Path) -> None:
    """Refuse to write into a folder that is read: its drawings might be replaced."""
    if folder.resolve().is_relative_to(source.resolve()):
        raise IconstudioError(
            f"“{folder}” lies in the folder whose icons are restyled. Choose one outside of it."
        )


def _tell(beginning: str, sentences: Mapping[str, str], named: str) -> None:
    """Say what is to be known of icons, a line each; of very many, where they are ``named``."""
    for identifier, sentence in sorted(sentences.items())[:_TOLD]:
        click.echo(" ".join(f"{beginning}{identifier}: {sentence}".split()), err=True)
    if (more := len(sentences) - _TOLD) > 0:
        click.echo(f"So of {more} more icons{named}.", err=True)
