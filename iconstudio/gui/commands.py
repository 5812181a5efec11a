"""Every edit of the page as a command that can be undone.

A command keeps the page before and after it: pages are immutable and share their parts,
so this costs a few pointers, and undo gives back exactly what was there.
"""

import weakref
from dataclasses import replace

from PySide6.QtGui import QUndoCommand

from iconstudio.gui.document import Document, Page
from iconstudio.gui.photo import Photo
from iconstudio.model import Point, Sketch


class PageCommand(QUndoCommand):
    """Replace the document's page by ``after``."""

    def __init__(self, document: Document, text: str, after: Page) -> None:
        super().__init__(text)
        # The document owns its stack, and that its commands: a way back would be a cycle, and
        # PySide may crash when Python's collector takes such a cycle apart.
        self._document = weakref.ref(document)
        self._before = document.page
        self.after = after

    def redo(self) -> None:
        """Do the edit."""
        self._show(self.after)

    def undo(self) -> None:
        """Give back the page from before the edit."""
        self._show(self._before)

    def _show(self, page: Page) -> None:
        document = self._document()
        if document is not None:
            document.show(page)


class AddVertex(PageCommand):
    """Append a vertex to the open outline."""

    def __init__(self, document: Document, point: Point) -> None:
        page = document.page
        super().__init__(document, "add point", page.with_outline((*page.vertices, point), False))


class InsertVertex(PageCommand):
    """Put a vertex on the edge that starts at vertex ``index``."""

    def __init__(self, document: Document, index: int, point: Point) -> None:
        page = document.page
        vertices = (*page.vertices[: index + 1], point, *page.vertices[index + 1 :])
        super().__init__(document, "insert point", page.with_outline(vertices, page.closed))


class MoveVertex(PageCommand):
    """Move vertex ``index``. Moves of one ``gesture`` (one drag, say) are undone together."""

    def __init__(self, document: Document, index: int, point: Point, gesture: int) -> None:
        page = document.page
        vertices = (*page.vertices[:index], point, *page.vertices[index + 1 :])
        super().__init__(document, "move point", page.with_outline(vertices, page.closed))
        self._gesture = gesture

    def id(self) -> int:
        """Allow merging with the other moves of vertices."""
        return 1

    def mergeWith(self, other: QUndoCommand) -> bool:
        """Take over the end of ``other`` if it belongs to the same gesture."""
        if not isinstance(other, MoveVertex) or other._gesture != self._gesture:
            return False
        self.after = other.after
        return True


class DeleteVertex(PageCommand):
    """Remove vertex ``index``; with fewer than three left, the outline is open again."""

    def __init__(self, document: Document, index: int) -> None:
        page = document.page
        vertices = page.vertices[:index] + page.vertices[index + 1 :]
        closed = page.closed and len(vertices) >= 3
        super().__init__(document, "delete point", page.with_outline(vertices, closed))


class CloseOutline(PageCommand):
    """Join the last vertex to the first."""

    def __init__(self, document: Document) -> None:
        page = document.page
        super().__init__(document, "close outline", page.with_outline(page.vertices, True))


class ClearOutline(PageCommand):
    """Remove all vertices; the photo and the keyword stay."""

    def __init__(self, document: Document) -> None:
        super().__init__(document, "clear outline", document.page.with_outline((), False))


class SetKeyword(PageCommand):
    """Name the object. Letters typed one after the other are undone together."""

    def __init__(self, document: Document, keyword: str) -> None:
        sketch = replace(document.sketch, keyword=keyword)
        super().__init__(document, "name the object", replace(document.page, sketch=sketch))

    def id(self) -> int:
        """Allow merging with the letters typed next."""
        return 2

    def mergeWith(self, other: QUndoCommand) -> bool:
        """Take over the letters typed next."""
        if not isinstance(other, SetKeyword):
            return False
        self.after = other.after
        return True


class ExcludeIcons(PageCommand):
    """Say which icons must not be used."""

    def __init__(self, document: Document, exclude: frozenset[str]) -> None:
        fewer = exclude < document.sketch.exclude
        text = "use icon again" if fewer else "leave icon out"
        sketch = replace(document.sketch, exclude=exclude)
        super().__init__(document, text, replace(document.page, sketch=sketch))


class SetPhoto(PageCommand):
    """Put another photo under the drawing, or none.

    An outline traced over something else would lie nowhere sensible, so it goes; undo
    brings it back.
    """

    def __init__(self, document: Document, photo: Photo | None) -> None:
        page = document.page.with_outline((), False)
        super().__init__(document, "set photo", replace(page, photo=photo))


class LoadSketch(PageCommand):
    """Start from another sketch: an example, a file, or nothing at all."""

    def __init__(
        self, document: Document, sketch: Sketch, photo: Photo | None = None, text: str = "open"
    ) -> None:
        closed = len(sketch.polygon.vertices) >= 3
        super().__init__(document, text, Page(sketch, closed, photo))
