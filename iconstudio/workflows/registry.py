"""All workflows, in the order of the switch: a new one is one more line."""

from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any

from iconstudio.workflows.editing.spec import EDITING
from iconstudio.workflows.hybrids.spec import HYBRIDS
from iconstudio.workflows.line_style.spec import LINE_STYLE
from iconstudio.workflows.modelling.spec import MODELLING
from iconstudio.workflows.montage.spec import MONTAGE
from iconstudio.workflows.pattern.spec import PATTERN
from iconstudio.workflows.workflow import Workflow

_workflows: tuple[Workflow[Any], ...] = (
    MODELLING,
    EDITING,
    HYBRIDS,
    MONTAGE,
    LINE_STYLE,
    PATTERN,
)


def workflows() -> tuple[Workflow[Any], ...]:
    """Return all workflows."""
    return _workflows


def taking_icons() -> str:
    """Return the titles of the workflows that icons can be sent to, as words in a sentence."""
    *others, last = (one.title for one in _workflows if one.invitation)
    return f"{', '.join(others)} or {last}"


@contextmanager
def registered(workflow: Workflow[Any]) -> Iterator[None]:
    """Have one more workflow for a while: for tests, and for trying one out."""
    global _workflows
    before = _workflows
    _workflows = (*before, workflow)
    try:
        yield
    finally:
        _workflows = before
