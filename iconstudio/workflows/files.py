"""The files of the user's work: which workflow one is of."""

from pathlib import Path

from iconstudio.inputs.fields import Fields, read


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
