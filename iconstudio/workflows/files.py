"""The files of the user's work: read and written as their workflows declare."""

from collections.abc import Generator
from pathlib import Path
from typing import Any, TypeVar

from iconstudio.inputs.fields import Fields, read, relative, write
from iconstudio.inputs.icons import reference_to
from iconstudio.workflows.events import Event
from iconstudio.workflows.workflow import Resources, Workflow

W = TypeVar("W")


def open_file(path: Path, name: str) -> Fields:
    """Return the fields of a file with work of the workflow of that name.

    Raises
    ------
    IconstudioError
        If it cannot be read, or is plainly of another workflow.
    """
    from iconstudio.workflows.registry import workflow_of, workflows

    fields, wanted = read(path), workflow_of(name)
    if not wanted.keys & fields.keys:
        for other in workflows():
            if other.keys & fields.keys:
                raise fields.mistake(
                    f"this is no {wanted.noun}, but looks like a {other.noun}. Open it in "
                    f"{other.title}, or with iconstudio {other.name}."
                )
    return fields


def read_file(path: Path, workflow: Workflow[W], resources: Resources) -> Generator[Event, None, W]:
    """Return the work in a file; yield progress.

    Raises
    ------
    IconstudioError
        If it cannot be read, or is plainly of another workflow.
    """
    return (yield from workflow.read(open_file(path, workflow.name), resources))


def write_file(path: Path, workflow: Workflow[W], work: W, **more: Any) -> None:
    """Write the file of some work, with ``more`` fields that it may have.

    Icons that no collection has go into SVG files beside it.

    Raises
    ------
    IconstudioError
        If a file cannot be written.
    """
    data = workflow.write(work, lambda icon: relative(reference_to(icon, path), path))
    write(path, data | more)
