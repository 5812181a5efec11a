"""The one kind of step that can be undone: another page in place of the one before."""

import weakref
from typing import TYPE_CHECKING, Any

from PySide6.QtGui import QUndoCommand

if TYPE_CHECKING:
    from iconstudio.gui.document.document import Document


class Change(QUndoCommand):
    """Replace the document's page by ``after``; changes of one ``gesture`` are undone together.

    It keeps the pages before and after: pages are immutable and share their parts, so this costs
    a few pointers, and undo gives back exactly what was there.
    """

    def __init__(self, document: "Document", text: str, after: Any, gesture: object = None) -> None:
        super().__init__(text)
        # The document owns its stack, and that its commands: a way back would be a cycle, and
        # PySide may crash when Python's collector takes such a cycle apart.
        self._document = weakref.ref(document)
        self._before = document.page
        self._after = after
        self._gesture = gesture

    def redo(self) -> None:
        """Do the edit."""
        self._show(self._after)

    def undo(self) -> None:
        """Give back the page from before the edit."""
        self._show(self._before)

    def id(self) -> int:
        """Allow merging if this is part of a gesture."""
        return -1 if self._gesture is None else 1

    def mergeWith(self, other: QUndoCommand) -> bool:
        """Take over the end of ``other`` if it belongs to the same gesture."""
        if not isinstance(other, Change) or other._gesture != self._gesture:
            return False
        self._after = other._after
        return True

    def _show(self, page: Any) -> None:
        document = self._document()
        if document is not None:
            document.show(page)
