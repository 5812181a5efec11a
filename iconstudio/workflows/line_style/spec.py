"""What line styles declare."""

from iconstudio.workflows.line_style.file import RestyleFile
from iconstudio.workflows.workflow import Workflow, lazily

LINE_STYLE = Workflow(
    name="restyle",
    title="Line style",
    noun="restyling",
    help="Draw the lines of icons by example.",
    invitation="Restyle its lines",
    file=RestyleFile,
    run=lazily("iconstudio.workflows.line_style.restyling:run"),
    command="iconstudio.cli.restyle:command",
    examples="restylings",
    workspace="iconstudio.gui.workspaces.line_style.workspace:LineStyleWorkspace",
    page_format="iconstudio.workflows.line_style.page_format:RestylePages",
)
