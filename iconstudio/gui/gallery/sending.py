"""Menus of what can be done with an icon: it can be sent to another workspace, too."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass

from PySide6.QtCore import QPoint, Qt
from PySide6.QtWidgets import QMenu


@dataclass(frozen=True, slots=True)
class Destination:
    """A workspace that takes icons: its title, and the words that offer to send one there."""

    title: str
    invitation: str


def offer(menu: QMenu, destinations: Sequence[Destination], send: Callable[[str], object]) -> None:
    """Add an item for each destination; ``send`` gets the title of the one that is chosen."""
    for destination in destinations:
        action = menu.addAction(destination.invitation)
        action.triggered.connect(lambda _=False, title=destination.title: send(title))


def pop_up(menu: QMenu, spot: QPoint) -> None:
    """Show a menu at a place of the screen, once."""
    menu.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
    menu.popup(spot)
