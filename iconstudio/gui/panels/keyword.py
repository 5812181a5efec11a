"""Name the object, see which icons that finds, and remix."""

from PySide6.QtCore import QPoint, Qt, Signal
from PySide6.QtWidgets import QMenu

from iconstudio.gui.gallery.sending import pop_up
from iconstudio.gui.gallery.sheet import Sheet
from iconstudio.gui.gallery.sheet_delegate import Look, Mark
from iconstudio.gui.gallery.sheet_model import Entry, Rule, credited
from iconstudio.gui.panels.search import IconSearch
from iconstudio.gui.panels.wordfield import Key, WordField
from iconstudio.gui.theme.layout import push_button, with_role
from iconstudio.gui.theme.theme import UNIT
from iconstudio.model import Exemplar
from iconstudio.workflows import criteria as edits
from iconstudio.workflows.criteria import CriteriaDocument
from iconstudio.workflows.events import Retrieved

_LESS_ALIKE = Rule("Less alike: click one to bring it in")


class KeywordField(WordField):
    """A text field that leaves undo and redo to the document."""

    others = (Key.Undo, Key.Redo)


class KeywordPanel(IconSearch):
    """The keyword field, the Remix button, and thumbnails of what it finds: edits the page.

    A click on a thumbnail, Space or its menu leaves an icon out, or takes it back. Icons that are
    less alike than the others stand behind these, until they are brought in.

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
        sheet = Sheet(
            Look(44, margin=6, mark=Mark.STRUCK, fills=True), self._describe, "Icons found"
        )
        margins = UNIT * 3 // 2, UNIT * 3 // 2, UNIT * 3 // 2, UNIT
        start = "The name finds the icons whose parts are used."
        super().__init__(field, button, sheet, start, margins)
        self._document = document
        with_role(self, "card")
        self.caption.setTextInteractionFlags(Qt.TextInteractionFlag.LinksAccessibleByMouse)
        self.menu: QMenu | None = None
        self._excluded = self._included = self._strangers = frozenset[str]()
        self._icons: list[Exemplar] = []
        self._found, self._remark = 0, ""
        button.clicked.connect(self.run)
        self.field.textEdited.connect(lambda text: edits.set_keyword(document, text, field.gesture))
        self.field.returnPressed.connect(self.run)
        self.sheet.chosen.connect(self._toggle)
        self.sheet.asked.connect(self._open_menu)
        self.caption.linkActivated.connect(lambda _: edits.exclude_icons(document, frozenset()))

    def set_sketch(
        self, keyword: str, excluded: frozenset[str], included: frozenset[str] = frozenset()
    ) -> None:
        """Show what the document says."""
        if self.field.text() != keyword:
            self.field.setText(keyword)
        if self._excluded != excluded:
            self._excluded = excluded
            self.sheet.model().mark(lambda icon: icon.id in excluded)
            if self._found:
                self._tell_found()
        if self._included != included:
            self._included = included
            self.sheet.show_entries(self._in_order())

    def set_searching(self, keyword: str) -> None:
        """Say that ``keyword`` is being looked up, or what to do if there is none."""
        self._clear()
        self.tell_searching(keyword)

    def show_retrieved(self, event: Retrieved) -> None:
        """Show what the keyword found; icons in sight that were left out stay in their places."""
        self.field.end_entry()
        self._found, self._remark = len(event.exemplars), event.remark
        self._strangers = event.strangers
        found = {icon.id for icon in event.exemplars}
        merged = list(event.exemplars)
        for place, icon in enumerate(self._icons):
            if icon.id in self._excluded and icon.id not in found:
                merged.insert(min(place, len(merged)), icon)
        self._icons = merged
        self.sheet.show_entries(self._in_order())
        self._tell_found()

    def show_error(self, message: str) -> None:
        """Say why the keyword cannot be used."""
        self._clear()
        self.caption.say(message, error=True)

    def _in_order(self) -> list[Entry]:
        """Return the icons; those less alike behind a rule, unless they were brought in."""
        behind = self._strangers - self._included
        alike = [icon for icon in self._icons if icon.id not in behind]
        less = [icon for icon in self._icons if icon.id in behind]
        return [*alike, _LESS_ALIKE, *less] if less else alike

    def _toggle(self, icon: Exemplar) -> None:
        """Leave an icon out, or take it back; bring in one that is less alike, or not."""
        if icon.id in self._strangers:
            edits.toggle_stranger(self._document, icon.id)
        else:
            edits.toggle_icon(self._document, icon.id)

    def _clear(self) -> None:
        self._found, self._icons = 0, []
        self.sheet.show_entries(())

    def _open_menu(self, icon: Exemplar, spot: QPoint) -> None:
        menu = self.menu = QMenu(self)
        if icon.id in self._strangers - self._included:
            words = "Bring this icon in"
        else:
            out = icon.id in self._excluded
            words = "Use this icon again" if out else "Leave this icon out"
        menu.addAction(words, lambda: self._toggle(icon))
        pop_up(menu, spot)

    def _tell_found(self) -> None:
        if out := len(self._excluded):
            undo = "<a href='#'>use all again</a>"
            self.tell_found(self._found, f"{out} left out", undo, remark=self._remark, links=True)
        else:
            self.tell_found(self._found, "click one to leave it out", remark=self._remark)

    def _describe(self, icon: Exemplar, out: bool) -> tuple[str, str]:
        if icon.id in self._strangers - self._included:
            used = "Used only where there are too few others. Click to bring it in"
            return f"{icon.name}, less alike", f"{credited(icon)}\n{used}"
        name = f"{icon.name}, left out" if out else icon.name
        return name, f"{credited(icon)}\nClick to {'use it again' if out else 'leave it out'}"
