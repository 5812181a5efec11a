"""What sketch-based modelling declares."""

from iconstudio.workflows.modelling.file import SketchFile
from iconstudio.workflows.workflow import Workflow, lazily

MODELLING = Workflow(
    name="model",
    title="Sketch",
    noun="sketch",
    help="Make icons in the shape of a sketch out of parts of real ones.",
    file=SketchFile,
    run=lazily("iconstudio.workflows.modelling.modelling:run"),
    examples="",
    command="iconstudio.cli.model:command",
    workspace="iconstudio.gui.workspaces.sketching.workspace:SketchWorkspace",
    page_format="iconstudio.workflows.modelling.page_format:SketchPages",
    inner_pictures="iconstudio.workflows.modelling.inner_pictures:inner_pictures",
)
