"""The files of the user's work: read and written as their workflows declare."""

from collections.abc import Callable, Generator, Iterable
from pathlib import Path
from typing import Any, TypeVar

from msgspec.structs import replace

from iconstudio.inputs import json
from iconstudio.inputs.formats import Reference
from iconstudio.inputs.icons import reference_to
from iconstudio.inputs.mistakes import likely
from iconstudio.model import IconstudioError
from iconstudio.workflows.events import Event
from iconstudio.workflows.workflow import File, Resources, Workflow

F = TypeVar("F", bound=File[Any])
W = TypeVar("W")


def open_file(path: Path, kind: type[F]) -> F:
    """Return what a file says that is of this kind.

    Raises
    ------
    IconstudioError
        If it cannot be read, or is of another workflow.
    """
    from iconstudio.workflows.registry import workflows

    data = json.load(path)
    if name := _unknown_workflow(data, workflows()):
        raise IconstudioError(
            f"“{path.name}” is a file of “{name:.60}”, which this version does not know. "
            + _what_is_known(name, workflows())
        )
    if isinstance(data, dict) and "pairs" in data:
        raise IconstudioError(
            f"“{path.name}” is a line style. Open it by “Open line style” in Line style, "
            f"or use it with iconstudio restyle ICON --style {path.name}."
        )
    likely = likely_workflow(data, workflows())
    if likely is not None and likely.file is not kind:
        wanted = next(one for one in workflows() if one.file is kind)
        raise IconstudioError(
            f"In “{path.name}”: this is no {wanted.noun}, but looks like {_one(likely.noun)}. "
            f"Open it in {likely.title}, or with iconstudio {likely.name}."
        )
    return json.converted(data, kind, path)


def likely_workflow(data: object, some: Iterable[Workflow[Any]]) -> Workflow[Any] | None:
    """Return the workflow that a file names; without a name, the one that its fields tell.

    None if there is no such workflow, or its fields may be of several.
    """
    some = tuple(some)
    if (name := _named_workflow(data)) is not None:
        return next((one for one in some if one.name == name), None)
    keys = set(data) if isinstance(data, dict) else set()
    known = {one: len(keys.intersection(one.file.__struct_encode_fields__)) for one in some}
    most = max(known.values(), default=0)
    best = [one for one, count in known.items() if count == most > 0]
    return best[0] if len({one.file for one in best}) == 1 else None


def _named_workflow(data: object) -> str | None:
    """Return the name of the workflow that a file says it is of; older ones say nothing."""
    name = data.get("workflow") if isinstance(data, dict) else None
    return name if isinstance(name, str) else None


def _unknown_workflow(data: object, some: Iterable[Workflow[Any]]) -> str | None:
    """Return what a file says it is of if there is no such workflow."""
    name = _named_workflow(data)
    return None if any(one.name == name for one in some) else name


def _what_is_known(name: str, some: Iterable[Workflow[Any]]) -> str:
    """Return what to do about the name of an unknown workflow: write it right, or update."""
    called = {word.casefold(): one.name for one in some for word in (one.noun, one.title, one.name)}
    if near := likely(name, tuple(called)):
        return f'Write "workflow": "{called[near]}" if you mean that.'
    known = ", ".join(sorted({*called.values()}))
    return f"Open it with the version that wrote it, or a newer one; this one knows {known}."


def read_file(
    path: Path,
    workflow: Workflow[W],
    resources: Resources,
    tell: Callable[[str], object] = lambda sentence: None,
) -> Generator[Event, None, W]:
    """Return the work in a file; yield progress. ``tell`` is called with what a user should know.

    Raises
    ------
    IconstudioError
        If it cannot be read, or is of another workflow.
    """
    file = open_file(path, workflow.file)
    for remark in file.remarks:
        tell(f"In “{path.name}”: {remark}")
    return (yield from file.resolving(resources))


def write_file(path: Path, workflow: Workflow[W], work: W, **more: Any) -> None:
    """Write the file of some work, with ``more`` fields that it may have.

    Icons that no collection has go into SVG files beside it.

    Raises
    ------
    IconstudioError
        If a file cannot be written.
    """
    file = workflow.file.of(work, lambda icon: Reference(reference_to(icon, path)))
    json.write(path, replace(file, workflow=workflow.name, **more))


def _one(noun: str) -> str:
    return f"{'an' if noun[0] in 'aeiou' else 'a'} {noun}"
