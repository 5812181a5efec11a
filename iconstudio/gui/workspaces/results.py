"""What a workspace does with its results: shows, keeps, saves and sends them."""

from collections.abc import Callable, Sequence
from typing import ClassVar

from PySide6.QtCore import QPoint, Signal
from PySide6.QtGui import QHideEvent
from PySide6.QtWidgets import QMenu, QWidget

from iconstudio.gui.exchange.saving import Saver
from iconstudio.gui.gallery.detail import DetailPanel
from iconstudio.gui.gallery.sending import Destination, offer, offer_to_open, pop_up
from iconstudio.gui.gallery.sheet import Sheet
from iconstudio.gui.pictures.picture import Picture
from iconstudio.gui.workspaces.actions import Actions


class ResultsWidget(QWidget):
    """Shows results, of which one may be picked.

    Signals
    -------
    picked(object)
        The Picture that the user looks at, or None.
    kept(Picture)
        A result worth keeping in sight.
    send(Pictogram, str)
        An icon is to go to the workspace of that title.
    send_sources(Remix, str)
        The sources of a result are to be opened in the workspace of that title.
    """

    picked = Signal(object)
    kept = Signal(object)
    send = Signal(object, str)
    send_sources = Signal(object, str)

    detail: DetailPanel | None = None
    """Shows the picked result, if there are any."""
    actions_by_name: Actions
    """What is declared in ``entries``. The menus show these, and their shortcuts work while this
    is in sight. What makes no sense is disabled."""
    saver: Saver
    """Asks where results go."""
    keeps_last: ClassVar[bool] = False
    """Whether the result in sight is kept when the user goes elsewhere."""
    destinations: Sequence[Destination] = ()
    """Where icons can be sent to."""
    menu: QMenu | None = None
    """What can be done with the result that was asked about last."""

    def __init__(self) -> None:
        super().__init__()
        self._kept: Picture | None = None
        self.kept.connect(self._note_kept)

    @property
    def picture(self) -> Picture | None:
        """The picked result."""
        return None if self.detail is None else self.detail.picture

    def look_at(self, picture: Picture | None) -> None:
        """Pick a result, and show it large; or none."""
        self.detail.show_picture(picture)
        self.picked.emit(picture)

    def hideEvent(self, event: QHideEvent) -> None:
        """Keep the result in sight if it should be."""
        super().hideEvent(event)
        picture = self.picture
        if picture is None or picture.preview or picture is self._kept:
            return
        if self.keeps_last and not event.spontaneous():
            self.kept.emit(picture)

    def pick_from(self, sheet: Sheet) -> None:
        """Let the results on a sheet be looked at, and kept."""
        sheet.picked.connect(self.look_at)
        sheet.chosen.connect(self.look_at)
        sheet.chosen.connect(self.kept)

    def take_out(self, save: Callable[[Picture], None]) -> None:
        """Save the picked result, or copy it; that keeps it in sight."""
        if self.picture is not None:
            self.kept.emit(self.picture)
            save(self.picture)

    def send_picture(self, picture: Picture, title: str) -> None:
        """Send a result to the workspace of that title."""
        self.kept.emit(picture)
        self.send.emit(picture.pictogram(), title)

    def send_sources_of(self, picture: Picture, title: str) -> None:
        """Have the sources of a result opened in the workspace of that title."""
        self.kept.emit(picture)
        self.send_sources.emit(picture.icon, title)

    def offer_for(self, picture: Picture, spot: QPoint) -> None:
        """Open a menu of what can be done with a result, at a place of the screen."""
        menu = QMenu(self)
        self.fill_result_menu(menu, picture)
        if menu.actions():
            self.menu = menu
            pop_up(menu, spot)

    def fill_result_menu(self, menu: QMenu, picture: Picture) -> None:
        """Say what can be done with a result: it can be sent elsewhere."""
        offer(menu, self.destinations, lambda title: self.send_picture(picture, title))
        if picture.has_code:
            offer_to_open(
                menu, self.destinations, lambda title: self.send_sources_of(picture, title)
            )

    def _note_kept(self, picture: Picture) -> None:
        self._kept = picture
