"""What can be done with a mix and its hybrids."""

from iconstudio.gui.workspaces.actions import Entry, Key, work_entries
from iconstudio.gui.workspaces.inner_pictures import INNER_PICTURES


def _has_icons(place) -> bool:
    return bool(place.page.ids)


def _picked(place) -> bool:
    return place.picture is not None


ENTRIES = (
    Entry("svg_in", "O&pen drawing…", "Mix a drawing of your own", "Ctrl+Shift+O", "open",
          do="column.chooser.choose_file", menu="&File"),
    Entry("save_all", "Save all &favourites…", "Save every favourite as SVG", "Ctrl+Alt+S",
          menu="&File", enabled=lambda place: place.page.favourites),
    Entry("paste", "&Paste icon", "Mix the drawing on the clipboard", Key.Paste,
          do="opener.paste"),
    Entry("clear", "Remove &all icons", "Remove all icons", "Ctrl+Backspace", "clear",
          enabled=_has_icons),
    Entry("favourite", "&Favourite", "Keep the picked hybrid, or no longer", "F", menu="&Edit",
          do=lambda place: place.keep(place.picture), enabled=_picked),
    Entry("like", "More &like this", "Draw hybrids like the picked one", "L", menu="&Edit",
          do=lambda place: place.draw_like(place.picture), enabled=_picked),
    Entry("run", "&Mix", "Draw hybrids of the icons", "Ctrl+Return"),
    INNER_PICTURES,
    *work_entries("mix", _has_icons),
)  # fmt: skip
