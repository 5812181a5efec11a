"""The grid of results: a row a style, a column a lambda_S."""

from collections.abc import Sequence

from PySide6.QtCore import QPoint, Qt, Signal
from PySide6.QtGui import QKeyEvent, QResizeEvent
from PySide6.QtWidgets import (
    QButtonGroup,
    QFrame,
    QGridLayout,
    QLabel,
    QSizePolicy,
    QStackedLayout,
    QWidget,
)

from iconstudio.gui.canvas.tools.base import NUDGES
from iconstudio.gui.gallery import symmetric
from iconstudio.gui.gallery.axes import HEAD, RowHead, Scale
from iconstudio.gui.gallery.cell import CellState, ResultCell
from iconstudio.gui.gallery.display import DisplaySwitch
from iconstudio.gui.gallery.symmetric import symmetric_switch
from iconstudio.gui.gallery.tidiness import shown, tidy_switch
from iconstudio.gui.pictures.picture import Picture
from iconstudio.gui.theme.layout import column, label, row, with_role
from iconstudio.gui.theme.theme import UNIT
from iconstudio.workflows.events import StyleMatched, StyleSkipped


class ResultsGrid(QWidget):
    """A row of cells for each style, below the scale; no cell is higher than wide."""

    def __init__(self, styles: tuple[str, ...], lambdas: tuple[float, ...], nearer: str) -> None:
        super().__init__()
        self.styles, self.lambdas = styles, lambdas
        self.scale = Scale(nearer, lambdas)
        self.cells: dict[tuple[str, float], ResultCell] = {}
        self.heads = {style: RowHead(style) for style in styles}
        self.reasons: dict[str, QLabel] = {}
        """Why there are no results of a style; empty if there are."""
        self.group = QButtonGroup(self)
        grid = QGridLayout(self)
        grid.setContentsMargins(0, 0, 0, 0)
        grid.setSpacing(0)
        grid.addWidget(self.scale, 0, 1, 1, max(1, len(lambdas)))
        for y, style in enumerate(styles, start=1):
            grid.setRowStretch(y, 1)
            grid.addWidget(self.heads[style], y, 0)
            for x, value in enumerate(lambdas, start=1):
                cell = ResultCell(f"{style.capitalize()}, λ {value:.2f}")
                self.cells[style, value] = cell
                self.group.addButton(cell)
                grid.addWidget(cell, y, x)
                grid.setColumnStretch(x, 1)
            reason = self.reasons[style] = label(wordWrap=True)
            reason.setContentsMargins(UNIT, 0, UNIT, 0)
            reason.hide()
            grid.addWidget(reason, y, 1, 1, -1)

    def skip(self, style: str, reason: str) -> None:
        """Show a reason in place of the results of a style; without one, the results."""
        self.reasons[style].setText(reason)
        self.reasons[style].setVisible(bool(reason))
        for value in self.lambdas:
            self.cells[style, value].setHidden(bool(reason))

    def keyPressEvent(self, event: QKeyEvent) -> None:
        """Go from result to result with the arrow keys."""
        places = {cell: place for place, cell in self.cells.items()}
        way, place = NUDGES.get(event.key()), places.get(self.focusWidget())
        if way is None or place is None:
            super().keyPressEvent(event)
            return
        x, y = self.lambdas.index(place[1]) + way[0], self.styles.index(place[0]) + way[1]
        while 0 <= x < len(self.lambdas) and 0 <= y < len(self.styles):
            cell = self.cells[self.styles[y], self.lambdas[x]]
            if cell.isEnabled() and cell.isVisible():
                cell.setFocus(Qt.FocusReason.OtherFocusReason)
                cell.click()
                return
            x, y = x + way[0], y + way[1]

    def resizeEvent(self, event: QResizeEvent) -> None:
        """Grow no higher than the cells are wide."""
        super().resizeEvent(event)
        wide = (self.width() - HEAD) // max(1, len(self.lambdas))
        height = self.scale.height() + len(self.styles) * wide
        self.setMaximumHeight(max(height, self.minimumSizeHint().height()))


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
    aged()
        A result turned pale, as it is of something else than what is there now, or back.
    asked(Picture, QPoint)
        The user wants to know, at this place of the screen, what can be done with a result.
    """

    picked = Signal(object)
    chosen = Signal(object)
    aged = Signal()
    asked = Signal(object, QPoint)

    def __init__(self, welcome: str, nearer: str) -> None:
        super().__init__()
        with_role(self, "card")
        self._nearer = nearer
        self.grid = ResultsGrid((), (), nearer)
        self.switch, self.tidy_switch = DisplaySwitch(), tidy_switch()
        self.symmetric_switch = symmetric_switch()
        self.symmetric_switch.hide()
        symmetric.setting.changed.connect(self._renew_symmetric)
        self._own: dict[tuple[str, float], Picture] = {}
        self._symmetric: dict[tuple[str, float], Picture] = {}
        """Results as they were cut, and what may stand in their places."""
        self._waiting: dict[tuple[str, float], Picture] = {}
        """Other results, for the place of what is picked as long as it is."""
        self.note = label(wordWrap=True)
        switches = self.symmetric_switch, self.tidy_switch, self.switch
        top = row(label("Results", "title"), (self.note, 1), *switches)
        below = QWidget()
        # Nothing is left for what is below it until it is full.
        self._place = column((self.grid, 1000), (None, 1), of=below, spacing=0)
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
            for (style, _), cell in self.grid.cells.items()
            if cell.picture is not None and not self.skipped(style)
        ]

    @property
    def finished(self) -> int:
        """How many results of the last run are finished."""
        return sum(cell.state is CellState.READY for cell in self.grid.cells.values())

    @property
    def focus(self) -> tuple[str, float] | None:
        """Style and lambda_S of the picked result."""
        return next((key for key, cell in self.grid.cells.items() if cell.isChecked()), None)

    @property
    def picked_cell(self) -> ResultCell | None:
        """The cell of the picked result."""
        return None if self.focus is None else self.cell(*self.focus)

    def cell(self, style: str, lambda_s: float) -> ResultCell:
        """Return the cell of a style and a lambda_S."""
        return self.grid.cells[style, lambda_s]

    def skipped(self, style: str) -> bool:
        """Whether a reason stands in place of the results of a style."""
        return bool(self.grid.reasons[style].text())

    def begin(self, styles: Sequence[str], lambdas: Sequence[float]) -> None:
        """Make room for the results of a new run; those that are there stay until then."""
        shape = tuple(styles), tuple(lambdas)
        if shape != (self.grid.styles, self.grid.lambdas):
            self._show(ResultsGrid(*shape, self._nearer))
        self._forget_others()
        for cell in self.grid.cells.values():
            cell.renew()
        self._stack.setCurrentIndex(1)

    def clear(self) -> None:
        """Let go of all results."""
        self._forget_others()
        self._show(ResultsGrid((), (), self._nearer))
        self._stack.setCurrentIndex(0)

    def set_stale(self, stale: bool) -> None:
        """Say whether all results are of something else than what is there now."""
        for cell in self.grid.cells.values():
            cell.set_stale(stale)

    def show_matched(self, event: StyleMatched) -> None:
        """Say how many icons a style had to choose from."""
        self.grid.heads[event.style].set_count(event.retrieved)
        self.grid.skip(event.style, "")

    def show_skipped(self, event: StyleSkipped) -> None:
        """Give the reason in place of the results of a style, until it is matched again."""
        self.grid.heads[event.style].set_count(None)
        self.grid.skip(event.style, event.reason)

    def add(self, picture: Picture) -> bool:
        """Put a result into its cell, and return whether it belongs there.

        A preview does not once the finished result is there, nor a symmetric one if none is wanted.
        Another one in place of what is picked waits until something else is.
        """
        composite = picture.icon.composite
        place = composite.style, composite.lambda_s
        cell = self.cell(*place)
        if picture.preview and cell.state is CellState.READY:
            return False
        if composite.without and cell.isChecked():
            self._waiting[place] = picture
            return False
        (self._symmetric if composite.symmetry else self._own)[place] = picture
        self.symmetric_switch.setVisible(bool(self._symmetric))
        if composite.symmetry and not symmetric.setting.value:
            return False
        if composite.symmetry and place in self._waiting:
            self._own[place] = self._waiting.pop(place)  # it was made of that one
        cell.show_picture(picture)
        if cell.isChecked():
            self.picked.emit(picture)
        return True

    def coming(self, style: str, lambda_s: float) -> Picture:
        """Return what is in a cell, or waits for its place."""
        place = style, lambda_s
        return self._waiting.get(place) or self.cell(*place).picture

    def renew_tidiness(self) -> None:
        """Show all results tidied or not, as the setting says."""
        for cell in self.grid.cells.values():
            if cell.picture is not None:
                cell.picture = shown(cell.picture)
                cell.update()
                if cell.isChecked():
                    self.picked.emit(cell.picture)

    def recommend(self, style: str, lambda_s: float | None) -> None:
        """Mark the result of a style to look at first, if there is one, and no other."""
        reason = f"of the {style} icons that are new, this one is the likeliest to be good"
        for value in self.grid.lambdas:
            self.cell(style, value).recommend(reason if value == lambda_s else "")

    def end(self) -> None:
        """Nothing more is to come: empty the cells that still wait."""
        for cell in self.grid.cells.values():
            if cell.picture is None:
                cell.expect(False)

    def pick(self, style: str, lambda_s: float) -> None:
        """Pick a result for the user to begin with."""
        self._admit()
        cell = self.cell(style, lambda_s)
        cell.setChecked(True)
        self.picked.emit(cell.picture)

    def _renew_symmetric(self) -> None:
        """Show symmetric results in the places of others, or these, as the setting says."""
        pictures = self._symmetric if symmetric.setting.value else self._own
        for place in self._symmetric:
            cell = self.cell(*place)
            cell.show_picture(shown(pictures[place]))
            if cell.isChecked():
                self.picked.emit(cell.picture)

    def _admit(self, but: tuple[str, float] | None = None) -> None:
        """Show what waits in its place, ``but`` for one."""
        for place in self._waiting.keys() - {but}:
            self._own[place] = self._waiting.pop(place)
            self.cell(*place).show_picture(shown(self._own[place]))

    def _forget_others(self) -> None:
        self._own, self._symmetric, self._waiting = {}, {}, {}
        self.symmetric_switch.hide()

    def _show(self, grid: ResultsGrid) -> None:
        """Put another grid in place; what is shown in both is taken over."""
        before, focus, self.grid = self.grid, self.focus, grid
        kept = {key for key in before.cells.keys() & grid.cells.keys() if before.cells[key].picture}
        for key in kept:
            grid.cells[key].show_picture(before.cells[key].picture)
            grid.cells[key].setChecked(key == focus)
        for cell in grid.cells.values():
            cell.customContextMenuRequested.connect(self._ask)
            cell.paling.changed.connect(self.aged)
        grid.group.buttonClicked.connect(self._pick)
        self._place.replaceWidget(before, grid)
        before.hide()
        before.deleteLater()
        if focus not in kept:
            self.picked.emit(None)

    def _pick(self, cell: ResultCell) -> None:
        self._admit(but=self.focus)
        self.picked.emit(cell.picture)
        self.chosen.emit(cell.picture)

    def _ask(self, spot: QPoint) -> None:
        cell = self.sender()
        self.asked.emit(cell.picture, cell.mapToGlobal(spot))
