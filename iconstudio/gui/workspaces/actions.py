"""What can be done, declared by name: words, keys, what it does and when."""

from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import dataclass
from functools import partial
from operator import attrgetter
from pathlib import Path
from typing import Any

from PySide6.QtGui import QAction, QActionGroup, QKeySequence
from PySide6.QtWidgets import QMenu, QWidget

from iconstudio.gui.gallery.display import setting
from iconstudio.gui.pictures.picture import Display
from iconstudio.gui.theme import icons
from iconstudio.inputs.examples import examples

Key = QKeySequence.StandardKey

Ask = Callable[[Any], object]
"""Asks the owner of an action, a workspace or the window, for something that is true or not."""


@dataclass(frozen=True, slots=True)
class Entry:
    """One action: ``text`` in the menu, ``tip`` on the button (its shortcut is added)."""

    name: str
    text: str
    tip: str = ""
    keys: QKeySequence.StandardKey | str | None = None
    icon: str = ""
    do: str | Callable[..., object] = ""
    """What it does: a method of its owner (``view.fit``), by default that of its own name; or a
    function of its owner. One that is checkable gets its state, too."""
    enabled: Ask | None = None
    """Whether it makes sense at the moment."""
    checked: Ask | None = None
    """Whether the setting that it shows, and changes, is on."""
    checkable: bool = False
    """Whether it is a setting of its own."""
    choice: str = ""
    """Of the actions with the same word here exactly one is checked; it does what it does."""
    menu: str = ""
    """The menu in which it stands, among those that only its owner has."""

    @property
    def is_setting(self) -> bool:
        """Whether it is checked or not."""
        return self.checkable or bool(self.choice) or self.checked is not None


def _holds_result(place: Any) -> bool:
    return place.picture is not None


def _takes_out(save: str) -> dict[str, Any]:
    """Return what an action does that takes the picked result out, by a method of the saver."""
    return {
        "do": lambda place: place.take_out(getattr(place.saver, save)),
        "enabled": _holds_result,
    }


def _shows(display: Display) -> dict[str, Any]:
    """Return what an action does that shows results in another way, and when it is checked."""
    return {
        "do": lambda place, on: setting.choose(display),
        "checked": lambda place: setting.value is display,
        "choice": "display",
    }


EXAMPLES = Entry("examples", "E&xamples", "Start from an example", icon="examples")
UNDO = Entry("undo", "&Undo", "Undo", Key.Undo, "undo")
REDO = Entry("redo", "&Redo", "Redo", Key.Redo, "redo")

COMMON = (
    Entry(
        "svg", "Save icon as S&VG…", "Save the picked icon as SVG", "Ctrl+E",
        **_takes_out("save_svg"),
    ),
    Entry(
        "png", "Save icon as PN&G…", "Save the picked icon as PNG", "Ctrl+Shift+E",
        **_takes_out("save_png"),
    ),
    Entry(
        "code_png", "Save colour co&de as PNG…", "Save what comes from where as PNG",
        **_takes_out("save_code")
        | {"enabled": lambda place: _holds_result(place) and place.picture.has_code},
    ),
    Entry(
        "copy", "&Copy icon as SVG", "Copy the picked icon as SVG", "Ctrl+Shift+C",
        **_takes_out("copy_svg"),
    ),
    Entry(
        "cancel", "&Cancel", "Stop; finished results stay", "Ctrl+.",
        enabled=lambda place: place.busy,
    ),
    Entry("plain", "Ico&ns", "Show the results as they are", **_shows(Display.PLAIN)),
    Entry(
        "both", "Icons and colo&ur code", "Show results with their colour code", "Ctrl+Shift+K",
        **_shows(Display.BOTH),
    ),
    Entry(
        "coded", "Colou&r code", "Colour the results by source", "Ctrl+K",
        **_shows(Display.CODED),
    ),
)  # fmt: skip
"""What every workspace does."""

CANVAS = (
    Entry(
        "pan", "&Move the page", "Move the page (or hold Space)", "H", "pan",
        do=lambda place: place.view.set_tool(place.view.pan_tool), choice="tool",
    ),
    Entry("zoom_in", "Zoom &in", "", Key.ZoomIn, do="view.zoom_in"),
    Entry("zoom_out", "Zoom &out", "", Key.ZoomOut, do="view.zoom_out"),
    Entry("fit", "&Fit the page", "Show the whole page", "Ctrl+0", "fit", do="view.fit"),
)  # fmt: skip
"""What every workspace with a canvas does."""


def work_entries(noun: str, enabled: Ask) -> tuple[Entry, ...]:
    """Return what is done with work that is called ``noun``; it is there if ``enabled``."""
    json = f"&Export {noun} as JSON…"
    return (
        Entry("new", f"Ne&w {noun}", "Start afresh", "Ctrl+Shift+N", "new",
              do=lambda place: place.document.change(f"new {noun}", place.blank)),
        Entry("open", f"&Import {noun}…", f"Read the {noun} in a JSON file",
              do="opener.choose_work"),
        Entry("save", json, f"Write the {noun} into a JSON file", enabled=enabled),
        Entry("paste", "&Paste", "Use what is on the clipboard", Key.Paste, do="opener.paste"),
    )  # fmt: skip


def examples_menu(owner: QWidget, folder: str, use: Callable[[Path], object]) -> QMenu:
    """Return a menu of the examples in a folder; ``use`` is called with the file of one."""
    menu = QMenu(EXAMPLES.text, owner)
    for one in examples(folder):
        menu.addAction(one.title, lambda path=one.path: use(path))
    return menu


def tool(name: str, text: str, tip: str, keys: str, icon: str) -> Entry:
    """Return the action that takes a tool; see ``Workspace.use_tool``."""
    use = {"do": lambda place: place.use_tool(name), "choice": "tool", "menu": "&View"}
    return Entry(name, text, tip, keys, icon, **use)


class Actions(Mapping[str, QAction]):
    """Actions by name, each connected to what it does: ``actions["run"]``.

    They belong to ``owner``, and their shortcuts work while it is visible. Of entries with the same
    name, the first one counts; of those to choose between, the first one is chosen.
    """

    def __init__(self, owner: QWidget, entries: Iterable[Entry]) -> None:
        self._owner = owner
        self._entries: dict[str, Entry] = {}
        self._by_name: dict[str, QAction] = {}
        self._groups: dict[str, QActionGroup] = {}
        for entry in entries:
            self._entries.setdefault(entry.name, entry)
        for entry in self._entries.values():
            self.add(entry, QAction(entry.text, owner, checkable=entry.is_setting))
            self._connect(entry, self[entry.name])

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

    def refresh(self) -> None:
        """Ask anew which actions make sense, and which settings are on."""
        for name, entry in self._entries.items():
            if entry.enabled is not None:
                self[name].setEnabled(bool(entry.enabled(self._owner)))
            if entry.checked is not None:
                self[name].setChecked(bool(entry.checked(self._owner)))

    def own(self, menu: str) -> list[QAction]:
        """Return the actions for a menu that only this owner has."""
        return [self[name] for name, one in self._entries.items() if one.menu == menu]

    def _connect(self, entry: Entry, action: QAction) -> None:
        do, owner = entry.do or entry.name, self._owner
        if isinstance(do, str):
            do = partial(_call, do)
        if entry.choice:
            first = entry.choice not in self._groups
            group = self._groups.setdefault(entry.choice, QActionGroup(owner))
            group.addAction(action)
            action.setChecked(first)
        if entry.checked is not None:  # when it is shown, nothing is to be done
            action.triggered.connect(lambda on: do(owner, on))
        elif entry.choice:
            action.toggled.connect(lambda on: on and do(owner))
        elif entry.checkable:
            action.toggled.connect(lambda on: do(owner, on))
        else:
            action.triggered.connect(lambda: do(owner))


def _call(method: str, owner: QWidget, *on: bool) -> None:
    attrgetter(method)(owner)(*on)


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


INNER = (
    tool("hole", "Draw a &hole", "Hole: draw where paper should show inside", "O", "hole"),
    tool("line", "Dra&w a line", "Line: draw a line inside the outline", "I", "line"),
)
"""The tools for what is inside an outline."""
