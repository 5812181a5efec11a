"""The sheet of patterns of other seeds, to choose from."""

from PySide6.QtCore import Signal
from PySide6.QtWidgets import QFrame

from iconstudio.gui.gallery.sheet import Sheet
from iconstudio.gui.gallery.sheet_delegate import framed
from iconstudio.gui.pictures.picture import Picture
from iconstudio.gui.theme.layout import card, label, row
from iconstudio.gui.theme.theme import UNIT
from iconstudio.gui.workspaces.made import Made
from iconstudio.model import Patterning

_SIDE = 19 * UNIT // 2


class SeedsPanel(QFrame):
    """Patterns that differ by their seed only; the one on the page is ticked.

    Signals
    -------
    chosen(Patterning)
        The user wants the seed of this work.
    """

    chosen = Signal(object)

    def __init__(self) -> None:
        super().__init__()
        self._works: dict[int, Patterning] = {}
        """By the identities of their pictures."""
        self._used: Patterning | None = None
        hint = "Patterns of other seeds appear here, to choose from"
        self.sheet = Sheet(framed(_SIDE), self._describe, "Other seeds", hint, draggable=True)
        self.sheet.chosen.connect(lambda picture: self.chosen.emit(self._works[id(picture)]))
        row(card(label("Other seeds", "heading"), (self.sheet, 1)), of=self)

    def begin(self, made: Made) -> None:
        """Show one pattern in place of all."""
        self._works = {}
        self._show([], made)

    def add(self, made: Made) -> None:
        """Show one more."""
        self._show(list(self.sheet.pictures), made)

    def clear(self) -> None:
        """Show none."""
        self._works = {}
        self.sheet.show_entries([])

    def show_used(self, work: Patterning) -> None:
        """Tick the pattern of some work; those of another exemplar are no longer shown."""
        self._used = work
        if any(_subject(one) != _subject(work) for one in self._works.values()):
            self.clear()
        self._mark()

    def _show(self, pictures: list[Picture], made: Made) -> None:
        self._works[id(made.picture)] = made.work
        self.sheet.show_entries([*pictures, made.picture])
        self._mark()

    def _mark(self) -> None:
        self.sheet.model().mark(lambda picture: self._works.get(id(picture)) == self._used)

    def _describe(self, picture: Picture, used: bool) -> tuple[str, str]:
        name = f"Seed {self._works[id(picture)].seed}"
        torn = f"{picture.icon.torn:.0%} of its ink in torn elements"
        return (f"{name}, in use" if used else name), f"{name}, {torn}\nClick to take it over"


def _subject(work: Patterning) -> tuple[object, ...]:
    """Return what an exemplar shows, wherever it lies."""
    return frozenset(one.icon for one in work.motifs), work.image and work.image.photo
