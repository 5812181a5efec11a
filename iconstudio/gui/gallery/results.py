"""The grid of results: a row a style, a column a lambda_S."""

from collections.abc import Sequence

from PySide6.QtCore import QPoint, Qt, Signal
from PySide6.QtGui import QKeyEvent
from PySide6.QtWidgets import (
    QButtonGroup,
    QFrame,
    QLabel,
    QSizePolicy,
    QStackedLayout,
    QWidget,
)

from iconstudio.gui.canvas.tools.base import NUDGES
from iconstudio.gui.gallery.axes import Grid, RowHead, Scale
from iconstudio.gui.gallery.cell import CellState, ResultCell
from iconstudio.gui.gallery.display import DisplaySwitch
from iconstudio.gui.pictures.picture import Picture
from iconstudio.gui.theme.layout import column, label, row, with_role
from iconstudio.gui.theme.theme import UNIT
from iconstudio.workflows.events import StyleMatched, StyleSkipped


class ResultsPanel(QFrame):
    """All results of a run; fills while it goes on.

    Parameters
    ----------
    welcome
        Says what will appear here.
    nearer
        What the results on the left are.

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

    def __init__(self, welcome: str, nearer: str) -> None:
        super().__init__()
        with_role(self, "card")
        self._cells: dict[tuple[str, float], ResultCell] = {}
        self._heads: dict[str, RowHead] = {}
        self._reasons: dict[str, QLabel] = {}
        self._rows: list[list[ResultCell]] = []
        self._shape: tuple[tuple[str, ...], tuple[float, ...]] = (), ()
        self._group = QButtonGroup(self)
        self._group.setExclusive(True)
        self._group.buttonClicked.connect(self._pick)

        self.switch = DisplaySwitch()
        self.note = label(wordWrap=True)
        top = row(label("Results", "title"), (self.note, 1), self.switch)
        self.scale = Scale(nearer)
        self._sheet = Grid(self.scale)
        self._grid = self._sheet.cells
        below = QWidget()
        # Nothing is left for what is below it until it is full.
        column((self._sheet, 1000), (None, 1), of=below, spacing=0)
        self._welcome = label(welcome, alignment=Qt.AlignmentFlag.AlignCenter, wordWrap=True)
        self._stack = QStackedLayout()
        margins = 2 * UNIT, UNIT * 3 // 2, 2 * UNIT, UNIT
        column(top, (self._stack, 1), of=self, margins=margins)
        # Only now that it has a place: elsewhere, its first page would open as a window.
        self._stack.addWidget(self._welcome)
        self._stack.addWidget(below)
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Expanding)

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
        for height, style in enumerate(styles, start=1):
            self._heads[style] = RowHead(style)
            self._grid.addWidget(self._heads[style], height, 0)
            cells = []
            for place, value in enumerate(lambdas, start=1):
                cell = ResultCell(f"{style.capitalize()}, λ {value:.2f}")
                cell.customContextMenuRequested.connect(self._ask)
                self._group.addButton(cell)
                self._grid.addWidget(cell, height, place)
                self._grid.setColumnStretch(place, 1)
                self._cells[style, value] = cell
                cells.append(cell)
            reason = label(wordWrap=True)
            reason.setContentsMargins(UNIT, 0, UNIT, 0)
            reason.hide()
            self._grid.addWidget(reason, height, 1, 1, -1)
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
        self._reasons[style].setText(reason)
        self._reasons[style].setVisible(bool(reason))
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

    def keyPressEvent(self, event: QKeyEvent) -> None:
        """Go from result to result with the arrow keys."""
        cell = self.focusWidget()
        if event.key() not in NUDGES or not isinstance(cell, ResultCell):
            super().keyPressEvent(event)
            return
        y = next(i for i, cells in enumerate(self._rows) if cell in cells)
        x = self._rows[y].index(cell)
        right, down = NUDGES[event.key()]
        while True:
            y, x = y + down, x + right
            if not (0 <= y < len(self._rows) and 0 <= x < len(self._rows[y])):
                return
            target = self._rows[y][x]
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
