"""The styles to choose from: each is shown by its name, then by a sample."""

from collections.abc import Iterable, Sequence

from PySide6.QtCore import Signal
from PySide6.QtGui import QAction, QFont, QFontMetricsF, QPainterPath, QTransform
from PySide6.QtWidgets import QFrame, QToolButton

from iconstudio.gui.gallery.sheet import Sheet
from iconstudio.gui.gallery.sheet_delegate import Look
from iconstudio.gui.jobs.runner import Runner
from iconstudio.gui.jobs.worker import Worker
from iconstudio.gui.pictures.picture import Picture
from iconstudio.gui.theme.elided import ElidedLabel
from iconstudio.gui.theme.layout import card, label, row
from iconstudio.gui.theme.theme import UNIT
from iconstudio.gui.workspaces.line_style.live import Sample, samples
from iconstudio.gui.workspaces.line_style.own_styles import known_styles
from iconstudio.inputs.styles import bundled
from iconstudio.model import CANVAS, Icon, LineStyle, Path
from iconstudio.session import Session

_SIDE = 10 * UNIT
_LETTERS, _ROOM = 52, 236.0
"""Height of a name's letters, and how wide it is at most, in canvas units."""


class StylesPanel(QFrame):
    """A sheet of the styles that come with the program, after the user's own.

    Signals
    -------
    chosen(LineStyle)
        The user wants this style.
    """

    chosen = Signal(object)

    def __init__(self, session: Session, worker: Worker, actions: Iterable[QAction]) -> None:
        super().__init__()
        self._session = session
        self._begun = False
        self._used: tuple[LineStyle, ...] = ()
        self._own: tuple[LineStyle, ...] = ()
        self._drawn: set[LineStyle] = set()
        self._shown: dict[LineStyle, Picture] = {}
        self._styles: dict[int, LineStyle] = {}
        """By the identities of their pictures."""
        self.runner = Runner(worker, self)
        self.runner.event.connect(self._show_sample)
        self._reading = Runner(worker, self)
        self._reading.event.connect(self.add)
        self.sheet = Sheet(Look(_SIDE, margin=9), _described, "Line styles")
        self.sheet.chosen.connect(lambda picture: self.chosen.emit(self._styles[id(picture)]))
        self._name = ElidedLabel("")
        self._name.setProperty("muted", True)
        title = label("Line style", "title")
        top = row(title, (self._name, 1), *map(_button, actions), spacing=UNIT)
        row(card(top, (self.sheet, 1)), of=self)

    @property
    def styles(self) -> tuple[LineStyle, ...]:
        """The styles, in their order."""
        return (*self._own, *bundled())

    def begin(self) -> None:
        """Show the styles, and draw their samples, which takes a while the first time."""
        if not self._begun:
            self._begun = True
            self._reading.start(known_styles)
            self._draw()

    def add(self, style: LineStyle) -> None:
        """Add a style of the user's own, in front; it takes the place of one of the same name."""
        if style not in self.styles:
            self._own = (style, *(one for one in self._own if one.name != style.name))
            self._draw()

    def show_used(self, used: Sequence[LineStyle]) -> None:
        """Tick the styles that are in use."""
        self._name.setText(", ".join(style.name for style in used))
        changed, self._used = self._used != tuple(used), tuple(used)
        self._mark()
        if changed:
            self._reveal()

    def _mark(self) -> None:
        ticked = [self._shown[one] for one in self._used if one in self._shown]
        self.sheet.model().mark(lambda picture: any(picture is one for one in ticked))

    def _reveal(self) -> None:
        """Scroll to the style of most lines."""
        if self._used and (picture := self._shown.get(self._used[0])) is not None:
            self.sheet.reveal(picture)

    def _draw(self) -> None:
        if not self._begun:
            return
        self._show()
        missing = tuple(one for one in self.styles if one not in self._drawn)
        if missing:
            session = self._session
            self.runner.start(lambda: samples(session, missing))

    def _show_sample(self, event: object) -> None:
        if isinstance(event, Sample):
            style, picture = event.style, event.picture
            self._drawn.add(style)
            if picture is not None and style in self._shown:
                self.sheet.model().put(self._shown[style], picture)
                self._shown[style] = picture
                self._name_pictures()

    def _show(self) -> None:
        self._shown = {one: self._shown.get(one) or _named(one) for one in self.styles}
        self._name_pictures()
        show_in_place(self.sheet, tuple(self._shown.values()))

    def _name_pictures(self) -> None:
        self._styles = {id(picture): style for style, picture in self._shown.items()}
        self._mark()


def show_in_place(sheet: Sheet, pictures: Sequence[Picture]) -> None:
    """Show other pictures on a sheet; it stays scrolled as it is."""
    bar = sheet.verticalScrollBar()
    place = bar.value()
    sheet.show_entries(pictures)
    sheet.executeDelayedItemsLayout()
    bar.setValue(place)


def _button(action: QAction) -> QToolButton:
    button = QToolButton()
    button.setDefaultAction(action)
    button.setAccessibleName(action.iconText())
    return button


def _named(style: LineStyle) -> Picture:
    """Return the name of a style, a line for each word, as its picture."""
    font, words = QFont(), style.name.split()
    font.setPixelSize(_LETTERS)
    outline = QPainterPath()
    for number, word in enumerate(words):
        width = QFontMetricsF(font).horizontalAdvance(word)
        outline.addText(-width / 2, _LETTERS * (number + 0.8), font, word)
    box = outline.boundingRect()
    scale = min(1.0, _ROOM / max(box.width(), box.height(), 1.0))
    middle = QTransform.fromTranslate(CANVAS / 2, CANVAS / 2).scale(scale, scale)
    middle.translate(-box.center().x(), -box.center().y())
    return Picture(Icon(Path(()), style.name), middle.map(outline))


def _described(picture: Picture, used: bool) -> tuple[str, str]:
    name = picture.title.removeprefix("lines, ")
    return (f"{name}, in use" if used else name), name
