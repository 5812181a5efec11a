"""Icons traced in the background, so that a canvas can draw them crisp at any size."""

from collections.abc import Callable, Generator

from PySide6.QtCore import QObject, Signal
from PySide6.QtGui import QPainterPath

from iconstudio.gui.jobs.worker import Worker
from iconstudio.gui.pictures.vector import painter_path
from iconstudio.model import Exemplar, IconstudioError, Pictogram
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
        return self._outline(icon.pictogram.svg, lambda: icon)

    def outline_of(self, icon: Pictogram) -> QPainterPath | None:
        """Return the outline of an icon that need not be drawn yet; else as ``outline``."""
        return self._outline(icon.svg, lambda: self._session.exemplar(icon))

    def _outline(self, svg: str, exemplar: Callable[[], Exemplar]) -> QPainterPath | None:
        if svg not in self._paths:
            self._paths[svg] = None
            self._worker.submit(lambda: self._trace(svg, exemplar)).event.connect(self._keep)
        return self._paths[svg]

    def _trace(
        self, svg: str, exemplar: Callable[[], Exemplar]
    ) -> Generator[tuple[str, QPainterPath]]:
        try:
            yield svg, painter_path(self._session.drawing(exemplar()).path)
        except IconstudioError:
            return  # it stays drawn of pixels

    def _keep(self, traced: tuple[str, QPainterPath]) -> None:
        svg, path = traced
        self._paths[svg] = path
        self.changed.emit()
