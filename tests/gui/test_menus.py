"""The menus of all workspaces: each item has a letter of its own, or none."""

import re
from collections import Counter

import pytest
from hands import go_to, shown
from PySide6.QtWidgets import QMenu

from iconstudio.gui.window.main_window import MainWindow
from iconstudio.gui.window.menus import MENUS
from iconstudio.workflows.registry import registered, workflows
from tests.toy import MIRROR


@pytest.fixture
def window(qtbot, session):
    with registered(MIRROR), shown(MainWindow(session), qtbot) as window:
        yield window


def letters(menu: QMenu) -> Counter[str]:
    """The underlined letters of a menu's items."""
    items = (action.text().replace("&&", "") for action in menu.actions())
    return Counter(letter.lower() for item in items for letter in re.findall("&(.)", item))


def test_no_letter_stands_twice_in_a_menu(window):
    twice = {}
    for title in [one.title for one in workflows()]:
        go_to(window, title)
        for menu in window._menus.values():
            found = {letter for letter, count in letters(menu).items() if count > 1}
            if found:
                twice[title, menu.title()] = found
            for action in menu.actions():
                if action.menu() is not None:
                    assert not {one for one, n in letters(action.menu()).items() if n > 1}
    assert not twice


def test_every_item_has_a_letter_but_those_that_are_called_as_workflows(window):
    titles = {one.title for one in workflows()}
    for title in titles:
        go_to(window, title)
        items = [one.text() for name in MENUS for one in window._menus[name].actions()]
        assert {item for item in items if item and "&" not in item} <= titles
