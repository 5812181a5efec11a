"""What editing declares."""

from collections.abc import Generator
from typing import Any

from iconstudio.inputs.fields import Fields
from iconstudio.model import Edit
from iconstudio.workflows.editing.file import EditFile, edit_data, edit_in
from iconstudio.workflows.events import Event
from iconstudio.workflows.workflow import Refer, Resources, Workflow, lazily


def _read(fields: Fields, resources: Resources) -> Generator[Event, None, Edit]:
    yield from ()
    return edit_in(fields).resolved(resources.icon)


def _write(edit: Edit, refer: Refer) -> dict[str, Any]:
    return edit_data(EditFile.of(edit, refer))


EDITING = Workflow(
    name="edit",
    title="Edit",
    noun="edit",
    help="Change one part of an icon, and keep the rest.",
    invitation="Edit this icon",
    read=_read,
    write=_write,
    keys=frozenset({"icon", "remove", "add"}),
    run=lazily("iconstudio.workflows.editing.editing:run"),
    examples="edits",
    command="iconstudio.cli.edit:command",
    workspace="iconstudio.gui.workspaces.editing.workspace:EditWorkspace",
    page_format="iconstudio.workflows.editing.page_format:EditPages",
)
