"""The edits of a montage that panels and menus make, by one command each."""

from collections.abc import Callable
from dataclasses import replace

from iconstudio.workflows.montage.page import MontageDocument, MontagePage


def clear_scribbles(document: MontageDocument) -> None:
    """Remove all scribbles."""
    _change(document, "clear scribbles", MontagePage.cleared)


def delete(document: MontageDocument, number: int) -> None:
    """Take the icon of that number out."""
    _change(document, "delete icon", lambda page: page.without(number))


def hide(document: MontageDocument, number: int, hidden: bool) -> None:
    """Hide an icon, or show it."""
    text = "hide icon" if hidden else "show icon"
    _change(document, text, lambda page: page.hidden(number, hidden))


def reorder(document: MontageDocument, number: int, at: int) -> None:
    """Put an icon at another height, 0 being the back."""
    _change(document, "reorder icons", lambda page: page.ordered(number, at))


def mirror(document: MontageDocument) -> None:
    """Mirror the chosen icon, if there is one."""
    layer = document.page.current
    if layer is None:
        return
    placement = replace(layer.placement, flip=not layer.placement.flip)
    _change(document, "mirror icon", lambda page: page.placed(layer.number, placement))


def _change(
    document: MontageDocument, text: str, edit: Callable[[MontagePage], MontagePage]
) -> None:
    after = edit(document.page)
    if after != document.page:
        document.change(text, after)
