"""What every tool offers to the canvas."""

from dataclasses import dataclass

from PySide6.QtCore import QPointF, Qt
from PySide6.QtGui import QKeyEvent, QPainter

from iconstudio.gui.canvas.camera import Camera
from iconstudio.gui.theme.theme import Theme
from iconstudio.model import Point

NUDGES = {
    Qt.Key.Key_Left: (-1, 0),
    Qt.Key.Key_Right: (1, 0),
    Qt.Key.Key_Up: (0, -1),
    Qt.Key.Key_Down: (0, 1),
}
"""Which way the arrow keys lead."""


def nudge(event: QKeyEvent) -> tuple[int, int] | None:
    """Return how far an arrow key moves something: ten times as far with Shift; None for others."""
    if event.key() not in NUDGES:
        return None
    far = 10 if event.modifiers() & Qt.KeyboardModifier.ShiftModifier else 1
    right, down = NUDGES[event.key()]
    return far * right, far * down


@dataclass(frozen=True, slots=True)
class Pointer:
    """The mouse or pen at one moment: where on the page, and where in the view."""

    page: Point
    view: QPointF
    camera: Camera
    button: Qt.MouseButton = Qt.MouseButton.NoButton
    modifiers: Qt.KeyboardModifier = Qt.KeyboardModifier.NoModifier
    pressure: float = 1.0
    """How hard the pen presses, from 0 to 1; of a mouse always 1."""
    eraser: bool = False
    """Whether the pen is turned round."""


class Tool:
    """A tool that does nothing; tools override what they need.

    A tool never paints the page itself, only its own feedback, and changes the document only by
    commands.
    """

    @property
    def cursor(self) -> Qt.CursorShape:
        """The shape of the mouse pointer now."""
        return Qt.CursorShape.ArrowCursor

    @property
    def hint(self) -> str:
        """One short sentence: what can be done now."""
        return ""

    def press(self, pointer: Pointer) -> None:
        """A button went down."""

    def move(self, pointer: Pointer) -> None:
        """The pointer moved, with or without a button."""

    def release(self, pointer: Pointer) -> None:
        """The button went up."""

    def double_click(self, pointer: Pointer) -> None:
        """The button went down a second time at the same place: that is a press like any other."""
        self.press(pointer)

    def leave(self) -> None:
        """The pointer left the canvas."""

    def key(self, event: QKeyEvent) -> bool:
        """Handle a key; return whether it meant anything to the tool."""
        return False

    def cancel(self) -> bool:
        """Give up what is under way; return whether there was anything."""
        return False

    def paint(self, painter: QPainter, camera: Camera, theme: Theme) -> None:
        """Draw the tool's feedback in view coordinates."""
