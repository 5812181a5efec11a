"""Name the object, see which icons that finds, and remix."""

from collections.abc import Sequence

from PySide6.QtCore import Qt, Signal
from PySide6.QtWidgets import (
    QFrame,
    QHBoxLayout,
    QPushButton,
    QVBoxLayout,
    QWidget,
)

from iconstudio.gui.gallery.thumbnails import Thumbnails
from iconstudio.gui.panels.caption import Caption
from iconstudio.gui.panels.wordfield import Key, WordField
from iconstudio.gui.theme.theme import UNIT
from iconstudio.model import Exemplar


class KeywordField(WordField):
    """A text field that leaves undo and redo to the document."""

    others = (Key.Undo, Key.Redo)


class KeywordPanel(QFrame):
    """The keyword field, the Remix button, and thumbnails of what the keyword finds.

    Signals
    -------
    edited(str)
        The user typed.
    run()
        The user pressed Remix or Enter.
    toggled(str)
        An icon is to be left out, or taken back.
    restored()
        All icons that were left out are to be taken back.
    """

    edited = Signal(str)
    run = Signal()
    toggled = Signal(str)
    restored = Signal()

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setProperty("card", True)
        self.field = KeywordField(placeholderText="What is it? For example: motorcycle")
        self.field.setAccessibleName("What the object is")
        self.field.setClearButtonEnabled(True)
        self.button = QPushButton("Remix")
        self.button.setProperty("primary", True)
        self.button.setToolTip("Make new icons in four styles (Ctrl+Return)")
        self.caption = Caption()
        self.caption.setTextInteractionFlags(Qt.TextInteractionFlag.LinksAccessibleByMouse)
        self.thumbnails = Thumbnails()
        self._found = 0

        row = QHBoxLayout()
        row.setSpacing(UNIT)
        row.addWidget(self.field, 1)
        row.addWidget(self.button)
        layout = QVBoxLayout(self)
        layout.setContentsMargins(UNIT * 3 // 2, UNIT * 3 // 2, UNIT * 3 // 2, UNIT)
        layout.setSpacing(UNIT)
        layout.addLayout(row)
        layout.addWidget(self.caption)
        layout.addWidget(self.thumbnails, 1)

        self.field.textEdited.connect(self.edited)
        self.field.returnPressed.connect(self.run)
        self.button.clicked.connect(self.run)
        self.thumbnails.toggled.connect(self.toggled)
        self.caption.linkActivated.connect(self.restored)
        self.set_searching("")

    def set_words(self, placeholder: str, tip: str) -> None:
        """Say what to type, and what the button does."""
        self.field.setPlaceholderText(placeholder)
        self.button.setToolTip(tip)

    def set_sketch(self, keyword: str, excluded: frozenset[str]) -> None:
        """Show what the document says."""
        if self.field.text() != keyword:
            self.field.setText(keyword)
        if self.thumbnails.sheet().excluded != excluded:
            self.thumbnails.sheet().set_excluded(excluded)
            if self._found:
                self._tell_found()

    def set_searching(self, keyword: str) -> None:
        """Say that ``keyword`` is being looked up, or what to do if there is none."""
        self._found = 0
        self.thumbnails.sheet().clear()
        self.caption.say(
            f"Looking for “{keyword}”…"
            if keyword
            else "The name finds the icons whose parts are used."
        )

    def show_exemplars(self, exemplars: Sequence[Exemplar]) -> None:
        """Show what the keyword found."""
        self._found = len(exemplars)
        self.thumbnails.sheet().show(exemplars)
        self._tell_found()

    def show_error(self, message: str) -> None:
        """Say why the keyword cannot be used."""
        self._found = 0
        self.thumbnails.sheet().clear()
        self.caption.say(message, error=True)

    def _tell_found(self) -> None:
        icons = "1 icon" if self._found == 1 else f"{self._found} icons"
        out = len(self.thumbnails.sheet().excluded)
        if out:
            undo = "<a href='#'>use all again</a>"
            self.caption.say(f"{icons} found · {out} left out · {undo}", links=True)
        else:
            self.caption.say(f"{icons} found · click one to leave it out")
