"""Line styles learned from files: JSON, or the lines of a drawing."""

from collections.abc import Callable
from pathlib import Path

from iconstudio.inputs.line_style import read_style, style_of_lines
from iconstudio.model import LineStyle
from iconstudio.workflows.workflow import Resources


def is_written(reference: str) -> bool:
    """Whether a file holds a style in JSON, not a drawing to learn one from."""
    return Path(reference).suffix.lower() == ".json"


def style_in(
    resources: Resources, reference: str, tell: Callable[[str], None] = lambda sentence: None
) -> LineStyle:
    """Return the style in a file: JSON, or an SVG (``FILE.svg#id``) whose lines are its example.

    ``tell`` is called with what a user should know of it.

    Raises
    ------
    IconstudioError
        If it cannot be read, or nothing can be learned from it.
    """
    if is_written(reference):
        return read_style(Path(reference), tell)
    icon = resources.icon(reference)
    for remark in icon.remarks:
        tell(f"In “{Path(reference).name}”: {remark}")
    return style_of_lines(resources.lines(icon), Path(reference).stem)
