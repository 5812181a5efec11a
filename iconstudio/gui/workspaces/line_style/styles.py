"""The styles to choose from, each shown by a sample."""

from collections.abc import Iterable, Sequence

from PySide6.QtCore import Signal
from PySide6.QtGui import QAction, QPainterPath
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
from iconstudio.model import Icon, LineStyle, Path
from iconstudio.session import Session

_SIDE = 10 * UNIT


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
        self._drawn: dict[LineStyle, Picture] = {}
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
        """Draw the samples, which takes a while, now that they are in sight."""
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
        ticked = [self._drawn[one] for one in self._used if one in self._drawn]
        self.sheet.model().mark(lambda picture: any(picture is one for one in ticked))

    def _reveal(self) -> None:
        """Scroll to the style of most lines."""
        if self._used and (picture := self._drawn.get(self._used[0])) is not None:
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
            self._drawn[event.style] = event.picture or _nothing(event.style)
            self._show()
            if self._used[:1] == (event.style,):
                self._reveal()

    def _show(self) -> None:
        self._drawn = {one: self._drawn[one] for one in self.styles if one in self._drawn}
        self._styles = {id(picture): style for style, picture in self._drawn.items()}
        self._mark()
        show_in_place(self.sheet, tuple(self._drawn.values()))


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


def _nothing(style: LineStyle) -> Picture:
    """Return a picture of a style that makes nothing of the sample."""
    return Picture(Icon(Path(()), style.name), QPainterPath())


def _described(picture: Picture, used: bool) -> tuple[str, str]:
    name = picture.title.removeprefix("lines, ")
    return (f"{name}, in use" if used else name), name
