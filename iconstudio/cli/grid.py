"""What ``iconstudio model`` and ``iconstudio edit`` share: options, and the grid of results."""

from collections.abc import Callable, Generator
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any, TypeVar

import click

from iconstudio.algorithms.iconification.matching import SCALES
from iconstudio.algorithms.iconification.style import STYLES
from iconstudio.cli import running
from iconstudio.cli.lists import ListCommand, Numbers, Words, flat, is_number
from iconstudio.cli.timing import Stopwatch, profile_option
from iconstudio.model import Edit, IconstudioError, Sketch
from iconstudio.output.report import GridReport
from iconstudio.output.request import Request
from iconstudio.session import Session
from iconstudio.workflows.criteria import contradiction, with_known_icons
from iconstudio.workflows.events import Event
from iconstudio.workflows.grid import LAMBDAS, GridSettings

_Work = TypeVar("_Work", Sketch, Edit)
_STYLES = tuple(style.name for style in STYLES)
_MOST = 64
"""Values of an option: more would keep a computer busy for hours."""


@dataclass(frozen=True)
class GridOptions:
    """What the command line asks of a grid: one field an option."""

    file: Path
    folder: Path
    keyword: str | None
    exclude: tuple[str, ...]
    include: tuple[str, ...]
    styles: tuple[str, ...]
    lambdas: tuple[float, ...]
    scales: tuple[float, ...]
    dump: bool
    fine: bool
    profile: bool
    tidy: bool = True
    variants: bool = True

    def of(self, request: _Work, session: Session) -> _Work:
        """Return the request in the file, as the options change it.

        Raises
        ------
        IconstudioError
            If an option names an icon that the collection does not have.
        """
        request, remarks = with_known_icons(request, session.collection.get)
        for remark in remarks:
            running.tell(f"In “{self.file.name}”: {remark}")
        wanted = replace(
            request,
            keyword=request.keyword if self.keyword is None else self.keyword,
            exclude=request.exclude | running.icons_of("--exclude", session, self.exclude),
            include=request.include | running.icons_of("--include", session, self.include),
        )
        if torn := contradiction(wanted):
            running.tell(torn)
        return wanted

    def settings(self, styles: tuple[str, ...]) -> GridSettings:
        """Return which results to make; ``styles`` are those made if none is named."""
        side = running.side_of(self.fine)
        return GridSettings(
            side=side,
            styles=self.styles or styles,
            lambdas=self.lambdas,
            scales=self.scales,
            variants=self.variants,
        )


_variants_option = click.option(
    "--no-variants",
    "variants",
    is_flag=True,
    flag_value=False,
    default=True,
    help="Keep every result as it was joined: no symmetric one and none that differs more takes"
    " its place.",
)


def grid_command(
    name: str, metavar: str, styles: str, tidies: bool = False
) -> Callable[[Callable[[GridOptions], None]], click.Command]:
    """Make a function a command with the options of a grid.

    Parameters
    ----------
    styles
        Which styles there are if none is named, for the help.
    tidies
        Whether what seams bring about is put right, and variants take places.
    """
    options: tuple[Callable[..., Any], ...] = (
        running.input_file(metavar),
        running.output_folder("grid.png"),
        click.option(
            "--keyword", metavar="K", help="What to look for; instead of the file's keyword."
        ),
        click.option(
            "--exclude", multiple=True, metavar="ID", help="Do not use this icon; may be repeated."
        ),
        click.option(
            "--include",
            multiple=True,
            metavar="ID",
            help="Use this icon though it is less alike; may be repeated.",
        ),
        click.option(
            "--styles",
            type=Words(),
            multiple=True,
            callback=_joined,
            help=f"Some of {', '.join(_STYLES)}. Default: {styles}.",
        ),
        click.option(
            "--lambdas",
            type=Numbers(1000),
            multiple=True,
            default=(LAMBDAS,),
            callback=_ascending,
            help="Values of lambda_S. Default: 8 from 0.03 (closer to the sketch) to 0.75"
            " (smoother).",
        ),
        click.option(
            "--scales",
            type=Numbers(3),
            multiple=True,
            default=(SCALES,),
            callback=_ascending,
            help="Scale factors to try. Default: 0.9,1,1.1; more daring: 0.8,0.9,1,1.1,1.25.",
        ),
        click.option(
            "--dump", is_flag=True, help="Write STYLE.npz too: all that a result can be checked by."
        ),
        running.fine_option,
        profile_option,
    )
    if tidies:
        options = (*options, running.tidy_option, _variants_option)
    goes_on = {"--styles": _STYLES.__contains__, "--lambdas": is_number, "--scales": is_number}

    def decorate(function: Callable[[GridOptions], None]) -> click.Command:
        def call(**options: Any) -> None:
            function(GridOptions(**options))

        for option in reversed(options):
            call = option(call)
        return click.command(name, cls=ListCommand, goes_on=goes_on, help=function.__doc__)(call)

    return decorate


def run(
    session: Session,
    events: Generator[Event],
    request: Request,
    settings: GridSettings,
    folder: Path,
    stopwatch: Stopwatch,
    *,
    dump: bool = False,
    tidy: bool = True,
) -> None:
    """Run a workflow that fills a grid, write everything into ``folder``, say what is there."""
    report = GridReport(folder, request, settings.lambdas, dump=dump)
    results = running.run(session, events, report, stopwatch, tidy)
    if not results:
        raise IconstudioError(
            f"No style has enough icons of “{request.keyword}”. Try a more common word; "
            f"iconstudio search {request.keyword!r} shows what there is."
        )
    running.tell_results(results, "icon", folder / "grid.png")


def need_keyword(keyword: str) -> None:
    """Refuse an empty keyword."""
    if not keyword.strip():
        raise IconstudioError(
            'There is no keyword. Say what it shows: --keyword dog, or "keyword" in the file.'
        )


def _joined(
    ctx: click.Context, param: click.Parameter, values: tuple[tuple[str, ...], ...]
) -> tuple[str, ...]:
    return flat(values)


def _ascending(
    ctx: click.Context, param: click.Parameter, values: tuple[tuple[float, ...], ...]
) -> tuple[float, ...]:
    numbers = tuple(sorted({*flat(values)}))
    if len(numbers) > _MOST:
        raise click.BadParameter(f"give at most {_MOST} numbers, not {len(numbers)}", ctx, param)
    return numbers
