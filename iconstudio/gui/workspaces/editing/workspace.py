"""Pictogram editing (section 4.2): choose an icon, mark what goes and what comes, remix."""

from collections.abc import Generator
from typing import NamedTuple

from iconstudio.gui.canvas.tools.areas import DrawTool, SelectTool
from iconstudio.gui.canvas.view import CanvasView
from iconstudio.gui.exchange.opening import Opener
from iconstudio.gui.panels.chooser import IconChooser
from iconstudio.gui.workspaces.editing.actions import ENTRIES
from iconstudio.gui.workspaces.editing.scene import EditScene
from iconstudio.gui.workspaces.editing.start import StartPanel
from iconstudio.gui.workspaces.remixing import RemixWorkspace
from iconstudio.importing.edits import EditImporter
from iconstudio.model import Edit, Exemplar, Pictogram
from iconstudio.workflows.areas import AreaOutline, Kind
from iconstudio.workflows.editing import page as edits
from iconstudio.workflows.editing.editing import own_styles
from iconstudio.workflows.editing.page import EditPage
from iconstudio.workflows.editing.placing import place_edit
from iconstudio.workflows.events import Event
from iconstudio.workflows.grid import GridSettings

_SELECT = (
    "Click an area to correct it",
    "There is nothing to select yet: draw with Remove or Add",
)
DESCRIPTION = "Mark what should go and what should come here"


class EditInputs(NamedTuple):
    """What the results are of."""

    edit: Edit | None
    all_styles: bool


class EditWorkspace(RemixWorkspace):
    """An icon is changed where the user marks it."""

    page_type = EditPage
    entries = ENTRIES
    placeholder = "What is it? For example: camera"
    tip = "Make the icon anew where it is marked (Ctrl+Return)"
    welcome = (
        "The changed icon appears here, several times: on the left it keeps closer to what you "
        "drew;\nto the right, the new parts join more smoothly."
    )
    nearer = "Closer to the drawing"

    def build(self) -> None:
        """Make canvas, panels and runs."""
        super().build()
        self.importer = EditImporter(self.session, self.document)
        self.opener = Opener(self.importer, self.files, self)
        self.outline = AreaOutline(self.document)
        self.tools = {kind.value: DrawTool(self.outline, kind) for kind in Kind}
        self.tools["select"] = SelectTool(self.outline, *_SELECT)
        self.tool = self.tools["remove"]
        self.scene = EditScene(self.document, self.outlines)
        self.view = CanvasView(self.scene, self.tool, DESCRIPTION)
        self.offer_symmetry(_outline, lambda page: place_edit(page.edit(), page.icon).silhouette)
        self.make_actions()
        chooser = IconChooser(self.session, self.finder)
        self.start_panel = StartPanel(self.document, self.view, chooser, self.examples)
        chooser.chosen.connect(self._begin_with)
        self.opener.opened.connect(self._begin)
        self.lay_out("icon", "undo redo", "remove add hole|line select pan fit clear")

    # -- what the window asks for --------------------------------------------------------------

    @property
    def icons(self) -> tuple[Pictogram, ...]:
        """The icon to be changed."""
        icon = self.page.icon
        return () if icon is None else (icon.pictogram,)

    def enter(self) -> None:
        """Begin on the canvas, or choose an icon."""
        super().enter()
        if self.start_panel.isVisibleTo(self):
            self.start_panel.setFocus()

    # -- editing -------------------------------------------------------------------------------

    def inputs(self) -> EditInputs:
        """Return the edit and the mode."""
        return EditInputs(self.page.edit(), self.actions_by_name["styles"].isChecked())

    def settings(self) -> GridSettings:
        """Return the styles of the icon, or all."""
        every = self.actions_by_name["styles"].isChecked()
        return GridSettings() if every else GridSettings(styles=own_styles(self.page.icon))

    def events(self, inputs: EditInputs, settings: GridSettings) -> Generator[Event]:
        """Return the run of an edit."""
        return self.session.run(self.workflow, inputs.edit, settings)

    def complete(self) -> None:
        """Close an area that is still open."""
        self.outline.finish()

    def finished(self) -> bool:
        """Whether something is marked, and all areas are closed."""
        return super().finished() and _outline(self.page) is not None

    def problem(self) -> str:
        """Return what is missing before the icon can be remixed."""
        return edits.problem(self.page)

    def doubts(self) -> str:
        """Return which outlines cross themselves."""
        return edits.doubts(self.page.edit())

    def help_out(self) -> None:
        """Put the focus where an icon can be chosen or named."""
        if self.page.icon is None:
            self.start_panel.setFocus()
        else:
            super().help_out()

    # -- page ----------------------------------------------------------------------------------

    def show_page(self) -> None:
        """Show what the page says."""
        page = self.page
        self.show_criteria("edit")
        if page.empty:
            self.start_panel.offer(True)

    def follow_styles(self, on: bool) -> None:
        """Follow a change of the styles that are wanted."""
        self.show_page()
        self.runner.renew()

    def _begin_with(self, icon: Exemplar) -> None:
        self.opener.replace(lambda: self.importer.beginning(icon))

    def _begin(self) -> None:
        """Begin to mark: something has been put on the page."""
        self.start_panel.offer(False)
        self.actions_by_name["remove"].setChecked(True)

    def choose_icon(self) -> None:
        """Offer another icon."""
        self.start_panel.offer(True)
        self.start_panel.setFocus()

    def use_tool(self, name: str) -> None:
        """Take another tool; what is traced for something else is finished."""
        tool = self.tool = self.tools[name]
        self.outline.turn_to(tool.kind if isinstance(tool, DrawTool) else None)
        super().use_tool(name)

    def clear(self) -> None:
        """Remove all areas."""
        edits.clear(self.document)

    def delete(self) -> None:
        """Remove what is selected."""
        self.tool.delete_selected()
        self.view.refresh()

    def save(self) -> None:
        """Write the edit into a file."""
        self.save_work(self.page.edit(), self.page.keyword)


def _outline(page: EditPage) -> EditPage | None:
    """Return what the outline that is wanted depends on; None if nothing is marked yet."""
    marked = page.icon is not None and page.areas and page.open_area is None
    return EditPage(page.icon, areas=page.areas) if marked else None
