"""What editing declares."""

from collections.abc import Generator
from typing import Any

from iconstudio.inputs.fields import Fields
from iconstudio.model import Edit
from iconstudio.workflows.editing.file import EditFile, edit_data, edit_in
from iconstudio.workflows.events import Event
from iconstudio.workflows.workflow import Refer, Resources, Workflow, lazily


def _read(fields: Fields, resources: Resources) -> Generator[Event, None, Edit | None]:
    yield from ()
    return edit_in(fields).resolved(resources.icon)


def _write(edit: Edit | None, refer: Refer) -> dict[str, Any]:
    return {} if edit is None else edit_data(EditFile.of(edit, refer))


EDITING: Workflow[Edit | None] = Workflow(
    name="edit",
    title="Edit",
    noun="edit",
    help="Change one part of an icon, and keep the rest.",
    invitation="Edit this icon",
    work=lambda: None,
    read=_read,
    write=_write,
    keys=frozenset({"icon", "remove", "add"}),
    run=lazily("iconstudio.workflows.editing.editing:run"),
    take=lambda _, icon: Edit(icon, icon.credit.title),
    examples="edits",
    command="iconstudio.cli.edit:command",
    workspace="iconstudio.gui.workspaces.editing.workspace:EditWorkspace",
)
