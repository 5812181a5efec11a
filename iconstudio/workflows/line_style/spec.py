"""What line styles declare."""

from dataclasses import replace

from iconstudio.model import Pictogram, Restyling
from iconstudio.workflows.line_style.file import RestyleFile
from iconstudio.workflows.workflow import Workflow, lazily


def _with_icon(work: Restyling, icon: Pictogram) -> Restyling:
    return replace(work, icon=icon, others=())


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
    take=_with_icon,
)
