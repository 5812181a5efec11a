"""Choose another icon without leaving the tool in use."""

from PySide6.QtCore import Qt
from PySide6.QtGui import QKeyEvent

from iconstudio.gui.workspaces.montage.page import MontageDocument, choose

_STEPS = {Qt.Key.Key_PageUp: 1, Qt.Key.Key_PageDown: -1}


def step_key(document: MontageDocument, event: QKeyEvent) -> bool:
    """Choose the icon above with Page Up, that below with Page Down; return whether it was one."""
    page, step = document.page, _STEPS.get(event.key())
    if step is None or page.current is None:
        return False
    at = (page.index(page.current.number) + step) % len(page.layers)
    choose(document, page.layers[at].number)
    return True
