"""Patterns by example: an exemplar, the pattern beside it, and what is wanted on the right."""

import random
from collections.abc import Callable

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QStackedWidget, QWidget

from iconstudio.grammar import counted
from iconstudio.gui.canvas.start import StartButtons
from iconstudio.gui.canvas.view import CanvasView
from iconstudio.gui.exchange.opening import Opener
from iconstudio.gui.gallery.detail import DetailPanel
from iconstudio.gui.jobs.worker import Worker
from iconstudio.gui.panels.chooser import IconChooser
from iconstudio.gui.theme.layout import card, column, push_button, row, splitter
from iconstudio.gui.workspaces.following import FollowingWorkspace
from iconstudio.gui.workspaces.made import Made
from iconstudio.gui.workspaces.montage.tools.scribble import Brush
from iconstudio.gui.workspaces.pattern.actions import ENTRIES
from iconstudio.gui.workspaces.pattern.colour import ColourButton
from iconstudio.gui.workspaces.pattern.controls import PatternControls
from iconstudio.gui.workspaces.pattern.correcting import CorrectTool
from iconstudio.gui.workspaces.pattern.layers import LayerReader, LayersPanel
from iconstudio.gui.workspaces.pattern.patterner import Patterner
from iconstudio.gui.workspaces.pattern.result import PatternView, TiledSwitch
from iconstudio.gui.workspaces.pattern.scene import PatternScene
from iconstudio.gui.workspaces.pattern.seeds import SeedsPanel
from iconstudio.gui.workspaces.pattern.tools import ArrangeTool
from iconstudio.importing.patterns import IMAGES, PatternImporter
from iconstudio.inputs.items import File
from iconstudio.model import IconstudioError, Patterning, Pictogram, Separation
from iconstudio.model.patterning import GROUND, INK
from iconstudio.workflows.pattern import page as edits
from iconstudio.workflows.pattern.layering import ImageLayers
from iconstudio.workflows.pattern.page import PatternPage
from iconstudio.workflows.pattern.scattering import PALETTE
from iconstudio.workflows.pattern.warming import warm_up

DESCRIPTION = "Arrange the icons of the exemplar here"
INVITATION = "Put icons, or an image, on the canvas: the pattern appears here."
SHAPE_AWAITED = "Choose the shape to fill: the next icon that you click, drop, paste or open."


class PatternWorkspace(FollowingWorkspace):
    """Every edit of the exemplar, or of what is wanted, makes the pattern anew."""

    page_type = PatternPage
    entries = ENTRIES

    @staticmethod
    def get_ready() -> None:
        """Load what makes patterns."""
        import iconstudio.workflows.pattern.patterning  # noqa: F401

    def build(self) -> None:
        """Make canvas, panels and runs."""
        self.session.workers.everywhere(warm_up)
        self.importer = PatternImporter(self.session, self.document)
        self.opener = Opener(self.importer, self.finder, self)
        self.patterner = Patterner(self.session, self.worker, self)
        self.scene = PatternScene(self.document, self.outlines)
        self.brush = Brush(self)
        self.tools = {
            "arrange": ArrangeTool(self.document, self.scene),
            "brush": CorrectTool(self.document, self.scene, self.brush),
        }
        self.view = CanvasView(self.scene, self.tools["arrange"], DESCRIPTION)
        self.chooser = IconChooser(self.session, self.finder)
        self.reader = LayerReader(self.session, Worker(self), self)
        self.layers = LayersPanel(self.document, self.brush, self._use_layer)
        self.below = QStackedWidget()
        self._has_image = False
        switch = TiledSwitch()
        self.large = PatternView(switch)
        self.detail = DetailPanel(True, INVITATION, self.large, switch)
        self.detail.explain("How large it is, and whom to thank for its icons")
        tip = "Save the pattern as the background of a style sheet (Ctrl+Alt+E)"
        self.detail.add_button("css", push_button("CSS…", tip))
        for name, text in (("svg", "SVG…"), ("png", "PNG…")):
            self.detail.buttons[name].setText(text)  # there are more of them than elsewhere
        self.seeds = SeedsPanel()
        self.colour = ColourButton((*PALETTE, INK, GROUND), "Colour of the chosen icons")
        self.make_actions()
        actions = self.actions_by_name
        self.controls = PatternControls(self.document, self.outlines, actions["shape"])
        self.start_buttons = StartButtons(self.view, actions["image_in"], self.examples)
        self._lay_out()
        self._wire()
        self.show_page()

    def _lay_out(self) -> None:
        upright, across = Qt.Orientation.Vertical, Qt.Orientation.Horizontal
        bar = "undo redo", "arrange brush", "mirror duplicate front behind", "scatter fit"
        canvas = self.canvas_panel_of(*bar, trailing=[self.colour])
        for panel in (self.chooser, self.layers):
            self.below.addWidget(panel)
        left = splitter(upright, (canvas, 400, 3), (card((self.below, 1)), 190, 2))
        right = QWidget()
        column(self.controls, (self.seeds, 1), of=right)
        row(splitter(across, (left, 440, 2), (self.detail, 524, 3), (right, 280, 0)), of=self)

    def _wire(self) -> None:
        patterner = self.patterner
        for runner in (patterner.live, patterner.others):
            self.follow(runner)
            runner.failed.connect(self.failed)
        self.detail.watch(patterner.live)
        self.follow(self.opener.runner)
        self.follow(self.reader)
        self.reader.event.connect(self._show_layers)
        self.reader.failed.connect(self.layers.caption.setText)
        self.layers.tinted.connect(self.scene.set_tinted)
        patterner.patterned.connect(self._show_result)
        patterner.sheet_began.connect(self._begin_sheet)
        patterner.sheet_grew.connect(self._grow_sheet)
        patterner.remarked.connect(self.layers.remark)
        patterner.left.connect(self._leave)
        self.seeds.chosen.connect(self._take_seed)
        self.seeds.sheet.asked.connect(self.offer_for)
        self.colour.chosen.connect(lambda colour: edits.colour_chosen(self.document, colour))
        self.chooser.chosen.connect(lambda one: self.opener.take(one.pictogram))
        shape = self.actions_by_name["shape"]
        self.importer.wants_shape = shape.isChecked
        self.importer.shape_taken = lambda: shape.setChecked(False)

    # -- what the window asks for --------------------------------------------------------------

    @property
    def icons(self) -> tuple[Pictogram, ...]:
        """The icons of the exemplar."""
        return self.page.icons

    def enter(self) -> None:
        """Begin with looking for icons, then on the canvas."""
        (self.chooser if self.page.empty else self.view).setFocus()

    def run(self) -> None:
        """Make the pattern once more."""
        self.patterner.run()

    def outcome(self) -> str:
        """Return how many patterns there are to choose from."""
        count = len(self.seeds.sheet.pictures)
        return counted(count, "pattern") if count else ""

    # -- results -------------------------------------------------------------------------------

    def _show_result(self, made: Made) -> None:
        self.look_at(made.picture)
        self.show_age()

    @property
    def stale(self) -> bool:
        """Whether the pattern in sight is of something else than the page."""
        return self.patterner.stale

    def _begin_sheet(self, made: Made) -> None:
        self.seeds.begin(made)

    def _grow_sheet(self, made: Made) -> None:
        self.seeds.add(made)
        self.counted.emit(len(self.seeds.sheet.pictures))

    def _take_seed(self, work: Patterning) -> None:
        edits.set_seed(self.document, work.seed)
        made = self.patterner.made
        if made is not None and made.work == self.page.work and not made.picture.preview:
            self.kept.emit(made.picture)

    def _leave(self) -> None:
        """Leave the results behind: their exemplar is gone."""
        self.seeds.clear()
        if self.picture is not None:
            self.look_at(None)
        self.rest()

    # -- page ----------------------------------------------------------------------------------

    def show_page(self) -> None:
        """Show what the page says, and have its pattern made."""
        page = self.page
        self.controls.show_page(page)
        self.seeds.show_used(page.work)
        chosen = [page.work.motifs[number] for number in sorted(page.chosen)]
        self.colour.setEnabled(bool(chosen))
        if chosen:
            self.colour.show_colour(chosen[-1].colour)
        self._show_image(page.work.image)
        self.patterner.request(page)
        self.show_age()

    def _show_image(self, image: Separation | None) -> None:
        """Show the layers of the image, with the brush for them; or have icons chosen."""
        if self._has_image != (image is not None):
            self._has_image = image is not None
            self.scene.show_layers(None)
            self.actions_by_name["brush" if image else "arrange"].setChecked(True)
        self._show_panel()
        self.reader.request(image)
        if image is not None:
            self.layers.show_image(image)

    def _show_panel(self) -> None:
        choosing = not self._has_image or self.actions_by_name["shape"].isChecked()
        self.below.setCurrentWidget(self.chooser if choosing else self.layers)

    def _show_layers(self, layers: object) -> None:
        if isinstance(layers, ImageLayers):
            self.scene.show_layers(layers)
            self.layers.show_layers(layers)

    def _use_layer(self, number: int) -> None:
        self.tools["brush"].layer = number
        self.view.refresh()

    def scatter(self) -> None:
        """Scatter the icons anew."""
        edits.scatter(self.document, random.randrange(10_000))

    def tell_mistakes(self, edit: Callable[[object], object]) -> None:
        """Do an edit; if it cannot be done, tell why."""
        try:
            edit(self.document)
        except IconstudioError as error:
            self.hinted.emit(str(error))

    def await_shape(self, on: bool) -> None:
        """Let the next icon be the shape that is filled, or no longer."""
        self._show_panel()
        self.remarked.emit(SHAPE_AWAITED if on else "")
        if on:
            self.chooser.caption.say(SHAPE_AWAITED)
            self.chooser.setFocus()
        else:
            self.chooser.tell()

    # -- files ---------------------------------------------------------------------------------

    def choose_image(self) -> None:
        """Ask for an image to continue."""
        self.opener.ask("Open an image to continue", IMAGES, self.open_image)

    def open_image(self, path: str) -> None:
        """Open a file as an image, whatever it is called."""
        self.opener.replace(lambda: self.importer.image(File(path)))

    def save(self) -> None:
        """Write the work into a file, beside its image."""
        image = self.page.work.image
        photos = {} if image is None else {"image": image.photo}
        self.save_work(self.page.work, "pattern", photos)
