"""Choose icons to work on: look them up by a word, or open a drawing of one's own."""

from collections.abc import Callable, Generator
from contextlib import closing

from PySide6.QtCore import QMimeData, Qt, QTimer, Signal
from PySide6.QtGui import QKeyEvent
from PySide6.QtWidgets import QFileDialog

from iconstudio.gui.exchange.dragging import unpacked
from iconstudio.gui.exchange.dropping import DropTarget
from iconstudio.gui.exchange.opening import Opener
from iconstudio.gui.gallery.sheet import Sheet
from iconstudio.gui.gallery.sheet_delegate import Look
from iconstudio.gui.gallery.sheet_model import credited
from iconstudio.gui.jobs.preparation import DEBOUNCE
from iconstudio.gui.jobs.runner import Runner
from iconstudio.gui.jobs.worker import Worker
from iconstudio.gui.panels.search import IconSearch
from iconstudio.gui.panels.wordfield import WordField
from iconstudio.gui.theme.layout import push_button
from iconstudio.gui.theme.theme import UNIT
from iconstudio.images.reading import SUFFIXES
from iconstudio.importing.images import is_called_image
from iconstudio.importing.importer import IconImporter
from iconstudio.inputs.together import ReadTogether
from iconstudio.model import Exemplar
from iconstudio.session import Session
from iconstudio.workflows.events import Event, Retrieved

_FILES = f"Drawings ({' '.join(f'*.{one}' for one in ('svg', 'svgz', *SUFFIXES))});;All files (*)"
_WELCOME = "Look icons up by a word, or open a drawing of your own."


class IconChooser(IconSearch):
    """A search field, a button to open a file, and thumbnails of the icons to choose from.

    Files that were opened stay in front of what is found. With ``multiple``, the icons named by
    ``set_taken`` are ticked, and choosing one of these gives it back.

    Signals
    -------
    chosen(Exemplar)
        The user clicked an icon, pressed Enter on it, or opened it.
    released(Exemplar)
        The user chose an icon that was taken; only with ``multiple``.
    failed(str)
        Nothing was found, or a file is no good; the chooser shows the sentence itself too.
    """

    chosen = Signal(object)
    released = Signal(object)
    failed = Signal(str)

    def __init__(self, session: Session, worker: Worker, multiple: bool = False) -> None:
        tip = "Use a drawing of your own: an SVG, a scan or a PNG"
        button = push_button("Open drawing…", tip)
        look = Look(7 * UNIT, margin=6)
        sheet = Sheet(look, self._describe, "Icons found", draggable=True)
        super().__init__(SearchField(), button, sheet, _WELCOME)
        self._session = session
        self._multiple = multiple
        self._keyword = self._remark = ""
        self._found: tuple[Exemplar, ...] = ()
        self._opened: dict[str, Exemplar] = {}
        DropTarget(
            self,
            lambda data: self.open_file(_dropped_drawing(data)),
            lambda data: _dropped_drawing(data) is not None,
        )
        self.setFocusProxy(self.field)

        self._search = Runner(worker, self)
        self._search.event.connect(self._show_found)
        self._search.failed.connect(self._fail)
        self._opener = Opener(_FileImporter(session, self.take), worker, self)
        self._opener.opened.connect(self.caption.say)
        self._opener.failed.connect(self._fail)
        symbol = "Choose a symbol of the sprite sheet."
        self._opener.choosing.connect(lambda: self.caption.say(symbol))
        self._timer = QTimer(self, singleShot=True, interval=DEBOUNCE)
        self._timer.timeout.connect(self._look_up)
        self.field.textEdited.connect(self._timer.start)
        self.field.returnPressed.connect(self._look_up)
        self.field.left.connect(self._enter_choices)
        self.sheet.chosen.connect(self._choose)
        button.clicked.connect(self.choose_file)

    def set_taken(self, identifiers: frozenset[str]) -> None:
        """Say which icons are taken already; it matters only if several can be."""
        taken = identifiers if self._multiple else frozenset()
        self.sheet.model().mark(lambda icon: icon.id in taken)

    def choose_file(self) -> None:
        """Ask for a file: an SVG, or an image."""
        path, _ = QFileDialog.getOpenFileName(self, "Open a drawing of your own", "", _FILES)
        if path:
            self.open_file(path)

    def open_file(self, path: str) -> None:
        """Read and draw a file in the background, then choose it; of a scan, show what it gives."""
        if not is_called_image(path):
            self.caption.say(f"Opening “{path}”…")
        self._opener.open_drawing(path)

    def _look_up(self) -> None:
        self._timer.stop()
        keyword = self.field.text().strip()
        if keyword == self._keyword and (self._found or self._search.running):
            return
        self._search.cancel()
        self._keyword, self._found = keyword, ()
        self._fill()
        self.tell_searching(keyword)
        if keyword:
            self._search.start(lambda: _retrieved(self._session, keyword))

    def _show_found(self, event: Event) -> None:
        if isinstance(event, Retrieved):
            self._found, self._remark = event.exemplars, event.remark
            self._fill()
            self.tell()

    def tell(self) -> None:
        """Say what there is to choose from, or what to do."""
        if not self._found:
            self.tell_searching(self._keyword)
            return
        what = "click to add or take away" if self._multiple else "click one to use it"
        self.tell_found(len(self._found), what, remark=self._remark)

    def take(self, exemplar: Exemplar) -> None:
        """Choose an icon that was opened; it stays in front of what is found."""
        self._opened = {exemplar.id: exemplar} | self._opened
        self._fill()
        if not self.sheet.model().is_marked(exemplar):
            self.chosen.emit(exemplar)

    def _describe(self, icon: Exemplar, taken: bool) -> tuple[str, str]:
        what = "take it away" if taken else "add it" if self._multiple else "use it"
        name = f"{icon.name}, taken" if taken else icon.name
        return name, f"{credited(icon)}\nClick to {what}, or drag it"

    def _choose(self, exemplar: Exemplar) -> None:
        taken = self.sheet.model().is_marked(exemplar)
        (self.released if taken else self.chosen).emit(exemplar)

    def _fill(self) -> None:
        shown = self._opened | {one.id: one for one in self._found}
        self.sheet.show_entries(tuple(shown.values()))

    def _fail(self, message: str) -> None:
        self.caption.say(message, error=True)
        self.failed.emit(message)

    def _enter_choices(self) -> None:
        if self.sheet.model().entries:
            self.sheet.setFocus(Qt.FocusReason.OtherFocusReason)
            self.sheet.setCurrentIndex(self.sheet.model().index(0))


class _FileImporter(IconImporter):
    """Reads files for a chooser, which is no page."""

    def __init__(self, session: Session, take: Callable[[Exemplar], None]) -> None:
        super().__init__(session, None)
        self._take = take

    def put(self, gathered: ReadTogether) -> tuple[str]:
        """Choose an icon."""
        (found,) = gathered.found
        self._take(found)
        return (f"Opened “{found.pictogram.credit.title}”.",)


class SearchField(WordField):
    """A text field that the Down key leaves.

    Signals
    -------
    left()
        The user wants to go on to what was found.
    """

    left = Signal()

    def __init__(self) -> None:
        super().__init__()
        self.setPlaceholderText("Find an icon: lamp")
        self.setAccessibleName("Find an icon")

    def keyPressEvent(self, event: QKeyEvent) -> None:
        """Leave with Down."""
        if event.key() == Qt.Key.Key_Down:
            self.left.emit()
        else:
            super().keyPressEvent(event)


def _retrieved(session: Session, keyword: str) -> Generator[Event]:
    """Yield what ``prepare`` does up to the icons; their distances are of no use here."""
    with closing(session.prepare(keyword)) as events:
        for event in events:
            yield event
            if isinstance(event, Retrieved):
                return


def _dropped_drawing(data: QMimeData) -> str | None:
    """Return the path of a single SVG file that is dragged; all else is for the workspace."""
    urls = data.urls()
    if len(urls) != 1 or not urls[0].isLocalFile() or unpacked(data) is not None:
        return None
    path = urls[0].toLocalFile()
    return path if path.lower().endswith((".svg", ".svgz")) else None
