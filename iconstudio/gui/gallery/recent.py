"""The latest results of all workspaces, kept in sight."""

from collections.abc import Sequence

from PySide6.QtCore import Qt, Signal
from PySide6.QtWidgets import QMenu, QWidget

from iconstudio.gui.gallery.icon_list import IconList, same
from iconstudio.gui.gallery.pictures import Picture
from iconstudio.gui.gallery.sending import Destination, offer

SIDE = 38
"""Side of an entry in device-independent pixels."""

MOST = 24
"""How many results are kept."""

EMPTY = "Results that you pick are kept here"


class RecentResults(IconList):
    """One row of results; a click, Enter or the context menu says what can be done with one.

    Signals
    -------
    sent(Picture, str)
        A result is to go to the workspace of that title.
    save_svg(Picture), save_png(Picture), save_code(Picture), copy_svg(Picture)
        A result is to be taken out of the window.
    """

    sent = Signal(object, str)
    save_svg = Signal(object)
    save_png = Signal(object)
    save_code = Signal(object)
    copy_svg = Signal(object)

    def __init__(self, destinations: Sequence[Destination], parent: QWidget | None = None) -> None:
        advice = "Click for what to do with it, or drag it where you need it"
        super().__init__(SIDE, EMPTY, advice, parent)
        self._destinations = destinations
        self.menu: QMenu | None = None
        self.setAccessibleName("Recent results")
        self.chosen.connect(self._open_menu)
        self.asked.connect(self._open_menu)

    def keep(self, picture: Picture) -> None:
        """Put a result in front; if it is there already, it moves there."""
        kept = [one for one in self.pictures if not same(one, picture)]
        self.show_pictures([picture, *kept][:MOST])
        self.reveal(picture)

    def _open_menu(self, picture: Picture) -> None:
        menu = QMenu(self)
        menu.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        offer(menu, self._destinations, lambda title: self.sent.emit(picture, title))
        if self._destinations:
            menu.addSeparator()
        menu.addAction("Save SVG…", lambda: self.save_svg.emit(picture))
        menu.addAction("Save PNG…", lambda: self.save_png.emit(picture))
        menu.addAction("Save colour code as PNG…", lambda: self.save_code.emit(picture))
        menu.addAction("Copy SVG", lambda: self.copy_svg.emit(picture))
        menu.addSeparator()
        menu.addAction("Remove", lambda: self.remove(picture))
        self.menu = menu
        menu.popup(self.below(picture))
