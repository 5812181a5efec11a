"""Choose a symbol of a sprite sheet: a list of their names, and a picture of one."""

from collections.abc import Callable, Sequence

from PySide6.QtWidgets import QLineEdit, QListWidget, QWidget

from iconstudio.gui.exchange.icon_dialog import GAP, IconDialog, ScanView
from iconstudio.gui.jobs.runner import Runner
from iconstudio.gui.jobs.worker import Worker, once
from iconstudio.gui.theme.layout import column, row
from iconstudio.gui.theme.theme import UNIT
from iconstudio.model import Exemplar, Pictogram
from iconstudio.session import Session


class SymbolDialog(IconDialog):
    """The names of a sheet's symbols, which can be searched, and a picture of the current one."""

    def __init__(
        self,
        session: Session,
        worker: Worker,
        find: Callable[[str], Pictogram],
        names: Sequence[str],
        parent: QWidget,
    ) -> None:
        """``find`` reads the symbol of a name, in the worker's thread."""
        super().__init__("Choose a symbol of the sprite sheet", "Use symbol", parent)
        self._session, self._find = session, find
        self.runner = Runner(worker, self)
        self.runner.event.connect(self._show)
        self.runner.failed.connect(lambda message: self.caption.say(message, error=True))
        self._make_list()
        self.list.addItems(list(names))
        self.list.currentTextChanged.connect(self._read)
        self.list.itemActivated.connect(self.accept)
        self.field.textChanged.connect(self._filter)
        self.finished.connect(self.runner.cancel)
        self.list.setCurrentRow(0)

    def _make_list(self) -> None:
        self.field = QLineEdit(placeholderText="Find a symbol")
        self.field.setAccessibleName("Find a symbol")
        self.field.setClearButtonEnabled(True)
        self.list = QListWidget()
        self.list.setAccessibleName("Symbols")
        self.preview = ScanView("The symbol")
        names = column(self.field, (self.list, 1))
        self.lay_out(row((names, 1), (self.preview, 1), spacing=GAP))
        self.resize(80 * UNIT, 48 * UNIT)

    def _filter(self, text: str) -> None:
        """Show the names that hold a text, and make the first of them the current one."""
        wanted = text.strip().casefold()
        first = None
        for number in range(self.list.count()):
            item = self.list.item(number)
            item.setHidden(wanted not in item.text().casefold())
            if first is None and not item.isHidden():
                first = number
        current = self.list.currentItem()
        if current is None or current.isHidden():
            self.list.setCurrentRow(-1 if first is None else first)

    def _read(self, name: str) -> None:
        self.forget()
        self.preview.clear()
        if not name:
            self.runner.cancel()
            self.caption.say("No symbol is called so.")
            return
        self.caption.say(f"Reading “{name}”…")
        find, session = self._find, self._session
        self.runner.start(lambda: once(lambda: session.exemplar(find(name))))

    def _show(self, exemplar: Exemplar) -> None:
        self.preview.show_ink(exemplar.coverage > 127)
        self.offer(exemplar.pictogram, exemplar.pictogram.credit.title)
