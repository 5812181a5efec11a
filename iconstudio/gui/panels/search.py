"""Icons are looked up by a word, and shown."""

from html import escape

from PySide6.QtWidgets import QFrame, QPushButton, QWidget

from iconstudio.grammar import counted
from iconstudio.gui.gallery.sheet import Sheet
from iconstudio.gui.panels.wordfield import WordField
from iconstudio.gui.theme.caption import Caption
from iconstudio.gui.theme.layout import column, row


class IconSearch(QFrame):
    """A field for a word, a button, thumbnails of what is found, and a caption that tells of it.

    Parameters
    ----------
    start
        What the caption says as long as there is no word.
    """

    def __init__(
        self,
        field: WordField,
        button: QPushButton,
        sheet: Sheet,
        start: str,
        margins: tuple[int, int, int, int] = (0, 0, 0, 0),
    ) -> None:
        super().__init__()
        self.field, self.button, self.sheet = field, button, sheet
        self.caption = Caption()
        self._start = start
        field.setClearButtonEnabled(True)
        self._line = row((field, 1), button)
        column(self._line, self.caption, (sheet, 1), of=self, margins=margins)
        self.tell_searching("")

    def put_beside(self, widget: QWidget) -> None:
        """Put a widget between the field and the button."""
        self._line.insertWidget(1, widget)

    def tell_searching(self, keyword: str) -> None:
        """Say that a word is being looked up, or what to do if there is none."""
        self.caption.say(f"Looking for “{keyword}”…" if keyword else self._start)

    def tell_found(self, count: int, *more: str, remark: str = "", links: bool = False) -> None:
        """Say how many icons were found, what can be done with them, and how the word was read."""
        told = " · ".join((f"{counted(count, 'icon')} found", *more))
        said = escape(remark) if links else remark
        self.caption.say(f"{said} {told}" if remark else told, links=links)
