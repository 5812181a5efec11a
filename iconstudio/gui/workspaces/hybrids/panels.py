"""The column where icons are gathered, and the column where hybrids appear."""

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QFrame, QSpinBox, QStackedWidget, QWidget

from iconstudio.gui.gallery.display import DisplaySwitch
from iconstudio.gui.gallery.sheet import Sheet
from iconstudio.gui.gallery.sheet_delegate import Look, Mark
from iconstudio.gui.gallery.tidiness import tidy_switch
from iconstudio.gui.jobs.worker import Worker
from iconstudio.gui.panels.chooser import IconChooser
from iconstudio.gui.panels.seed import SeedField
from iconstudio.gui.panels.symmetry import WORDS, SymmetryButton
from iconstudio.gui.pictures.picture import Picture
from iconstudio.gui.theme import icons
from iconstudio.gui.theme.caption import Caption
from iconstudio.gui.theme.layout import (
    card,
    column,
    hidden,
    label,
    push_button,
    row,
    scrolled,
    with_role,
)
from iconstudio.gui.theme.theme import UNIT
from iconstudio.gui.workspaces.hybrids.cards import COLUMNS, SIDE, Cards
from iconstudio.gui.workspaces.hybrids.hover_bar import HoverBar
from iconstudio.gui.workspaces.hybrids.sections import Sections
from iconstudio.session import Session
from iconstudio.workflows.hybrids import page as edits
from iconstudio.workflows.hybrids.file import LARGEST_SEED
from iconstudio.workflows.hybrids.hybrids import FEWEST, MOST
from iconstudio.workflows.hybrids.page import HybridsDocument, HybridsPage

WIDTH = COLUMNS * SIDE + (COLUMNS - 1) * UNIT // 2 + 4 * UNIT + 2
"""Of the column of icons: as many cards as stand in a row."""

_LOOK = Look(12 * UNIT, mark=Mark.STAR, picks=True, fills=True, coded=True, tidies=True)


class IconsColumn(QWidget):
    """Find icons above, what was gathered below, and how to mix it: edits the page."""

    def __init__(self, document: HybridsDocument, session: Session, worker: Worker) -> None:
        super().__init__()
        self.setFixedWidth(WIDTH)
        self.chooser = IconChooser(session, worker, multiple=True)
        self.count = QSpinBox(minimum=FEWEST, maximum=MOST, value=5)
        self.count.setAccessibleName("How many icons to pick")
        self.count.setFixedSize(7 * UNIT, 4 * UNIT)
        self.count.lineEdit().setTextMargins(UNIT, 0, 0, 0)
        tip = "Let the program pick icons of this name that mix well"
        self.pick = push_button("Pick for me", tip)
        self.cards = Cards(document)
        self.symmetry = SymmetryButton()
        words = "All are nearly symmetric · Hold to symmetry"
        self.offer = push_button(words, role="pill")
        self.offer.setCursor(Qt.CursorShape.PointingHandCursor)
        self.seed = SeedField(LARGEST_SEED, "hybrids")
        self.run = push_button("Mix", role="primary")
        self._gathered = label(role="heading")
        self._hint = Caption()
        wide = (UNIT * 3 // 2,) * 4
        settings = row(self.symmetry, self.seed, None, self.run)
        area = scrolled(self.cards, focusPolicy=Qt.FocusPolicy.NoFocus)
        gathered = self._gathered, self._hint, (area, 1), self.offer, settings
        picking = row(self.pick, self.count, (label("icons that mix well"), 1))
        finding = card((self.chooser, 1), picking, margins=wide)
        column((finding, 5), (card(*gathered, margins=wide), 6), of=self)
        self._wire(document)

    def _wire(self, document: HybridsDocument) -> None:
        self.chooser.released.connect(lambda one: edits.remove_icon(document, one.id))
        self.symmetry.chosen.connect(lambda axis: edits.set_symmetry(document, axis))
        self.offer.clicked.connect(
            lambda: edits.set_symmetry(document, edits.shared_axis(document.page))
        )
        self.seed.changed.connect(lambda seed: edits.set_seed(document, seed, self.seed.gesture))

    def show_page(self, page: HybridsPage) -> None:
        """Show what is to be mixed, and offer a symmetry that all icons nearly have."""
        count = len(page.ingredients)
        self._gathered.setText(f"Icons to mix · {count}" if count else "Icons to mix")
        self._hint.say(
            "Click a part on an icon to pin it: every hybrid keeps it."
            if count
            else f"Choose {FEWEST} to {MOST} icons above, or drop icons and files here."
        )
        self.cards.show_icons(page.ingredients, page.symmetry)
        self.chooser.set_taken(page.ids)
        self.symmetry.set_axis(page.symmetry)
        offered = edits.shared_axis(page) if page.symmetry is None else None
        self.offer.setVisible(offered is not None)
        self.offer.setToolTip(WORDS[offered] if offered else "")
        self.seed.set_seed(page.seed)
        problem = edits.problem(page.mix)
        self.run.setEnabled(not problem)
        self.run.setToolTip(problem or "Draw hybrids of the icons (Ctrl+Return)")


class SheetPanel(QFrame):
    """The sheet with its title; a welcome as long as it is empty.

    ``button`` leads back to the whole sheet; who shows a part of it shows the button, too.
    """

    def __init__(self) -> None:
        super().__init__()
        with_role(self, "card")
        self.sheet = Sheet(_LOOK, _described, "Hybrids")
        self.bar = HoverBar(self.sheet)
        self.sections = Sections(self.sheet, self.bar)
        self.note = label()
        self.button = hidden(push_button("Whole sheet", "Go back to all hybrids"))
        self.button.setIcon(icons.icon("back"))
        self._stack = QStackedWidget()
        self._stack.addWidget(self._welcome())
        self._stack.addWidget(self.sheet)
        title = label("Hybrids", "title")
        self.tidy_switch = tidy_switch()
        parts = title, (self.note, 1), self.button, self.tidy_switch, DisplaySwitch()
        top = row(*parts, margins=(UNIT // 2, 0, UNIT, 0))
        half = UNIT // 2
        column(top, (self._stack, 1), of=self, spacing=half, margins=(UNIT, UNIT, half, half))

    def show_welcome(self, welcome: bool) -> None:
        """Show the welcome, or the sheet."""
        self._stack.setCurrentIndex(0 if welcome else 1)

    def _welcome(self) -> QWidget:
        middle = Qt.AlignmentFlag.AlignCenter
        title = label("Be surprised by mixtures of icons", "title", alignment=middle)
        words = label(
            "Choose a few icons on the left, or type a word and let the program pick them.\n"
            "Press Mix: their parts are put together at random, the best first.",
            alignment=middle,
        )
        self.start = push_button("Try an example")
        page = QWidget()
        column(None, title, words, row(None, self.start, None), None, of=page)
        return page


def _described(picture: Picture, kept: bool) -> tuple[str, str]:
    return picture.title, f"{picture.title.capitalize()}\n{edits.terms(picture.icon.score)}"
