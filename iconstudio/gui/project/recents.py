"""The projects that were opened or saved last."""

from collections.abc import Callable
from pathlib import Path

from PySide6.QtWidgets import QMenu

from iconstudio.gui.preferences import put_in_front, remember, remembered

MOST = 10
_NAME = "recent projects"
_LONGEST = 60
"""Most characters of a folder that are shown."""


def recents() -> list[str]:
    """Return their paths, the last one first."""
    return remembered(_NAME)


def note(path: Path) -> None:
    """Put a project in front."""
    put_in_front(_NAME, str(path.absolute()), MOST)


def discard(path: Path) -> None:
    """Take a project out: it is gone."""
    remember(_NAME, [one for one in recents() if one != str(path)])


def fill(menu: QMenu, use: Callable[[Path], object]) -> None:
    """Fill a menu with them, anew."""
    menu.clear()
    for number, name in enumerate(recents(), start=1):
        path = Path(name)
        folder = str(path.parent).replace(str(Path.home()), "~", 1)
        if len(folder) > _LONGEST:
            folder = f"…{folder[1 - _LONGEST :]}"
        key = f"&{number}" if number < 10 else str(number)
        words = f"{key}  {path.stem} – {folder}".replace("&", "&&").replace("&&", "&", 1)
        menu.addAction(words, lambda path=path: use(path))
    if menu.isEmpty():
        menu.addAction("No projects yet").setEnabled(False)
    else:
        menu.addSeparator()
        menu.addAction("&Clear the list", lambda: remember(_NAME, []))
