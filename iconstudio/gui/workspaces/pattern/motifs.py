"""Where the motifs of an exemplar lie, as Qt has them, and which one is pointed at."""

from collections.abc import Sequence

from PySide6.QtCore import QPointF, QRectF, Qt
from PySide6.QtGui import QPainterPath, QPolygonF, QTransform

from iconstudio.gui.canvas.outlines import IconOutlines
from iconstudio.model import CANVAS, MARGIN, Motif, Point

_INK = QRectF(MARGIN, MARGIN, CANVAS - 2 * MARGIN, CANVAS - 2 * MARGIN)
"""Where the ink of an icon lies on its own canvas, as long as its outline is not known."""


def transform_of(motif: Motif) -> QTransform:
    """Return the mapping from an icon's own canvas to that of the exemplar."""
    return QTransform(*motif.transform)


class MotifShapes:
    """The shapes of motifs, as far as their icons have been traced."""

    def __init__(self, outlines: IconOutlines) -> None:
        self._outlines = outlines

    def outline(self, motif: Motif) -> QPainterPath | None:
        """Return the outline of a motif's icon on its own canvas; None if it is not known yet."""
        return self._outlines.outline_of(motif.icon)

    def box(self, motif: Motif) -> QRectF:
        """Return where its ink lies on the icon's own canvas."""
        path = self.outline(motif)
        return _INK if path is None or path.isEmpty() else path.boundingRect()

    def frame(self, motif: Motif, margin: float = 0.0) -> QPolygonF:
        """Return the corners of what a motif covers, turned as it is, and a margin around it.

        From the upper left clockwise, on the exemplar's canvas.
        """
        more = margin * CANVAS / motif.size
        box = self.box(motif).adjusted(-more, -more, more, more)
        corners = box.topLeft(), box.topRight(), box.bottomRight(), box.bottomLeft()
        return QPolygonF([transform_of(motif).map(corner) for corner in corners])

    def found(self, motifs: Sequence[Motif], point: Point, reach: float) -> int | None:
        """Return the number of the motif at a point: the topmost with ink there, or around it."""
        spot = QPointF(*point)
        numbers = range(len(motifs) - 1, -1, -1)
        for number in numbers:
            path = self.outline(motifs[number])
            back, _ = transform_of(motifs[number]).inverted()
            if path is not None and path.contains(back.map(spot)):
                return number
        fill = Qt.FillRule.WindingFill
        frames = ((n, self.frame(motifs[n], reach)) for n in numbers)
        return next((n for n, frame in frames if frame.containsPoint(spot, fill)), None)

    def within(self, motifs: Sequence[Motif], box: QRectF) -> frozenset[int]:
        """Return the numbers of the motifs whose middles lie in a box."""
        return frozenset(
            number
            for number, one in enumerate(motifs)
            if box.contains(self.frame(one).boundingRect().center())
        )
