"""Sketch-based modelling (section 4.1): trace, name, remix."""

from collections.abc import Generator
from pathlib import Path

import numpy as np
from numpy.typing import NDArray
from PySide6.QtCore import Qt

from iconstudio.algorithms.geometry import crosses_itself
from iconstudio.gui.canvas.start import StartButtons
from iconstudio.gui.canvas.tools.polygon import PolygonTool
from iconstudio.gui.canvas.view import CanvasView
from iconstudio.gui.document.document import Document
from iconstudio.gui.exchange.mime import holds_something
from iconstudio.gui.exchange.saving import Saver
from iconstudio.gui.gallery.pictures import Picture
from iconstudio.gui.jobs.worker import Worker
from iconstudio.gui.window.actions import Entry, Key, work_entries
from iconstudio.gui.workspaces.remixing import RemixWorkspace
from iconstudio.gui.workspaces.sketching.opening import SketchOpener
from iconstudio.gui.workspaces.sketching.overlay import DimSlider
from iconstudio.gui.workspaces.sketching.scene import SketchScene
from iconstudio.images.photo import file_beside
from iconstudio.model import IconstudioError, Polygon, Sketch
from iconstudio.session import Session
from iconstudio.workflows.events import Event, RegionsFound
from iconstudio.workflows.files import write_file
from iconstudio.workflows.grid import ModelSettings
from iconstudio.workflows.modelling import page as edits
from iconstudio.workflows.modelling.file import SketchFile
from iconstudio.workflows.modelling.page import SketchPage
from iconstudio.workflows.outline import Outline
from iconstudio.workflows.workflow import Workflow

OWN = {
    "&File": (
        *work_entries("sketch"),
        Entry("photo", "Open &photo…", "Open a photo to trace over", "Ctrl+Shift+O", "photo"),
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


class SketchWorkspace(RemixWorkspace):
    """The outline of an object is traced, perhaps over a photo, and remixed."""

    def __init__(self, workflow: Workflow, session: Session, files: Worker, saver: Saver) -> None:
        super().__init__(workflow, session, files, saver, Document(SketchPage()))
        self.opener = SketchOpener(session, self.document, files, self)
        self._regions: tuple = ()

        self.scene = SketchScene(self.document)
        self.scene.setParent(self)
        self.outline = Outline(self.document)
        self.tool = PolygonTool(self.outline)
        self.view = CanvasView(self.scene, self.tool, holds_something)
        self.view.setAccessibleDescription("Trace the outline of an object here")
        self.dim = DimSlider()
        self.offer_symmetry(lambda page: page.sketch.polygon if page.closed else None, _filled)

        self._make_actions()
        self.start_buttons = StartButtons(
            self.view, "Open photo…", self.actions_by_name["photo"], self.examples
        )
        self._lay_out()
        self._wire()
        self.show_page()

    # -- putting together ----------------------------------------------------------------------

    def _make_actions(self) -> None:
        self.make_actions(
            {
                "new": lambda: edits.load_sketch(self.document, Sketch(), text="new sketch"),
                "photo": self.opener.choose_photo,
                "save": self._save,
                "delete": self.tool.delete_selected,
                "clear": self._clear_outline,
                "trace": lambda on: self.view.set_tool(self.tool if on else self.view.pan_tool),
                "regions": self._show_regions,
                **self.opener_slots(self.opener),
                **self.remix_slots(),
            },
            OWN,
        )
        self.actions_by_name.choose_between("trace", "pan")
        self.examples = self.add_examples(self.workflow.examples, self.opener.open_work)

    def _lay_out(self) -> None:
        named = self.actions_by_name
        groups = [
            [named["photo"], named["examples"]],
            [named["undo"], named["redo"]],
            [named[name] for name in ("trace", "pan", "fit", "regions", "clear")],
            [self.symmetry, named["live"]],
        ]
        self.lay_out(groups, [self.dim])

    def _wire(self) -> None:
        self.document.page_changed.connect(self.show_page)
        self.wire()
        self.connect_opener(self.opener)
        self.dim.slider.valueChanged.connect(self.scene.set_dim)
        self.view.dropped.connect(lambda data, _: self.opener.open_mime(data))

    # -- what the window asks for --------------------------------------------------------------

    def demonstrate(self, example: SketchFile) -> None:
        """Load an example and remix it as soon as it is there."""
        self.opener.opened.connect(self.run, Qt.ConnectionType.SingleShotConnection)
        self.opener.open_example(example)

    # -- modelling -----------------------------------------------------------------------------

    def inputs(self) -> Sketch:
        """Return the sketch."""
        return self.document.page.sketch

    def settings(self) -> ModelSettings:
        """Return all styles."""
        return ModelSettings()

    def events(self, inputs: Sketch, settings: ModelSettings) -> Generator[Event]:
        """Return the run of a sketch."""
        return self.session.run(self.workflow, inputs, settings)

    def complete(self) -> None:
        """Close an outline that is still open."""
        page = self.document.page
        if not page.closed and len(page.vertices) >= 3:
            self.outline.close()

    def run(self) -> None:
        """Remix for the sketch; an outline that is still open is closed first."""
        super().run()
        if self.runs.running and crosses_itself(self.document.page.sketch.polygon):
            self.hinted.emit(
                "The outline crosses itself; everything that it encloses counts as inside."
            )

    def finished(self) -> bool:
        """Whether the outline is closed and has a name."""
        return super().finished() and self.document.page.closed

    def problem(self) -> str:
        """Return what is missing before the sketch can be remixed."""
        page = self.document.page
        if not page.vertices:
            return "There is no outline yet. Click around the object on the canvas to trace it."
        try:
            page.sketch.polygon.fitted()
        except IconstudioError as error:
            return str(error)
        if not page.closed:
            return "The outline is still open. Click its first point to close it."
        if not page.sketch.keyword.strip():
            return (
                "The object has no name yet. Type what it is below the canvas, for example “dog”."
            )
        return ""

    def show_event(self, event: Event | Picture) -> None:
        """Show what a run has come to."""
        if isinstance(event, RegionsFound):
            self._regions = event.centres
            self._show_regions()
        super().show_event(event)

    # -- page ----------------------------------------------------------------------------------

    def show_page(self) -> None:
        """Show what the page says."""
        page = self.document.page
        self.show_criteria("sketch")
        self.start_buttons.setVisible(page.empty)
        self.dim.setVisible(page.photo is not None)
        if not page.vertices:
            self._regions = ()
        self._show_regions()
        for name in ("clear", "delete", "save"):
            self.actions_by_name[name].setEnabled(bool(page.vertices))

    def _show_regions(self) -> None:
        ran = self.runs.ran
        same = ran is not None and ran.polygon == self.document.page.sketch.polygon
        # In live mode those of a moment ago stay until the new ones come.
        wanted = self.actions_by_name["regions"].isChecked() and (same or self.runs.live)
        self.scene.set_regions(self._regions if wanted else ())

    def _clear_outline(self) -> None:
        if self.document.page.vertices:
            self.outline.clear()

    def _save(self) -> None:
        page = self.document.page
        title = page.sketch.keyword

        def write(path: Path) -> None:
            photo = None if page.photo is None else str(file_beside(page.photo, path))
            write_file(path, self.workflow, page.sketch, photo=photo)

        self.saver.save_work("sketch", title, write)


def _filled(polygon: Polygon) -> NDArray[np.bool_]:
    from iconstudio.algorithms.raster import fill_polygon

    return fill_polygon(polygon.fitted())
