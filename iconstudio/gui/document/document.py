"""The document: what lies on a canvas now, and how it came there."""

import itertools
from typing import Generic

from PySide6.QtCore import QObject, Signal
from PySide6.QtGui import QUndoStack

from iconstudio.gui.document.commands import Change
from iconstudio.workflows.pages import P

_gestures = itertools.count()


def new_gesture() -> int:
    """Return a mark for the changes of one gesture (one drag, say): they are undone together."""
    return next(_gestures)


class Document(QObject, Generic[P]):
    """Holds a page; only changes on its undo stack replace it, or another project.

    Signals
    -------
    page_changed(P)
        After every edit, undo and redo.
    opened()
        When something else has been put on the page, so that the view should fit it.
    """

    page_changed = Signal(object)
    opened = Signal()

    def __init__(self, page: P) -> None:
        super().__init__()
        self._page = page
        self.undo_stack = QUndoStack(self)

    @property
    def page(self) -> P:
        """What lies on the canvas now."""
        return self._page

    def change(self, text: str, after: P, gesture: object = None) -> None:
        """Replace the page, as one step that can be undone.

        ``text`` names the step in the menu. Neighbouring changes of the same ``gesture``, if it is
        not None, are one step.
        """
        self.undo_stack.push(Change(self, text, after, gesture))

    def load(self, page: P) -> None:
        """Begin with another page. What was done to the one before is no step on the way here."""
        self.undo_stack.clear()
        self.show(page)

    def show(self, page: P) -> None:
        """Put ``page`` on the canvas. For commands and ``load`` only: it cannot be undone."""
        before, self._page = self._page, page
        if page == before:
            return
        self.page_changed.emit(page)
        if page.elsewhere(before):
            self.opened.emit()
