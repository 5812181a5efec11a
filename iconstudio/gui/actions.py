"""Menus, shortcuts and tool bar buttons."""

from collections.abc import Callable, Iterator
from dataclasses import dataclass

from PySide6.QtGui import QAction, QActionGroup, QKeySequence, QUndoStack
from PySide6.QtWidgets import QMainWindow, QMenu

from iconstudio.gui import icons, theme

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


ENTRIES = (
    Entry("new", "&New sketch", "Start afresh", Key.New),
    Entry("photo", "Open &photo…", "Open a photo to trace over", Key.Open, "photo"),
    Entry("paste", "P&aste photo", "Use the image on the clipboard", Key.Paste),
    Entry("open", "Open s&ketch…", "Open a sketch file", "Ctrl+Shift+O"),
    Entry("save", "&Save sketch…", "Save the sketch as JSON", Key.Save),
    Entry("svg", "Save icon as S&VG…", "Save the picked icon as SVG", "Ctrl+E"),
    Entry("png", "Save icon as P&NG…", "Save the picked icon as PNG", "Ctrl+Shift+E"),
    Entry("copy", "&Copy icon as SVG", "Copy the picked icon as SVG", "Ctrl+Shift+C"),
    Entry("quit", "&Quit", "", Key.Quit),
    Entry("delete", "&Delete point", "Remove the selected or the last point", "Backspace"),
    Entry("clear", "Clear &outline", "Remove the outline", "Ctrl+Backspace", "clear"),
    Entry("run", "&Remix", "Make new icons in four styles", "Ctrl+Return"),
    Entry("cancel", "&Cancel", "Stop; finished results stay", "Ctrl+."),
    Entry("trace", "&Trace outline", "Trace the outline", "P", "polygon", True),
    Entry("pan", "&Move the page", "Move the page (or hold Space)", "H", "pan", True),
    Entry("zoom_in", "Zoom &in", "", Key.ZoomIn),
    Entry("zoom_out", "Zoom &out", "", Key.ZoomOut),
    Entry("fit", "&Fit the page", "Show the whole page", "Ctrl+0", "fit"),
    Entry("coded", "&Colour code", "Colour the results by source", "Ctrl+K", "", True),
    Entry("regions", "&Salient regions", "Show the regions that are matched", "R", "regions", True),
    Entry("about", "&About Iconstudio", "", None),
)

MENUS: dict[str, tuple[str, ...]] = {
    "&File": (
        "new", "photo", "paste", "examples", "", "open", "save", "", "svg", "png", "copy", "",
        "quit",
    ),
    "&Edit": ("undo", "redo", "", "delete", "clear", "", "run", "cancel"),
    "&View": ("trace", "pan", "", "zoom_in", "zoom_out", "fit", "", "coded", "regions"),
    "&Help": ("about",),
}  # fmt: skip

BAR = (("photo", "examples"), ("undo", "redo"), ("trace", "pan", "fit", "regions", "clear"))


class Actions:
    """All actions of the window by name, as items: ``actions["run"]``."""

    def __init__(self, window: QMainWindow, undo_stack: QUndoStack) -> None:
        self._by_name: dict[str, QAction] = {}
        for entry in ENTRIES:
            action = QAction(entry.text, window, checkable=entry.checkable)
            if entry.keys is not None:
                action.setShortcuts(
                    QKeySequence.keyBindings(entry.keys)
                    if isinstance(entry.keys, Key)
                    else [QKeySequence(entry.keys)]
                )
            self._by_name[entry.name] = action
        self._icons = {entry.name: entry.icon for entry in ENTRIES if entry.icon}
        self._add_undo(window, undo_stack)
        self.examples = QMenu("&Examples", window)
        self._by_name["examples"] = self.examples.menuAction()
        self._icons["examples"] = "examples"
        # Before the first layout: a button without an icon would claim the width of its text.
        self.refresh_icons(theme.current())
        tips = {entry.name: entry.tip for entry in ENTRIES}
        tips |= {"examples": "Start from an example", "undo": "Undo", "redo": "Redo"}
        for name, action in self._by_name.items():
            keys = action.shortcut().toString(QKeySequence.SequenceFormat.NativeText)
            tip = tips[name] or action.text().replace("&", "")
            action.setToolTip(f"{tip} ({keys})" if keys else tip)
        tools = QActionGroup(window)
        tools.addAction(self["trace"])
        tools.addAction(self["pan"])
        self["trace"].setChecked(True)
        for title, names in MENUS.items():
            menu = window.menuBar().addMenu(title)
            for name in names:
                if name:
                    menu.addAction(self[name])
                else:
                    menu.addSeparator()

    def __getitem__(self, name: str) -> QAction:
        return self._by_name[name]

    def __iter__(self) -> Iterator[str]:
        return iter(self._by_name)

    def connect(self, slots: dict[str, Callable[..., object]]) -> None:
        """Connect actions to what they do; checkable ones pass their state."""
        for name, slot in slots.items():
            action = self[name]
            (action.toggled if action.isCheckable() else action.triggered).connect(slot)

    def bar(self) -> list[list[QAction]]:
        """Return the actions of the tool bar, group by group."""
        return [[self[name] for name in group] for group in BAR]

    def refresh_icons(self, look: theme.Theme) -> None:
        """Draw the icons in the colours of ``look``."""
        for name, icon in self._icons.items():
            self[name].setIcon(icons.icon(icon, look))
            # An icon beside some menu items only would be noise.
            self[name].setIconVisibleInMenu(False)

    def _add_undo(self, window: QMainWindow, undo_stack: QUndoStack) -> None:
        undo = undo_stack.createUndoAction(window, "&Undo")
        redo = undo_stack.createRedoAction(window, "&Redo")
        undo.setShortcuts(QKeySequence.keyBindings(Key.Undo))
        redo.setShortcuts(QKeySequence.keyBindings(Key.Redo))
        for name, action in (("undo", undo), ("redo", redo)):
            self._by_name[name] = action
            self._icons[name] = name
