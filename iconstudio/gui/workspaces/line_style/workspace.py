"""Line styles by example (*Curve Analogies*): lines take the hand of a few strokes."""

from functools import partial
from pathlib import Path

from PySide6.QtCore import Qt, QTimer
from PySide6.QtGui import QHideEvent, QShowEvent
from PySide6.QtWidgets import QWidget

from iconstudio.gui.canvas.start import StartButtons
from iconstudio.gui.canvas.view import CanvasView
from iconstudio.gui.gallery.detail import DetailPanel
from iconstudio.gui.gallery.pictures import Picture
from iconstudio.gui.gallery.sending import Destination
from iconstudio.gui.jobs.live import LiveRunner
from iconstudio.gui.jobs.runner import Runner
from iconstudio.gui.jobs.worker import Worker
from iconstudio.gui.theme.layout import column, row, splitter
from iconstudio.gui.theme.theme import UNIT
from iconstudio.gui.workspaces.base import Workspace
from iconstudio.gui.workspaces.line_style.actions import ENTRIES
from iconstudio.gui.workspaces.line_style.controls import StyleControls
from iconstudio.gui.workspaces.line_style.finding import FindDialog
from iconstudio.gui.workspaces.line_style.live import (
    IconLines,
    Made,
    made,
    made_variations,
    read_lines,
)
from iconstudio.gui.workspaces.line_style.opening import STYLES, RestyleOpener
from iconstudio.gui.workspaces.line_style.pad import ExamplePanel
from iconstudio.gui.workspaces.line_style.scene import RestyleScene
from iconstudio.gui.workspaces.line_style.styles import StylesPanel
from iconstudio.gui.workspaces.line_style.tools import PenTool, SelectTool
from iconstudio.gui.workspaces.line_style.variations import VariationsPanel
from iconstudio.inputs.line_style import write_style
from iconstudio.model import IconstudioError, LineStyle, Pictogram, Restyling, StylePair
from iconstudio.workflows.line_style import page as edits
from iconstudio.workflows.line_style.page import OWN, RestylePage

DESCRIPTION = "Select lines, or draw some, here"
INVITATION = "The restyled icon appears here, with its credits."
REST = 400
"""Milliseconds without a change after which variations are made."""


class LineStyleWorkspace(Workspace):
    """Styles on the left, the lines on a canvas, variations and the picked result on the right."""

    page_type = RestylePage
    entries = ENTRIES

    def build(self) -> None:
        """Make canvas, panels and runs."""
        self.opener = RestyleOpener(self.session, self.document, self.finder, self)
        self.live = LiveRunner(self.worker, partial(made, self.session), self)
        self.varying = LiveRunner(Worker(self), partial(made_variations, self.session), self)
        self.reading = Runner(self.finder, self)
        self.resting = QTimer(self, singleShot=True, interval=REST)
        self.made: Made | None = None
        """The result in sight, of the page or of what is being drawn."""
        self._kept: Picture | None = None
        self._asked: Pictogram | None = None
        """The icon whose lines are being read, or were last."""
        self.scene = RestyleScene(self.document)
        self.tools = {
            "select": SelectTool(self.document, self.scene),
            "pen": PenTool(self.document, self.scene, self._preview),
        }
        self.view = CanvasView(self.scene, self.tools["select"], DESCRIPTION)
        self.detail = DetailPanel(upright=True, invitation=INVITATION)
        self.detail.switch.hide()
        self.detail.setMinimumHeight(36 * UNIT)
        self.variations = VariationsPanel()
        self.controls = StyleControls(self.document)
        self.example = ExamplePanel()
        self.make_actions()
        actions = self.actions_by_name
        self.styles = StylesPanel(
            self.session, Worker(self), [actions["style_in"], actions["style_out"]]
        )
        self.start_buttons = StartButtons(self.view, actions["find"], self.examples)
        self._lay_out()
        self._wire()
        self.show_page()

    def _lay_out(self) -> None:
        bar = "undo redo", "find svg_in", "select pen pan", "fit clear"
        upright, across = Qt.Orientation.Vertical, Qt.Orientation.Horizontal
        left = splitter(upright, (self.styles, 380, 1), (self.example, 200, 0))
        middle, right = (
            QWidget(),
            splitter(upright, (self.variations, 290, 1), (self.detail, 310, 1)),
        )
        column((self.canvas_panel_of(*bar), 1), self.controls, of=middle)
        row(splitter(across, (left, 352, 0), (middle, 480, 3), (right, 416, 2)), of=self)

    def _wire(self) -> None:
        self.follow(self.live, self._show_result)
        self.follow(self.varying, self._show_variation)
        self.follow(self.reading, self._show_lines)
        self.follow(self.opener.runner)
        self.resting.timeout.connect(self._vary)
        self.styles.chosen.connect(self._choose_style)
        pad = self.example.pad
        pad.drawing.connect(self._preview_example)
        pad.drawn.connect(self._add_example)
        pad.given_up.connect(self.show_page)
        self.example.clear.clicked.connect(lambda: edits.clear_example(self.document))
        self.variations.chosen.connect(self._look_at_variation)
        self.variations.wanted.connect(
            lambda work: edits.take_over(self.document, work.strength, work.seed)
        )
        self.variations.sheet.asked.connect(self.offer_for)
        self.kept.connect(self._note_kept)

    # -- what the window asks for --------------------------------------------------------------

    @property
    def icons(self) -> tuple[Pictogram, ...]:
        """The icon whose lines are restyled."""
        icon = self.page.work.icon
        return () if icon is None else (icon,)

    def enter(self) -> None:
        """Begin on the canvas."""
        self.view.setFocus()

    def set_destinations(self, destinations: tuple[Destination, ...]) -> None:
        """Say where icons can be sent to."""
        others = tuple(one for one in destinations if one.title != self.workflow.title)
        super().set_destinations(others)

    def run(self) -> None:
        """Draw the lines once more; say what is missing if that cannot be."""
        page = self.page
        if not page.has_lines:
            self.hinted.emit("There are no lines yet. Find an icon, drop one here, or draw some.")
        elif page.work.style is None:
            self.hinted.emit("There is no style yet. Choose one on the left, or draw an example.")
        else:
            self.live.run(page.work)
            self.resting.start()

    def outcome(self) -> str:
        """Return how many variations there are."""
        count = len(self.variations.sheet.pictures)
        return f"{count} variations" if count else ""

    def showEvent(self, event: QShowEvent) -> None:
        """Draw the samples of the styles when they are first in sight."""
        super().showEvent(event)
        self.styles.begin()

    def hideEvent(self, event: QHideEvent) -> None:
        """Keep the result in sight when the user goes elsewhere."""
        super().hideEvent(event)
        if not event.spontaneous() and self.picture is not None and self.picture is not self._kept:
            self.kept.emit(self.picture)

    # -- results -------------------------------------------------------------------------------

    def _preview(self, work: Restyling) -> None:
        """Show what work would come to that is not on the page yet."""
        if (work.icon is not None or work.strokes) and work.style is not None:
            self.live.request(work)

    def _preview_example(self, pair: StylePair) -> None:
        try:
            style = edits.with_example(self.page, pair)
        except IconstudioError:
            return  # too short yet
        self._preview(edits.styled(self.page, style))

    def _add_example(self, pair: StylePair) -> None:
        try:
            edits.add_example(self.document, pair)
        except IconstudioError as error:
            self.hinted.emit(str(error))
            self.show_page()

    def _show_result(self, event: object) -> None:
        if isinstance(event, Made):
            self.made = event
            self.scene.show_result(event.picture)
            self.look_at(event.picture)
            self.live.release()
            if not event.picture.icon.path:
                self.hinted.emit("Nothing is left of it in this style. Make the size smaller.")

    def _vary(self) -> None:
        work = self.page.work
        if self.page.complete and self.varying.ran != work:
            self.variations.clear()
            self.varying.request(work)

    def _show_variation(self, event: object) -> None:
        if isinstance(event, Made):
            self.variations.add(event)
            self.counted.emit(len(self.variations.sheet.pictures))
            self.varying.release()

    def _look_at_variation(self, picture: Picture) -> None:
        self.scene.show_result(picture)
        self.look_at(picture)
        self.kept.emit(picture)

    def _note_kept(self, picture: Picture) -> None:
        self._kept = picture

    # -- page ----------------------------------------------------------------------------------

    def show_page(self) -> None:
        """Show what the page says, and have its lines drawn."""
        page = self.page
        self.controls.show_page(page)
        self.example.show_style(page.style)
        for style in page.styles:
            self.styles.add(style)
        self.styles.show_used(page.styles)
        self._read_lines()
        self._restyle()

    def _read_lines(self) -> None:
        icon = self.page.work.icon
        if icon is None:
            self.reading.cancel()
        elif icon not in (self.scene.icon, self._asked):
            self._asked = icon
            self.reading.start(lambda: read_lines(self.session, icon))

    def _show_lines(self, event: object) -> None:
        if isinstance(event, IconLines):
            self.scene.show_lines(event)

    def _restyle(self) -> None:
        page = self.page
        if not page.complete:
            self.live.cancel()
            self._leave()
        elif self.made is not None and self.made.work.icon != page.work.icon:
            self._leave()
        if page.complete and page.work != self.live.ran:
            self.varying.cancel()
            self.live.request(page.work)
            self.resting.start()

    def _leave(self) -> None:
        """Leave the results behind: they are of something else."""
        self.resting.stop()
        self.varying.cancel()
        self.made = None
        self.scene.show_result(None)
        self.variations.clear()
        if self.picture is not None:
            self.look_at(None)
        self.rest()

    # -- files ---------------------------------------------------------------------------------

    def find_icon(self) -> None:
        """Let the user look up an icon."""
        dialog = FindDialog(self.session, self.finder, self)
        dialog.chosen.connect(self.opener.take)
        dialog.open()

    def choose_drawing(self) -> None:
        """Ask for a drawing to restyle."""
        self.opener.ask("Open a drawing", "Drawings (*.svg *.svgz *.png)", self.opener.open_drawing)

    def choose_style(self) -> None:
        """Ask for a line style."""
        self.opener.ask("Open a line style", STYLES.split(";;")[0], self.opener.open_style)

    def save_style(self) -> None:
        """Write the style into a file."""
        style = self.page.style
        name = "my style" if style.name == OWN else style.name

        def write(path: Path) -> None:
            write_style(path, style)

        self.saver.save_work("line style", name, write)

    def save_strokes(self) -> None:
        """Save the picked result as SVG in which strokes are strokes."""
        self._keep(self.saver.save_strokes)

    def save(self) -> None:
        """Write the work into a file."""
        self.save_work(self.page.work, self.workflow.noun)

    def _choose_style(self, style: LineStyle) -> None:
        edits.set_style(self.document, style)
