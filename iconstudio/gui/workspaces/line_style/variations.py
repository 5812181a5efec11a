"""The sheet of variations: other strengths and other seeds."""

from PySide6.QtCore import Signal
from PySide6.QtWidgets import QFrame

from iconstudio.gui.gallery.sheet import Sheet
from iconstudio.gui.gallery.sheet_delegate import Look
from iconstudio.gui.pictures.picture import Picture
from iconstudio.gui.theme.layout import card, label, push_button, row
from iconstudio.gui.theme.theme import UNIT
from iconstudio.gui.workspaces.line_style.styles import show_in_place
from iconstudio.gui.workspaces.made import Made
from iconstudio.model import Restyling

_SIDE = 10 * UNIT


class VariationsPanel(QFrame):
    """Results in other strengths and with other seeds.

    Signals
    -------
    chosen(Made)
        The user looks at a variation.
    wanted(Restyling)
        Its strength and seed are to be taken over.
    """

    chosen = Signal(object)
    wanted = Signal(object)

    def __init__(self) -> None:
        super().__init__()
        self._works: dict[int, Restyling] = {}
        """By the identities of their pictures."""
        self._chosen: Picture | None = None
        look = Look(_SIDE, margin=7)
        hint = "Variations appear here: other strengths, other seeds"
        self.sheet = Sheet(look, self._describe, "Variations", hint, draggable=True)
        self.sheet.chosen.connect(self._choose)
        self.sheet.doubleClicked.connect(lambda _: self._take_over())
        tip = "Go on with the strength and the seed of the variation (or double-click it)"
        self.button = push_button("Use these settings", tip, self._take_over, role="pill")
        policy = self.button.sizePolicy()
        policy.setRetainSizeWhenHidden(True)
        self.button.setSizePolicy(policy)
        self.button.hide()
        row(
            card(row((label("Variations", "title"), 1), self.button), (self.sheet, 1)),
            of=self,
        )

    def clear(self) -> None:
        """Show none."""
        self._works = {}
        self._show([])

    def add(self, made: Made) -> None:
        """Add one."""
        self._works[id(made.picture)] = made.work
        self._show([*self.sheet.pictures, made.picture])

    def _show(self, pictures: list[Picture]) -> None:
        if self._chosen not in pictures:
            self._pick(None)
        show_in_place(self.sheet, pictures)

    def _choose(self, picture: Picture) -> None:
        self._pick(picture)
        self.chosen.emit(Made(picture, self._works[id(picture)]))

    def _pick(self, chosen: Picture | None) -> None:
        self._chosen = chosen
        self.button.setVisible(chosen is not None)
        self.sheet.model().mark(lambda picture: picture is chosen)

    def _take_over(self) -> None:
        if self._chosen is not None:
            self.wanted.emit(self._works[id(self._chosen)])

    def _describe(self, picture: Picture, chosen: bool) -> tuple[str, str]:
        work = self._works[id(picture)]
        name = f"strength {work.strength:.0%}, seed {work.seed}"
        return name, f"{name.capitalize()}\nClick to see it large, double-click to use its settings"
