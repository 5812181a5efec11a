"""Move the page under the pointer."""

from collections.abc import Callable

from PySide6.QtCore import QPointF, Qt

from iconstudio.gui.canvas.tools.base import Pointer, Tool


class PanTool(Tool):
    """Drag the page. ``pan`` takes the shift in view pixels."""

    def __init__(self, pan: Callable[[QPointF], None]) -> None:
        self._pan = pan
        self._last: QPointF | None = None

    @property
    def cursor(self) -> Qt.CursorShape:
        """A hand, closed while it holds the page."""
        held = self._last is not None
        return Qt.CursorShape.ClosedHandCursor if held else Qt.CursorShape.OpenHandCursor

    @property
    def hint(self) -> str:
        """What can be done now."""
        return "Drag to move the page. The wheel zooms."

    def press(self, pointer: Pointer) -> None:
        """Take hold of the page."""
        self._last = pointer.view

    def move(self, pointer: Pointer) -> None:
        """Take the page along."""
        if self._last is not None:
            self._pan(pointer.view - self._last)
            self._last = pointer.view

    def release(self, pointer: Pointer) -> None:
        """Let go."""
        self._last = None

    def cancel(self) -> bool:
        """Let go."""
        held, self._last = self._last is not None, None
        return held
