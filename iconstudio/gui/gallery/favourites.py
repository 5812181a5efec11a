"""The favourites: the results that the user keeps."""

from PySide6.QtWidgets import QFrame, QMenu

from iconstudio.gui.gallery.sending import pop_up
from iconstudio.gui.gallery.sheet import Sheet
from iconstudio.gui.gallery.sheet_delegate import framed
from iconstudio.gui.gallery.sheet_model import results_with
from iconstudio.gui.pictures.picture import Picture
from iconstudio.gui.theme.layout import label, push_button, row, with_role
from iconstudio.gui.theme.theme import UNIT

SIDE = 7 * UNIT
"""Side of a favourite in device-independent pixels."""


class FavouritesPanel(QFrame):
    """A row of results in the order in which they were kept.

    As long as it is empty, ``hint`` says how to fill it. A click picks a favourite; the key
    Delete and the context menu take it out; it can be dragged to where icons are used.
    ``icon_list`` tells of all that, and ``button`` when all are to be saved.
    """

    def __init__(self, hint: str) -> None:
        super().__init__()
        with_role(self, "card")
        self.menu: QMenu | None = None
        advice = "Click to look at it, or drag it where you need it; Delete removes it"
        self.icon_list = Sheet(
            framed(SIDE),
            results_with(advice),
            "Favourites",
            hint=hint,
            one_row=True,
            draggable=True,
            removable=True,
        )
        tip = "Save every favourite as SVG, with credits"
        self.button = push_button("Save all…", tip)
        self.button.setEnabled(False)
        row(
            label("Favourites", "heading"),
            (self.icon_list, 1),
            self.button,
            of=self,
            spacing=UNIT * 3 // 2,
            margins=(UNIT * 3 // 2, UNIT, UNIT * 3 // 2, UNIT),
        )
        self.icon_list.asked.connect(self._open_menu)
        self.icon_list.changed.connect(lambda: self.button.setEnabled(bool(self.pictures)))

    @property
    def pictures(self) -> tuple[Picture, ...]:
        """The favourites, in the order in which they were added."""
        return self.icon_list.pictures

    def _open_menu(self, picture: Picture) -> None:
        menu = self.menu = QMenu(self)
        menu.addAction("Remove from the favourites", lambda: self.icon_list.remove(picture))
        pop_up(menu, self.icon_list.below(picture))
