"""Icons traced in the background, so that a canvas can draw them crisp at any size."""

from collections.abc import Generator

from PySide6.QtCore import QObject, Signal
from PySide6.QtGui import QPainterPath

from iconstudio.gui.jobs.worker import Worker
from iconstudio.gui.pictures.vector import painter_path
from iconstudio.model import Exemplar, IconstudioError
from iconstudio.session import Session


class IconOutlines(QObject):
    """The outlines of icons, in canvas units; each is traced once.

    Signals
    -------
    changed()
        There is one more.
    """

    changed = Signal()

    def __init__(self, session: Session, worker: Worker, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._session = session
        self._worker = worker
        self._paths: dict[str, QPainterPath | None] = {}

    def outline(self, icon: Exemplar) -> QPainterPath | None:
        """Return the outline of an icon; None as long as it is not traced, which begins now."""
        if icon.pictogram.svg not in self._paths:
            self._paths[icon.pictogram.svg] = None
            self._worker.submit(lambda: self._trace(icon)).event.connect(self._keep)
        return self._paths[icon.pictogram.svg]

    def _trace(self, icon: Exemplar) -> Generator[tuple[str, QPainterPath]]:
        try:
            yield icon.pictogram.svg, painter_path(self._session.drawing(icon).path)
        except IconstudioError:
            return  # it stays drawn of pixels

    def _keep(self, traced: tuple[str, QPainterPath]) -> None:
        svg, path = traced
        self._paths[svg] = path
        self.changed.emit()
