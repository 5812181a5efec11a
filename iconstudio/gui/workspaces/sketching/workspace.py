"""Sketch-based modelling (section 4.1): trace, name, remix."""

import numpy as np
from numpy.typing import NDArray
from PySide6.QtCore import Qt

from iconstudio.gui.canvas.start import StartButtons
from iconstudio.gui.canvas.tools.areas import DrawTool, SelectTool
from iconstudio.gui.canvas.tools.polygon import PolygonTool
from iconstudio.gui.canvas.view import CanvasView
from iconstudio.gui.exchange.opening import Opener
from iconstudio.gui.panels.options import OptionsButton
from iconstudio.gui.panels.slider import IconSlider
from iconstudio.gui.pictures.picture import Picture
from iconstudio.gui.workspaces.remixing import RemixWorkspace
from iconstudio.gui.workspaces.sketching.actions import ENTRIES
from iconstudio.gui.workspaces.sketching.alternatives import PartAlternatives
from iconstudio.gui.workspaces.sketching.scene import SketchScene
from iconstudio.importing.sketches import PHOTOS, SketchImporter
from iconstudio.model import Polygon, Sketch
from iconstudio.workflows.areas import AreaOutline, Kind
from iconstudio.workflows.events import Event, RegionsFound
from iconstudio.workflows.modelling.file import SketchFile
from iconstudio.workflows.modelling.page import (
    SketchPage,
    doubts,
    problem,
    set_detail,
    unpin_all,
)
from iconstudio.workflows.outline import Outline
from iconstudio.workflows.pinning import idle_pins

_SELECT = (
    "Click a hole or a line to correct it",
    "There is nothing inside the outline yet: draw a hole (O) or a line (I)",
)
DESCRIPTION = "Trace the outline of an object here"


class SketchWorkspace(RemixWorkspace):
    """The outline of an object is traced, perhaps over a photo, and remixed."""

    page_type = SketchPage
    entries = ENTRIES
    placeholder = "What is it? For example: motorcycle"
    tip = "Make new icons in four styles (Ctrl+Return)"
    welcome = (
        "Your icons appear here: a row for each style, from thin lines to solid.\nOn the left "
        "they stay closer to your sketch; to the right, larger parts join more smoothly."
    )
    nearer = "Closer to the sketch"

    def build(self) -> None:
        """Make canvas, panels and runs."""
        super().build()
        self.importer = SketchImporter(self.session, self.document)
        self.opener = Opener(self.importer, self.files, self)
        self._regions: RegionsFound | None = None
        self.scene = SketchScene(self.document)
        self.outline = Outline(self.document)
        self.tool = PolygonTool(self.outline)
        self.inner = AreaOutline(self.document)
        self.tools = {"trace": self.tool, "select": SelectTool(self.inner, *_SELECT)}
        for kind in (Kind.HOLE, Kind.LINE):
            self.tools[kind.value] = DrawTool(self.inner, kind)
        self.view = CanvasView(self.scene, self.tool, DESCRIPTION)
        self.dim = IconSlider("dim", "Dim the photo", (0, 100), 35, self.scene.set_dim)
        self.offer_symmetry(lambda page: page.sketch.polygon if page.closed else None, _filled)
        self.alternatives = PartAlternatives(
            self.session, self.document, self.finder, self.detail.large, self
        )
        self.alternatives.runner.failed.connect(self.failed)
        self.alternatives.changed.connect(self._remix_pinned)
        self.alternatives.exchanged.connect(self._open_exchanged)
        self.make_actions()
        self.options = OptionsButton(self.actions_by_name["scales"], self._weight_details)
        self.keyword_panel.put_beside(self.options)
        self.start_buttons = StartButtons(self.view, self.actions_by_name["photo"], self.examples)
        bar = "photo examples", "undo redo", "trace hole|line|select pan fit clear"
        self.lay_out(*bar, trailing=[self.dim])

    # -- what the window asks for --------------------------------------------------------------

    @property
    def remarks(self) -> tuple[str, ...]:
        """Which pins are not heeded."""
        return tuple(filter(None, [idle_pins(self.page.sketch)]))

    def demonstrate(self, example: SketchFile) -> None:
        """Load an example and remix it as soon as it is there."""
        self.opener.opened.connect(self.run, Qt.ConnectionType.SingleShotConnection)
        self.open_sketch(example)

    def open_sketch(self, file: SketchFile) -> None:
        """Put another sketch in place of the one that is there."""
        self.opener.replace(lambda: self.importer.resolving(file))

    def choose_photo(self) -> None:
        """Ask for a photo."""
        self.opener.ask("Open a photo to trace over", PHOTOS, self.opener.open_file)

    # -- modelling -----------------------------------------------------------------------------

    def inputs(self) -> Sketch:
        """Return the sketch."""
        return self.page.sketch

    def complete(self) -> None:
        """Close an outline that is still open, and end what is drawn inside it."""
        self.inner.finish()
        page = self.page
        if not page.closed and len(page.vertices) >= 3:
            self.outline.close()

    def finished(self) -> bool:
        """Whether the outline is closed and has a name."""
        return super().finished() and self.page.closed

    def problem(self) -> str:
        """Return what is missing before the sketch can be remixed."""
        return problem(self.page)

    def doubts(self) -> str:
        """Return which outlines cross themselves."""
        return doubts(self.page.sketch)

    def show_event(self, event: Event | Picture) -> None:
        """Show what a run has come to."""
        if isinstance(event, RegionsFound):
            self._regions = event
            self.show_regions()
        super().show_event(event)

    def unpin(self) -> None:
        """Remove all pins."""
        unpin_all(self.document)
        self._remix_pinned()

    def _remix_pinned(self) -> None:
        """Remix with the pins that were changed; in live mode, that goes by itself."""
        if not self.runner.live and not self.problem():
            self.runner.run(following=True)

    def _open_exchanged(self, picture: Picture) -> None:
        for one in self.destinations:
            if one.opens_results:
                self.send_sources_of(picture, one.title)

    # -- page ----------------------------------------------------------------------------------

    def show_page(self) -> None:
        """Show what the page says."""
        page = self.page
        self.show_criteria("sketch")
        self.dim.setVisible(page.photo is not None)
        self.options.show_detail(page.sketch.detail)
        self.detail.large.show_pins(page.sketch.pins)
        if not page.vertices:
            self._regions = None
            if not page.areas and self.tool is not self.tools["trace"]:
                self.actions_by_name["trace"].trigger()
        self.show_regions()

    def show_regions(self, on: bool = True) -> None:
        """Show the salient regions of the outline, if they are wanted and known."""
        ran = self.runner.ran
        same = ran is not None and ran.polygon == self.page.sketch.polygon
        # In live mode those of a moment ago stay until the new ones come.
        wanted = self.actions_by_name["regions"].isChecked() and (same or self.runner.live)
        found = self._regions if wanted else None
        if found is None:
            self.scene.set_regions(())
        else:
            self.scene.set_regions(found.centres, found.details)

    def use_tool(self, name: str) -> None:
        """Take another tool; what is drawn inside with another one is finished."""
        tool = self.tool = self.tools[name]
        self.inner.turn_to(tool.kind if isinstance(tool, DrawTool) else None)
        super().use_tool(name)

    def _weight_details(self, detail: float, gesture: object) -> None:
        set_detail(self.document, detail, gesture)

    def save(self) -> None:
        """Write the sketch into a file, beside its photo."""
        sketch, photo = self.page.sketch, self.page.photo
        self.save_work(sketch, sketch.keyword, {} if photo is None else {"photo": photo})


def _filled(polygon: Polygon) -> NDArray[np.bool_]:
    from iconstudio.algorithms.raster import fill_polygon

    return fill_polygon(polygon.fitted())
