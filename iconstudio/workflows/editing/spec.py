"""What editing declares."""

from iconstudio.workflows.editing.file import EditFile
from iconstudio.workflows.workflow import Workflow, lazily

EDITING = Workflow(
    name="edit",
    title="Edit",
    noun="edit",
    help="Change one part of an icon, and keep the rest.",
    invitation="Edit this icon",
    file=EditFile,
    run=lazily("iconstudio.workflows.editing.editing:run"),
    examples="edits",
    command="iconstudio.cli.edit:command",
    workspace="iconstudio.gui.workspaces.editing.workspace:EditWorkspace",
    page_format="iconstudio.workflows.editing.page_format:EditPages",
    inner_pictures="iconstudio.workflows.editing.inner_pictures:inner_pictures",
)
