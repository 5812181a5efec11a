"""The icons of the work, in the default workspace: found, added, looked at and taken out."""

from PySide6.QtCore import Signal
from PySide6.QtWidgets import QWidget

from iconstudio.gui.gallery.sheet import Sheet
from iconstudio.gui.gallery.sheet_delegate import Look
from iconstudio.gui.gallery.sheet_model import Entry, credited
from iconstudio.gui.jobs.runner import Runner
from iconstudio.gui.jobs.worker import Worker, once
from iconstudio.gui.panels.chooser import IconChooser
from iconstudio.gui.theme.layout import card, column, label
from iconstudio.gui.theme.theme import UNIT
from iconstudio.model import Exemplar, Pictogram
from iconstudio.session import Session


class WorkIcons(QWidget):
    """Find icons above; those of the work stand below, where a click takes one out.

    Signals
    -------
    removed(Exemplar)
        The user wants to do without this icon.
    """

    removed = Signal(object)

    def __init__(self, session: Session, worker: Worker) -> None:
        super().__init__()
        self._session = session
        self._icons: tuple[Pictogram, ...] = ()
        self.chooser = IconChooser(session, worker, multiple=True)
        self.sheet = _IconSheet(
            Look(7 * UNIT, margin=6),
            _described,
            "Icons chosen",
            "Choose icons above, or drop icons and files here.",
            draggable=True,
            removable=True,
        )
        self._count = label(role="heading")
        self._drawing = Runner(worker, self)
        self._drawing.event.connect(self.sheet.show_entries)
        self.chooser.released.connect(self.removed)
        self.sheet.chosen.connect(self.removed)
        self.sheet.removed.connect(self.removed)
        self.setFixedWidth(44 * UNIT)
        finding = card(label("Icons", "title"), (self.chooser, 1))
        column((finding, 3), (card(self._count, (self.sheet, 1)), 2), of=self)

    def show_icons(self, icons: tuple[Pictogram, ...]) -> None:
        """Show the icons of the work."""
        self._count.setText(f"Chosen · {len(icons)}" if icons else "Chosen")
        self.chooser.set_taken(frozenset(icon.id for icon in icons))
        if icons != self._icons:
            self._icons = icons
            exemplar = self._session.exemplar
            self._drawing.start(lambda: once(lambda: tuple(map(exemplar, icons))))


class _IconSheet(Sheet):
    """Icons that Delete takes out of the work, not just off the sheet.

    Signals
    -------
    removed(Exemplar)
        An icon is to be taken out.
    """

    removed = Signal(object)

    def remove(self, entry: Entry) -> None:
        """Ask for it; whose icons they are takes it out."""
        self.removed.emit(entry)


def _described(icon: Exemplar, marked: bool) -> tuple[str, str]:
    return icon.name, f"{credited(icon)}\nClick to take it away, or drag it"
