"""Finds out whether a finished outline is nearly symmetric."""

from PySide6.QtCore import QObject, QTimer, Signal

from iconstudio.gui.workspaces.sketching.page import SketchDocument
from iconstudio.model import Axis, IconstudioError

PAUSE = 250
"""Milliseconds without an edit after which the outline is looked at."""


class SymmetryProposal(QObject):
    """Looks at the outline when the user pauses.

    Signals
    -------
    found(object)
        The Axis to offer, or None.
    """

    found = Signal(object)

    def __init__(self, document: SketchDocument, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._document = document
        self._outline = None
        self._axis: Axis | None = None
        self._timer = QTimer(self, singleShot=True, interval=PAUSE)
        self._timer.timeout.connect(self._look)
        document.page_changed.connect(self._page_changed)

    def _page_changed(self) -> None:
        page = self._document.page
        if not page.closed or page.sketch.symmetry is not None:
            self._timer.stop()
            self.found.emit(None)
        elif page.sketch.polygon == self._outline:
            self.found.emit(self._axis)
        else:
            self.found.emit(None)
            self._timer.start()

    def _look(self) -> None:
        from iconstudio.algorithms.raster import fill_polygon
        from iconstudio.algorithms.symmetry import propose

        self._outline = self._document.page.sketch.polygon
        try:
            self._axis = propose(fill_polygon(self._outline.fitted()))
        except IconstudioError:
            self._axis = None
        self.found.emit(self._axis)
