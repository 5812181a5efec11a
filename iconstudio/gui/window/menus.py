"""The menus: what the window can do, whatever workspace is in use, and what that can do."""

from collections.abc import Sequence

from PySide6.QtGui import QAction
from PySide6.QtWidgets import QMenu

from iconstudio.gui.window.about import show_about
from iconstudio.gui.workspaces.actions import Actions, Entry, Key

WINDOW = (
    Entry(
        "new_project", "&New project", "Start another project", Key.New, do="project.new"
    ),
    Entry(
        "open_project", "&Open…", "Open a project, or a file of work", Key.Open,
        do="project.choose",
    ),
    Entry(
        "save_project", "&Save", "Save the project: the pages of all workflows", Key.Save,
        do="project.save",
    ),
    Entry(
        "save_project_as", "Save &as…", "Save the project in another file", "Ctrl+Shift+S",
        do="project.save_as",
    ),
    Entry("quit", "&Quit", "", Key.Quit, do="close"),
    Entry("about", "&About Iconstudio", do=show_about),
)  # fmt: skip
"""What the window does, whatever workspace is in use."""

RECENT = Entry("recent", "Open &recent", "Open a project of late")

MODES, OWN = "modes", "own"
"""Places in the menus: of the switch between workspaces, and of a workspace's own actions."""

MENUS: dict[str, tuple[str, ...]] = {
    "&File": (
        *("new_project", "open_project", "recent", "save_project", "save_project_as", ""),
        *("new", OWN, "examples", "", "open", "save", ""),
        *("svg", "png", "code_png", "copy", "", "quit"),
    ),
    "&Edit": (
        *("undo", "redo", "", "paste", "delete", "clear", OWN, ""),
        *("run", "live", "fine", "scales", "cancel"),
    ),
    "&View": (
        *(MODES, "", OWN, "pan", "", "zoom_in", "zoom_out", "fit", ""),
        *("plain", "both", "coded"),
    ),
    "&Help": ("about",),
}


def fill_menu(
    menu: QMenu, title: str, window: Actions, workspace: Actions, modes: Sequence[QAction]
) -> None:
    """Fill a menu anew with what the window and the workspace in use can do."""
    for action in menu.actions():  # after QMenu.clear, PySide takes them for deleted
        menu.removeAction(action)
        if action.isSeparator():
            action.deleteLater()
    for name in MENUS[title]:
        if name == "":
            menu.addSeparator()
        elif name == OWN:
            menu.addActions(workspace.own(title))
        elif name == MODES:
            menu.addActions(modes)
        elif (action := workspace.get(name) or window.get(name)) is not None:
            menu.addAction(action)
