"""What montage declares."""

from collections.abc import Generator
from typing import Any

from iconstudio.inputs.fields import Fields
from iconstudio.model import Montage
from iconstudio.workflows.events import Event
from iconstudio.workflows.montage.file import MontageFile, montage_data, montage_in
from iconstudio.workflows.workflow import Refer, Resources, Workflow, lazily


def _read(fields: Fields, resources: Resources) -> Generator[Event, None, Montage]:
    yield from ()
    return montage_in(fields).resolved(resources.icon)


def _write(montage: Montage, refer: Refer) -> dict[str, Any]:
    return montage_data(MontageFile.of(montage, refer))


MONTAGE = Workflow(
    name="montage",
    title="Montage",
    noun="montage",
    help="Join the parts of icons that are scribbled over.",
    invitation="Add to montage",
    read=_read,
    write=_write,
    keys=frozenset({"layers"}),
    run=lazily("iconstudio.workflows.montage.montage:run"),
    examples="montages",
    command="iconstudio.cli.montage:command",
    workspace="iconstudio.gui.workspaces.montage.workspace:MontageWorkspace",
    page_format="iconstudio.workflows.montage.page_format:MontagePages",
)
