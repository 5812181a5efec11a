"""What can be done, by name: words, shortcuts and icons; and the menus they stand in."""

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass

from PySide6.QtGui import QAction, QActionGroup, QKeySequence
from PySide6.QtWidgets import QMenu, QWidget

from iconstudio.gui.theme import icons

Key = QKeySequence.StandardKey


@dataclass(frozen=True, slots=True)
class Entry:
    """One action: ``text`` in the menu, ``tip`` on the button (its shortcut is added)."""

    name: str
    text: str
    tip: str = ""
    keys: QKeySequence.StandardKey | str | None = None
    icon: str = ""
    checkable: bool = False


ENTRIES = {
    entry.name: entry
    for entry in (
        Entry("new_project", "&New project", "Start another project", Key.New),
        Entry("open_project", "&Open…", "Open a project, or a file of work", Key.Open),
        Entry("recent", "Open &recent", "Open a project of late"),
        Entry("save_project", "&Save", "Save the project: the pages of all workflows", Key.Save),
        Entry("save_project_as", "Save &as…", "Save the project in another file", "Ctrl+Shift+S"),
        Entry("new", "Ne&w", "Start afresh", "Ctrl+Shift+N", "new"),
        Entry("examples", "E&xamples", "Start from an example", icon="examples"),
        Entry("open", "&Import…", "Read the work in a JSON file"),
        Entry("paste", "&Paste", "Use what is on the clipboard", Key.Paste),
        Entry("save", "&Export as JSON…", "Write the work into a JSON file"),
        Entry("svg", "Save icon as S&VG…", "Save the picked icon as SVG", "Ctrl+E"),
        Entry("png", "Save icon as PN&G…", "Save the picked icon as PNG", "Ctrl+Shift+E"),
        Entry("code_png", "Save colour co&de as PNG…", "Save what comes from where as PNG"),
        Entry("copy", "&Copy icon as SVG", "Copy the picked icon as SVG", "Ctrl+Shift+C"),
        Entry("quit", "&Quit", "", Key.Quit),
        Entry("undo", "&Undo", "Undo", Key.Undo, "undo"),
        Entry("redo", "&Redo", "Redo", Key.Redo, "redo"),
        Entry("delete", "&Delete", "Remove what is selected", "Backspace"),
        Entry("clear", "C&lear", "Remove everything", "Ctrl+Backspace", "clear"),
        Entry("run", "&Remix", "Make new icons", "Ctrl+Return"),
        Entry("live", "Li&ve", "Live: results follow while you draw", "Ctrl+L", "live", True),
        Entry("fine", "F&ine quality", "Fine: smoother joins, five times as slow", checkable=True),
        Entry("cancel", "&Cancel", "Stop; finished results stay", "Ctrl+."),
        Entry("pan", "&Move the page", "Move the page (or hold Space)", "H", "pan", True),
        Entry("zoom_in", "Zoom &in", "", Key.ZoomIn),
        Entry("zoom_out", "Zoom &out", "", Key.ZoomOut),
        Entry("fit", "&Fit the page", "Show the whole page", "Ctrl+0", "fit"),
        Entry("plain", "&Icons", "Show the results as they are", checkable=True),
        Entry(
            "both",
            "Icons and &colour code",
            "Show results with their colour code",
            "Ctrl+Shift+K",
            "",
            True,
        ),
        Entry("coded", "Colour co&de", "Colour the results by source", "Ctrl+K", "", True),
        Entry("about", "&About Iconstudio"),
    )
}
"""The actions that mean the same in several workspaces, or belong to the window."""


def work_entries(noun: str) -> tuple[Entry, ...]:
    """Return what ENTRIES say of the user's work, in words for work that is called ``noun``."""
    return (
        Entry("new", f"Ne&w {noun}", "Start afresh", "Ctrl+Shift+N", "new"),
        Entry("open", f"&Import {noun}…", f"Read the {noun} in a JSON file"),
        Entry("save", f"&Export {noun} as JSON…", f"Write the {noun} into a JSON file"),
    )


DISPLAYS = "plain", "both", "coded"
"""How results are shown: the values of ``pictures.Display``."""

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
        *("run", "live", "fine", "cancel"),
    ),
    "&View": (MODES, "", OWN, "pan", "", "zoom_in", "zoom_out", "fit", "", *DISPLAYS),
    "&Help": ("about",),
}


class Actions(Mapping[str, QAction]):
    """Actions by name, each connected to what it does: ``actions["run"]``.

    They belong to ``owner``, and their shortcuts work while it is visible.

    Parameters
    ----------
    slots
        What each action does; checkable ones pass their state.
    own
        Menus of ``MENUS``, and the entries for them that only this owner has. An entry with the
        name of one of ``ENTRIES`` says it in other words, wherever it stands.
    """

    def __init__(
        self,
        owner: QWidget,
        slots: Mapping[str, Callable[..., object]],
        own: Mapping[str, Sequence[Entry]] | None = None,
    ) -> None:
        own = own or {}
        entries = ENTRIES | {entry.name: entry for some in own.values() for entry in some}
        self._owner = owner
        self._by_name: dict[str, QAction] = {}
        self._own = {
            menu: tuple(entry.name for entry in some if entry.name not in ENTRIES)
            for menu, some in own.items()
        }
        for name, slot in slots.items():
            action = _action(entries[name], owner)
            (action.toggled if action.isCheckable() else action.triggered).connect(slot)
            self.add(entries[name], action)

    def __getitem__(self, name: str) -> QAction:
        return self._by_name[name]

    def __iter__(self) -> Iterator[str]:
        return iter(self._by_name)

    def __len__(self) -> int:
        return len(self._by_name)

    def add(self, entry: Entry, action: QAction) -> None:
        """Take in an action that was made elsewhere: a menu's, or that of a stack."""
        _describe(entry, action)
        self._owner.addAction(action)
        self._by_name[entry.name] = action
        if entry.icon:
            action.setIcon(icons.icon(entry.icon))
            # An icon beside some menu items only would be noise.
            action.setIconVisibleInMenu(False)

    def choose_between(self, *names: str) -> None:
        """Let exactly one of these checkable actions be checked, the first one now."""
        group = QActionGroup(self._owner)
        for name in names:
            group.addAction(self[name])
        self[names[0]].setChecked(True)

    def own(self, menu: str) -> list[QAction]:
        """Return the actions for a menu that only this owner has."""
        return [self[name] for name in self._own.get(menu, ())]


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


def _action(entry: Entry, owner: QWidget) -> QAction:
    action = QAction(owner, checkable=entry.checkable)
    action.setText(entry.text)
    return action


def _describe(entry: Entry, action: QAction) -> None:
    if entry.keys is not None:
        action.setShortcuts(
            QKeySequence.keyBindings(entry.keys)
            if isinstance(entry.keys, Key)
            else [QKeySequence(entry.keys)]
        )
    keys = action.shortcut().toString(QKeySequence.SequenceFormat.NativeText)
    tip = entry.tip or entry.text.replace("&", "")
    action.setToolTip(f"{tip} ({keys})" if keys else tip)
