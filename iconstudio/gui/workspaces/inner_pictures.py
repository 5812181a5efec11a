"""Shows the inner pictures of a workspace's page, and of the result that is picked."""

from typing import Any

from iconstudio.gui.gallery.inner_pictures import InnerPicturesWindow
from iconstudio.gui.workspaces.actions import Entry
from iconstudio.gui.workspaces.base import Workspace
from iconstudio.model import IconstudioError
from iconstudio.workflows.workflow import load_object

NOTHING = "Nothing guides a cut yet: finish an outline, an area or a scribble, or pick a hybrid."


def show_inner_pictures(place: Workspace) -> InnerPicturesWindow:
    """Open a window that follows the page."""
    window = InnerPicturesWindow(place)
    inner_pictures = load_object(place.workflow.inner_pictures)

    def show(*_: Any) -> None:
        missing = NOTHING
        try:
            icon = None if place.picture is None else place.picture.icon
            pictures = inner_pictures(place.page, icon)
        except IconstudioError as error:
            pictures, missing = (), str(error)
        window.show_pictures(pictures, missing)

    place.document.page_changed.connect(show)
    place.picked.connect(show)

    def leave() -> None:
        place.document.page_changed.disconnect(show)
        place.picked.disconnect(show)

    window.finished.connect(leave)
    show()
    window.show()
    return window


INNER_PICTURES = Entry(
    "inner_pictures", "Inner &pictures…", "Show the masks and positions that guide a cut", "Ctrl+I",
    do=show_inner_pictures, menu="&View",
)  # fmt: skip
