"""The grid of results: a row a style, a column a lambda_S."""

from collections.abc import Sequence

from PySide6.QtCore import QPoint, Qt, Signal
from PySide6.QtGui import QKeyEvent
from PySide6.QtWidgets import (
    QButtonGroup,
    QFrame,
    QHBoxLayout,
    QLabel,
    QSizePolicy,
    QStackedLayout,
    QVBoxLayout,
    QWidget,
)

from iconstudio.gui.gallery.axes import Grid, RowHead, Scale
from iconstudio.gui.gallery.cell import CellState, ResultCell
from iconstudio.gui.gallery.display_switch import DisplaySwitch
from iconstudio.gui.gallery.pictures import Display, Picture
from iconstudio.gui.theme.theme import UNIT
from iconstudio.workflows.events import StyleMatched, StyleSkipped

WELCOME = (
    "Your icons appear here: a row for each style, from thin lines to solid.\n"
    "On the left they stay closer to your sketch; to the right, larger parts join more smoothly."
)

_STEPS = {
    Qt.Key.Key_Left: (0, -1),
    Qt.Key.Key_Right: (0, 1),
    Qt.Key.Key_Up: (-1, 0),
    Qt.Key.Key_Down: (1, 0),
}


class ResultsPanel(QFrame):
    """All results of a run; fills while it goes on.

    Signals
    -------
    picked(object)
        The Picture that the user looks at, or None.
    chosen(Picture)
        The user himself picked this one.
    asked(Picture, QPoint)
        The user wants to know, at this place of the screen, what can be done with a result.
    """

    picked = Signal(object)
    chosen = Signal(object)
    asked = Signal(object, QPoint)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setProperty("card", True)
        self._cells: dict[tuple[str, float], ResultCell] = {}
        self._heads: dict[str, RowHead] = {}
        self._reasons: dict[str, QLabel] = {}
        self._rows: list[list[ResultCell]] = []
        self._shape: tuple[tuple[str, ...], tuple[float, ...]] = (), ()
        self._group = QButtonGroup(self)
        self._group.setExclusive(True)
        self._group.buttonClicked.connect(self._pick)
        self.display = Display.BOTH

        self.switch = DisplaySwitch()
        title = QLabel("Results")
        title.setProperty("title", True)
        self.note = QLabel(wordWrap=True)
        self.note.setProperty("muted", True)
        top = QHBoxLayout()
        top.setSpacing(UNIT)
        top.addWidget(title)
        top.addWidget(self.note, 1)
        top.addWidget(self.switch)
        self.scale = Scale()
        self._sheet = Grid(self.scale)
        self._grid = self._sheet.cells
        below = QWidget()
        column = QVBoxLayout(below)
        column.setContentsMargins(0, 0, 0, 0)
        column.setSpacing(0)
        column.addWidget(self._sheet, 1000)  # nothing is left for what is below it until it is full
        column.addStretch(1)
        self._welcome = QLabel(WELCOME, alignment=Qt.AlignmentFlag.AlignCenter, wordWrap=True)
        self._welcome.setProperty("muted", True)
        self._stack = QStackedLayout()
        layout = QVBoxLayout(self)
        layout.setContentsMargins(2 * UNIT, UNIT * 3 // 2, 2 * UNIT, UNIT)
        layout.setSpacing(UNIT)
        layout.addLayout(top)
        layout.addLayout(self._stack, 1)
        # Only now that it has a place: elsewhere, its first page would open as a window.
        self._stack.addWidget(self._welcome)
        self._stack.addWidget(below)
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Expanding)

    def set_words(self, welcome: str, nearer: str) -> None:
        """Say what will appear here, and what the results on the left are."""
        self._welcome.setText(welcome)
        self.scale.nearer = nearer

    @property
    def pictures(self) -> list[Picture]:
        """The results that are in sight."""
        return [
            cell.picture
            for (style, _), cell in self._cells.items()
            if cell.picture is not None and not self.skipped(style)
        ]

    @property
    def finished(self) -> int:
        """How many results of the last run are finished."""
        return sum(cell.state is CellState.READY for cell in self._cells.values())

    @property
    def focus(self) -> tuple[str, float] | None:
        """Style and lambda_S of the picked result."""
        return next((key for key, cell in self._cells.items() if cell.isChecked()), None)

    def cell(self, style: str, lambda_s: float) -> ResultCell:
        """Return the cell of a style and a lambda_S."""
        return self._cells[style, lambda_s]

    def skipped(self, style: str) -> bool:
        """Whether a reason stands in place of the results of a style."""
        return bool(self._reasons[style].text())

    def begin(self, styles: Sequence[str], lambdas: Sequence[float]) -> None:
        """Make room for the results of a new run; those that are there stay until then."""
        shape = tuple(styles), tuple(lambdas)
        if shape != self._shape:
            self._build(*shape)
        for cell in self._cells.values():
            cell.renew()
        self._stack.setCurrentIndex(1)

    def clear(self) -> None:
        """Let go of all results."""
        self._group.setExclusive(False)  # so that none may be picked
        for cell in self._cells.values():
            cell.expect(False)
            cell.setChecked(False)
        self._group.setExclusive(True)
        for style, head in self._heads.items():
            head.set_count(None)
            self._set_skipped(style, "")
        self.picked.emit(None)
        self._stack.setCurrentIndex(0)

    def set_stale(self, stale: bool) -> None:
        """Say whether all results are of something else than what is there now."""
        for cell in self._cells.values():
            cell.set_stale(stale)

    def _build(self, styles: tuple[str, ...], lambdas: tuple[float, ...]) -> None:
        """Make the grid; what is shown in both the old and the new one is taken over."""
        kept = {key: cell.picture for key, cell in self._cells.items() if cell.picture is not None}
        focus = self.focus
        self._tear_down()
        self._shape = styles, lambdas
        self.scale.set_lambdas(lambdas)
        self._sheet.set_shape(len(styles), len(lambdas))
        self._grid.addWidget(self.scale, 0, 1, 1, len(lambdas))
        self.scale.show()
        for row, style in enumerate(styles, start=1):
            self._heads[style] = RowHead(style)
            self._grid.addWidget(self._heads[style], row, 0)
            cells = []
            for column, value in enumerate(lambdas, start=1):
                cell = ResultCell(f"{style.capitalize()}, λ {value:.2f}")
                cell.show_display(self.display)
                cell.customContextMenuRequested.connect(self._ask)
                self._group.addButton(cell)
                self._grid.addWidget(cell, row, column)
                self._grid.setColumnStretch(column, 1)
                self._cells[style, value] = cell
                cells.append(cell)
            reason = QLabel(wordWrap=True)
            reason.setProperty("muted", True)
            reason.setContentsMargins(UNIT, 0, UNIT, 0)
            reason.hide()
            self._grid.addWidget(reason, row, 1, 1, -1)
            self._reasons[style] = reason
            self._rows.append(cells)
        for key in kept.keys() & self._cells.keys():
            self._cells[key].show_picture(kept[key])
            self._cells[key].setChecked(key == focus)
        if focus not in kept.keys() & self._cells.keys():
            self.picked.emit(None)

    def show_matched(self, event: StyleMatched) -> None:
        """Say how many icons a style had to choose from."""
        self._heads[event.style].set_count(event.retrieved)
        self._set_skipped(event.style, "")

    def show_skipped(self, event: StyleSkipped) -> None:
        """Give the reason in place of the results of a style, until it is matched again."""
        self._heads[event.style].set_count(None)
        self._set_skipped(event.style, event.reason)

    def _set_skipped(self, style: str, reason: str) -> None:
        label = self._reasons[style]
        label.setText(reason)
        label.setVisible(bool(reason))
        for cell in self._rows[list(self._heads).index(style)]:
            cell.setHidden(bool(reason))

    def add(self, picture: Picture) -> bool:
        """Put a result into its cell, and return whether it belongs there.

        A preview does not once the finished result is there.
        """
        composite = picture.icon.composite
        cell = self._cells[composite.style, composite.lambda_s]
        if picture.preview and cell.state is CellState.READY:
            return False
        cell.show_picture(picture)
        if cell.isChecked():
            self.picked.emit(picture)
        return True

    def recommend(self, style: str, lambda_s: float | None) -> None:
        """Mark the result of a style to look at first, if there is one, and no other."""
        reason = f"of the {style} icons, this one holds together best and is closest to the outline"
        for value in self._shape[1]:
            self.cell(style, value).recommend(reason if value == lambda_s else "")

    def end(self) -> None:
        """Nothing more is to come: empty the cells that still wait."""
        for cell in self._cells.values():
            if cell.picture is None:
                cell.expect(False)

    def pick(self, style: str, lambda_s: float) -> None:
        """Pick a result for the user to begin with."""
        cell = self.cell(style, lambda_s)
        cell.setChecked(True)
        self.picked.emit(cell.picture)

    def show_display(self, display: Display) -> None:
        """Show the results as icons, by their colour code, or both."""
        self.display = display
        self.switch.show_display(display)
        for cell in self._cells.values():
            cell.show_display(display)

    def keyPressEvent(self, event: QKeyEvent) -> None:
        """Go from result to result with the arrow keys."""
        cell = self.focusWidget()
        if event.key() not in _STEPS or not isinstance(cell, ResultCell):
            super().keyPressEvent(event)
            return
        row = next(i for i, cells in enumerate(self._rows) if cell in cells)
        column = self._rows[row].index(cell)
        down, right = _STEPS[event.key()]
        while True:
            row, column = row + down, column + right
            if not (0 <= row < len(self._rows) and 0 <= column < len(self._rows[row])):
                return
            target = self._rows[row][column]
            if target.isEnabled() and target.isVisible():
                target.setFocus(Qt.FocusReason.OtherFocusReason)
                target.click()
                return

    def _pick(self, cell: ResultCell) -> None:
        self.picked.emit(cell.picture)
        self.chosen.emit(cell.picture)

    def _ask(self, spot: QPoint) -> None:
        cell = self.sender()
        self.asked.emit(cell.picture, cell.mapToGlobal(spot))

    def _tear_down(self) -> None:
        for cell in self._cells.values():
            self._group.removeButton(cell)
        for widget in (*self._cells.values(), *self._heads.values(), *self._reasons.values()):
            self._grid.removeWidget(widget)
            widget.hide()
            widget.deleteLater()
        self._grid.removeWidget(self.scale)
        self._cells, self._heads, self._reasons, self._rows = {}, {}, {}, []
