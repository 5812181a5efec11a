"""Sketch-based modelling (section 4.1): trace, name, remix."""

from pathlib import Path

from PySide6.QtCore import QMimeData, Qt
from PySide6.QtWidgets import QApplication, QHBoxLayout, QMenu, QSplitter

from iconstudio.gui import theme
from iconstudio.gui.actions import Entry, Key
from iconstudio.gui.canvas.outline import Outline
from iconstudio.gui.canvas.tools.polygon import PolygonTool
from iconstudio.gui.canvas.view import CanvasView
from iconstudio.gui.document import Document
from iconstudio.gui.panels.board import Board
from iconstudio.gui.panels.canvas import CanvasPanel
from iconstudio.gui.panels.keyword import KeywordPanel
from iconstudio.gui.panels.sending import Destination
from iconstudio.gui.panels.symmetry import SymmetryButton, SymmetryHint
from iconstudio.gui.pictures import Picture, pictured
from iconstudio.gui.preparation import Preparation, Query
from iconstudio.gui.runner import Runner
from iconstudio.gui.saving import Saver
from iconstudio.gui.theme import UNIT
from iconstudio.gui.worker import Worker
from iconstudio.gui.workspaces.base import Workspace
from iconstudio.gui.workspaces.sketching import page as edits
from iconstudio.gui.workspaces.sketching.opening import Opener
from iconstudio.gui.workspaces.sketching.overlay import DimSlider, StartButtons
from iconstudio.gui.workspaces.sketching.page import SketchPage
from iconstudio.gui.workspaces.sketching.proposal import SymmetryProposal
from iconstudio.gui.workspaces.sketching.scene import SketchScene
from iconstudio.inputs.sketch import SketchFile, examples, write_sketch
from iconstudio.model import IconstudioError, Sketch
from iconstudio.session import ModelSettings, Session
from iconstudio.workflows.events import Event, RegionsFound

OWN = {
    "&File": (
        Entry("new", "&New sketch", "Start afresh", Key.New, "new"),
        Entry("photo", "Open &photo…", "Open a photo to trace over", Key.Open, "photo"),
        Entry("examples", "&Examples", "Start from an example", icon="examples"),
        Entry("open", "Open s&ketch…", "Open a sketch file", "Ctrl+Shift+O"),
        Entry("save", "&Save sketch…", "Save the sketch as JSON", Key.Save),
    ),
    "&Edit": (
        Entry("paste", "P&aste photo", "Use the image on the clipboard", Key.Paste),
        Entry("delete", "&Delete point", "Remove the selected or the last point", "Backspace"),
        Entry("clear", "Clear &outline", "Remove the outline", "Ctrl+Backspace", "clear"),
        Entry("run", "&Remix", "Make new icons in four styles", "Ctrl+Return"),
    ),
    "&View": (
        Entry("trace", "&Trace outline", "Trace the outline", "P", "polygon", True),
        Entry("regions", "&Salient regions", "Show the regions that are matched", "R", "regions",
              True),
    ),
}  # fmt: skip


class SketchWorkspace(Workspace):
    """Canvas and keyword on the left, results and details on the right."""

    title = "Sketch"

    def __init__(self, session: Session, files: Worker, saver: Saver) -> None:
        super().__init__(session, files, saver, Document(SketchPage()))
        self.opener = Opener(self.document, files, self)
        self.runner = Runner(self.worker, self)
        self.preparation = Preparation(session, self.worker, self)
        self._opening = Runner(self.worker, self)
        self._ran: Sketch | None = None
        self._regions: tuple = ()

        self.scene = SketchScene(self.document)
        self.scene.setParent(self)
        self.outline = Outline(self.document)
        self.tool = PolygonTool(self.outline)
        self.view = CanvasView(self.scene, self.tool, _can_be_opened)
        self.view.setAccessibleDescription("Trace the outline of an object here")
        self.keyword_panel = KeywordPanel()
        self.board = Board()
        self.dim = DimSlider()
        self.symmetry = SymmetryButton()
        self.symmetry_hint = SymmetryHint(self.view)
        self._proposal = SymmetryProposal(self.document, self)

        self._make_actions()
        self.start_buttons = StartButtons(self.view, self.actions_by_name["photo"], self._examples)
        self._lay_out()
        self._wire_page()
        self._wire_work()
        self.refresh_icons(theme.current())
        self._show_page(self.document.page)
        self._rest()
        self._opening.start(session.open)

    # -- putting together ----------------------------------------------------------------------

    def _make_actions(self) -> None:
        self._examples = QMenu("&Examples", self)
        self.make_actions(
            {
                "new": lambda: edits.load_sketch(self.document, Sketch(), text="new sketch"),
                "photo": self.opener.choose_photo,
                "paste": lambda: self.opener.open_mime(QApplication.clipboard().mimeData()),
                "open": self.opener.choose_sketch,
                "save": self._save,
                "run": self.run,
                "delete": self.tool.delete_selected,
                "clear": self._clear_outline,
                "trace": lambda on: self.view.set_tool(self.tool if on else self.view.pan_tool),
                "coded": self.board.results.set_coded,
                "regions": self._show_regions,
                **self.view_slots(self.view),
            },
            OWN,
        )
        actions = self.actions_by_name
        actions.choose_between("trace", "pan")
        actions.add(OWN["&File"][2], self._examples.menuAction())
        for example in examples():
            action = self._examples.addAction(example.title)
            action.triggered.connect(lambda _=False, e=example: self.opener.open_example(e))

    def _lay_out(self) -> None:
        named = self.actions_by_name
        groups = [
            [named["photo"], named["examples"]],
            [named["undo"], named["redo"]],
            [named[name] for name in ("trace", "pan", "fit", "regions", "clear")],
            [self.symmetry],
        ]
        self.canvas_panel = CanvasPanel(self.view, groups, [self.dim])
        left = QSplitter(Qt.Orientation.Vertical)
        left.addWidget(self.canvas_panel)
        left.addWidget(self.keyword_panel)
        left.setSizes([440, 190])
        both = QSplitter(Qt.Orientation.Horizontal)
        both.addWidget(left)
        both.addWidget(self.board)
        both.setSizes([460, 800])
        for splitter, shares in ((left, (3, 1)), (both, (1, 2))):
            splitter.setHandleWidth(UNIT)
            splitter.setChildrenCollapsible(False)
            for part, share in enumerate(shares):
                splitter.setStretchFactor(part, share)
        layout = QHBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.addWidget(both)

    def _wire_page(self) -> None:
        document, panel = self.document, self.keyword_panel
        panel.edited.connect(lambda text: edits.set_keyword(document, text))
        panel.run.connect(self.run)
        panel.toggled.connect(self._toggle_icon)
        panel.restored.connect(lambda: edits.exclude_icons(document, frozenset()))
        self.symmetry.chosen.connect(self._hold_to)
        self.symmetry_hint.accepted.connect(self._hold_to)
        self._proposal.found.connect(self.symmetry_hint.offer)
        self.dim.slider.valueChanged.connect(self.scene.set_dim)
        document.page_changed.connect(self._show_page)
        self.view.dropped.connect(lambda data, _: self.opener.open_mime(data))
        self.opener.failed.connect(self.failed)
        self.opener.opened.connect(self.said)

    def _wire_work(self) -> None:
        panel, preparation, board = self.keyword_panel, self.preparation, self.board
        preparation.started.connect(panel.set_searching)
        preparation.retrieved.connect(panel.show_exemplars)
        preparation.failed.connect(panel.show_error)
        preparation.remarked.connect(self.failed)
        for runner in (self.runner, preparation.runner, self._opening):
            runner.progress.connect(self.progressed)
            runner.ended.connect(self._rest)
        for runner in (self.runner, self._opening):
            runner.failed.connect(self.failed)
        self.runner.event.connect(self._show_event)
        self.runner.ended.connect(board.end)
        self.connect_board(board)

    # -- what the window asks for --------------------------------------------------------------

    @property
    def picture(self) -> Picture | None:
        """The picked result."""
        return self.board.detail.picture

    @property
    def coded(self) -> bool:
        """Whether the results are coded by source."""
        return self.board.results.coded

    def enter(self) -> None:
        """Begin on the canvas."""
        self.view.setFocus()

    def set_destinations(self, destinations: tuple[Destination, ...]) -> None:
        """Say where results can be sent to."""
        self.board.set_destinations(destinations)

    def cancel(self) -> None:
        """Stop the run and the search; results that are finished stay."""
        self.preparation.cancel()
        self.runner.cancel()

    def refresh_icons(self, look: theme.Theme) -> None:
        """Draw all icons in the colours of ``look``."""
        super().refresh_icons(look)
        self.dim.refresh_icons(look)
        self.symmetry.refresh_icons(look)

    def demonstrate(self, example: SketchFile) -> None:
        """Load an example and remix it as soon as it is there."""
        self.opener.opened.connect(self.run, Qt.ConnectionType.SingleShotConnection)
        self.opener.open_example(example)

    # -- modelling -----------------------------------------------------------------------------

    def run(self) -> None:
        """Remix for the sketch; an outline that is still open is closed first."""
        page = self.document.page
        if self.runner.running and self._ran == page.sketch:
            return
        self.said.emit("")
        if not page.closed and len(page.vertices) >= 3:
            self.outline.close()
        sketch = self.document.page.sketch
        problem = _problem(sketch)
        if problem:
            self.failed.emit(problem)
            if not sketch.keyword.strip():
                self.keyword_panel.field.setFocus()
            return
        self.preparation.hurry()
        settings = ModelSettings()
        title = sketch.keyword.strip()
        self.runner.start(lambda: pictured(self.session.model(sketch, settings), title))
        self._ran = sketch
        self.board.begin(settings)
        self._show_page(self.document.page)
        if sketch.polygon.crosses_itself:
            self.failed.emit(
                "The outline crosses itself; everything that it encloses counts as inside."
            )

    def _show_event(self, event: Event | Picture) -> None:
        if isinstance(event, RegionsFound):
            self._regions = event.centres
            self._show_regions()
        self.preparation.show(event)
        self.board.show_event(event)

    def _rest(self) -> None:
        busy = self.runner.running, self.preparation.runner.running, self._opening.running
        if not any(busy):
            count = len(self.board.results.pictures)
            self.rested.emit(f"{count} icons" if count else "")

    # -- page ----------------------------------------------------------------------------------

    def _show_page(self, page: SketchPage) -> None:
        sketch = page.sketch
        self.keyword_panel.set_sketch(sketch.keyword, sketch.exclude)
        self.preparation.want(Query.of(sketch.keyword, sketch.exclude))
        self.symmetry.set_axis(sketch.symmetry)
        self.start_buttons.setVisible(page.empty)
        self.dim.setVisible(page.photo is not None)
        if not page.vertices:
            self._regions = ()
        self._show_regions()
        stale = self._ran is not None and self._ran != sketch
        note = "of an earlier sketch – press Remix to renew" if stale else ""
        self.board.results.note.setText(note)
        for name in ("clear", "delete", "save"):
            self.actions_by_name[name].setEnabled(bool(page.vertices))

    def _show_regions(self) -> None:
        same = self._ran is not None and self._ran.polygon == self.document.page.sketch.polygon
        wanted = self.actions_by_name["regions"].isChecked() and same
        self.scene.set_regions(self._regions if wanted else ())

    def _toggle_icon(self, icon: str) -> None:
        edits.exclude_icons(self.document, self.document.page.sketch.exclude ^ {icon})

    def _hold_to(self, axis: object) -> None:
        if axis != self.document.page.sketch.symmetry:
            edits.set_symmetry(self.document, axis)

    def _clear_outline(self) -> None:
        if self.document.page.vertices:
            self.outline.clear()

    def _save(self) -> None:
        page = self.document.page
        photo = Path(page.photo.path) if page.photo is not None and page.photo.path else None
        title = page.sketch.keyword
        self.saver.save_work("sketch", title, lambda path: write_sketch(path, page.sketch, photo))


def _can_be_opened(data: QMimeData) -> bool:
    return data.hasUrls() or data.hasImage()


def _problem(sketch: Sketch) -> str:
    """Return what is missing before ``sketch`` can be remixed, as a sentence; else nothing."""
    if not sketch.polygon.vertices:
        return "There is no outline yet. Click around the object on the canvas to trace it."
    try:
        sketch.polygon.fitted()
    except IconstudioError as error:
        return str(error)
    if not sketch.keyword.strip():
        return "The object has no name yet. Type what it is below the canvas, for example “dog”."
    return ""
