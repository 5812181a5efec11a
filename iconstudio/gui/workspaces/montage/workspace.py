"""Pictogram montage (section 4.4): bring icons in, arrange them, scribble over what to keep."""

from functools import partial

from PySide6.QtCore import Qt

from iconstudio.gui.canvas.start import StartButtons
from iconstudio.gui.canvas.view import CanvasView
from iconstudio.gui.exchange.opening import Opener
from iconstudio.gui.gallery.detail import DetailPanel
from iconstudio.gui.jobs.live import LiveRunner
from iconstudio.gui.panels.chooser import IconChooser
from iconstudio.gui.panels.slider import IconSlider
from iconstudio.gui.pictures.picture import Picture
from iconstudio.gui.theme.layout import row, splitter
from iconstudio.gui.workspaces.base import Workspace
from iconstudio.gui.workspaces.montage.actions import ENTRIES
from iconstudio.gui.workspaces.montage.layers import LayerList, left_side
from iconstudio.gui.workspaces.montage.live import TITLE, Request, made
from iconstudio.gui.workspaces.montage.scene import MontageScene
from iconstudio.gui.workspaces.montage.tools import montage_tools
from iconstudio.gui.workspaces.montage.tools.scribble import THINNEST, WIDEST, Brush
from iconstudio.importing.montages import MontageImporter
from iconstudio.model import Pictogram, Remix
from iconstudio.workflows.events import Remark
from iconstudio.workflows.montage.page import MontagePage

DESCRIPTION = "Arrange icons, and scribble over their parts, here"
INVITATION = "Scribble over a part of an icon with the brush: the montage appears here."


class MontageWorkspace(Workspace):
    """Icons to choose from and layers on the left, the canvas, and the live result on the right."""

    page_type = MontagePage
    keeps_last = True
    entries = ENTRIES

    def build(self) -> None:
        """Make canvas, panels and runs."""
        self.importer = MontageImporter(self.session, self.document)
        self.opener = Opener(self.importer, self.finder, self)
        self.live = LiveRunner(self.worker, partial(made, self.session), self)
        self.scene = MontageScene(self.document, self.outlines)
        self.brush = Brush(self)
        self.tools = montage_tools(self.document, self.scene, self.brush)
        self.view = CanvasView(self.scene, self.tools["brush"], DESCRIPTION)
        self.chooser = IconChooser(self.session, self.finder)
        self.layers = LayerList(self.document)
        self.detail = DetailPanel(upright=True, invitation=INVITATION)
        self.make_actions()
        self.start_buttons = StartButtons(self.view, self.actions_by_name["svg_in"], self.examples)
        bar = "undo redo", "arrange brush eraser pan", "mirror fit clear"
        sizes, brush = (THINNEST, WIDEST), self.brush
        self.slider = IconSlider("brush", "Brush size", sizes, brush.width, brush.set_width)
        brush.changed.connect(self.slider.slider.setValue)
        panel = self.canvas_panel_of(*bar, trailing=[self.slider])
        left = left_side(self.chooser, self.layers)
        parts = (left, 292, 0), (panel, 552, 3), (self.detail, 416, 2)
        row(splitter(Qt.Orientation.Horizontal, *parts), of=self)
        self.chooser.chosen.connect(lambda one: self.opener.take(one.pictogram))
        self.detail.watch(self.live)
        self.follow(self.live, self._show_result)

    # -- what the window asks for --------------------------------------------------------------

    @property
    def icons(self) -> tuple[Pictogram, ...]:
        """The icons on the canvas."""
        return tuple(one.icon.pictogram for one in self.page.layers)

    def enter(self) -> None:
        """Begin with looking for icons, then on the canvas."""
        (self.view if self.page.layers else self.chooser).setFocus()

    def open_result(self, result: Remix) -> None:
        """Put the sources of a result in place of what is there, marked so that it comes again."""
        self.opener.replace(lambda: self.importer.reproducing(result))

    # -- result --------------------------------------------------------------------------------

    def _show_result(self, event: object) -> None:
        if isinstance(event, Picture):
            self.look_at(event)
        elif isinstance(event, Remark):
            self.hinted.emit(event.sentence)

    # -- page ----------------------------------------------------------------------------------

    def show_page(self) -> None:
        """Show what the page says."""
        page = self.page
        if page.marked:
            self.live.request(Request.of(page))
        else:
            self.live.cancel()
            if self.picture is not None:
                self.look_at(None)

    def save(self) -> None:
        """Write the montage into a file."""
        self.save_work(self.page.montage(), TITLE)
