"""The latest results of all workspaces, kept in sight."""

from collections.abc import Sequence

from PySide6.QtCore import Signal
from PySide6.QtWidgets import QMenu

from iconstudio.gui.exchange.saving import Saver
from iconstudio.gui.gallery.sending import Destination, offer, pop_up
from iconstudio.gui.gallery.sheet import Sheet
from iconstudio.gui.gallery.sheet_delegate import framed
from iconstudio.gui.gallery.sheet_model import results_with
from iconstudio.gui.pictures.picture import Picture, same

SIDE = 38
"""Side of an entry in device-independent pixels."""

MOST = 24
"""How many results are kept."""

EMPTY = "Results that you pick are kept here"


class RecentResults(Sheet):
    """One row of results; a click, Enter or the context menu says what can be done with one.

    Signals
    -------
    sent(Picture, str)
        A result is to go to the workspace of that title.
    """

    sent = Signal(object, str)

    def __init__(self, destinations: Sequence[Destination], saver: Saver) -> None:
        """``saver`` takes results out of the window."""
        super().__init__(
            framed(SIDE),
            results_with("Click for what to do with it, or drag it where you need it"),
            "Recent results",
            hint=EMPTY,
            one_row=True,
            draggable=True,
            removable=True,
        )
        self._destinations, self._saver = destinations, saver
        self.menu: QMenu | None = None
        self.chosen.connect(self._open_menu)
        self.asked.connect(self._open_menu)

    def keep(self, picture: Picture) -> None:
        """Put a result in front; if it is there already, it moves there."""
        kept = [one for one in self.pictures if not same(one, picture)]
        self.show_entries([picture, *kept][:MOST])
        self.reveal(picture)

    def _open_menu(self, picture: Picture) -> None:
        menu = self.menu = QMenu(self)
        offer(menu, self._destinations, lambda title: self.sent.emit(picture, title))
        if self._destinations:
            menu.addSeparator()
        menu.addAction("Save SVG…", lambda: self._saver.save_svg(picture))
        menu.addAction("Save PNG…", lambda: self._saver.save_png(picture))
        code = menu.addAction("Save colour code as PNG…", lambda: self._saver.save_code(picture))
        code.setEnabled(picture.has_code)
        menu.addAction("Copy SVG", lambda: self._saver.copy_svg(picture))
        menu.addSeparator()
        menu.addAction("Remove", lambda: self.remove(picture))
        pop_up(menu, self.below(picture))
