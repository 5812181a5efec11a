"""What hybrids declare."""

from iconstudio.workflows.hybrids.file import HybridsFile
from iconstudio.workflows.workflow import Workflow, lazily

HYBRIDS = Workflow(
    name="hybrids",
    title="Hybrids",
    noun="mix",
    help="Mix icons at random, and rank what comes of it.",
    invitation="Mix with others",
    file=HybridsFile,
    run=lazily("iconstudio.workflows.hybrids.hybrids:run"),
    examples="hybrids",
    command="iconstudio.cli.hybrids:command",
    workspace="iconstudio.gui.workspaces.hybrids.workspace:HybridsWorkspace",
    page_format="iconstudio.workflows.hybrids.page_format:HybridsPages",
    inner_pictures="iconstudio.workflows.hybrids.inner_pictures:inner_pictures",
)
