"""Keys that mean the same with all tools of a montage."""

from PySide6.QtCore import Qt
from PySide6.QtGui import QKeyEvent

from iconstudio.workflows.montage.page import MontageDocument, choose

_STEPS = {Qt.Key.Key_PageUp: 1, Qt.Key.Key_PageDown: -1}


def layer_key(document: MontageDocument, event: QKeyEvent) -> bool:
    """Choose the icon above or below with Page Up and Down, take it out with Delete.

    Returns whether the key meant anything.
    """
    page, step = document.page, _STEPS.get(event.key())
    current = page.current
    if current is None:
        return False
    if event.key() == Qt.Key.Key_Delete:
        document.change("delete icon", page.without(current.number))
    elif step is not None:
        at = (page.index(current.number) + step) % len(page.layers)
        choose(document, page.layers[at].number)
    else:
        return False
    return True
