"""Menus that offer to send an icon to another workspace."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass

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
