"""What montage declares."""

from iconstudio.workflows.montage.file import MontageFile
from iconstudio.workflows.workflow import Workflow, lazily

MONTAGE = Workflow(
    name="montage",
    title="Montage",
    noun="montage",
    help="Join the parts of icons that are scribbled over.",
    invitation="Add to montage",
    opens_results=True,
    file=MontageFile,
    run=lazily("iconstudio.workflows.montage.montage:run"),
    examples="montages",
    command="iconstudio.cli.montage:command",
    workspace="iconstudio.gui.workspaces.montage.workspace:MontageWorkspace",
    page_format="iconstudio.workflows.montage.page_format:MontagePages",
    inner_pictures="iconstudio.workflows.montage.inner_pictures:inner_pictures",
)
