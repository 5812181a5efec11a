"""What can be done with a montage."""

from iconstudio.gui.workspaces.actions import CANVAS, Entry, Key, tool, work_entries
from iconstudio.gui.workspaces.inner_pictures import INNER_PICTURES
from iconstudio.workflows.montage import edits


def _holds_icons(place) -> bool:
    return bool(place.page.layers)


ENTRIES = (
    Entry("svg_in", "O&pen drawing…", "Add a drawing of your own", "Ctrl+Shift+O", "open",
          do="chooser.choose_file", menu="&File"),
    Entry("paste", "P&aste drawing", "Add the drawing on the clipboard", Key.Paste,
          do="opener.paste"),
    Entry("delete", "&Delete icon", "Take the chosen icon out", "Backspace", enabled=_holds_icons,
          do=lambda place: edits.delete(place.document, place.page.current.number)),
    Entry("clear", "Clear &scribbles", "Remove all scribbles", "Ctrl+Backspace", "clear",
          do=lambda place: edits.clear_scribbles(place.document),
          enabled=lambda place: any(one.strokes for one in place.page.layers)),
    Entry("mirror", "&Mirror icon", "Mirror the chosen icon", "M", "mirror", menu="&Edit",
          do=lambda place: edits.mirror(place.document), enabled=_holds_icons),
    Entry("wider", "&Wider brush", "Wider brush", "]", menu="&Edit",
          do=lambda place: place.brush.step(1)),
    Entry("narrower", "&Narrower brush", "Narrower brush", "[", menu="&Edit",
          do=lambda place: place.brush.step(-1)),
    tool("brush", "&Keep brush", "Scribble over the parts to keep", "B", "brush"),
    tool("arrange", "&Arrange icons", "Choose, move and scale icons", "V", "arrow"),
    tool("eraser", "&Eraser", "Rub scribbles out", "E", "eraser"),
    INNER_PICTURES,
    *work_entries("montage", _holds_icons),
    *CANVAS,
)  # fmt: skip
