"""Pictogram montage (section 4.4): bring icons in, arrange them, scribble over what to keep."""

from collections.abc import Callable
from dataclasses import replace
from functools import partial

from PySide6.QtCore import Qt
from PySide6.QtGui import QHideEvent
from PySide6.QtWidgets import (
    QFrame,
    QHBoxLayout,
    QLabel,
    QSplitter,
    QVBoxLayout,
    QWidget,
)

from iconstudio.gui.canvas.outlines import IconOutlines
from iconstudio.gui.canvas.start import StartButtons
from iconstudio.gui.canvas.view import CanvasView
from iconstudio.gui.document.document import Document
from iconstudio.gui.exchange.mime import holds_something
from iconstudio.gui.exchange.saving import Saver
from iconstudio.gui.gallery.detail import DetailPanel
from iconstudio.gui.gallery.display_switch import DisplaySwitch
from iconstudio.gui.gallery.pictures import Picture
from iconstudio.gui.gallery.sending import Destination
from iconstudio.gui.jobs.live import LiveRunner
from iconstudio.gui.jobs.worker import Worker
from iconstudio.gui.panels.canvas import CanvasPanel
from iconstudio.gui.panels.chooser import IconChooser
from iconstudio.gui.theme.theme import UNIT
from iconstudio.gui.window.actions import Entry, Key, work_entries
from iconstudio.gui.workspaces.base import Workspace
from iconstudio.gui.workspaces.montage.appearance import palette_of
from iconstudio.gui.workspaces.montage.layers import LayerList, scrolling
from iconstudio.gui.workspaces.montage.live import TITLE, Request, made
from iconstudio.gui.workspaces.montage.opening import MontageOpener
from iconstudio.gui.workspaces.montage.overlay import BrushSlider
from iconstudio.gui.workspaces.montage.scene import MontageScene
from iconstudio.gui.workspaces.montage.tools.arrange import ArrangeTool
from iconstudio.gui.workspaces.montage.tools.scribble import Brush, ScribbleTool
from iconstudio.model import Pictogram
from iconstudio.session import Session
from iconstudio.workflows.files import write_file
from iconstudio.workflows.montage.page import MontagePage, choose
from iconstudio.workflows.workflow import Workflow

OWN = {
    "&File": (
        *work_entries("montage"),
        Entry("svg_in", "Op&en drawing…", "Add a drawing of your own", "Ctrl+Shift+O", "open"),
    ),
    "&Edit": (
        Entry("paste", "P&aste drawing", "Add the drawing on the clipboard", Key.Paste),
        Entry("delete", "&Delete icon", "Take the chosen icon out", "Backspace"),
        Entry("clear", "Clear &scribbles", "Remove all scribbles", "Ctrl+Backspace", "clear"),
        Entry("mirror", "&Mirror icon", "Mirror the chosen icon", "M", "mirror"),
        Entry("wider", "&Wider brush", "Wider brush", "]"),
        Entry("narrower", "&Narrower brush", "Narrower brush", "["),
    ),
    "&View": (
        Entry("arrange", "&Arrange icons", "Choose, move and scale icons", "V", "arrow", True),
        Entry("brush", "&Keep brush", "Scribble over the parts to keep", "B", "brush", True),
        Entry("eraser", "&Eraser", "Rub scribbles out", "E", "eraser", True),
    ),
}  # fmt: skip

_INVITATION = (
    "The montage appears here as soon as you scribble over a part of an icon with the brush."
)


class MontageWorkspace(Workspace):
    """Icons to choose from and layers on the left, the canvas, and the live result on the right."""

    def __init__(self, workflow: Workflow, session: Session, files: Worker, saver: Saver) -> None:
        super().__init__(workflow, session, files, saver, Document(MontagePage()))
        self.finder = Worker(self)
        """Looks icons up and draws them also while a montage is made."""
        self.opener = MontageOpener(session, self.document, self.finder, self)
        self.outlines = IconOutlines(session, self.finder, self)
        self.live = LiveRunner(self.worker, partial(made, session), self)
        self._kept: Picture | None = None

        self.scene = MontageScene(self.document, self.outlines)
        self.scene.setParent(self)
        self.brush = Brush(self)
        self.tools = {
            "arrange": ArrangeTool(self.document, self.scene),
            "brush": ScribbleTool(self.document, self.scene, self.brush, rubs=False),
            "eraser": ScribbleTool(self.document, self.scene, self.brush, rubs=True),
        }
        self.view = CanvasView(self.scene, self.tools["brush"], holds_something)
        self.view.setAccessibleDescription("Arrange icons, and scribble over their parts, here")
        self.chooser = IconChooser(session, self.finder)
        self.layers = LayerList()
        self.detail = DetailPanel(upright=True, invitation=_INVITATION)
        self.slider = BrushSlider(self.brush)
        self.switch = DisplaySwitch()

        self._make_actions()
        self.start_buttons = StartButtons(
            self.view, "Open drawing…", self.actions_by_name["svg_in"], self.examples
        )
        self.displays = self.switch, self.detail.large
        self._lay_out()
        self._wire()
        self._show_page(self.document.page)

    # -- putting together ----------------------------------------------------------------------

    def _make_actions(self) -> None:
        self.make_actions(
            {
                "new": lambda: self._change("new montage", lambda page: MontagePage()),
                "svg_in": self.chooser.choose_file,
                "save": self._save,
                "delete": lambda: self._delete(self.document.page.current.number),
                "clear": lambda: self._change("clear scribbles", MontagePage.cleared),
                "mirror": self._mirror,
                "wider": lambda: self.brush.step(1),
                "narrower": lambda: self.brush.step(-1),
                **self.opener_slots(self.opener),
                **{name: self._chooser_of(name) for name in self.tools},
                **self.view_slots(self.view),
                "pan": lambda on: on and self.view.set_tool(self.view.pan_tool),
            },
            OWN,
        )
        self.actions_by_name.choose_between("brush", "arrange", "eraser", "pan")
        self.examples = self.add_examples(self.workflow.examples, self.opener.open_work)

    def _chooser_of(self, name: str) -> Callable[[bool], None]:
        return lambda on: on and self.view.set_tool(self.tools[name])

    def _lay_out(self) -> None:
        named = self.actions_by_name
        groups = [
            [named["undo"], named["redo"]],
            [named[name] for name in ("arrange", "brush", "eraser", "pan")],
            [named[name] for name in ("mirror", "fit", "clear")],
        ]
        self.canvas_panel = CanvasPanel(self.view, groups, [self.slider])
        left = QSplitter(Qt.Orientation.Vertical)
        left.addWidget(_card("Find icons", self.chooser))
        left.addWidget(_card("Layers", scrolling(self.layers)))
        left.setSizes([300, 260])
        self.detail.add_to_heading(self.switch)
        whole = QSplitter(Qt.Orientation.Horizontal)
        for part, share in ((left, 0), (self.canvas_panel, 3), (self.detail, 2)):
            whole.addWidget(part)
            whole.setStretchFactor(whole.count() - 1, share)
        whole.setSizes([292, 552, 416])
        for splitter in (left, whole):
            splitter.setHandleWidth(UNIT)
            splitter.setChildrenCollapsible(False)
        layout = QHBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.addWidget(whole)

    def _wire(self) -> None:
        layers, live = self.layers, self.live
        self.connect_opener(self.opener)
        self.chooser.chosen.connect(lambda one: self.opener.take(one.pictogram))
        self.view.dropped.connect(lambda data, _: self.opener.open_mime(data))
        layers.chosen.connect(lambda number: choose(self.document, number))
        layers.deleted.connect(self._delete)
        layers.hid.connect(self._hide)
        layers.moved.connect(
            lambda number, at: self._change("reorder icons", lambda page: page.ordered(number, at))
        )
        self.switch.chosen.connect(self.choose_display)
        self.document.page_changed.connect(self._show_page)
        live.event.connect(self._show_result)
        live.progress.connect(self.progressed)
        live.failed.connect(self.failed)
        live.ended.connect(lambda _: live.running or self.idle.emit(""))
        self.detail.sent.connect(lambda title: self.send_picture(self.picture, title))
        self.connect_detail(self.detail)
        self.kept.connect(self._note_kept)

    # -- what the window asks for --------------------------------------------------------------

    @property
    def picture(self) -> Picture | None:
        """The result."""
        return self.detail.picture

    @property
    def icons(self) -> tuple[Pictogram, ...]:
        """The icons on the canvas."""
        return tuple(one.icon.pictogram for one in self.document.page.layers)

    def enter(self) -> None:
        """Begin with looking for icons, then on the canvas."""
        (self.view if self.document.page.layers else self.chooser).setFocus()

    def take(self, pictogram: Pictogram) -> None:
        """Add an icon."""
        self.opener.take(pictogram)

    def set_destinations(self, destinations: tuple[Destination, ...]) -> None:
        """Say where results can be sent to."""
        self.detail.set_destinations(destinations)

    def cancel(self) -> None:
        """Stop the run; the last result stays."""
        self.live.cancel()

    def hideEvent(self, event: QHideEvent) -> None:
        """Keep the result in sight when the user goes elsewhere."""
        super().hideEvent(event)
        if not event.spontaneous() and self.picture is not None and self.picture is not self._kept:
            self.kept.emit(self.picture)

    # -- result --------------------------------------------------------------------------------

    def _show_result(self, event: object) -> None:
        if isinstance(event, Picture):
            self.detail.show_picture(event)
            self.picked.emit(event)

    def _note_kept(self, picture: Picture) -> None:
        self._kept = picture

    # -- page ----------------------------------------------------------------------------------

    def _show_page(self, page: MontagePage) -> None:
        if page.marked:
            self.live.request(Request(page.montage(), palette_of(page)))
        else:
            self.live.cancel()
            if self.picture is not None:
                self.detail.show_picture(None)
                self.picked.emit(None)
        self.layers.show_page(page)
        for one in page.layers:
            self.outlines.request(one.icon.exemplar)
        self.start_buttons.setVisible(not page.layers)
        self.actions_by_name["clear"].setEnabled(any(one.strokes for one in page.layers))
        for name in ("delete", "mirror", "save"):
            self.actions_by_name[name].setEnabled(bool(page.layers))

    def _change(self, text: str, edit: Callable[[MontagePage], MontagePage]) -> None:
        after = edit(self.document.page)
        if after != self.document.page:
            self.document.change(text, after)

    def _delete(self, number: int) -> None:
        self._change("delete icon", lambda page: page.without(number))

    def _mirror(self) -> None:
        layer = self.document.page.current
        placement = replace(layer.placement, flip=not layer.placement.flip)
        self._change("mirror icon", lambda page: page.placed(layer.number, placement))

    def _hide(self, number: int, hidden: bool) -> None:
        text = "hide icon" if hidden else "show icon"
        self._change(text, lambda page: page.hidden(number, hidden))

    def _save(self) -> None:
        page = self.document.page
        montage = page.montage()
        self.saver.save_work(
            "montage", TITLE, lambda path: write_file(path, self.workflow, montage)
        )


def _card(title: str, widget: QWidget) -> QFrame:
    card = QFrame()
    card.setProperty("card", True)
    heading = QLabel(title)
    heading.setProperty("heading", True)
    layout = QVBoxLayout(card)
    layout.setContentsMargins(UNIT * 3 // 2, UNIT, UNIT, UNIT)
    layout.setSpacing(UNIT)
    layout.addWidget(heading)
    layout.addWidget(widget, 1)
    return card
