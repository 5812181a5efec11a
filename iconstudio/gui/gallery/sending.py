"""Menus of what can be done with an icon: it can be sent to another workspace, too."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass

from PySide6.QtCore import QPoint, Qt
from PySide6.QtGui import QAction
from PySide6.QtWidgets import QMenu


@dataclass(frozen=True, slots=True)
class Destination:
    """A workspace that takes icons: its title, and the words that offer to send one there."""

    title: str
    invitation: str
    opens_results: bool = False
    """Whether it opens results, too: their sources, as they are joined."""


def offer(menu: QMenu, destinations: Sequence[Destination], send: Callable[[str], object]) -> None:
    """Add an item for each destination; ``send`` gets the title of the one that is chosen."""
    for destination in destinations:
        action = menu.addAction(destination.invitation)
        action.triggered.connect(lambda _=False, title=destination.title: send(title))


def offer_to_open(
    menu: QMenu, destinations: Sequence[Destination], send: Callable[[str], object]
) -> list[QAction]:
    """Add an item for each destination that opens results, and return them."""
    openers = [one for one in destinations if one.opens_results]
    for one in openers:
        action = menu.addAction(f"Open in {one.title}")
        action.triggered.connect(lambda _=False, title=one.title: send(title))
    return menu.actions()[len(menu.actions()) - len(openers) :]


def pop_up(menu: QMenu, spot: QPoint) -> None:
    """Show a menu at a place of the screen, once."""
    menu.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
    menu.popup(spot)
