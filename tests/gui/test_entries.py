"""What is typed into fields: each finished entry is one step that can be undone."""

import pytest
from hands import go_to
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest


def keyword(place):
    return place.page.criteria.keyword


def type_anew(field, text, end=Qt.Key.Key_Tab):
    """Type a text in place of what is there, and leave the field, or press Enter."""
    field.setFocus()
    field.selectAll()
    QTest.keyClicks(field, text)
    QTest.keyClick(field, end)


@pytest.mark.parametrize("end", [Qt.Key.Key_Tab, Qt.Key.Key_Return])
def test_each_word_is_a_step(sketching, end):
    for word in ("dog", "cat"):
        type_anew(sketching.keyword_panel.field, word, end)
    sketching.document.undo_stack.undo()
    assert keyword(sketching) == "dog"
    sketching.document.undo_stack.undo()
    assert keyword(sketching) == ""


def test_a_word_whose_icons_are_in_sight_is_a_step(sketching, qtbot):
    field = sketching.keyword_panel.field
    field.setFocus()
    QTest.keyClicks(field, "dog")
    qtbot.waitUntil(lambda: sketching.keyword_panel.sheet.model().rowCount() > 0)
    QTest.keyClicks(field, "house")
    sketching.document.undo_stack.undo()
    assert keyword(sketching) == "dog"


def test_a_word_that_is_typed_after_an_undo_joins_none_that_is_older(sketching):
    field = sketching.keyword_panel.field
    type_anew(field, "dog")
    type_anew(field, "cat")
    sketching.document.undo_stack.undo()
    type_anew(field, "fish")
    sketching.document.undo_stack.undo()
    assert keyword(sketching) == "dog"


@pytest.mark.parametrize("title", ["Hybrids", "Line style"])
def test_each_seed_is_a_step(window, title):
    place = go_to(window, title)
    controls = place.column if title == "Hybrids" else place.controls
    seed = (lambda: place.page.seed) if title == "Hybrids" else (lambda: place.page.work.seed)
    first = seed()
    type_anew(controls.seed.field, "12")
    type_anew(controls.seed.field, "345", Qt.Key.Key_Return)
    controls.seed.dice.click()
    controls.seed.dice.click()
    stack, seen = place.document.undo_stack, []
    for _ in range(4):
        seen.append(seed())
        stack.undo()
    assert seen[2:] == [345, 12] and seed() == first and len(set(seen)) == 4
