"""The files of line styles that the user opened or saved, remembered from one time to the next."""

from collections.abc import Generator
from pathlib import Path

from iconstudio.gui.preferences import put_in_front, remembered
from iconstudio.inputs.line_style import read_style
from iconstudio.model import IconstudioError, LineStyle

_NAME = "line styles"
_MOST = 24


def note(path: Path) -> None:
    """Put a file in front; those that were used longest ago are forgotten."""
    put_in_front(_NAME, str(path.absolute()), _MOST)


def known_styles() -> Generator[LineStyle]:
    """Yield the styles of these files, the last used one last; those that are gone are left out."""
    for name in reversed(remembered(_NAME)):
        try:
            yield read_style(Path(name))
        except IconstudioError:
            continue
