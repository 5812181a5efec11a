"""Samples of line styles, to choose from."""

from collections.abc import Generator

from iconstudio.model import Line, LineStyle, Path, Restyling
from iconstudio.workflows.events import Event, Result
from iconstudio.workflows.line_style.restyling import RestyleSettings
from iconstudio.workflows.line_style.spec import LINE_STYLE
from iconstudio.workflows.workflow import Resources

SAMPLE = (
    Line(
        ((28.0, 150.0), (128.0, 40.0), (228.0, 150.0)),
        width=8.0,
    ),
    Line(
        ((56.0, 122.0), (56.0, 226.0), (200.0, 226.0), (200.0, 122.0)),
        width=8.0,
    ),
)
"""What samples are drawn of: a house."""


def sampled(resources: Resources, style: LineStyle) -> Generator[Event, None, Path]:
    """Return what a style makes of a few lines, drawn coarsely; yield progress.

    Raises
    ------
    IconstudioError
        If it can make nothing of them.
    """
    path = Path()
    work = Restyling(style, strokes=SAMPLE)
    for event in LINE_STYLE.run(resources, work, RestyleSettings(coarse=True)):
        if isinstance(event, Result):
            path = event.icon.path
        else:
            yield event
    return path
