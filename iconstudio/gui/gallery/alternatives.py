"""What could stand in the place of a part of a result, as pictures of the whole to choose from."""

from collections.abc import Mapping

from PySide6.QtCore import QPoint, Qt, Signal
from PySide6.QtWidgets import QFrame, QLabel, QWidget

from iconstudio.gui.gallery.sheet import Sheet
from iconstudio.gui.gallery.sheet_delegate import framed
from iconstudio.gui.pictures.picture import Picture
from iconstudio.gui.theme.elided import ElidedLabel
from iconstudio.gui.theme.layout import column, hidden, push_button, row, with_role
from iconstudio.gui.theme.theme import UNIT

_SIDE, _ACROSS, _DOWN = 84, 4, 2
"""Side of a picture in device-independent pixels, and how many there is room for."""


_IN_MONTAGE = "The rest stays as it is; what you choose opens in Montage."


class AlternativesPopup(QFrame):
    """Pictures of the whole result, each with another icon in the place of a part.

    Signals
    -------
    chosen(int)
        The user wants the alternative of that number.
    unpinned()
        The part should no longer be held.
    closed()
        It is gone from sight.
    """

    chosen = Signal(int)
    unpinned = Signal()
    closed = Signal()

    def __init__(self, owner: QWidget) -> None:
        super().__init__(owner, Qt.WindowType.Popup)
        self.setProperty("card", True)
        self._numbers: list[int] = []
        self._title = with_role(ElidedLabel(""), "heading")
        self.unpin = hidden(push_button("Unpin", "Let the program choose for this place again"))
        self.sheet = Sheet(framed(_SIDE), _described, "Alternatives for this part")
        self.sheet.setFixedSize(_ACROSS * _SIDE + 2 * UNIT, _DOWN * _SIDE + UNIT)
        self._note = hidden(with_role(QLabel(_IN_MONTAGE), "hint"))
        heading = row((self._title, 1), self.unpin)
        column(heading, self.sheet, self._note, of=self, margins=(UNIT, UNIT, UNIT, UNIT))
        self.sheet.chosen.connect(self._choose)
        self.unpin.clicked.connect(self._unpin)

    def ask(self, name: str, pinned: bool, spot: QPoint, in_montage: bool = False) -> None:
        """Come up at a place of the screen, for a part of that name, which may be pinned.

        ``in_montage`` tells that what is chosen is opened as a montage.
        """
        self._title.set_words(f"In place of {name}")
        self.unpin.setVisible(pinned)
        self._note.setVisible(in_montage)
        self._say("Looking for alternatives…")
        self.show_pictures({})
        self.adjustSize()
        screen = self.parentWidget().screen().availableGeometry()
        x = min(max(spot.x() + UNIT, screen.left()), screen.right() - self.width())
        y = min(max(spot.y() + UNIT, screen.top()), screen.bottom() - self.height())
        self.move(x, y)
        self.show()
        self.sheet.setFocus()

    def show_pictures(self, pictures: Mapping[int, Picture]) -> None:
        """Show the alternatives, by their numbers."""
        self._numbers = sorted(pictures)
        self.sheet.show_entries([pictures[number] for number in self._numbers])

    def show_none(self) -> None:
        """Say that there are no alternatives."""
        self._say("No other icon of this row has anything to put here.")

    def hideEvent(self, event: object) -> None:
        """Tell that it is gone."""
        super().hideEvent(event)
        self.closed.emit()

    def _say(self, hint: str) -> None:
        self.sheet.set_hint(hint)

    def _choose(self, picture: Picture) -> None:
        at = next(n for n, one in enumerate(self.sheet.pictures) if one is picture)
        self.hide()
        self.chosen.emit(self._numbers[at])

    def _unpin(self) -> None:
        self.hide()
        self.unpinned.emit()


def _described(picture: Picture, marked: bool) -> tuple[str, str]:
    return picture.title, f"{picture.title}\nClick to take it for this part"
