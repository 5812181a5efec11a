"""``iconstudio hybrids``: random mixtures of icons, without a window."""

from collections.abc import Generator
from pathlib import Path

import click
from msgspec.structs import replace

from iconstudio.cli import running
from iconstudio.cli.timing import profile_option, profiled
from iconstudio.model import IconstudioError
from iconstudio.output.hybrids import HybridsReport
from iconstudio.session import Session
from iconstudio.workflows.events import Event
from iconstudio.workflows.hybrids.file import LARGEST_SEED, HybridsFile, read_hybrids
from iconstudio.workflows.hybrids.hybrids import MOST_DRAWS
from iconstudio.workflows.hybrids.spec import HYBRIDS
from iconstudio.workflows.remixing import CutSettings


@click.command("hybrids")
@running.input_file("HYBRIDS.json")
@running.output_folder("sheet.png")
@click.option(
    "--draws",
    type=click.IntRange(1, MOST_DRAWS),
    metavar="N",
    help="How many to draw at random; those that repeat an icon or a hybrid are left out. Instead "
    "of the file's number, or of 40.",
)
@click.option(
    "--seed",
    type=click.IntRange(0, LARGEST_SEED),
    metavar="N",
    help="The same seed gives the same hybrids; instead of the file's.",
)
@running.fine_option
@running.tidy_option
@profile_option
def command(
    file: Path,
    folder: Path,
    draws: int | None,
    seed: int | None,
    fine: bool,
    tidy: bool,
    profile: bool,
) -> None:
    """Mix the icons in HYBRIDS.json at random, and rank what comes of it."""
    hybrids = read_hybrids(file)
    hybrids = replace(
        hybrids,
        draws=hybrids.draws if draws is None else draws,
        seed=hybrids.seed if seed is None else seed,
    )
    with profiled(profile) as stopwatch, Session() as session:
        events = _mixing(session, hybrids, running.side_of(fine))
        report = HybridsReport(folder, hybrids.word, hybrids.draws, hybrids.seed, hybrids.symmetry)
        results = running.run(session, events, report, stopwatch, tidy)
    if not results:
        raise IconstudioError(
            "All hybrids repeat the icons. Choose icons that differ more, or ask for more draws."
        )
    running.tell_results(results, "hybrid", folder / "sheet.png")
    if results < hybrids.draws:
        click.echo(_repeated(hybrids.draws, results))


def _repeated(draws: int, results: int) -> str:
    """Return why there are fewer results than draws."""
    number = "draw looks" if draws - results == 1 else f"{draws - results} draws look"
    more = "More draws may give more" if draws < MOST_DRAWS else "Another seed may give others"
    return f"The other {number} like one of the icons, or like another hybrid. {more}."


def _mixing(session: Session, hybrids: HybridsFile, side: int) -> Generator[Event]:
    """Find or pick the icons, then mix them."""
    mix = yield from hybrids.resolving(session)
    if hybrids.icons is not None:
        running.tell_remarks(mix.icons)
    yield from session.run(HYBRIDS, mix, CutSettings(side=side))
