"""What can be done with an edit."""

from iconstudio.gui.workspaces.actions import INNER, Entry, Key, tool, work_entries
from iconstudio.gui.workspaces.remixing import GRID


def _marked(place) -> bool:
    return bool(place.page.areas)


ENTRIES = (
    Entry("icon", "C&hoose icon…", "Choose another icon", "Ctrl+Shift+O", "search",
          do="choose_icon", menu="&File"),
    Entry("paste", "&Paste icon", "Use the drawing on the clipboard", Key.Paste,
          do="opener.paste"),
    Entry("delete", "&Delete", "Remove the selected area or point", "Backspace", enabled=_marked),
    Entry("clear", "C&lear all areas", "Remove all areas", "Ctrl+Backspace", "clear",
          enabled=_marked),
    Entry("run", "Remi&x", "Make the icon anew where it is marked", "Ctrl+Return"),
    tool("remove", "Mark what &goes", "Remove: mark what should go", "R", "remove"),
    tool("add", "Draw what &comes", "Add: draw what should come", "A", "add"),
    *INNER,
    tool("select", "Correct &areas", "Select, move and correct areas", "V", "select"),
    Entry("styles", "Parts of a&ll styles", "Use parts of icons that are lighter or darker", "L",
          do="follow_styles", checkable=True, menu="&View"),
    *work_entries("edit", lambda place: not place.page.empty),
    *GRID,
)  # fmt: skip
