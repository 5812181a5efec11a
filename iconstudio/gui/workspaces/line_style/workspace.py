"""Line styles by example (*Curve Analogies*): lines take the hand of a few strokes."""

from dataclasses import replace
from functools import partial
from pathlib import Path

from PySide6.QtCore import Qt
from PySide6.QtGui import QShowEvent
from PySide6.QtWidgets import QWidget

from iconstudio.grammar import counted
from iconstudio.gui.canvas.start import StartButtons
from iconstudio.gui.canvas.view import CanvasView
from iconstudio.gui.exchange.opening import Opener
from iconstudio.gui.gallery.detail import DetailPanel
from iconstudio.gui.jobs.worker import Worker
from iconstudio.gui.theme.layout import column, row, splitter
from iconstudio.gui.theme.theme import UNIT
from iconstudio.gui.workspaces.following import FollowingWorkspace
from iconstudio.gui.workspaces.line_style import own_styles
from iconstudio.gui.workspaces.line_style.actions import ENTRIES
from iconstudio.gui.workspaces.line_style.controls import StyleControls
from iconstudio.gui.workspaces.line_style.finding import FindDialog
from iconstudio.gui.workspaces.line_style.pad import ExamplePanel
from iconstudio.gui.workspaces.line_style.reading import LineReader
from iconstudio.gui.workspaces.line_style.restyler import Restyler
from iconstudio.gui.workspaces.line_style.scene import RestyleScene
from iconstudio.gui.workspaces.line_style.styles import StylesPanel
from iconstudio.gui.workspaces.line_style.tools import PenTool, SelectTool
from iconstudio.gui.workspaces.line_style.variations import VariationsPanel
from iconstudio.gui.workspaces.made import Made
from iconstudio.importing.restylings import STYLES, RestyleImporter
from iconstudio.inputs.line_style import write_style
from iconstudio.inputs.styles import bundled
from iconstudio.model import IconstudioError, Pictogram, StylePair
from iconstudio.workflows.line_style import page as edits
from iconstudio.workflows.line_style.page import OWN, RestylePage
from iconstudio.workflows.line_style.restyling import warm_up

DESCRIPTION = "Select lines, or draw some, here"
INVITATION = "The restyled icon appears here, with its credits."


class LineStyleWorkspace(FollowingWorkspace):
    """Styles on the left, the lines on a canvas, variations and the picked result on the right."""

    page_type = RestylePage
    entries = ENTRIES

    @staticmethod
    def get_ready() -> None:
        """Read the styles of the program."""
        bundled()

    def build(self) -> None:
        """Make canvas, panels and runs."""
        self._shown: Made | None = None
        """The result in sight."""
        self.session.workers.everywhere(warm_up)
        self.session.expect_lines()
        self.importer = RestyleImporter(self.session, self.document)
        self.opener = Opener(self.importer, self.finder, self)
        self.restyler = Restyler(self.session, self.worker, self)
        self.reader = LineReader(self.session, self.finder, self)
        self.scene = RestyleScene(self.document)
        self.tools = {
            "select": SelectTool(self.document, self.scene),
            "pen": PenTool(self.document, self.scene, self.restyler.preview),
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
        restyler = self.restyler
        for runner in (restyler.live, restyler.varying):
            self.follow(runner)
            runner.failed.connect(self.failed)
        self.detail.watch(restyler.live)
        restyler.restyled.connect(self._show_result)
        restyler.began_varying.connect(self.variations.clear)
        restyler.varied.connect(self._show_variation)
        restyler.previewed.connect(self.show_age)
        restyler.left.connect(self._leave)
        self.follow(self.reader, self.scene.show_lines)
        self.follow(self.opener.runner)
        self.styles.chosen.connect(lambda style: edits.set_style(self.document, style))
        pad = self.example.pad
        pad.drawing.connect(self._preview_example)
        pad.drawn.connect(self._add_example)
        pad.given_up.connect(self.show_page)
        self.example.cleared.connect(lambda: edits.clear_example(self.document))
        self.variations.chosen.connect(self._look_at_variation)
        self.variations.wanted.connect(
            lambda work: edits.take_over(self.document, work.strength, work.seed)
        )
        self.variations.sheet.asked.connect(self.offer_for)

    # -- what the window asks for --------------------------------------------------------------

    @property
    def icons(self) -> tuple[Pictogram, ...]:
        """The icon whose lines are restyled."""
        icon = self.page.work.icon
        return () if icon is None else (icon,)

    def enter(self) -> None:
        """Begin on the canvas."""
        self.view.setFocus()

    def run(self) -> None:
        """Draw the lines once more; say what is missing if that cannot be."""
        page = self.page
        if not page.has_lines:
            self.hinted.emit("There are no lines yet. Find an icon, drop one here, or draw some.")
        elif page.work.style is None:
            self.hinted.emit("There is no style yet. Choose one on the left, or draw an example.")
        else:
            self.restyler.run()

    def outcome(self) -> str:
        """Return how many variations there are."""
        count = len(self.variations.sheet.pictures)
        return counted(count, "variation") if count else ""

    def showEvent(self, event: QShowEvent) -> None:
        """Draw the samples of the styles when they are first in sight."""
        super().showEvent(event)
        self.styles.begin()

    # -- results -------------------------------------------------------------------------------

    def _preview_example(self, pair: StylePair) -> None:
        try:
            style = edits.with_example(self.page, pair)
        except IconstudioError:
            return  # too short yet
        self.restyler.preview(edits.styled(self.page, style))

    def _add_example(self, pair: StylePair) -> None:
        try:
            edits.add_example(self.document, pair)
        except IconstudioError as error:
            self.hinted.emit(str(error))
            self.show_page()

    @property
    def stale(self) -> bool:
        """Whether the result in sight is neither of the page nor a variation of that."""
        return self._shown is not None and not self.restyler.wants(self._shown)

    def show_age(self) -> None:
        """Say whether the result is of the page as it is now, on the canvas, too."""
        super().show_age()
        self.scene.paling.set_stale(self.stale)

    def _show(self, made: Made | None) -> None:
        self._shown = made
        picture = None if made is None else made.picture
        self.scene.show_result(picture)
        self.look_at(picture)
        self.show_age()

    def _show_result(self, made: Made) -> None:
        self._show(made)
        if not made.picture.icon.path:
            self.hinted.emit("Nothing is left of it in this style. Make the size smaller.")

    def _show_variation(self, made: Made) -> None:
        self.variations.add(made)
        self.counted.emit(len(self.variations.sheet.pictures))

    def _look_at_variation(self, made: Made) -> None:
        self._show(made)
        self.kept.emit(made.picture)

    # -- page ----------------------------------------------------------------------------------

    def show_page(self) -> None:
        """Show what the page says, and have its lines drawn."""
        page = self.page
        self.controls.show_page(page)
        self.example.show_style(page.style)
        for style in page.styles:
            self.styles.add(style)
        self.styles.show_used(page.styles)
        self.reader.request(page.work.icon)
        self.restyler.request(page)
        self.show_age()

    def _leave(self) -> None:
        """Leave the results behind: they are of something else."""
        self.variations.clear()
        self._show(None)
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
        self.opener.ask("Open a line style", STYLES, self.open_style)

    def open_style(self, path: str) -> None:
        """Learn a style from a file."""
        learn = partial(self.importer.opening_style, Path(path), own_styles.note)
        self.opener.replace(learn)

    def save_style(self) -> None:
        """Write the style into a file."""
        style = self.page.style

        def write(path: Path) -> None:
            write_style(path, replace(style, name=path.stem) if style.name == OWN else style)
            own_styles.note(path)

        self.saver.save_work("line style", style.name, write)

    def save(self) -> None:
        """Write the work into a file."""
        self.save_work(self.page.work, self.workflow.noun)
