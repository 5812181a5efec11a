"""What can be done with lines and their style."""

from iconstudio.gui.workspaces.actions import CANVAS, Entry, Key, tool, work_entries
from iconstudio.gui.workspaces.following import TAKING_OUT
from iconstudio.model import Restyled
from iconstudio.workflows.line_style import page as edits


def _has_lines(place) -> bool:
    return place.page.has_lines


def _has_drawn(place) -> bool:
    return any(number >= place.scene.first_stroke for number in place.page.selected)


def _has_style(place) -> bool:
    return place.page.work.style is not None


def _has_strokes(place) -> bool:
    return place.takeable and isinstance(place.picture.icon, Restyled)


ENTRIES = (
    Entry("svg_in", "O&pen drawing…", "Restyle a drawing of your own", "Ctrl+Shift+O", "open",
          do="choose_drawing", menu="&File"),
    Entry("find", "&Find an icon…", "Look up an icon to restyle", "Ctrl+F", "search",
          do="find_icon", menu="&File"),
    Entry("style_in", "Open line s&tyle…", "Learn a style from a file: JSON, or lines of an SVG",
          do="choose_style", icon="open", menu="&File"),
    Entry("style_out", "Save line st&yle…", "Write the style into a JSON file",
          do="save_style", icon="save", menu="&File", enabled=_has_style),
    Entry("strokes", "Save icon as SVG with stro&kes…",
          "Save the picked icon as SVG, its strokes as strokes", "Ctrl+Alt+E",
          do=lambda place: place.take_out(place.saver.save_strokes),
          menu="&File", enabled=_has_strokes),
    Entry("paste", "P&aste drawing", "Restyle the drawing on the clipboard", Key.Paste,
          do="opener.paste"),
    Entry("delete", "&Delete drawn lines", "Remove the selected lines that you drew", "Backspace",
          enabled=_has_drawn,
          do=lambda place: edits.remove_strokes(place.document, place.scene.first_stroke)),
    Entry("clear", "Remove all &lines", "Remove all lines", "Ctrl+Backspace", "clear",
          do=lambda place: edits.clear_lines(place.document), enabled=_has_lines),
    Entry("run", "Restyle a&new", "Draw the lines, and the variations, once more", "Ctrl+Return"),
    tool("select", "&Select lines", "Select lines for a style of their own", "V", "arrow"),
    tool("pen", "&Draw lines", "Draw lines freehand", "P", "pen"),
    *TAKING_OUT,
    *work_entries("restyling", lambda place: not place.page.empty),
    *CANVAS,
)  # fmt: skip
