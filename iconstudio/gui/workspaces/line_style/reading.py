"""Reads the lines of the icon on the page, as they are, so that they can be seen and selected."""

from dataclasses import dataclass

from PySide6.QtCore import QObject

from iconstudio.gui.jobs.runner import Runner
from iconstudio.gui.jobs.worker import Worker, once
from iconstudio.model import Line, Pictogram
from iconstudio.session import Session


@dataclass(frozen=True, slots=True, eq=False)
class IconLines:
    """The lines of an icon, as they are."""

    icon: Pictogram
    lines: tuple[Line, ...]


class LineReader(Runner):
    """Its event is the ``IconLines`` of the icon that was requested last."""

    def __init__(self, session: Session, worker: Worker, parent: QObject) -> None:
        super().__init__(worker, parent)
        self._session = session
        self._icon: Pictogram | None = None

    def request(self, icon: Pictogram | None) -> None:
        """Read the lines of an icon, if there is one and it is another."""
        if icon == self._icon:
            return
        self._icon = icon
        if icon is None:
            self.cancel()
        else:
            lines = self._session.lines
            self.start(lambda: once(lambda: IconLines(icon, lines(icon))))
