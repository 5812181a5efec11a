"""Pictogram editing (section 4.2): choose an icon, mark what goes and what comes, remix."""

from collections.abc import Generator
from typing import NamedTuple

from iconstudio.gui.canvas.outlines import IconOutlines
from iconstudio.gui.canvas.view import CanvasView
from iconstudio.gui.document.document import Document
from iconstudio.gui.exchange.mime import holds_something
from iconstudio.gui.exchange.saving import Saver
from iconstudio.gui.jobs.worker import Worker
from iconstudio.gui.window.actions import Entry, Key, work_entries
from iconstudio.gui.workspaces.editing.areas import AreaOutline
from iconstudio.gui.workspaces.editing.opening import EditOpener
from iconstudio.gui.workspaces.editing.scene import EditScene
from iconstudio.gui.workspaces.editing.start import StartPanel
from iconstudio.gui.workspaces.editing.tools import DrawTool, SelectTool
from iconstudio.gui.workspaces.remixing import RemixWorkspace
from iconstudio.model import Edit, IconstudioError, Pictogram
from iconstudio.session import Session
from iconstudio.workflows.editing import page as edits
from iconstudio.workflows.editing.editing import own_styles, place_edit
from iconstudio.workflows.editing.page import EditPage, Kind
from iconstudio.workflows.events import Event
from iconstudio.workflows.files import write_file
from iconstudio.workflows.grid import ModelSettings
from iconstudio.workflows.workflow import Workflow

OWN = {
    "&File": (
        *work_entries("edit"),
        Entry("icon", "Choose &icon…", "Choose another icon", "Ctrl+Shift+O", "search"),
    ),
    "&Edit": (
        Entry("paste", "&Paste icon", "Use the drawing on the clipboard", Key.Paste),
        Entry("delete", "&Delete", "Remove the selected area or point", "Backspace"),
        Entry("clear", "C&lear all areas", "Remove all areas", "Ctrl+Backspace", "clear"),
        Entry("run", "&Remix", "Make the icon anew where it is marked", "Ctrl+Return"),
    ),
    "&View": (
        Entry("remove", "Mark what &goes", "Remove: mark what should go", "R", "remove", True),
        Entry("add", "Draw what &comes", "Add: draw what should come", "A", "add", True),
        Entry("select", "&Correct areas", "Select, move and correct areas", "V", "select", True),
        Entry("styles", "Parts of a&ll styles", "Use parts of icons that are lighter or darker",
              "L", "", True),
    ),
}  # fmt: skip

WELCOME = (
    "The changed icon appears here, several times: on the left it keeps closer to what you drew;\n"
    "to the right, the new parts join more smoothly."
)


class EditInputs(NamedTuple):
    """What the results are of."""

    edit: Edit | None
    all_styles: bool


class EditWorkspace(RemixWorkspace):
    """An icon is changed where the user marks it."""

    def __init__(self, workflow: Workflow, session: Session, files: Worker, saver: Saver) -> None:
        super().__init__(workflow, session, files, saver, Document(EditPage()))
        self.finder = Worker(self)
        """Looks icons up and draws them also while a run goes on."""
        self.opener = EditOpener(session, self.document, files, self)
        self.outlines = IconOutlines(session, self.finder, self)
        self.scene = EditScene(self.document, self.outlines)
        self.scene.setParent(self)
        self.outline = AreaOutline(self.document)
        self.tools = {
            "remove": DrawTool(self.outline, Kind.REMOVE),
            "add": DrawTool(self.outline, Kind.ADD),
            "select": SelectTool(self.outline),
        }
        self.tool = self.tools["remove"]
        self.view = CanvasView(self.scene, self.tool, holds_something)
        self.view.setAccessibleDescription("Mark what should go and what should come here")
        self.browser.results.set_words(WELCOME, "Closer to the drawing")
        self.keyword_panel.set_words(
            "What is it? For example: camera", "Make the icon anew where it is marked (Ctrl+Return)"
        )
        self.offer_symmetry(_outline, lambda page: place_edit(page.edit(), page.icon).silhouette)
        self._make_actions()
        self.start_panel = StartPanel(self.view, session, self.finder, self.examples)
        self._lay_out()
        self._wire()
        self.show_page()

    # -- putting together ----------------------------------------------------------------------

    def _make_actions(self) -> None:
        self.make_actions(
            {
                "new": lambda: self.document.change("new edit", EditPage()),
                "icon": self._choose_icon,
                "save": self._save,
                "delete": self._delete,
                "clear": lambda: edits.clear(self.document),
                "remove": lambda on: self._use("remove", on),
                "add": lambda on: self._use("add", on),
                "select": lambda on: self._use("select", on),
                "styles": lambda _: self._show_styles(),
                **self.opener_slots(self.opener),
                **self.remix_slots(),
            },
            OWN,
        )
        self.actions_by_name.choose_between("remove", "add", "select", "pan")
        self.examples = self.add_examples(self.workflow.examples, self.opener.open_work)

    def _lay_out(self) -> None:
        named = self.actions_by_name
        self.lay_out(
            [
                [named["icon"]],
                [named["undo"], named["redo"]],
                [named[name] for name in ("remove", "add", "select", "pan", "fit", "clear")],
                [self.symmetry, named["live"]],
            ]
        )

    def _wire(self) -> None:
        self.document.page_changed.connect(self.show_page)
        self.wire()
        self.connect_opener(self.opener)
        chooser = self.start_panel.chooser
        chooser.chosen.connect(self.opener.take_exemplar)
        self.start_panel.closed.connect(lambda: self._show_start(False))
        self.document.opened.connect(lambda: self._show_start(self.document.page.empty))
        self.view.dropped.connect(lambda data, _: self.opener.open_mime(data))
        self.opener.opened.connect(self._begin)

    # -- what the window asks for --------------------------------------------------------------

    @property
    def icons(self) -> tuple[Pictogram, ...]:
        """The icon to be changed."""
        icon = self.document.page.icon
        return () if icon is None else (icon.pictogram,)

    def enter(self) -> None:
        """Begin on the canvas, or choose an icon."""
        super().enter()
        if self.start_panel.isVisibleTo(self):
            self.start_panel.setFocus()

    def take(self, pictogram: Pictogram) -> None:
        """Begin with an icon that was sent here."""
        self.opener.take(pictogram)

    # -- editing -------------------------------------------------------------------------------

    def inputs(self) -> EditInputs:
        """Return the edit and the mode."""
        return EditInputs(self.document.page.edit(), self.actions_by_name["styles"].isChecked())

    def settings(self) -> ModelSettings:
        """Return the styles of the icon, or all."""
        every = self.actions_by_name["styles"].isChecked()
        return (
            ModelSettings() if every else ModelSettings(styles=own_styles(self.document.page.icon))
        )

    def events(self, inputs: EditInputs, settings: ModelSettings) -> Generator[Event]:
        """Return the run of an edit."""
        return self.session.run(self.workflow, inputs.edit, settings)

    def complete(self) -> None:
        """Close an area that is still open."""
        self.outline.finish()

    def finished(self) -> bool:
        """Whether something is marked, and all areas are closed."""
        return super().finished() and _outline(self.document.page) is not None

    def problem(self) -> str:
        """Return what is missing before the icon can be remixed."""
        page = self.document.page
        if page.icon is None:
            return "There is no icon yet. Look one up on the left, or open a drawing of your own."
        try:
            place_edit(page.edit(), page.icon)
        except IconstudioError as error:
            return str(error)
        if not page.keyword.strip():
            return "The icon has no name. Type what it is below the canvas, for example “camera”."
        return ""

    def help_out(self) -> None:
        """Put the focus where an icon can be chosen or named."""
        if self.document.page.icon is None:
            self.start_panel.setFocus()
        else:
            super().help_out()

    # -- page ----------------------------------------------------------------------------------

    def show_page(self) -> None:
        """Show what the page says."""
        page = self.document.page
        self.show_criteria("edit")
        if page.empty:
            self._show_start(True)
        else:
            self.outlines.request(page.icon)
        there = {
            "save": not page.empty,
            "clear": bool(page.areas),
            "delete": bool(page.areas),
        }
        for name, enabled in there.items():
            self.actions_by_name[name].setEnabled(enabled)

    def _show_styles(self) -> None:
        self.show_page()
        self.runs.renew()

    def _show_start(self, shown: bool) -> None:
        self.start_panel.close_button.setVisible(not self.document.page.empty)
        was = self.start_panel.isVisibleTo(self)
        self.start_panel.setVisible(shown)
        if was and not shown and self.isVisible():
            self.view.setFocus()

    def _begin(self) -> None:
        """Begin to mark: something has been put on the page."""
        self._show_start(False)
        self.actions_by_name["remove"].setChecked(True)

    def _choose_icon(self) -> None:
        self._show_start(True)
        self.start_panel.setFocus()

    def _use(self, name: str, on: bool) -> None:
        if not on:
            self.view.set_tool(self.view.pan_tool)
            return
        tool = self.tool = self.tools[name]
        drawing = isinstance(tool, DrawTool)
        if not (drawing and self.outline.area and self.outline.area.kind is tool.kind):
            self.outline.finish()
        if drawing:
            self.outline.select(None)
        self.view.set_tool(tool)

    def _delete(self) -> None:
        self.tool.delete_selected()
        self.view.refresh()

    def _save(self) -> None:
        page = self.document.page
        edit = page.edit()
        self.saver.save_work(
            "edit", page.keyword, lambda path: write_file(path, self.workflow, edit)
        )


def _outline(page: EditPage) -> EditPage | None:
    """Return what the outline that is wanted depends on; None if nothing is marked yet."""
    marked = page.areas and page.open_area is None
    return EditPage(page.icon, areas=page.areas) if marked else None
