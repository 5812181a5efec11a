"""The column where icons are gathered, and the column where hybrids appear."""

import random

from PySide6.QtCore import QSize, Qt, Signal
from PySide6.QtWidgets import (
    QFrame,
    QHBoxLayout,
    QLabel,
    QLineEdit,
    QPushButton,
    QSpinBox,
    QStackedWidget,
    QToolButton,
    QVBoxLayout,
    QWidget,
)

from iconstudio.gui.gallery.pictures import Picture
from iconstudio.gui.gallery.sheet import Sheet
from iconstudio.gui.gallery.sheet_delegate import Look, Mark
from iconstudio.gui.panels.caption import Caption
from iconstudio.gui.panels.chooser import IconChooser
from iconstudio.gui.panels.symmetry import WORDS, SymmetryButton
from iconstudio.gui.theme import icons
from iconstudio.gui.theme.theme import UNIT
from iconstudio.gui.workspaces.hybrids.cards import COLUMNS, SIDE, Cards
from iconstudio.gui.workspaces.hybrids.hover_bar import HoverBar
from iconstudio.gui.workspaces.hybrids.sections import Sections, terms
from iconstudio.model import Axis
from iconstudio.workflows.hybrids.file import LARGEST_SEED
from iconstudio.workflows.hybrids.hybrids import FEWEST, MOST
from iconstudio.workflows.hybrids.page import HybridsPage

WIDTH = COLUMNS * SIDE + (COLUMNS - 1) * UNIT // 2 + 4 * UNIT + 2
"""Of the column of icons: as many cards as stand in a row."""

_LOOK = Look(12 * UNIT, mark=Mark.STAR, picks=True, fills=True)


class SeedField(QWidget):
    """The number that the random draws depend on, and a dice that throws another.

    Signals
    -------
    changed(object)
        The user wants this seed, a whole number.
    """

    changed = Signal(object)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.field = QLineEdit()
        self.field.setFixedWidth(11 * UNIT)
        self.field.setMaxLength(len(str(LARGEST_SEED)))
        self.field.setAccessibleName("Random seed")
        self.field.setToolTip("Random seed: the same number gives the same hybrids")
        self.dice = QToolButton(toolTip="Draw other hybrids: another random seed")
        self.dice.setAccessibleName("Another random seed")
        self.dice.setIcon(icons.icon("dice"))
        self.dice.setIconSize(QSize(20, 20))
        label = QLabel("Seed")
        label.setProperty("muted", True)
        label.setBuddy(self.field)
        row = QHBoxLayout(self)
        row.setContentsMargins(0, 0, 0, 0)
        row.setSpacing(UNIT // 2)
        row.addWidget(label)
        row.addWidget(self.field)
        row.addWidget(self.dice)
        self.field.textEdited.connect(self._read)
        self.dice.clicked.connect(lambda: self.changed.emit(random.randrange(10_000)))

    def set_seed(self, seed: int) -> None:
        """Show the seed."""
        typed = self.field.text()
        if (int(typed) if typed.isdigit() else None) != seed and (
            typed or not self.field.hasFocus()
        ):
            self.field.setText(str(seed))

    def _read(self, text: str) -> None:
        digits = "".join(c for c in text if c in "0123456789")
        if digits != text:
            self.field.setText(digits)
        self.changed.emit(min(int(digits or 0), LARGEST_SEED))


class PickRow(QWidget):
    """“Pick 5 for me”.

    Signals
    -------
    requested(int)
        So many icons are to be picked.
    """

    requested = Signal(int)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.count = QSpinBox(minimum=FEWEST, maximum=MOST, value=5)
        self.count.setAccessibleName("How many icons to pick")
        self.count.setFixedSize(7 * UNIT, 4 * UNIT)
        self.button = QPushButton("Pick for me")
        self.button.setToolTip("Let the program pick icons of this name that mix well")
        words = QLabel("icons that mix well")
        words.setProperty("muted", True)
        row = QHBoxLayout(self)
        row.setContentsMargins(0, 0, 0, 0)
        row.setSpacing(UNIT)
        row.addWidget(self.button)
        row.addWidget(self.count)
        row.addWidget(words, 1)
        self.button.clicked.connect(lambda: self.requested.emit(self.count.value()))


class IconsColumn(QWidget):
    """Find icons above, what was gathered below, and how to mix it."""

    def __init__(self, chooser: IconChooser, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setFixedWidth(WIDTH)
        self.chooser = chooser
        self.pick = PickRow()
        self.cards = Cards()
        self.symmetry = SymmetryButton()
        self.offer = QPushButton("All are nearly symmetric · Hold to symmetry")
        self.offer.setProperty("pill", True)
        self.offer.setCursor(Qt.CursorShape.PointingHandCursor)
        self.seed = SeedField()
        self.run = QPushButton("Mix")
        self.run.setProperty("primary", True)
        self._count = QLabel()
        self._count.setProperty("heading", True)
        self._hint = Caption()
        finding, gathered = QFrame(), QFrame()
        for card in (finding, gathered):
            card.setProperty("card", True)
        above = QVBoxLayout(finding)
        above.addWidget(chooser, 1)
        above.addWidget(self.pick)
        settings = QHBoxLayout()
        settings.setSpacing(UNIT)
        settings.addWidget(self.symmetry)
        settings.addWidget(self.seed)
        settings.addStretch()
        settings.addWidget(self.run)
        below = QVBoxLayout(gathered)
        below.addWidget(self._count)
        below.addWidget(self._hint)
        below.addWidget(self.cards, 1)
        below.addWidget(self.offer)
        below.addLayout(settings)
        for inner in (above, below):
            inner.setContentsMargins(UNIT * 3 // 2, UNIT * 3 // 2, UNIT * 3 // 2, UNIT * 3 // 2)
            inner.setSpacing(UNIT)
        column = QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        column.setSpacing(UNIT)
        column.addWidget(finding, 5)
        column.addWidget(gathered, 6)

    def show_page(self, page: HybridsPage, offered: Axis | None) -> None:
        """Show what is to be mixed; ``offered`` is a symmetry that all icons nearly have."""
        count = len(page.ingredients)
        self._count.setText(f"Icons to mix · {count}" if count else "Icons to mix")
        self._hint.say(
            "Click a part on an icon to pin it: every hybrid keeps it."
            if count
            else f"Choose {FEWEST} to {MOST} icons above, or drop icons and files here."
        )
        self.cards.show_icons(page.ingredients, page.symmetry)
        self.chooser.set_taken(page.ids)
        self.symmetry.set_axis(page.symmetry)
        self.offer.setVisible(offered is not None)
        self.offer.setToolTip(WORDS[offered] if offered else "")
        self.seed.set_seed(page.seed)


class SheetPanel(QFrame):
    """The sheet with its title; a welcome as long as it is empty.

    Signals
    -------
    back()
        The user wants to see the whole sheet again.
    """

    back = Signal()

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setProperty("card", True)
        self.sheet = Sheet(_LOOK, _described, "Hybrids")
        self.bar = HoverBar(self.sheet)
        self.sections = Sections(self.sheet, self.bar)
        self.title = QLabel("Hybrids")
        self.title.setProperty("title", True)
        self.note = QLabel()
        self.note.setProperty("muted", True)
        self.button = QPushButton("Whole sheet", toolTip="Go back to all hybrids")
        self.button.setIcon(icons.icon("back"))
        self.button.clicked.connect(self.back)
        policy = self.button.sizePolicy()
        policy.setRetainSizeWhenHidden(True)
        self.button.setSizePolicy(policy)
        self.button.hide()
        top = QHBoxLayout()
        top.setContentsMargins(UNIT // 2, 0, UNIT, 0)
        top.setSpacing(UNIT)
        top.addWidget(self.title)
        top.addWidget(self.note, 1)
        top.addWidget(self.button)
        self._stack = QStackedWidget()
        self._stack.addWidget(self._welcome())
        self._stack.addWidget(self.sheet)
        layout = QVBoxLayout(self)
        layout.setContentsMargins(UNIT, UNIT, UNIT // 2, UNIT // 2)
        layout.setSpacing(UNIT // 2)
        layout.addLayout(top)
        layout.addWidget(self._stack, 1)

    def show_welcome(self, welcome: bool) -> None:
        """Show the welcome, or the sheet."""
        self._stack.setCurrentIndex(0 if welcome else 1)

    def show_section(self, title: str) -> None:
        """Offer the way back if a section is shown alone; ``title`` is empty if none is."""
        self.button.setVisible(bool(title))

    def _welcome(self) -> QWidget:
        title = QLabel("Be surprised by mixtures of icons")
        title.setProperty("title", True)
        words = QLabel(
            "Choose a few icons on the left, or type a word and let the program pick them.\n"
            "Press Mix: their parts are put together at random, the best first."
        )
        words.setProperty("muted", True)
        self.start = QPushButton("Try an example")
        page = QWidget()
        column = QVBoxLayout(page)
        column.setSpacing(UNIT)
        column.addStretch()
        for part in (title, words):
            part.setAlignment(Qt.AlignmentFlag.AlignCenter)
        for part in (title, words, self.start):
            column.addWidget(part, 0, Qt.AlignmentFlag.AlignHCenter)
        column.addStretch()
        return page


def _described(picture: Picture, kept: bool) -> tuple[str, str]:
    return picture.title, f"{picture.title.capitalize()}\n{terms(picture)}"
