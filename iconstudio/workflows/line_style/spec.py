"""What line styles declare."""

from dataclasses import replace

from iconstudio.model import Pictogram, Restyling
from iconstudio.workflows.line_style.file import RestyleFile
from iconstudio.workflows.workflow import Workflow, lazily


def _icons(work: Restyling) -> tuple[Pictogram, ...]:
    return () if work.icon is None else (work.icon,)


def _with_icons(work: Restyling, icons: tuple[Pictogram, ...]) -> Restyling:
    return replace(work, icon=icons[-1] if icons else None, others=())


LINE_STYLE = Workflow(
    name="restyle",
    title="Line style",
    noun="restyling",
    help="Draw the lines of icons by example.",
    invitation="Restyle its lines",
    file=RestyleFile,
    run=lazily("iconstudio.workflows.line_style.restyling:run"),
    command="iconstudio.cli.restyle:command",
    work=Restyling,
    icons=_icons,
    with_icons=_with_icons,
)
