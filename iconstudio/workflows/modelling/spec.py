"""What sketch-based modelling declares."""

from collections.abc import Generator
from typing import Any

from iconstudio.inputs.fields import Fields
from iconstudio.model import Sketch
from iconstudio.workflows.events import Event
from iconstudio.workflows.modelling.file import sketch_data, sketch_in
from iconstudio.workflows.workflow import Refer, Resources, Workflow, lazily


def _read(fields: Fields, resources: Resources) -> Generator[Event, None, Sketch]:
    yield from ()
    return sketch_in(fields).sketch


def _write(sketch: Sketch, refer: Refer) -> dict[str, Any]:
    return sketch_data(sketch)


MODELLING = Workflow(
    name="model",
    title="Sketch",
    noun="sketch",
    help="Make icons in the shape of a sketch out of parts of real ones.",
    read=_read,
    write=_write,
    keys=frozenset({"polygon"}),
    run=lazily("iconstudio.workflows.modelling.modelling:run"),
    examples="",
    command="iconstudio.cli.model:command",
    workspace="iconstudio.gui.workspaces.sketching.workspace:SketchWorkspace",
    page_format="iconstudio.workflows.modelling.page_format:SketchPages",
)
