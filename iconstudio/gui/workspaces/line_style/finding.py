"""A dialog in which an icon is looked up."""

from PySide6.QtCore import Qt, Signal
from PySide6.QtWidgets import QDialog, QWidget

from iconstudio.gui.jobs.worker import Worker
from iconstudio.gui.panels.chooser import IconChooser
from iconstudio.gui.theme.layout import column
from iconstudio.gui.theme.theme import UNIT
from iconstudio.model import Exemplar
from iconstudio.session import Session


class FindDialog(QDialog):
    """Looks icons up by a word, or opens a drawing; the first that is chosen is taken.

    Signals
    -------
    chosen(Pictogram)
        The user takes this icon.
    """

    chosen = Signal(object)

    def __init__(self, session: Session, worker: Worker, parent: QWidget) -> None:
        super().__init__(parent)
        self.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        self.setWindowTitle("Find an icon to restyle")
        self.chooser = IconChooser(session, worker)
        self.chooser.chosen.connect(self._take)
        column((self.chooser, 1), of=self, margins=(2 * UNIT,) * 4)
        self.resize(60 * UNIT, 52 * UNIT)
        self.chooser.setFocus()

    def _take(self, icon: Exemplar) -> None:
        self.accept()
        self.chosen.emit(icon.pictogram)
