"""What can be done with a sketch."""

from iconstudio.gui.workspaces.actions import INNER, Entry, Key, tool, work_entries
from iconstudio.gui.workspaces.remixing import GRID


def _drawn(place) -> bool:
    return bool(place.page.vertices)


def _pinned(place) -> bool:
    return bool(place.page.sketch.pins)


ENTRIES = (
    Entry("photo", "Open &photo…", "Open a photo to trace over", "Ctrl+Shift+O", "photo",
          do="choose_photo", menu="&File"),
    Entry("paste", "P&aste photo", "Use the image on the clipboard", Key.Paste, do="opener.paste"),
    Entry("delete", "&Delete", "Remove what is selected, or the last point", "Backspace",
          do="tool.delete_selected", enabled=_drawn),
    Entry("clear", "Clear &outline", "Remove the outline", "Ctrl+Backspace", "clear",
          do="outline.clear", enabled=_drawn),
    Entry("run", "Remi&x", "Make new icons in four styles", "Ctrl+Return"),
    tool("trace", "&Trace outline", "Trace the outline", "P", "polygon"),
    *INNER,
    tool("select", "Correct ho&les and lines", "Select, move and correct holes and lines", "V",
         "select"),
    Entry("regions", "&Salient regions", "Show the regions that are matched", "R", "regions",
          do="show_regions", checkable=True, menu="&View"),
    Entry("unpin", "Unpin all &parts", "Let the program choose for all parts again",
          enabled=_pinned, menu="&Edit"),
    *work_entries("sketch", _drawn),
    *GRID,
)  # fmt: skip
