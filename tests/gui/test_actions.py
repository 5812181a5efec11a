"""Actions as they are declared: what they do, when they make sense, and what they show."""

import pytest
from PySide6.QtGui import QKeySequence
from PySide6.QtWidgets import QWidget

from iconstudio.gui.workspaces.actions import Actions, Entry, tool


class Place(QWidget):
    """Something that actions belong to."""

    def __init__(self):
        super().__init__()
        self.done = []
        self.loud = False

    def shout(self):
        self.done.append("shout")

    def set_loud(self, on):
        self.loud = on

    def set_marked(self, on):
        self.done.append(on)

    def use_tool(self, name):
        self.done.append(name)


ENTRIES = (
    Entry("shout", "Sh&out", "Say it", "Ctrl+S", enabled=lambda place: place.loud, menu="&File"),
    Entry("loud", "&Loud", do="set_loud", checked=lambda place: place.loud),
    Entry("marked", "&Marked", do="set_marked", checkable=True),
    Entry("twice", "Twice", do=lambda place: place.done.append(2)),
    tool("pen", "&Pen", "Draw", "P", "brush"),
    tool("rubber", "&Rubber", "Rub", "E", "eraser"),
    Entry("shout", "Whisper"),
)


@pytest.fixture
def place(qtbot):
    place = Place()
    qtbot.addWidget(place)
    place.acts = Actions(place, ENTRIES)
    place.acts.refresh()
    return place


def test_an_action_is_enabled_when_its_owner_says_so(place):
    assert not place.acts["shout"].isEnabled()
    place.loud = True
    place.acts.refresh()
    place.acts["shout"].trigger()
    assert place.done == ["shout"]


def test_a_setting_is_shown_as_it_is_and_changed_by_the_user_alone(place):
    place.loud = True
    place.acts.refresh()
    assert place.acts["loud"].isChecked()
    place.acts["loud"].trigger()
    assert not place.loud and not place.acts["loud"].isChecked()


def test_one_that_is_a_setting_of_its_own_passes_its_state(place):
    place.acts["marked"].trigger()
    place.acts["marked"].setChecked(False)
    assert place.done == [True, False]


def test_of_tools_the_first_is_chosen_and_one_is_used_at_a_time(place):
    assert place.acts["pen"].isChecked() and place.done == []
    place.acts["rubber"].trigger()
    assert not place.acts["pen"].isChecked()
    place.acts["pen"].setChecked(True)
    assert place.done == ["rubber", "pen"]


def test_an_action_may_be_a_function_of_its_owner(place):
    place.acts["twice"].trigger()
    assert place.done == [2]


def test_of_entries_of_the_same_name_the_first_counts(place):
    assert place.acts["shout"].text() == "Sh&out"
    assert place.acts["shout"].shortcut() == QKeySequence("Ctrl+S")
    assert place.acts["shout"].toolTip() == "Say it (Ctrl+S)"
    assert place.acts.own("&File") == [place.acts["shout"]]
