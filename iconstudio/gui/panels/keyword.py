"""Name the object, see which icons that finds, and remix."""

from collections.abc import Sequence

from PySide6.QtCore import QPoint, Qt, Signal
from PySide6.QtWidgets import QMenu

from iconstudio.gui.gallery.sending import pop_up
from iconstudio.gui.gallery.sheet import Sheet
from iconstudio.gui.gallery.sheet_delegate import Look, Mark
from iconstudio.gui.gallery.sheet_model import credited
from iconstudio.gui.panels.search import IconSearch
from iconstudio.gui.panels.wordfield import Key, WordField
from iconstudio.gui.theme.layout import push_button, with_role
from iconstudio.gui.theme.theme import UNIT
from iconstudio.model import Exemplar
from iconstudio.workflows import criteria as edits
from iconstudio.workflows.criteria import CriteriaDocument


class KeywordField(WordField):
    """A text field that leaves undo and redo to the document."""

    others = (Key.Undo, Key.Redo)


class KeywordPanel(IconSearch):
    """The keyword field, the Remix button, and thumbnails of what it finds: edits the page.

    A click on a thumbnail, Space or its menu leaves an icon out, or takes it back.

    Signals
    -------
    run()
        The user pressed Remix or Enter.
    """

    run = Signal()

    def __init__(self, document: CriteriaDocument, placeholder: str, tip: str) -> None:
        """``placeholder`` says what to type, and ``tip`` what the button does."""
        field = KeywordField(placeholderText=placeholder)
        field.setAccessibleName("What the object is")
        button = push_button("Remix", tip, role="primary")
        sheet = Sheet(Look(44, margin=6, mark=Mark.STRUCK), _described, "Icons found")
        margins = UNIT * 3 // 2, UNIT * 3 // 2, UNIT * 3 // 2, UNIT
        start = "The name finds the icons whose parts are used."
        super().__init__(field, button, sheet, start, margins)
        self._document = document
        with_role(self, "card")
        self.caption.setTextInteractionFlags(Qt.TextInteractionFlag.LinksAccessibleByMouse)
        self.menu: QMenu | None = None
        self._excluded: frozenset[str] = frozenset()
        self._found, self._remark = 0, ""
        button.clicked.connect(self.run)
        self.field.textEdited.connect(lambda text: edits.set_keyword(document, text, field.gesture))
        self.field.returnPressed.connect(self.run)
        self.sheet.chosen.connect(lambda icon: edits.toggle_icon(document, icon.id))
        self.sheet.asked.connect(self._open_menu)
        self.caption.linkActivated.connect(lambda _: edits.exclude_icons(document, frozenset()))

    def set_sketch(self, keyword: str, excluded: frozenset[str]) -> None:
        """Show what the document says."""
        if self.field.text() != keyword:
            self.field.setText(keyword)
        if self._excluded != excluded:
            self._excluded = excluded
            self.sheet.model().mark(lambda icon: icon.id in excluded)
            if self._found:
                self._tell_found()

    def set_searching(self, keyword: str) -> None:
        """Say that ``keyword`` is being looked up, or what to do if there is none."""
        self._clear()
        self.tell_searching(keyword)

    def show_exemplars(self, exemplars: Sequence[Exemplar], remark: str = "") -> None:
        """Show what the keyword found; icons in sight that were left out stay in their places.

        ``remark`` says how the keyword was read if not as typed.
        """
        self.field.end_entry()
        self._found, self._remark = len(exemplars), remark
        found = {icon.id for icon in exemplars}
        merged = list(exemplars)
        for place, icon in enumerate(self.sheet.model().entries):
            if icon.id in self._excluded and icon.id not in found:
                merged.insert(min(place, len(merged)), icon)
        self.sheet.show_entries(merged)
        self._tell_found()

    def show_error(self, message: str) -> None:
        """Say why the keyword cannot be used."""
        self._clear()
        self.caption.say(message, error=True)

    def _clear(self) -> None:
        self._found = 0
        self.sheet.show_entries(())

    def _open_menu(self, icon: Exemplar, spot: QPoint) -> None:
        out = icon.id in self._excluded
        menu = self.menu = QMenu(self)
        words = "Use this icon again" if out else "Leave this icon out"
        menu.addAction(words, lambda: edits.toggle_icon(self._document, icon.id))
        pop_up(menu, spot)

    def _tell_found(self) -> None:
        if out := len(self._excluded):
            undo = "<a href='#'>use all again</a>"
            self.tell_found(self._found, f"{out} left out", undo, remark=self._remark, links=True)
        else:
            self.tell_found(self._found, "click one to leave it out", remark=self._remark)


def _described(icon: Exemplar, out: bool) -> tuple[str, str]:
    name = f"{icon.name}, left out" if out else icon.name
    return name, f"{credited(icon)}\nClick to {'use it again' if out else 'leave it out'}"
