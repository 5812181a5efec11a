"""What ``iconstudio restyle`` and ``iconstudio scribble`` share: the options of line styles."""

from collections.abc import Callable
from concurrent.futures import wait
from pathlib import Path
from typing import Any

import click

from iconstudio.cli import running
from iconstudio.cli.rows import row
from iconstudio.files import check_writable
from iconstudio.inputs.styles import bundled, named
from iconstudio.model import IconstudioError, LineStyle
from iconstudio.reading import is_path
from iconstudio.workers import Workers
from iconstudio.workflows.line_style.learning import style_in
from iconstudio.workflows.line_style.restyling import (
    LARGEST,
    LARGEST_SEED,
    SMALLEST,
    STRONGEST,
    WEAKEST,
    warm_up,
)
from iconstudio.workflows.workflow import Resources

_SOON = 4.0
"""Seconds that nobody minds to wait without a word."""


class Between(click.ParamType):  # type: ignore[type-arg]  # generic only since Click 8.5
    """A number within bounds, a whole one if ``whole``; click's own takes NaN for one."""

    name = "number"

    def __init__(self, smallest: float, largest: float, whole: bool = False) -> None:
        self._bounds = smallest, largest
        self._read: type[int] | type[float] = int if whole else float
        self._kind = "whole number" if whole else "number"

    def convert(
        self, value: Any, param: click.Parameter | None, ctx: click.Context | None
    ) -> float:
        """Read a number."""
        smallest, largest = self._bounds
        try:
            number = self._read(value)
        except ValueError:
            self.fail(f"{value!r} is no {self._kind}", param, ctx)
        if not smallest <= number <= largest:
            self.fail(f"give a {self._kind} from {smallest:.16g} to {largest:.16g}", param, ctx)
        return number


def style_option(function: Callable[..., Any]) -> Callable[..., Any]:
    """Add the option ``--style``, which gives a reference or None, and ``--list-styles``."""
    function = click.option(
        "--list-styles",
        is_flag=True,
        is_eager=True,
        expose_value=False,
        callback=_list,
        help="List the styles that come with the program.",
    )(function)
    return click.option(
        "--style",
        metavar="NAME|FILE",
        help="A style that comes with the program, or a file: a style (JSON), or an SVG whose lines"
        " are the example.",
    )(function)


def seed_option(function: Callable[..., Any]) -> Callable[..., Any]:
    """Add the option ``--seed``, None if it is not given."""
    return click.option(
        "--seed",
        type=Between(0, LARGEST_SEED, whole=True),
        metavar="N",
        help="The same seed gives the same lines. Default: 0.",
    )(function)


strength_option = click.option(
    "--strength",
    type=Between(WEAKEST, STRONGEST),
    metavar="S",
    help="How far lines go from the plain ones, over what the style's example does. Default: 1.",
)
size_option = click.option(
    "--size",
    type=Between(SMALLEST, LARGEST),
    metavar="S",
    help="How large the texture is, over that of the example. Default: 1.",
)


def style_of(reference: str, resources: Resources) -> LineStyle:
    """Return a style by its name, or from a file: JSON, or a drawing.

    Raises
    ------
    IconstudioError
        If there is none.
    """
    if is_path(reference):
        return style_in(resources, reference, running.tell)
    return named(reference)


def need_style(reference: str | None) -> str:
    """Return the reference of a style that was given.

    Raises
    ------
    IconstudioError
        If none was.
    """
    if reference is None:
        raise IconstudioError(
            "Which style? Say --style NAME, or --style FILE (JSON or SVG); iconstudio restyle "
            "--list-styles lists those that come with the program."
        )
    return reference


def get_ready(workers: Workers, count: int) -> None:
    """Have the first so many worker processes ready to restyle.

    The very first time they compile what restyles, for half a minute: so it is said.
    """
    tasks = [workers.submit(warm_up, lane=lane) for lane in range(count)]
    if wait(tasks, _SOON).not_done:
        running.tell("Preparing, which takes longer the first time…")
        wait(tasks)


def svg_name(name: str, *read: str | None) -> Path:
    """Return the path of an SVG that is to be written, and is none of those that are ``read``.

    Raises
    ------
    IconstudioError
        If its name does not end in .svg, or it cannot be written, or is read.
    """
    path = Path(name)
    if path.suffix.lower() != ".svg":
        raise IconstudioError(
            f"The icon is written as SVG, and “{path.name}” does not say so. "
            f"Call it “{path.stem or 'icon'}.svg”."
        )
    check_writable(path, read)
    return path


def _list(ctx: click.Context, _: click.Parameter, wanted: bool) -> None:
    if wanted:
        for style in bundled():
            click.echo(row(style.name, style.author, style.license))
        ctx.exit()
