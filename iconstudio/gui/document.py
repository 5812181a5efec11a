"""The document: what lies on the canvas now, and how it came there."""

from dataclasses import dataclass, field, replace

from PySide6.QtCore import QObject, QRectF, Signal
from PySide6.QtGui import QUndoStack

from iconstudio.gui.photo import Photo
from iconstudio.model import CANVAS, Point, Polygon, Sketch


@dataclass(frozen=True, slots=True)
class Page:
    """Everything that an edit can change, as one immutable value.

    ``sketch.polygon`` also holds an outline that is still being traced; it is finished once
    ``closed``. Coordinates are pixels of the photo, or free units without one.
    """

    sketch: Sketch = field(default_factory=Sketch)
    closed: bool = False
    photo: Photo | None = None

    @property
    def vertices(self) -> tuple[Point, ...]:
        """The outline's vertices, finished or not."""
        return self.sketch.polygon.vertices

    @property
    def empty(self) -> bool:
        """Whether there is nothing to look at yet."""
        return not self.vertices and self.photo is None

    def with_outline(self, vertices: tuple[Point, ...], closed: bool) -> "Page":
        """Return the page with another outline."""
        sketch = replace(self.sketch, polygon=Polygon(vertices))
        return replace(self, sketch=sketch, closed=closed)

    def bounds(self) -> QRectF:
        """Return the area to show: the photo, the outline with some air, or an empty canvas."""
        if self.photo is not None:
            return QRectF(0, 0, self.photo.width, self.photo.height)
        sheet = QRectF(0, 0, 2 * CANVAS, 2 * CANVAS)
        if len(self.vertices) < 3:
            return sheet
        left, top, right, bottom = self.sketch.polygon.bounds
        size = max(right - left, bottom - top)
        outline = QRectF(left, top, right - left, bottom - top)
        if sheet.contains(outline) and size > CANVAS / 2:
            return sheet
        air = size / 8
        return outline.adjusted(-air, -air, air, air)


class Document(QObject):
    """Holds the page; only commands on its undo stack change it.

    Signals
    -------
    page_changed(Page)
        After every edit, undo and redo.
    opened()
        When another photo or drawing has been put on the page, so that the view should fit it.
    """

    page_changed = Signal(object)
    opened = Signal()

    def __init__(self, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._page = Page()
        self.undo_stack = QUndoStack(self)

    @property
    def page(self) -> Page:
        """What lies on the canvas now."""
        return self._page

    @property
    def sketch(self) -> Sketch:
        """The sketch, finished or not."""
        return self._page.sketch

    def show(self, page: Page) -> None:
        """Put ``page`` on the canvas. For commands only: anything else could not be undone."""
        before, self._page = self._page, page
        if page == before:
            return
        self.page_changed.emit(page)
        elsewhere = len(page.vertices) > 2 and set(page.vertices).isdisjoint(before.vertices)
        if page.photo is not before.photo or (elsewhere and page.photo is None):
            self.opened.emit()
