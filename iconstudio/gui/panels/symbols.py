"""Choose a symbol of a sprite sheet: a list of their names, and a picture of one."""

from collections.abc import Callable, Generator, Sequence

from PySide6.QtCore import Qt, Signal
from PySide6.QtWidgets import (
    QDialog,
    QHBoxLayout,
    QLineEdit,
    QListWidget,
    QPushButton,
    QVBoxLayout,
    QWidget,
)

from iconstudio.gui.jobs.runner import Runner
from iconstudio.gui.jobs.worker import Worker
from iconstudio.gui.panels.caption import Caption
from iconstudio.gui.panels.scanning import ScanView
from iconstudio.gui.theme.theme import UNIT
from iconstudio.model import Exemplar, Pictogram
from iconstudio.session import Session


class SymbolDialog(QDialog):
    """The names of a sheet's symbols, which can be searched, and a picture of the current one.

    Signals
    -------
    chosen(Pictogram)
        The symbol that the user takes.
    """

    chosen = Signal(object)

    def __init__(
        self,
        session: Session,
        worker: Worker,
        find: Callable[[str], Pictogram],
        names: Sequence[str],
        parent: QWidget,
    ) -> None:
        """``find`` reads the symbol of a name, in the worker's thread."""
        super().__init__(parent)
        self.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        self.setWindowTitle("Choose a symbol of the sprite sheet")
        self._session, self._find = session, find
        self.icon: Pictogram | None = None
        self.runner = Runner(worker, self)
        self.runner.event.connect(self._show)
        self.runner.failed.connect(lambda message: self.caption.say(message, error=True))
        self._lay_out()
        self.list.addItems(list(names))
        self.list.currentTextChanged.connect(self._read)
        self.list.itemActivated.connect(self.accept)
        self.field.textChanged.connect(self._filter)
        self.finished.connect(self.runner.cancel)
        self.list.setCurrentRow(0)

    def _lay_out(self) -> None:
        self.field = QLineEdit(placeholderText="Find a symbol")
        self.field.setAccessibleName("Find a symbol")
        self.field.setClearButtonEnabled(True)
        self.list = QListWidget()
        self.list.setAccessibleName("Symbols")
        self.preview = ScanView("The symbol")
        self.caption = Caption()
        self.accept_button = QPushButton("Use symbol", default=True)
        self.accept_button.setProperty("primary", True)
        self.accept_button.setEnabled(False)
        self.accept_button.clicked.connect(self.accept)
        cancel = QPushButton("Cancel")
        cancel.setAutoDefault(False)
        cancel.clicked.connect(self.reject)
        names, top, buttons = QVBoxLayout(), QHBoxLayout(), QHBoxLayout()
        names.setSpacing(UNIT)
        names.addWidget(self.field)
        names.addWidget(self.list, 1)
        top.setSpacing(3 * UNIT // 2)
        top.addLayout(names, 1)
        top.addWidget(self.preview, 1)
        buttons.setSpacing(3 * UNIT // 2)
        buttons.addWidget(self.caption, 1)
        buttons.addWidget(cancel)
        buttons.addWidget(self.accept_button)
        column = QVBoxLayout(self)
        column.setContentsMargins(2 * UNIT, 2 * UNIT, 2 * UNIT, 2 * UNIT)
        column.setSpacing(3 * UNIT // 2)
        column.addLayout(top, 1)
        column.addLayout(buttons)
        self.resize(80 * UNIT, 48 * UNIT)

    def accept(self) -> None:
        """Take the symbol that is in sight, as soon as it is read."""
        if self.icon is not None:
            super().accept()
            self.chosen.emit(self.icon)

    def _filter(self, text: str) -> None:
        """Show the names that hold a text, and make the first of them the current one."""
        wanted = text.strip().casefold()
        first = None
        for row in range(self.list.count()):
            item = self.list.item(row)
            item.setHidden(wanted not in item.text().casefold())
            if first is None and not item.isHidden():
                first = row
        current = self.list.currentItem()
        if current is None or current.isHidden():
            self.list.setCurrentRow(-1 if first is None else first)

    def _read(self, name: str) -> None:
        self.icon = None
        self.accept_button.setEnabled(False)
        self.preview.clear()
        if not name:
            self.runner.cancel()
            self.caption.say("No symbol is called so.")
            return
        self.caption.say(f"Reading “{name}”…")
        self.runner.start(lambda: self._exemplar(name))

    def _exemplar(self, name: str) -> Generator[Exemplar]:
        yield self._session.exemplar(self._find(name))

    def _show(self, exemplar: Exemplar) -> None:
        self.icon = exemplar.pictogram
        self.preview.show_ink(exemplar.coverage > 127)
        self.accept_button.setEnabled(True)
        self.caption.say(" ".join(self.icon.remarks) or exemplar.pictogram.credit.title)
