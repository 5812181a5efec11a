"""The window: puts the parts together and wires them."""

from PySide6.QtCore import QEvent, Qt
from PySide6.QtGui import QCloseEvent, QGuiApplication
from PySide6.QtWidgets import (
    QApplication,
    QMainWindow,
    QSplitter,
    QVBoxLayout,
    QWidget,
)

from iconstudio.gui import commands, theme
from iconstudio.gui.about import show_about
from iconstudio.gui.actions import Actions
from iconstudio.gui.canvas.tools.polygon import PolygonTool
from iconstudio.gui.canvas.view import CanvasView
from iconstudio.gui.document import Document, Page
from iconstudio.gui.modelling import Modelling
from iconstudio.gui.opening import Opener
from iconstudio.gui.panels.canvas import CanvasPanel
from iconstudio.gui.panels.detail import DetailPanel
from iconstudio.gui.panels.keyword import KeywordPanel
from iconstudio.gui.panels.notice import Notice
from iconstudio.gui.panels.progress import ProgressStrip
from iconstudio.gui.panels.results import ResultsPanel
from iconstudio.gui.pictures import Picture
from iconstudio.gui.saving import Saver
from iconstudio.gui.theme import UNIT
from iconstudio.gui.worker import Worker
from iconstudio.model import Sketch
from iconstudio.session import ModelSettings, Session
from iconstudio.sketchfile import examples


class MainWindow(QMainWindow):
    """Canvas and keyword on the left, results and details on the right, progress below."""

    def __init__(self, session: Session) -> None:
        super().__init__()
        self._session = session
        self._files_worker = Worker(self)
        self._session_worker = Worker(self)
        self.document = Document(self)
        self.opener = Opener(self.document, self._files_worker, self)
        self.saver = Saver(self._files_worker, self)
        self.modelling = Modelling(self.document, session, self._session_worker, self)
        self._ran: Sketch | None = None
        self._regions: tuple = ()

        self.tool = PolygonTool(self.document)
        self.view = CanvasView(self.document, self.tool)
        self.actions_by_name = Actions(self, self.document.undo_stack)
        self.canvas_panel = CanvasPanel(self.view)
        self.canvas_panel.fill_bar(self.actions_by_name.bar(), self.actions_by_name.examples)
        self.keyword_panel = KeywordPanel()
        self.results = ResultsPanel()
        self.detail = DetailPanel()
        self.notice = Notice()
        self.strip = ProgressStrip()

        self._lay_out()
        self._wire_actions()
        self._wire_panels()
        self._wire_modelling()
        self.refresh_look()
        self._show_page(self.document.page)
        self._update_actions()
        self._rest()
        self.view.setFocus()
        self.modelling.open()

    # -- putting together ----------------------------------------------------------------------

    def _lay_out(self) -> None:
        self.setWindowTitle("Iconstudio")
        left = QSplitter(Qt.Orientation.Vertical)
        left.addWidget(self.canvas_panel)
        left.addWidget(self.keyword_panel)
        left.setSizes([440, 190])
        right = QSplitter(Qt.Orientation.Vertical)
        right.addWidget(self.results)
        right.addWidget(self.detail)
        right.setSizes([400, 210])
        both = QSplitter(Qt.Orientation.Horizontal)
        both.addWidget(left)
        both.addWidget(right)
        both.setSizes([460, 800])
        for splitter, shares in ((left, (3, 1)), (right, (3, 1)), (both, (1, 2))):
            splitter.setHandleWidth(UNIT)
            splitter.setChildrenCollapsible(False)
            for part, share in enumerate(shares):
                splitter.setStretchFactor(part, share)
        centre = QWidget()
        layout = QVBoxLayout(centre)
        layout.setContentsMargins(UNIT, 0, UNIT, 0)
        layout.setSpacing(UNIT)
        layout.addWidget(self.notice)
        layout.addWidget(both, 1)
        layout.addWidget(self.strip)
        self.setCentralWidget(centre)
        self.setTabOrder(self.canvas_panel.dim, self.view)
        self.setTabOrder(self.view, self.keyword_panel.field)
        room = QGuiApplication.primaryScreen().availableSize()
        self.resize(min(1360, room.width()), min(860, room.height()))

    def _wire_actions(self) -> None:
        self.actions_by_name.connect(
            {
                "new": self._new,
                "photo": self.opener.choose_photo,
                "paste": lambda: self.opener.open_mime(QApplication.clipboard().mimeData()),
                "open": self.opener.choose_sketch,
                "save": lambda: self.saver.save_sketch(self.document.page),
                "svg": self.saver.save_svg,
                "png": lambda: self.saver.save_png(self.results.coded),
                "copy": self.saver.copy_svg,
                "quit": self.close,
                "delete": self.tool.delete_selected,
                "clear": self._clear_outline,
                "run": self.run,
                "cancel": self.modelling.cancel,
                "trace": lambda on: self.view.set_tool(self.tool if on else self.view.pan_tool),
                "zoom_in": self.view.zoom_in,
                "zoom_out": self.view.zoom_out,
                "fit": self.view.fit,
                "coded": self.results.set_coded,
                "regions": self._show_regions,
                "about": lambda: show_about(self),
            }
        )
        for example in examples():
            action = self.actions_by_name.examples.addAction(example.title)
            action.triggered.connect(lambda _=False, e=example: self.opener.open_example(e))

    def _wire_panels(self) -> None:
        panel, document = self.keyword_panel, self.document
        panel.edited.connect(lambda text: self._push(commands.SetKeyword(document, text)))
        panel.run.connect(self.run)
        panel.toggled.connect(self._toggle_icon)
        panel.restored.connect(lambda: self._push(commands.ExcludeIcons(document, frozenset())))
        document.page_changed.connect(self._show_page)
        self.view.files_dropped.connect(self.opener.open_mime)
        self.opener.failed.connect(self.notice.say)
        self.opener.opened.connect(self._say)
        self.saver.failed.connect(self.notice.say)
        self.saver.saved.connect(self._say)
        self.results.picked.connect(self.detail.show_picture)
        self.results.picked.connect(self.saver.pick)
        self.results.picked.connect(self._update_actions)
        self.results.coded_changed.connect(self.detail.large.set_coded)
        self.results.coded_changed.connect(self.actions_by_name["coded"].setChecked)
        self.detail.save_svg.connect(self.saver.save_svg)
        self.detail.save_png.connect(self.actions_by_name["png"].trigger)
        self.detail.copy_svg.connect(self.saver.copy_svg)
        self.strip.cancelled.connect(self.modelling.cancel)

    def _wire_modelling(self) -> None:
        modelling = self.modelling
        modelling.preparing.connect(self.keyword_panel.set_searching)
        modelling.retrieved.connect(self.keyword_panel.show_exemplars)
        modelling.prepare_failed.connect(self.keyword_panel.show_error)
        modelling.started.connect(self._begin)
        modelling.regions.connect(self._keep_regions)
        modelling.matched.connect(self.results.show_matched)
        modelling.skipped.connect(self.results.show_skipped)
        modelling.finished_icon.connect(self._add_picture)
        modelling.progress.connect(self.strip.show_progress)
        modelling.progress.connect(lambda _: self.actions_by_name["cancel"].setEnabled(True))
        modelling.failed.connect(self.notice.say)
        modelling.remarked.connect(self.notice.say)
        modelling.ended.connect(self._end)
        modelling.idle.connect(self._rest)

    # -- modelling -----------------------------------------------------------------------------

    def run(self) -> None:
        """Remix for the sketch."""
        if self.modelling.running and self._ran == self.document.sketch:
            return
        self.notice.hide()
        if not self.modelling.run() and not self.document.sketch.keyword.strip():
            self.keyword_panel.field.setFocus()

    def _begin(self, sketch: Sketch, settings: ModelSettings) -> None:
        self._ran = sketch
        self.saver.set_title(sketch.keyword.strip())
        self.strip.say("")
        self.results.begin(settings.styles, settings.lambdas)
        self._show_page(self.document.page)
        self._update_actions()
        if sketch.polygon.crosses_itself:
            self.notice.say(
                "The outline crosses itself; everything that it encloses counts as inside."
            )

    def _add_picture(self, picture: Picture) -> None:
        self.results.add(picture)
        self.strip.set_finished(len(self.results.pictures))
        if self.detail.picture is None:
            composite = picture.result.composite
            self.results.pick(composite.style, composite.lambda_s)

    def _end(self, complete: bool) -> None:
        self.results.end()
        self._update_actions()

    def _rest(self) -> None:
        count = len(self.results.pictures)
        self.strip.rest(f"{count} icons" if count else "")
        self.actions_by_name["cancel"].setEnabled(False)

    def _toggle_icon(self, icon: str) -> None:
        exclude = self.document.sketch.exclude ^ {icon}
        self._push(commands.ExcludeIcons(self.document, exclude))

    def _keep_regions(self, centres: tuple) -> None:
        self._regions = centres
        self._show_regions()

    def _show_regions(self) -> None:
        same = self._ran is not None and self._ran.polygon == self.document.sketch.polygon
        wanted = self.actions_by_name["regions"].isChecked() and same
        self.view.set_regions(self._regions if wanted else ())

    # -- document ------------------------------------------------------------------------------

    def _show_page(self, page: Page) -> None:
        self.notice.hide()
        self.keyword_panel.set_sketch(page.sketch.keyword, page.sketch.exclude)
        self.canvas_panel.show_page(page)
        self._show_regions()
        stale = self._ran is not None and self._ran != page.sketch
        self.results.note.setText("of an earlier sketch – press Remix to renew" if stale else "")
        for name in ("clear", "delete", "save"):
            self.actions_by_name[name].setEnabled(bool(page.vertices))

    def _new(self) -> None:
        self._push(commands.LoadSketch(self.document, Sketch(), text="new sketch"))

    def _clear_outline(self) -> None:
        if self.document.page.vertices:
            self._push(commands.ClearOutline(self.document))

    def _push(self, command: commands.PageCommand) -> None:
        self.document.undo_stack.push(command)

    def _say(self, message: str) -> None:
        self.notice.hide()
        self.strip.say(message)

    # -- the window itself ---------------------------------------------------------------------

    def refresh_look(self) -> None:
        """Draw all icons in the colours of the present theme."""
        look = theme.current()
        for part in (self.actions_by_name, self.canvas_panel, self.notice):
            part.refresh_icons(look)

    def _update_actions(self) -> None:
        for name in ("svg", "png", "copy"):
            self.actions_by_name[name].setEnabled(self.detail.picture is not None)

    def threads_alive(self) -> bool:
        """Whether a thread of the window still runs; not once it is closed."""
        return self._files_worker.alive or self._session_worker.alive

    def changeEvent(self, event: QEvent) -> None:
        """Follow the system between light and dark."""
        super().changeEvent(event)
        if event.type() == QEvent.Type.PaletteChange and hasattr(self, "strip"):
            self.refresh_look()

    def closeEvent(self, event: QCloseEvent) -> None:
        """Stop all work and wait until the threads have ended."""
        self.modelling.cancel()
        self._files_worker.close()
        self._session_worker.close(self._session.close)
        self._session.close()
        super().closeEvent(event)
