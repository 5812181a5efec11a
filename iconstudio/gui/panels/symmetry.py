"""Choose an axis of symmetry, and be offered one that nearly fits."""

from PySide6.QtCore import QSize, Qt, Signal
from PySide6.QtGui import QActionGroup
from PySide6.QtWidgets import QMenu, QPushButton, QToolButton, QWidget

from iconstudio.gui.theme import icons
from iconstudio.gui.theme.layout import OnGeometry, with_role
from iconstudio.gui.theme.theme import UNIT
from iconstudio.model import Axis

WORDS = {
    None: "No symmetry",
    Axis.HORIZONTAL: "Horizontal: left mirrors right",
    Axis.VERTICAL: "Vertical: top mirrors bottom",
    Axis.DIAGONAL: "Diagonal",
    Axis.ANTIDIAGONAL: "Antidiagonal",
}
"""The axes of section 3.4 in words."""


class SymmetryButton(QToolButton):
    """A button with a menu of axes; its icon shows the one that is chosen.

    Signals
    -------
    chosen(object)
        The Axis that the user chose, or None.
    """

    chosen = Signal(object)

    def __init__(self) -> None:
        super().__init__()
        menu = QMenu(self)
        group = QActionGroup(menu)
        self._actions = {}
        for axis, words in WORDS.items():
            action = menu.addAction(words)
            action.setCheckable(True)
            token = "text" if axis is None else "accent"
            action.setIcon(icons.icon(f"axis-{axis or 'none'}", token))
            action.triggered.connect(lambda _=False, axis=axis: self.chosen.emit(axis))
            group.addAction(action)
            self._actions[axis] = action
        self.setMenu(menu)
        self.setPopupMode(QToolButton.ToolButtonPopupMode.InstantPopup)
        self.setIconSize(QSize(20, 20))
        self.setFocusPolicy(Qt.FocusPolicy.TabFocus)
        self.set_axis(None)

    def set_axis(self, axis: Axis | None) -> None:
        """Show which axis is chosen."""
        self._actions[axis].setChecked(True)
        self.setIcon(self._actions[axis].icon())
        self.setToolTip(f"Symmetry of the results – {WORDS[axis].lower()}")
        self.setAccessibleName(f"Symmetry: {WORDS[axis].lower()}")


class SymmetryHint(QPushButton):
    """A small offer in the corner of a canvas to hold to a symmetry that is nearly there.

    Signals
    -------
    accepted(object)
        The user wants the Axis that was offered.
    """

    accepted = Signal(object)

    def __init__(self, canvas: QWidget) -> None:
        super().__init__("Nearly symmetric · Hold to symmetry", canvas)
        self._canvas = canvas
        self._axis: Axis | None = None
        with_role(self, "pill")
        self.setCursor(Qt.CursorShape.PointingHandCursor)
        self.clicked.connect(lambda: self.accepted.emit(self._axis))
        OnGeometry(canvas, self._place)
        self.hide()

    def offer(self, axis: Axis | None) -> None:
        """Offer an axis, or nothing."""
        self._axis = axis
        self.setVisible(axis is not None)
        if axis is not None:
            self.setToolTip(WORDS[axis])
            self._place()

    def _place(self) -> None:
        self.adjustSize()
        self.move((self._canvas.width() - self.width()) // 2, UNIT)
