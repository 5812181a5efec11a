"""Choose icons, pin parts, mix, scroll, keep: in the real window, on the pretended session."""

import json
import threading
from itertools import pairwise

import pytest
from fake_session import exemplar
from hands import drop, save_to, search, workspaces
from PySide6.QtCore import QEvent, QMimeData, QPoint, QPointF, Qt, QUrl
from PySide6.QtGui import QContextMenuEvent, QWheelEvent
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication

from iconstudio.algorithms.raster import solid
from iconstudio.gui.exchange.dragging import packed
from iconstudio.gui.gallery.display import DisplaySwitch
from iconstudio.gui.gallery.sheet_model import Rule
from iconstudio.gui.pictures.picture import Display, Picture
from iconstudio.gui.window.main_window import MainWindow
from iconstudio.model import Axis, IconstudioError
from iconstudio.session import Session
from iconstudio.workflows.hybrids import page as edits
from iconstudio.workflows.hybrids.hybrids import MOST
from iconstudio.workflows.hybrids.page import on_shape
from iconstudio.workflows.hybrids.spec import HYBRIDS

LEFT = Qt.MouseButton.LeftButton
CTRL = Qt.KeyboardModifier.ControlModifier
SVG = '<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 9 9"><path d="M1 1h7v7z"/></svg>'


@pytest.fixture
def place(window):
    """The workspace, in sight."""
    workspace = window.workspace_of("Hybrids")
    window.show_workspace(workspaces(window).index(workspace))
    return workspace


@pytest.fixture
def chosen(place, qtbot):
    """The workspace with four icons: ring, frame, cross and triangle."""
    search(place.column.chooser, "lamp")
    pick(place, qtbot, 4)
    return place


@pytest.fixture
def mixed(chosen, qtbot):
    """The workspace with its first batch of hybrids."""
    run(chosen, qtbot)
    return chosen


def pick(place, qtbot, count):
    place.column.count.setValue(count)
    QTest.mouseClick(place.column.pick, LEFT)
    qtbot.waitUntil(lambda: not place.opener.runner.running, timeout=20000)


def run(place, qtbot):
    QTest.mouseClick(place.column.run, LEFT)
    finish(place, qtbot)


def finish(place, qtbot):
    qtbot.waitUntil(lambda: not place.draws.runner.running, timeout=20000)


def rows(place):
    """Return what is on the sheet, row by row."""
    model = place.sheet.model()
    return [model.entry(model.index(row)) for row in range(model.rowCount())]


def totals(entries):
    return [one.icon.score.total for one in entries if isinstance(one, Picture)]


def middle(place, picture):
    return place.sheet.visualRect(place.sheet.model().index_of(picture)).center()


def click(place, picture):
    QTest.mouseClick(place.sheet.viewport(), LEFT, pos=middle(place, picture))


def open_menu(place, picture):
    spot = middle(place, picture)
    QTest.mouseClick(place.sheet.viewport(), Qt.MouseButton.RightButton, pos=spot)
    event = QContextMenuEvent(QContextMenuEvent.Reason.Mouse, spot, QPoint(10, 10))
    QApplication.sendEvent(place.sheet.viewport(), event)


def hover(place, picture):
    QTest.mouseMove(place.sheet.viewport(), middle(place, picture))


def leave(place):
    QApplication.sendEvent(place.sheet.viewport(), QEvent(QEvent.Type.Leave))


def scroll_down(place):
    viewport = place.sheet.viewport()
    spot = QPointF(viewport.rect().center())
    event = QWheelEvent(
        spot, viewport.mapToGlobal(spot), QPoint(), QPoint(0, -1200), LEFT.NoButton,
        CTRL.NoModifier, Qt.ScrollPhase.NoScrollPhase, False,
    )  # fmt: skip
    QApplication.sendEvent(viewport, event)


def names(place):
    return [one.id for one in place.document.page.ingredients]


# -- icons -----------------------------------------------------------------------------------------


def test_an_empty_window_says_what_to_do_and_offers_it(place):
    assert place.panel.start.isVisible()
    assert not place.column.run.isEnabled()
    assert "at least two icons" in place.column.run.toolTip()
    menu = place.panel.start.menu()
    assert menu is place.actions_by_name["examples"].menu()
    titles = [action.text() for action in menu.actions()]
    assert titles == ["Chess pieces", "Fish", "Robots", "Table lamps"]


@pytest.mark.thorough
def test_every_example_of_the_menu_is_mixed_at_once(place, qtbot, session, monkeypatch):
    known = {}
    monkeypatch.setattr(
        session, "icon", lambda name: known.setdefault(name, exemplar(len(known)).pictogram)
    )
    for action in place.panel.start.menu().actions():
        count = len(session.calls)
        action.trigger()
        qtbot.waitUntil(lambda count=count: len(session.calls) > count, timeout=20000)
        finish(place, qtbot)
        assert session.calls[-1][0] == "mix"
        hybrids = [one for one in rows(place) if isinstance(one, Picture)]
        assert hybrids[0].title.startswith(action.text())
        assert not place.panel.start.isVisible()


def test_icons_and_files_can_be_dropped_on_the_cards_and_pasted(place, qtbot, tmp_path):
    own, mix = tmp_path / "own.svg", tmp_path / "two.json"
    own.write_text(SVG)
    mix.write_text('{"icons": ["shapes:ring-4", "shapes:frame-5"]}')
    drop(place.column.cards, packed(exemplar(2).pictogram))
    qtbot.waitUntil(lambda: names(place) == ["shapes:cross-2"])
    urls = QMimeData()
    urls.setUrls([QUrl.fromLocalFile(str(own))])
    drop(place.column.cards, urls)
    qtbot.waitUntil(lambda: len(names(place)) == 2)
    urls.setUrls([QUrl.fromLocalFile(str(mix))])
    QApplication.clipboard().setMimeData(urls)
    QTest.keyClick(place.column.cards.cards[0], Qt.Key.Key_V, CTRL)
    qtbot.waitUntil(lambda: names(place) == ["shapes:ring-4", "shapes:frame-5"])
    place.actions_by_name["undo"].trigger()
    assert len(names(place)) == 2 and names(place)[0] == "shapes:cross-2"


def test_icons_are_ticked_and_given_back(place, qtbot):
    chooser = place.column.chooser
    QTest.keyClicks(chooser.field, "lamp")
    QTest.keyClick(chooser.field, Qt.Key.Key_Return)
    sheet = chooser.sheet.model()
    qtbot.waitUntil(lambda: sheet.rowCount() == 60)
    for row in (3, 1, 3):
        box = chooser.sheet.visualRect(sheet.index(row))
        QTest.mouseClick(chooser.sheet.viewport(), LEFT, pos=box.center())
    assert names(place) == ["shapes:frame-1"]
    assert "one more icon" in place.column.run.toolTip()
    place.document.undo_stack.undo()
    assert names(place) == ["shapes:triangle-3", "shapes:frame-1"]


def test_picking_again_brings_the_next_group_and_undo_the_last(chosen, qtbot, session):
    first = names(chosen)
    pick(chosen, qtbot, 4)
    asked = [call[1:] for call in session.calls if call[0] == "choose"]
    assert asked == [("lamp", 4, None, 0), ("lamp", 4, None, 1)]
    assert names(chosen) != first
    chosen.document.undo_stack.undo()
    assert names(chosen) == first
    pick(chosen, qtbot, 3)
    assert session.calls[-2][1:] == ("lamp", 3, None, 0), "another number begins anew"


def test_icons_that_the_user_chose_or_pinned_stay_when_the_program_picks(chosen, qtbot):
    sent = exemplar(50)
    chosen.take(sent.pictogram)
    qtbot.waitUntil(lambda: sent.id in names(chosen))
    pinned = names(chosen)[0]
    edits.set_pins(chosen.document, pinned, ((128.0, 128.0),))
    pick(chosen, qtbot, 4)
    assert names(chosen)[:2] == [pinned, sent.id] and len(names(chosen)) == 6
    assert all(one.picked for one in chosen.page.ingredients[2:])


def test_more_picks_than_there_is_room_for_are_told(place, qtbot):
    for number in range(MOST - 2):
        place.add(exemplar(20 + number))
    search(place.column.chooser, "lamp")
    pick(place, qtbot, 4)
    assert len(names(place)) == MOST
    assert f"at most {MOST} icons can be mixed" in place.window().pane.notice.label.text()


def test_the_sheet_has_the_switch_of_how_results_are_shown(mixed, qtbot):
    (switch,) = mixed.panel.findChildren(DisplaySwitch)
    assert switch.isVisible()
    seen = set()
    for display in Display:
        QTest.mouseClick(switch.segments[display], LEFT)
        seen.add(bytes(mixed.sheet.viewport().grab().toImage().constBits()))
    assert len(seen) == 3


def test_picking_needs_a_word(place):
    QTest.mouseClick(place.column.pick, LEFT)
    assert "Type what the icons should show" in place.window().pane.notice.label.text()


def test_what_cannot_be_picked_is_told(place, qtbot):
    search(place.column.chooser, "zzz")
    pick(place, qtbot, 4)
    assert "No icon is found" in place.window().pane.notice.label.text()
    assert not names(place)


def test_a_card_removes_its_icon_by_button_and_key(chosen, qtbot):
    cards = chosen.column.cards.cards
    QTest.mouseMove(cards[1])
    qtbot.waitUntil(cards[1].button.isVisible)
    QTest.mouseClick(cards[1].button, LEFT)
    cards[0].setFocus()
    QTest.keyClick(cards[0], Qt.Key.Key_Backspace)
    assert names(chosen) == ["shapes:cross-2", "shapes:triangle-3"]
    assert len(cards) == 2
    chosen.document.undo_stack.undo()
    chosen.document.undo_stack.undo()
    assert len(names(chosen)) == 4


def test_the_button_on_a_card_shows_only_where_the_user_is(chosen, qtbot):
    cards = chosen.column.cards.cards

    def shown():
        return [number for number, card in enumerate(cards) if card.button.isVisible()]

    chosen.column.seed.field.setFocus()
    QTest.mouseMove(cards[1], QPoint(5, 5))  # Qt tells of the way off only after one on
    QTest.mouseMove(cards[1])
    qtbot.waitUntil(lambda: shown() == [1])
    QTest.mouseMove(chosen.column.seed)
    qtbot.waitUntil(lambda: shown() == [])
    cards[2].setFocus()
    assert shown() == [2]
    QTest.keyClick(cards[2], Qt.Key.Key_Tab)
    assert cards[2].button.hasFocus()
    assert shown() == [2]
    QTest.keyClick(cards[2].button, Qt.Key.Key_Space)
    assert "shapes:cross-2" not in names(chosen)


def test_an_icon_that_is_sent_joins_once_and_is_called_by_its_title(chosen, qtbot):
    said = []
    chosen.remarked.connect(said.append)
    for number in (9, 9):
        chosen.take(exemplar(number).pictogram)
    qtbot.waitUntil(lambda: len(names(chosen)) == 5)
    qtbot.waitUntil(lambda: "“frame 9” is among the icons already." in said)
    assert "Added “frame 9”." in said
    assert names(chosen)[-1] == "shapes:frame-9"


def test_a_thirteenth_icon_is_refused(place, qtbot):
    search(place.column.chooser, "lamp")
    pick(place, qtbot, 12)
    place.take(exemplar(40).pictogram)
    notice = place.window().pane.notice
    qtbot.waitUntil(notice.isVisible)
    assert "At most 12" in notice.label.text()
    assert len(names(place)) == 12


# -- pins ------------------------------------------------------------------------------------------


def test_a_click_pins_the_nearest_part_and_a_click_on_the_pin_frees_it(chosen, qtbot, session):
    card = chosen.column.cards.cards[3]  # the triangle: nothing but white at the top left
    QTest.mouseClick(card, LEFT, pos=QPoint(6, 20))
    (pin,) = chosen.document.page.ingredients[3].pins
    shape = solid(exemplar(3).ink)
    assert shape[int(pin[1]), int(pin[0])]
    run(chosen, qtbot)
    assert session.calls[-1][1].pins == ((), (), (), (pin,))
    QTest.mouseClick(card, LEFT, pos=card.at(pin).toPoint())
    assert chosen.document.page.mix.pins == ()
    chosen.document.undo_stack.undo()
    assert chosen.document.page.ingredients[3].pins == (pin,)


def test_on_a_shape_is_a_point_that_stays_and_else_the_nearest():
    ring = exemplar(0)
    assert on_shape(ring, (128.2, 128.9)) == (128.5, 128.5), "in the hole is on the solid shape"
    x, y = on_shape(ring, (128.5, 10.0))
    assert x == 128.5
    assert abs(y - (128 - 60)) <= 1


def test_keys_move_a_mark_and_pin_what_lies_there(chosen):
    card = chosen.column.cards.cards[3]
    card.setFocus()
    plain = card.grab().toImage()
    QTest.keyClick(card, Qt.Key.Key_Down, Qt.KeyboardModifier.ShiftModifier)
    assert card.grab().toImage() != plain, "the mark shows"
    for _ in range(3):
        QTest.keyClick(card, Qt.Key.Key_Left)
    assert chosen.document.page.mix.pins == ()
    QTest.keyClick(card, Qt.Key.Key_Space)
    (pin,) = chosen.document.page.ingredients[3].pins
    spot = card.at(pin) - QPointF(card.rect().center())
    assert abs(spot.x() + 9) < 2 and abs(spot.y() - 12) < 2
    QTest.keyClick(card, Qt.Key.Key_Space)
    assert chosen.document.page.mix.pins == ()
    for _ in range(40):
        QTest.keyClick(card, Qt.Key.Key_Right)
    QTest.keyClick(card, Qt.Key.Key_Space)
    assert len(chosen.document.page.ingredients[3].pins) == 1, "the mark stays on the card"


def test_under_symmetry_the_mirror_image_of_a_pin_shows_and_frees_it(chosen):
    chosen.column.symmetry.chosen.emit(Axis.HORIZONTAL)
    card = chosen.column.cards.cards[0]
    accent = card.palette().highlight().color()
    spot = card.at((90.0, 128.0)).toPoint()
    twin = card.at((166.0, 128.0)).toPoint()
    before = card.grab().toImage().pixelColor(twin)
    QTest.mouseClick(card, LEFT, pos=spot)
    after = card.grab().toImage()
    assert (
        after.pixelColor(card.at(chosen.document.page.ingredients[0].pins[0]).toPoint()) == accent
    )
    assert after.pixelColor(twin) != before
    QTest.mouseClick(card, LEFT, pos=twin)
    assert not chosen.document.page.ingredients[0].pins


def test_a_symmetry_that_all_icons_have_is_offered(chosen):
    assert chosen.column.offer.isVisible()
    QTest.mouseClick(chosen.column.offer, LEFT)
    assert chosen.document.page.symmetry is Axis.HORIZONTAL
    assert not chosen.column.offer.isVisible()
    chosen.document.undo_stack.undo()
    assert chosen.column.offer.isVisible()


# -- the sheet -------------------------------------------------------------------------------------


def test_a_batch_is_in_rank_order_without_repeats_and_ends_with_a_rule(mixed, session):
    *pictures, rule = rows(mixed)
    assert isinstance(rule, Rule)
    assert len(pictures) == 40 - 3, "draws 19, 29 and 39 repeat the ninth"
    assert totals(pictures) == sorted(totals(pictures), reverse=True)
    assert threading.get_ident() not in session.thread_ids
    assert mixed.window().pane.status.label.text() == "37 hybrids"
    assert sorted(int(one.title.split()[1]) for one in pictures) == list(range(1, 38))


@pytest.mark.thorough
def test_scrolling_to_the_end_draws_on_and_drops_repeats_of_earlier_batches(mixed, qtbot, session):
    first = rows(mixed)
    scroll_down(mixed)
    assert mixed.draws.runner.running
    finish(mixed, qtbot)
    mixes = [call[1] for call in session.calls if call[0] == "mix"]
    assert [mix.first for mix in mixes] == [0, 40]
    assert rows(mixed)[: len(first)] == first
    second = rows(mixed)[len(first) :]
    assert len(totals(second)) == 40 - 4
    assert totals(second) == sorted(totals(second), reverse=True)


@pytest.mark.thorough
def test_the_same_seed_gives_the_same_sheet(mixed, qtbot):
    before = [one.icon.path for one in rows(mixed)[:-1]]
    QTest.mouseClick(mixed.column.seed.dice, LEFT)
    assert mixed.panel.note.text()
    other = mixed.document.page.seed
    mixed.column.seed.field.setFocus()
    mixed.column.seed.field.selectAll()
    QTest.keyClicks(mixed.column.seed.field, "7x12")
    assert mixed.document.page.seed == 712
    run(mixed, qtbot)
    assert [one.icon.path for one in rows(mixed)[:-1]] != before
    mixed.document.undo_stack.undo()
    assert mixed.document.page.seed in (0, other), "digits typed are undone together"
    mixed.document.change("seed", type(mixed.document.page)(mixed.document.page.ingredients))
    mixed.draws.clear()
    run(mixed, qtbot)
    assert [one.icon.path for one in rows(mixed)[:-1]] == before


def test_a_hybrid_at_which_the_user_points_stays_where_it_is(chosen, qtbot, session):
    session.gate = threading.Semaphore(12)
    QTest.mouseClick(chosen.column.run, LEFT)
    qtbot.waitUntil(lambda: len(rows(chosen)) >= 11)
    qtbot.wait(50)
    pointed = rows(chosen)[5]
    hover(chosen, pointed)
    spot = middle(chosen, pointed)
    above = rows(chosen)[:6]
    session.gate.release(100)
    finish(chosen, qtbot)
    assert rows(chosen)[:6] == above
    assert middle(chosen, pointed) == spot
    late = totals(rows(chosen)[6:])
    assert late == sorted(late, reverse=True)
    assert max(late) > min(totals(above))
    leave(chosen)
    assert totals(rows(chosen)) == sorted(totals(rows(chosen)), reverse=True)


@pytest.mark.thorough
def test_results_that_arrive_do_not_scroll_the_sheet(mixed, qtbot, session):
    session.gate = threading.Semaphore(10)
    scroll_down(mixed)
    qtbot.waitUntil(lambda: len(totals(rows(mixed))) > 40)
    mixed.sheet.scrollToBottom()
    seen = mixed.sheet.indexAt(QPoint(30, 60))
    entry, top = mixed.sheet.model().entry(seen), mixed.sheet.visualRect(seen).top()
    session.gate.release(100)
    finish(mixed, qtbot)
    now = mixed.sheet.model().index_of(entry)
    assert mixed.sheet.visualRect(now).top() == top


def test_cancel_keeps_what_is_there_and_going_on_misses_nothing(chosen, qtbot, session):
    session.gate = threading.Semaphore(7)
    QTest.mouseClick(chosen.column.run, LEFT)
    qtbot.waitUntil(lambda: len(totals(rows(chosen))) == 7)
    QTest.mouseClick(chosen.window().pane.status.button, LEFT)
    assert not chosen.draws.runner.running
    session.gate = None
    run(chosen, qtbot)
    assert session.calls[-1][1].first == 7
    draws = [one.icon.draw for one in rows(chosen) if isinstance(one, Picture)]
    assert sorted(draws) == [n for n in range(47) if n % 10 != 9 or n == 9]


def test_a_picked_hybrid_shows_large_and_is_kept_in_sight(mixed):
    best = rows(mixed)[0]
    click(mixed, best)
    assert mixed.picture is best
    assert mixed.window().recent.pictures == (best,)
    assert "Rank score" in mixed.detail._about.toolTip()
    assert "smooth seams" in mixed.sheet.model().data(
        mixed.sheet.model().index(0), Qt.ItemDataRole.ToolTipRole
    )
    QTest.keyClick(mixed.sheet, Qt.Key.Key_Right)
    assert mixed.picture is rows(mixed)[1]


def test_colour_coding(mixed):
    before = mixed.sheet.viewport().grab().toImage()
    mixed.actions_by_name["coded"].trigger()
    assert mixed.actions_by_name["coded"].isChecked()
    assert mixed.sheet.viewport().grab().toImage() != before


# -- what is done with a hybrid --------------------------------------------------------------------


@pytest.mark.thorough
def test_undo_brings_back_the_sheet_of_an_earlier_mix(mixed, qtbot):
    stack, first = mixed.document.undo_stack, rows(mixed)
    assert any(isinstance(one, Picture) for one in first)
    mixed.column.seed.changed.emit(7)
    assert "earlier mix" in mixed.panel.note.text()
    run(mixed, qtbot)
    second = rows(mixed)
    assert second != first
    for step, there in ((stack.undo, first), (stack.redo, second), (stack.undo, first)):
        step()
        assert rows(mixed) == there
        assert mixed.panel.note.text() == ""
    assert not mixed.draws.runner.running
    mixed.clear()
    assert rows(mixed) == []
    stack.undo()
    assert rows(mixed) == first
    assert mixed.sheet.isVisible()
    mixed.mix_example()
    assert not mixed.draws.runner.running, "an example that is opened again is there already"
    run(mixed, qtbot)
    assert rows(mixed)[: len(first)] == first, "more of it is drawn below"


def test_favourites_by_key_button_and_menu_and_undo(mixed):
    first, second, third = rows(mixed)[:3]
    click(mixed, first)
    QTest.keyClick(mixed.sheet, Qt.Key.Key_F)
    hover(mixed, second)
    assert mixed.panel.bar.isVisible()
    QTest.mouseClick(mixed.panel.bar._star, LEFT)
    open_menu(mixed, third)
    mixed.menu.actions()[0].trigger()
    mixed.menu.close()
    assert mixed.favourites_panel.pictures == (first, second, third)
    assert mixed.window().recent.pictures == (third, second, first)
    mixed.document.undo_stack.undo()
    assert mixed.favourites_panel.pictures == (first, second)
    mixed.favourites_panel.icon_list.remove(first)
    assert mixed.document.page.favourites == (second.icon,)
    mixed.document.undo_stack.undo()
    assert mixed.favourites_panel.pictures == (first, second)
    click(mixed, first)
    QTest.keyClick(mixed.sheet, Qt.Key.Key_F)
    assert mixed.favourites_panel.pictures == (second,)


def test_all_favourites_are_saved_and_nothing_is_replaced(mixed, qtbot, tmp_path, monkeypatch):
    for picture in rows(mixed)[:2]:
        mixed.keep(picture)
    title = rows(mixed)[0].title.replace(" ", "-")
    (tmp_path / f"{title}-hybrid.svg").write_text("mine")
    monkeypatch.setattr(mixed.saver, "ask_folder", lambda: tmp_path)
    QTest.mouseClick(mixed.favourites_panel.button, LEFT)
    qtbot.waitUntil(lambda: len(list(tmp_path.iterdir())) == 3)
    assert (tmp_path / f"{title}-hybrid.svg").read_text() == "mine"
    assert "Ada Example" in (tmp_path / f"{title}-hybrid-2.svg").read_text()
    qtbot.waitUntil(lambda: "2 icons" in mixed.window().pane.status.label.text())


@pytest.mark.thorough
def test_more_like_this_has_a_section_of_its_own(mixed, qtbot, session):
    whole = rows(mixed)
    mixed.sheet.verticalScrollBar().setValue(40)
    click(mixed, whole[9])
    QTest.keyClick(mixed.sheet, Qt.Key.Key_L)
    finish(mixed, qtbot)
    assert session.calls[-1][1].like == whole[9].icon.seeds
    heading, *found = rows(mixed)
    assert heading.text == f"More like {whole[9].title}"
    assert not set(map(id, found)) & set(map(id, whole))
    assert totals(found) == sorted(totals(found), reverse=True)
    QTest.mouseClick(mixed.panel.button, LEFT)
    assert rows(mixed) == [heading, *found, *whole]
    assert mixed.picture is mixed.sheet.picture is whole[9], "it is still the picked one"
    assert not mixed.panel.button.isVisible()
    count = len(session.calls)
    mixed.draw_like(whole[9])
    assert rows(mixed) == [heading, *found], "what is there is not drawn again"
    assert len(session.calls) == count


def test_a_hybrid_goes_to_another_workspace(mixed, qtbot):
    best = rows(mixed)[0]
    open_menu(mixed, best)
    words = [action.text() for action in mixed.menu.actions()]
    mixed.menu.close()
    assert not any("Mix" in text for text in words), "it is here already"
    mixed.send_picture(best, "Edit")
    edit = mixed.window().workspace_of("Edit")
    assert mixed.window().workspace is edit


def test_two_icons_that_are_the_same_are_told(chosen, qtbot, session, monkeypatch):
    def refuse(mix):
        raise IconstudioError("“b” looks the same as another of the icons.")
        yield

    monkeypatch.setattr(session, "mix", refuse)
    run(chosen, qtbot)
    assert "looks the same" in chosen.window().pane.notice.label.text()


# -- files -----------------------------------------------------------------------------------------


def test_a_mix_is_saved_and_opened_again(chosen, qtbot, tmp_path, monkeypatch):
    own = tmp_path / "own.svg"
    own.write_text(SVG)
    chosen.column.chooser.open_file(str(own))
    qtbot.waitUntil(lambda: len(names(chosen)) == 5)
    QTest.mouseClick(chosen.column.cards.cards[0], LEFT, pos=QPoint(36, 20))
    chosen.column.symmetry.chosen.emit(Axis.VERTICAL)
    chosen.column.seed.changed.emit(2**62)
    page = chosen.document.page
    path = tmp_path / "mix.json"
    save_to(chosen, monkeypatch, path)
    chosen.actions_by_name["save"].trigger()
    qtbot.waitUntil(path.exists)
    assert json.loads(path.read_text())["seed"] == 2**62
    chosen.actions_by_name["new"].trigger()
    assert not names(chosen)
    chosen.opener.open_work(str(path))
    qtbot.waitUntil(lambda: len(names(chosen)) == 5)
    again = chosen.document.page
    assert (again.seed, again.symmetry) == (page.seed, page.symmetry)
    assert [one.id for one in again.ingredients][:4] == names(chosen)[:4]
    assert again.ingredients[0].pins == page.ingredients[0].pins
    chosen.document.undo_stack.undo()
    chosen.document.undo_stack.undo()
    assert chosen.document.page == page


def test_a_file_with_a_keyword_picks(place, qtbot, tmp_path, session):
    path = tmp_path / "mix.json"
    path.write_text('{"keyword": "lamp", "count": 3, "seed": 2, "draws": 5}')
    place.opener.open_work(str(path))
    qtbot.waitUntil(lambda: len(names(place)) == 3)
    assert ("choose", "lamp", 3, None, 2) in session.calls
    run(place, qtbot)
    assert len(totals(rows(place))) == 5


@pytest.mark.parametrize(
    ("text", "part"),
    [
        ("{", "not valid JSON"),
        ('{"icons": ["shapes:ring-0"]}', "cannot be mixed"),
        ('{"icons": ["shapes:ring-0", "shapes:ring-0"]}', "chosen twice"),
        ('{"icons": ["shapes:ring-0", "shapes:nothing"]}', "no icon"),
        ('{"icons": ["shapes:ring-0", "shapes:frame-1"], "pins": [[[1, 2]]]}', "pins for 1"),
    ],
)
def test_a_bad_file_is_told_and_changes_nothing(chosen, qtbot, tmp_path, text, part):
    before = chosen.document.page
    path = tmp_path / "mix.json"
    path.write_text(text)
    chosen.opener.open_work(str(path))
    notice = chosen.window().pane.notice
    qtbot.waitUntil(notice.isVisible)
    assert part in notice.label.text()
    assert chosen.document.page is before


def test_every_edit_is_one_step_and_undone_exactly(chosen):
    stack, cards = chosen.document.undo_stack, chosen.column.cards.cards
    pages = [chosen.document.page]
    steps = [
        lambda: QTest.mouseClick(cards[0], LEFT, pos=QPoint(36, 36)),
        lambda: chosen.column.symmetry.chosen.emit(Axis.VERTICAL),
        lambda: chosen.column.seed.changed.emit(5),
        lambda: QTest.mouseClick(cards[2].button, LEFT),
        lambda: chosen.actions_by_name["clear"].trigger(),
        lambda: chosen.actions_by_name["new"].trigger(),
    ]
    for step in steps:
        count = stack.count()
        step()
        assert stack.count() == count + 1
        pages.append(chosen.document.page)
    assert all(a != b for a, b in pairwise(pages))
    for page in reversed(pages[:-1]):
        stack.undo()
        assert chosen.document.page is page


def test_from_nothing_to_a_saved_svg_with_real_icons(qtbot, tmp_path, monkeypatch):
    window = MainWindow(Session(), (HYBRIDS,))
    qtbot.addWidget(window)
    window.show()
    place = window.workspace
    path = tmp_path / "lamps.json"
    icons = ["fluent-mdl2:lightbulb", "uil:lightbulb-alt", "lets-icons:lamp-light"]
    path.write_text(json.dumps({"icons": icons, "draws": 4}))
    place.opener.open_work(str(path))
    qtbot.waitUntil(lambda: names(place) == icons, timeout=60000)
    QTest.mouseClick(place.column.offer, LEFT)
    QTest.mouseClick(place.column.run, LEFT)
    qtbot.waitUntil(lambda: not place.draws.runner.running, timeout=60000)
    *hybrids, _ = rows(place)
    assert totals(hybrids) == sorted(totals(hybrids), reverse=True)
    click(place, hybrids[0])
    save_to(place, monkeypatch, tmp_path / "new.svg")
    place.actions_by_name["svg"].trigger()
    qtbot.waitUntil((tmp_path / "new.svg").exists)
    svg = (tmp_path / "new.svg").read_text()
    assert 'd="M' in svg
    assert "Iconscout" in svg or "Microsoft" in svg or "Tsvetkov" in svg
    window.close()


def test_a_new_mix_has_no_hybrids(mixed, qtbot):
    assert mixed.picture is None or mixed.sections.pictures
    mixed.actions_by_name["new"].trigger()
    assert not mixed.sections.pictures
    assert mixed.picture is None
    assert not mixed.actions_by_name["svg"].isEnabled()
    assert mixed.window().pane.status.label.text() == ""
    pick(mixed, qtbot, 4)
    assert len(mixed.sections.pictures) == 37, "the same icons were mixed before"


@pytest.mark.thorough
def test_the_hybrids_in_sight_are_counted(mixed, qtbot):
    total = len(mixed.sections.pictures)
    mixed.draw_like(mixed.sections.pictures[0])
    qtbot.waitUntil(lambda: not mixed.draws.runner.running, timeout=20000)
    alone = len(mixed.sections.alone.pictures)
    label = mixed.window().pane.status.label
    assert label.text() == f"{alone} hybrids · {total + alone} with the others"
    mixed.draws.show_all()
    assert label.text() == f"{total + alone} hybrids"
