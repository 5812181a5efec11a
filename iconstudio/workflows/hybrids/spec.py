"""What hybrids declare."""

from collections.abc import Generator
from typing import Any

from iconstudio.inputs.fields import Fields
from iconstudio.model import Mix
from iconstudio.workflows.events import Event
from iconstudio.workflows.hybrids.file import HybridsFile, hybrids_data, hybrids_in
from iconstudio.workflows.workflow import Refer, Resources, Workflow, lazily


def _read(fields: Fields, resources: Resources) -> Generator[Event, None, Mix]:
    file = hybrids_in(fields)
    if not file.keyword:
        return file.resolved(resources.icon)
    from iconstudio.workflows.hybrids.selection import select

    return file.mix(
        (yield from select(resources, file.keyword, file.count, file.symmetry, file.seed))
    )


def _write(mix: Mix, refer: Refer) -> dict[str, Any]:
    return hybrids_data(HybridsFile.of(mix, refer))


HYBRIDS = Workflow(
    name="hybrids",
    title="Hybrids",
    noun="mix",
    help="Mix icons at random, and rank what comes of it.",
    invitation="Mix with others",
    read=_read,
    write=_write,
    keys=frozenset({"icons", "draws", "seed", "pins"}),
    run=lazily("iconstudio.workflows.hybrids.hybrids:run"),
    examples="hybrids",
    command="iconstudio.cli.hybrids:command",
    workspace="iconstudio.gui.workspaces.hybrids.workspace:HybridsWorkspace",
    page_format="iconstudio.workflows.hybrids.page_format:HybridsPages",
)
