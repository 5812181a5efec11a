"""What can be done with an exemplar and its pattern."""

from dataclasses import replace

from iconstudio.gui.workspaces.actions import CANVAS, Entry, Key, tool, work_entries
from iconstudio.gui.workspaces.following import TAKING_OUT
from iconstudio.workflows.pattern import page as edits

_LARGER, _QUARTER = 1.1, 15.0
"""By how much, and by how many degrees, keys resize and turn icons."""


def _has_exemplar(place) -> bool:
    return not place.page.empty


def _has_icons(place) -> bool:
    return bool(place.page.work.motifs)


def _has_image(place) -> bool:
    return place.page.work.image is not None


def _has_chosen(place) -> bool:
    return bool(place.page.chosen)


def _on_chosen(name, text, tip, keys, icon, edit, *values) -> Entry:
    """Return the action that does an edit to the chosen icons."""
    do = {"do": lambda place: edit(place.document, *values), "enabled": _has_chosen}
    return Entry(name, text, tip, keys, icon, menu="&Edit", **do)


ENTRIES = (
    Entry("svg_in", "O&pen drawing…", "Add a drawing of your own", "Ctrl+Shift+O", "open",
          do="chooser.choose_file", menu="&File"),
    Entry("image_in", "Open i&mage…", "Continue an image: an ornament of flat colours",
          "Ctrl+I", "photo", do="choose_image", menu="&File"),
    Entry("css", "Save pa&ttern as CSS…", "Save the pattern as a style sheet with its background",
          "Ctrl+Alt+E", do=lambda place: place.take_out(place.saver.save_css), menu="&File",
          enabled=lambda place: place.takeable),
    Entry("paste", "P&aste", "Add the drawing on the clipboard, or continue the image",
          Key.Paste, do="opener.paste"),
    Entry("delete", "&Delete icons", "Take the chosen icons out", "Backspace",
          enabled=_has_chosen, do=lambda place: edits.remove_chosen(place.document)),
    Entry("clear", "Clear e&xemplar", "Take the exemplar away", "Ctrl+Backspace", "clear",
          enabled=_has_exemplar, do=lambda place: edits.clear(place.document)),
    _on_chosen("mirror", "&Mirror icons", "Mirror the chosen icons", "M", "mirror",
               edits.flip_chosen),
    Entry("duplicate", "Du&plicate icons", "Copy the chosen icons", "Ctrl+D", "duplicate",
          menu="&Edit", enabled=_has_chosen,
          do=lambda place: place.tell_mistakes(edits.duplicate_chosen)),
    _on_chosen("front", "Bring to &front", "Bring the chosen icons to the front", "Ctrl+]",
               "front", edits.raise_chosen),
    _on_chosen("behind", "Send to &back", "Put the chosen icons behind all others", "Ctrl+[",
               "behind", edits.lower_chosen),
    _on_chosen("larger", "&Larger icons", "Make the chosen icons larger", "+", "",
               edits.resize_chosen, _LARGER),
    _on_chosen("smaller", "&Smaller icons", "Make the chosen icons smaller", "-", "",
               edits.resize_chosen, 1 / _LARGER),
    _on_chosen("turn_right", "Turn r&ight", "Turn the chosen icons to the right", "R", "",
               edits.turn_chosen, _QUARTER),
    _on_chosen("turn_left", "Turn l&eft", "Turn the chosen icons to the left", "Shift+R", "",
               edits.turn_chosen, -_QUARTER),
    Entry("scatter", "Sca&tter anew", "Scatter the icons over the canvas anew", "S", "scatter",
          do="scatter", enabled=_has_icons, menu="&Edit"),
    Entry("shape", "Fill a s&hape…", "Fill a shape with the pattern: the next icon you choose",
          "Ctrl+F", "shape", do="await_shape", checkable=True, menu="&Edit"),
    Entry("run", "Make a&new", "Make the pattern, and those of other seeds, once more",
          "Ctrl+Return", enabled=_has_exemplar),
    Entry("wider", "&Wider brush", "Wider brush", "]", menu="&Edit", enabled=_has_image,
          do=lambda place: place.brush.step(1)),
    Entry("narrower", "Narr&ower brush", "Narrower brush", "[", menu="&Edit", enabled=_has_image,
          do=lambda place: place.brush.step(-1)),
    tool("arrange", "&Arrange icons", "Choose, move, resize and turn icons", "V", "arrow"),
    replace(tool("brush", "&Layer brush", "Paint over what belongs to a layer of the image", "B",
                 "brush"), enabled=_has_image),
    *work_entries("pattern", _has_exemplar),
    *TAKING_OUT,
    *CANVAS,
)  # fmt: skip
