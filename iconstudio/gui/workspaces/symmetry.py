"""Finds out whether what is wanted is nearly symmetric."""

from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray
from PySide6.QtCore import QObject, QTimer, Signal

from iconstudio.model import Axis, IconstudioError
from iconstudio.workflows.criteria import CriteriaDocument, CriteriaPage

PAUSE = 250
"""Milliseconds without an edit after which the outline is looked at."""


class SymmetryDetection(QObject):
    """Looks at the outline that is wanted when the user pauses.

    Parameters
    ----------
    outline
        Returns what a page says of the outline, to be compared; None if it is not finished.
    filled
        Returns that outline filled, (n, n) bool; may raise IconstudioError if it is no good.

    Signals
    -------
    found(object)
        The Axis to offer, or None.
    """

    found = Signal(object)

    def __init__(
        self,
        document: CriteriaDocument,
        outline: Callable[[CriteriaPage], object],
        filled: Callable[[object], NDArray[np.bool_]],
        parent: QObject | None = None,
    ) -> None:
        super().__init__(parent)
        self._document = document
        self._outline_of = outline
        self._filled = filled
        self._outline: object = None
        self._axis: Axis | None = None
        self._timer = QTimer(self, singleShot=True, interval=PAUSE)
        self._timer.timeout.connect(self._look)
        document.page_changed.connect(self._page_changed)

    def _page_changed(self, page: CriteriaPage) -> None:
        outline = self._outline_of(page)
        if outline is None or page.criteria.symmetry is not None:
            self._timer.stop()
            self.found.emit(None)
        elif outline == self._outline:
            self.found.emit(self._axis)
        else:
            self.found.emit(None)
            self._timer.start()

    def _look(self) -> None:
        from iconstudio.algorithms.iconification.symmetry import propose

        self._outline = self._outline_of(self._document.page)
        try:
            self._axis = propose(self._filled(self._outline))
        except IconstudioError:
            self._axis = None
        self.found.emit(self._axis)
