"""Patterns by mouse and keys, in the real window with the session that needs no icons."""

import json
import threading

import numpy as np
import pytest
from fake_session import exemplar
from hands import action, at, drag, go_to, press, save_to, threads_alive
from images import pixels
from PIL import Image as Pixels
from PySide6.QtCore import QMimeData, QPoint, Qt, QUrl
from PySide6.QtGui import QColor, QImage
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QColorDialog

from iconstudio.gui.gallery.detail import MAKING
from iconstudio.gui.project import questions
from iconstudio.gui.window.main_window import MainWindow
from iconstudio.gui.workspaces.pattern import patterner
from iconstudio.gui.workspaces.pattern.tools import stalk
from iconstudio.gui.workspaces.pattern.workspace import INVITATION
from iconstudio.model import Patterned
from iconstudio.session import Session
from iconstudio.svg.reading import own_svg
from iconstudio.workflows.events import Progress
from iconstudio.workflows.pattern.bounds import SEEDS
from iconstudio.workflows.pattern.page import PatternPage
from iconstudio.workflows.pattern.scattering import PALETTE
from iconstudio.workflows.pattern.spec import PATTERN

LEFT = Qt.MouseButton.LeftButton
SHIFT, CONTROL = Qt.KeyboardModifier.ShiftModifier, Qt.KeyboardModifier.ControlModifier
RING, FRAME, CROSS = (exemplar(number).pictogram for number in range(3))


@pytest.fixture
def place(window, qtbot, monkeypatch):
    monkeypatch.setattr(patterner, "REST", 1)
    return go_to(window, "Pattern")


@pytest.fixture
def laid_out(place, qtbot):
    """Nine rings, and their pattern."""
    place.take(RING)
    settled(place, qtbot)
    qtbot.waitUntil(lambda: place.scene.shapes.outline(place.page.work.motifs[0]) is not None)
    return place


def settled(place, qtbot, timeout=10000):
    """Wait until the pattern of the page as it is now is in sight."""

    def done():
        made = place.patterner.made
        live = place.patterner.live
        return not live.running and made is not None and made.work == place.page.work

    qtbot.waitUntil(done, timeout=timeout)


def motif(place, number=4):
    return place.page.work.motifs[number]


def middle(place, number=4):
    one = motif(place, number)
    return one.x, one.y


def click(place, point, modifiers=Qt.KeyboardModifier.NoModifier):
    QTest.mouseClick(place.view, LEFT, modifiers, at(place, point))


def works(session):
    return [call[1] for call in session.calls if call[0] == "pattern"]


def undone(place):
    """Undo a step, and return the page before it."""
    place.document.undo_stack.undo()
    return place.page


def test_an_empty_page_says_what_to_do_and_offers_it(place):
    assert place.scene.empty
    assert place.start_buttons.isVisible()
    assert place.chooser.isVisible()
    assert place.picture is None
    for name in ("css", "save", "clear", "scatter", "mirror", "run"):
        assert not place.actions_by_name[name].isEnabled(), name


def test_icons_are_scattered_and_the_pattern_follows(laid_out, qtbot, session):
    page = laid_out.page
    assert len(page.work.motifs) == 9
    assert {one.icon for one in page.work.motifs} == {RING}
    icon = laid_out.picture.icon
    assert isinstance(icon, Patterned)
    assert icon.credits == (RING,)
    assert threading.get_ident() not in session.thread_ids
    laid_out.take(CROSS)
    qtbot.waitUntil(lambda: len(laid_out.page.icons) == 2)
    motifs = laid_out.page.work.motifs
    counts = {icon: sum(one.icon == icon for one in motifs) for icon in laid_out.page.icons}
    assert sorted(counts.values()) == [4, 5], "scattered together, as nobody has arranged them"
    assert undone(laid_out) == page


def test_once_arranged_icons_go_where_there_is_room(laid_out, qtbot):
    drag(laid_out, middle(laid_out), (140, 140))
    page = laid_out.page
    laid_out.take(CROSS)
    qtbot.waitUntil(lambda: len(laid_out.page.work.motifs) == 10)
    assert laid_out.page.work.motifs[:9] == page.work.motifs
    assert laid_out.page.chosen == {9}
    assert undone(laid_out).work == page.work


def test_a_preview_is_shown_until_the_pattern_is_finished(place, qtbot, session):
    session.gate = threading.Semaphore(0)
    place.take(RING)
    qtbot.waitUntil(lambda: place.picture is not None)
    assert place.picture.preview
    session.gate.release(100)
    settled(place, qtbot)
    assert not place.picture.preview


def test_a_click_chooses_shift_adds_and_a_band_chooses_several(laid_out):
    click(laid_out, middle(laid_out, 0))
    assert laid_out.page.chosen == {0}
    click(laid_out, middle(laid_out, 5), SHIFT)
    assert laid_out.page.chosen == {0, 5}
    click(laid_out, middle(laid_out, 5), SHIFT)
    assert laid_out.page.chosen == {0}
    drag(laid_out, (1, 1), (250, middle(laid_out, 0)[1] + 25))
    assert laid_out.page.chosen == {0, 1, 2}
    press(laid_out, Qt.Key.Key_A, CONTROL)
    assert laid_out.page.chosen == set(range(9))
    press(laid_out, Qt.Key.Key_Escape)
    assert laid_out.page.chosen == frozenset()
    assert laid_out.document.undo_stack.count() == 1, "to choose is no step"


def test_a_drag_moves_what_is_chosen_in_one_step_and_the_pattern_follows(laid_out, qtbot, session):
    before, ran = laid_out.page.work, len(works(session))
    x, y = middle(laid_out)
    drag(laid_out, (x, y), (x + 20, y - 10))
    one = motif(laid_out)
    assert (one.x - x, one.y - y) == pytest.approx((20, -10), abs=1)
    assert [m for n, m in enumerate(laid_out.page.work.motifs) if n != 4] == [
        m for n, m in enumerate(before.motifs) if n != 4
    ]
    settled(laid_out, qtbot)
    assert len(works(session)) > ran
    ran = len([one for one in works(session) if one == before])
    assert undone(laid_out).work == before
    settled(laid_out, qtbot)
    assert len([one for one in works(session) if one == before]) == ran, "it is still known"


def test_what_is_dragged_together_stays_together_at_the_border(laid_out):
    press(laid_out, Qt.Key.Key_A, CONTROL)
    before = laid_out.page.work.motifs
    drag(laid_out, middle(laid_out), (2, 2))
    after = laid_out.page.work.motifs
    by = {(round(b.x - a.x, 3), round(b.y - a.y, 3)) for a, b in zip(before, after, strict=True)}
    assert len(by) == 1
    assert min(one.x for one in after) == pytest.approx(0, abs=1e-6)


def test_escape_puts_back_what_is_dragged(laid_out):
    before = laid_out.page.work
    start = at(laid_out, middle(laid_out))
    QTest.mousePress(laid_out.view, LEFT, pos=start)
    for step in (10, 20):
        QTest.mouseMove(laid_out.view, start + QPoint(step, 0))
    assert laid_out.page.work != before
    press(laid_out, Qt.Key.Key_Escape)
    QTest.mouseRelease(laid_out.view, LEFT, pos=start)
    assert laid_out.page.work == before


def test_handles_resize_and_turn(laid_out):
    click(laid_out, middle(laid_out))
    before, tool = motif(laid_out), laid_out.tools["arrange"]
    frame = tool._frame(before, laid_out.view.camera)
    x, y = before.x, before.y
    corner = laid_out.view.camera.to_page(frame[2])
    out = x + 1.5 * (corner[0] - x), y + 1.5 * (corner[1] - y)
    drag(laid_out, corner, out)
    assert motif(laid_out).size == pytest.approx(1.5 * before.size, rel=0.05)
    assert undone(laid_out).work.motifs[4] == before
    frame = tool._frame(before, laid_out.view.camera)
    held = laid_out.view.camera.to_page(stalk(frame)[0])
    around = x - (held[1] - y), y + (held[0] - x)  # a quarter clockwise
    drag(laid_out, held, around)
    assert motif(laid_out).turn - before.turn == pytest.approx(90, abs=3)
    assert undone(laid_out).work.motifs[4] == before


@pytest.mark.parametrize(
    ("name", "seen"),
    [
        ("mirror", lambda a, b: b.flip and b.turn == -a.turn),
        ("larger", lambda a, b: b.size == pytest.approx(1.1 * a.size)),
        ("smaller", lambda a, b: b.size == pytest.approx(a.size / 1.1)),
        ("turn_right", lambda a, b: b.turn == pytest.approx(a.turn + 15)),
        ("turn_left", lambda a, b: b.turn == pytest.approx(a.turn - 15)),
    ],
)
def test_keys_and_buttons_change_the_chosen_ones(laid_out, name, seen):
    click(laid_out, middle(laid_out))
    before = laid_out.page
    laid_out.actions_by_name[name].trigger()
    assert seen(before.work.motifs[4], motif(laid_out))
    assert laid_out.page.chosen == {4}
    assert undone(laid_out) == before


def test_motifs_are_copied_stacked_and_taken_out(laid_out):
    click(laid_out, middle(laid_out))
    chosen, before = motif(laid_out), laid_out.page
    laid_out.actions_by_name["front"].trigger()
    assert laid_out.page.work.motifs[-1] == chosen
    laid_out.actions_by_name["behind"].trigger()
    assert laid_out.page.work.motifs[0] == chosen
    laid_out.actions_by_name["duplicate"].trigger()
    assert len(laid_out.page.work.motifs) == 10
    assert laid_out.page.chosen == {9}
    press(laid_out, Qt.Key.Key_Delete)
    assert len(laid_out.page.work.motifs) == 9
    for _ in range(4):
        undone(laid_out)
    assert laid_out.page == before


def test_the_chosen_ones_take_another_colour(laid_out, monkeypatch):
    assert not laid_out.colour.isEnabled()
    click(laid_out, middle(laid_out))
    assert laid_out.colour.colour == motif(laid_out).colour
    laid_out.colour.chosen.emit(PALETTE[3])
    assert motif(laid_out).colour == laid_out.colour.colour == PALETTE[3]
    monkeypatch.setattr(QColorDialog, "getColor", lambda *_: QColor("#123456"))
    laid_out.colour.ask()
    assert motif(laid_out).colour == "#123456"
    monkeypatch.setattr(QColorDialog, "getColor", lambda *_: QColor())
    laid_out.colour.ask()
    assert motif(laid_out).colour == "#123456"
    undone(laid_out)
    assert undone(laid_out).work.motifs[4].colour == PALETTE[0]


def test_nudges_are_steps_of_the_arrow_keys(laid_out):
    click(laid_out, middle(laid_out))
    before = motif(laid_out)
    press(laid_out, Qt.Key.Key_Right)
    press(laid_out, Qt.Key.Key_Down, SHIFT)
    assert (motif(laid_out).x - before.x, motif(laid_out).y - before.y) == pytest.approx((1, 10))
    assert undone(laid_out).work.motifs[4].y == before.y


def test_scattering_anew_keeps_icons_sizes_and_colours(laid_out):
    click(laid_out, middle(laid_out))
    laid_out.colour.chosen.emit(PALETTE[3])
    laid_out.actions_by_name["smaller"].trigger()
    before = laid_out.page.work
    laid_out.actions_by_name["scatter"].trigger()
    after = laid_out.page.work
    assert [(one.x, one.y) for one in after.motifs] != [(one.x, one.y) for one in before.motifs]
    assert [(one.icon, one.colour) for one in after.motifs] == [
        (one.icon, one.colour) for one in before.motifs
    ]
    sizes = [a.size / b.size for a, b in zip(after.motifs, before.motifs, strict=True)]
    assert sizes == pytest.approx([sizes[0]] * 9, rel=0.01)
    assert undone(laid_out).work == before


def test_the_ground_may_be_transparent(laid_out, qtbot):
    before, transparent = laid_out.page, laid_out.controls.transparent
    transparent.click()
    assert laid_out.page.work.ground == ""
    assert not laid_out.controls.ground.isEnabled()
    settled(laid_out, qtbot)
    shown = pixels(laid_out.view.grab().toImage())
    middle_row = shown[shown.shape[0] // 2, :, 0]
    assert len(np.unique(middle_row)) > 2, "checks"
    transparent.click()
    assert laid_out.page == before
    undone(laid_out)
    assert undone(laid_out) == before


def changed(place, what):
    controls = place.controls
    match what:
        case "size":
            controls.size_fields.width_field.setValue(640)
        case "tile":
            controls.tile.click()
        case "density":
            controls.density.slider.setValue(20)
        case "scale":
            controls.factor.slider.setValue(-20)
        case "turn":
            controls.turn.slider.setValue(45)
        case "seed":
            controls.seed.dice.click()
        case "ground":
            controls.ground.chosen.emit("#17375e")


@pytest.mark.parametrize(
    ("what", "value"),
    [
        ("size", lambda work: (work.width, work.height) == (640, 512)),
        ("tile", lambda work: not work.tile),
        ("density", lambda work: work.density == 2),
        ("scale", lambda work: work.scale == 0.5),
        ("turn", lambda work: work.turn == 45),
        ("seed", lambda work: work.seed > 0),
        ("ground", lambda work: work.ground == "#17375e"),
    ],
)
def test_controls_change_what_is_wanted(laid_out, qtbot, monkeypatch, what, value):
    monkeypatch.setattr("random.randrange", lambda _: 77)
    before = laid_out.page
    changed(laid_out, what)
    assert value(laid_out.page.work)
    settled(laid_out, qtbot)
    assert undone(laid_out) == before
    settled(laid_out, qtbot)


def test_one_drag_of_a_slider_is_one_step(laid_out):
    slider, before = laid_out.controls.density.slider, laid_out.page
    slider.sliderPressed.emit()
    for value in (5, 10, 15):
        slider.setValue(value)
    slider.sliderReleased.emit()
    assert laid_out.page.work.density > 1.5
    assert undone(laid_out) == before
    assert slider.value() == 0


def test_a_pattern_that_would_take_too_long_is_refused(laid_out, qtbot):
    with qtbot.waitSignal(laid_out.failed) as failed:
        laid_out.controls.size_fields.width_field.setValue(10_000)
        laid_out.controls.size_fields.height_field.setValue(10_000)
    assert "minutes" in failed.args[0]


def test_other_seeds_are_shown_and_one_is_taken_over(laid_out, qtbot, session, window):
    sheet = laid_out.seeds.sheet
    qtbot.waitUntil(lambda: len(sheet.pictures) == SEEDS, timeout=10000)
    assert sheet.pictures[0] is laid_out.picture
    assert sheet.model().is_marked(sheet.pictures[0])
    ran, third = len(works(session)), sheet.pictures[2]
    spot = sheet.visualRect(sheet.model().index(2, 0)).center()
    QTest.mouseClick(sheet.viewport(), LEFT, pos=spot)
    assert laid_out.page.work.seed == 2
    assert laid_out.picture is third
    assert sheet.model().is_marked(third)
    assert window.recent.pictures[0] is third
    qtbot.wait(20)
    assert len(works(session)) == ran, "it was made already"
    assert len(sheet.pictures) == SEEDS
    undone(laid_out)
    assert laid_out.picture is sheet.pictures[0]


def test_a_sheet_that_was_made_is_shown_again_at_once(laid_out, qtbot, session):
    sheet = laid_out.seeds.sheet
    qtbot.waitUntil(lambda: len(sheet.pictures) == SEEDS, timeout=10000)
    first = sheet.pictures
    laid_out.controls.tile.click()
    qtbot.waitUntil(lambda: sheet.pictures[0] is not first[0], timeout=10000)
    undone(laid_out)
    ran = len(works(session))
    qtbot.waitUntil(lambda: sheet.pictures == first, timeout=10000)
    assert len(works(session)) == ran
    laid_out.take(CROSS)
    qtbot.waitUntil(lambda: sheet.pictures[:1] != first[:1], timeout=10000)
    assert first[0] not in sheet.pictures, "they are of another exemplar"


def test_the_next_icon_is_the_shape_that_is_filled(laid_out, qtbot):
    controls, before = laid_out.controls, laid_out.page
    assert not controls.whole.isEnabled()
    controls.fill.click()
    assert controls.fill.isChecked()
    assert "shape to fill" in laid_out.chooser.caption.text()
    laid_out.chooser.chosen.emit(exemplar(2))
    qtbot.waitUntil(lambda: laid_out.page.work.fill == CROSS)
    assert laid_out.page.work.motifs == before.work.motifs
    assert not controls.fill.isChecked()
    assert "shape to fill" not in laid_out.chooser.caption.text()
    settled(laid_out, qtbot)
    assert CROSS in laid_out.picture.icon.credits
    controls.whole.click()
    assert laid_out.page.work == before.work
    assert undone(laid_out).work.fill == CROSS


@pytest.mark.parametrize(
    ("content", "said"),
    [
        ({"motifs": []}, "no exemplar yet"),
        ({"image": "tiny.png"}, "1 x 1 pixels"),
        (None, "1 x 1 pixels"),
    ],
)
def test_what_is_no_exemplar_is_refused_and_the_page_stays(
    laid_out, qtbot, tmp_path, content, said
):
    before, path = laid_out.page, tmp_path / "p1.json"
    Pixels.new("RGB", (1, 1), "red").save(tmp_path / "tiny.png")
    path.write_text(json.dumps(content))
    with qtbot.waitSignal(laid_out.failed) as failed:
        if content is None:
            laid_out.open_image(str(tmp_path / "tiny.png"))
        else:
            laid_out.opener.open_file(str(path))
    assert said in failed.args[0]
    assert laid_out.page == before


@pytest.fixture
def ornament(tmp_path):
    """A red square on a white ground."""
    path = tmp_path / "ornament.png"
    colours = np.full((64, 96, 3), 255, np.uint8)
    colours[16:48, 24:72] = 220, 30, 30
    Pixels.fromarray(colours).save(path)
    return path


def test_an_image_is_the_exemplar_and_its_layers_are_corrected(place, qtbot, ornament):
    data = QMimeData()
    data.setUrls([QUrl.fromLocalFile(str(ornament))])
    place.open_mime(data)
    qtbot.waitUntil(lambda: place.page.work.image is not None)
    qtbot.waitUntil(lambda: place.reader.layers is not None)
    assert place.layers.isVisible() and not place.chooser.isVisible()
    assert place.actions_by_name["brush"].isChecked()
    assert place.reader.layers.colours == ("#ffffff", "#dc1e1e")
    settled(place, qtbot)
    place.patterner.remarked.emit("The image has 12 layers.")
    assert place.layers.caption.text().startswith("The image has 12 layers. Choose a layer")
    before = place.page
    drag(place, (5, 5), (5, 60))
    (correction,) = place.page.work.image.corrections
    assert correction.layer == 1
    qtbot.waitUntil(lambda: place.reader.layers.numbers[30, 5] == 1)
    assert place.reader.layers.separated[30, 5] == 0
    place.layers.clear.click()
    assert place.page == before
    undone(place)
    assert undone(place) == before
    place.actions_by_name["shape"].trigger()
    assert place.chooser.isVisible(), "to choose the shape from"
    place.actions_by_name["shape"].trigger()
    assert place.layers.isVisible()
    place.layers.count.setValue(3)
    assert place.page.work.image.colours == 3
    place.actions_by_name["clear"].trigger()
    assert place.chooser.isVisible()
    assert place.actions_by_name["arrange"].isChecked()


def test_a_coloured_drawing_is_opened_as_an_image_with_its_credits(place, qtbot, tmp_path):
    path = tmp_path / "ornament.svg"
    path.write_text(
        '<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 96 64"><title>Ornament</title>'
        '<rect width="96" height="64" fill="#fff"/>'
        '<rect x="24" y="16" width="48" height="32" fill="#dc1e1e"/></svg>'
    )
    place.open_image(str(path))
    qtbot.waitUntil(lambda: place.reader.layers is not None)
    assert place.reader.layers.colours == ("#ffffff", "#dc1e1e")
    assert [one.id.startswith("own:ornament") for one in place.page.work.image.credits] == [True]


def test_a_sprite_sheet_opened_as_an_image_is_told_in_words_of_the_window(place, qtbot, tmp_path):
    path = tmp_path / "sheet.svg"
    symbol = '<symbol id="{}" viewBox="0 0 9 9"><path d="M1 1h7v7z" fill="red"/></symbol>'
    symbols = "".join(map(symbol.format, ("flag", "bar")))
    path.write_text(f'<svg xmlns="http://www.w3.org/2000/svg">{symbols}</svg>')
    place.open_image(str(path))
    notice = place.window().pane.notice
    qtbot.waitUntil(notice.isVisible)
    assert "sprite sheet of 2 symbols (flag, bar)" in notice.label.text()
    assert notice.label.text().endswith("Drop it on the canvas to choose a symbol as an icon.")


def test_while_the_first_pattern_is_made_its_place_says_so(place, qtbot, monkeypatch):
    go, run = threading.Event(), place.session.run

    def slowly(*asked):
        while not go.wait(0.01):
            yield Progress("pattern", 0.1, "Making the pattern")
        yield from run(*asked)

    monkeypatch.setattr(place.session, "run", slowly)
    assert place.detail.empty.text() == INVITATION
    place.take(RING)
    qtbot.waitUntil(lambda: place.patterner.live.running)
    assert place.detail.empty.isVisible()
    assert place.detail.empty.text() == MAKING
    place.cancel()
    assert place.detail.empty.text() == INVITATION
    place.actions_by_name["undo"].trigger()
    assert place.detail.empty.text() == INVITATION
    place.actions_by_name["redo"].trigger()
    assert place.detail.empty.text() == MAKING
    go.set()
    qtbot.waitUntil(lambda: not place.detail.empty.isVisible())


def test_the_work_is_saved_beside_its_image_and_opened(
    place, qtbot, monkeypatch, tmp_path, ornament
):
    place.open_image(str(ornament))
    qtbot.waitUntil(lambda: place.page.work.image is not None)
    path = tmp_path / "work.json"
    save_to(place, monkeypatch, path)
    place.actions_by_name["save"].trigger()
    qtbot.waitUntil(path.exists)
    assert json.loads(path.read_text())["image"]


def test_patterns_of_icons_are_saved_and_opened(laid_out, qtbot, monkeypatch, tmp_path):
    path = tmp_path / "work.json"
    save_to(laid_out, monkeypatch, path)
    laid_out.actions_by_name["save"].trigger()
    qtbot.waitUntil(path.exists)
    work = laid_out.page.work
    laid_out.actions_by_name["new"].trigger()
    assert laid_out.page == PatternPage()
    assert laid_out.picture is None
    assert not laid_out.seeds.sheet.pictures
    laid_out.opener.open_work(str(path))
    qtbot.waitUntil(lambda: laid_out.page.work == work)


@pytest.mark.parametrize(
    ("name", "content"),
    [("svg", b"<svg"), ("png", b"\x89PNG"), ("css", b"background: url")],
)
def test_patterns_are_saved_with_their_credits(
    laid_out, qtbot, monkeypatch, tmp_path, name, content
):
    path = tmp_path / f"rings.{name}"
    save_to(laid_out, monkeypatch, path)
    laid_out.actions_by_name[name].trigger()
    qtbot.waitUntil(path.exists)
    assert content in path.read_bytes()
    if name == "png":
        assert QImage(str(path)).size().toTuple() == (512, 512)
    else:
        assert b"Ada Example" in path.read_bytes()


def test_page_and_results_are_kept_in_a_project(window, laid_out, qtbot, tmp_path, monkeypatch):
    laid_out.kept.emit(laid_out.picture)
    page, path, icon = laid_out.page, tmp_path / "mine.iconstudio", laid_out.picture.icon
    monkeypatch.setattr(questions, "ask_where", lambda *_: path)
    action(window, "save_project").trigger()
    qtbot.waitUntil(lambda: path.exists() and not window.project.modified)
    window.project.new()
    qtbot.waitUntil(lambda: laid_out.page.empty)
    window.project.open(path)
    qtbot.waitUntil(lambda: laid_out.page == page)
    (found,) = window.recent.pictures
    assert found.icon.looks_like(icon)
    assert (found.icon.size, found.icon.tile, found.icon.torn) == ((512, 512), True, icon.torn)
    click(laid_out, (1, 1))
    assert not window.project.modified
    settled(laid_out, qtbot)


def test_an_old_result_turns_pale_and_is_not_offered_until_the_new_one_is_there(
    laid_out, qtbot, monkeypatch
):
    buttons, view = laid_out.detail.buttons, laid_out.large
    names = "svg", "png", "css", "copy"
    assert all(laid_out.actions_by_name[name].isEnabled() for name in names)
    view.paling.timer.setInterval(1)
    view.setFixedSize(view.size())  # a splitter may move by a pixel while patterns change
    fresh = pixels(view.grab().toImage())
    monkeypatch.setattr(laid_out.patterner.live, "request", lambda _: None)
    laid_out.controls.ground.chosen.emit("#17375e")
    assert not any(laid_out.actions_by_name[name].isEnabled() for name in names)
    assert not any(buttons[name].isEnabled() for name in names)
    qtbot.waitUntil(lambda: view.paling.opacity < 1)
    assert pixels(view.grab().toImage()).std() < 0.6 * fresh.std()
    undone(laid_out)
    assert all(buttons[name].isEnabled() for name in names)
    assert np.array_equal(pixels(view.grab().toImage()), fresh)


def test_a_long_title_is_elided_and_its_tip_has_all_of_it(laid_out):
    words = "Pattern of " + "a very long name " * 12
    title = laid_out.detail._title
    title.set_words(words)
    assert title.text().endswith("…") and title.toolTip() == title.accessibleName() == words


def test_one_pattern_is_no_plural(laid_out):
    laid_out.seeds.begin(laid_out.patterner.made)
    assert laid_out.outcome() == "1 pattern"


def test_a_result_goes_elsewhere(window, laid_out, qtbot):
    laid_out.send_picture(laid_out.picture, "Montage")
    montage = window.workspace
    qtbot.waitUntil(lambda: len(montage.page.layers) == 1)
    assert montage.page.current.icon.pictogram.made_of[0] == RING
    assert "Pattern" not in [one.title for one in laid_out.destinations]


def test_tiles_are_shown_side_by_side_without_a_seam(laid_out, qtbot):
    switch, view = laid_out.detail.switch, laid_out.large
    switch.tiled.click()
    assert view.tiles
    shown = pixels(view.grab().toImage())
    period = view._image.width()
    middle = slice(view.height() // 3, 2 * view.height() // 3)
    left = view.width() // 2 - period
    one, other = (shown[middle, left + n * period : left + (n + 1) * period] for n in (0, 1))
    assert np.array_equal(one, other)
    assert one.std() > 0.05
    switch.single.click()
    assert not view.tiles
    assert view._tiled is False
    switch.tiled.click()
    changed(laid_out, "tile")
    settled(laid_out, qtbot)
    assert not view.tiles, "this one does not tile"


@pytest.mark.thorough
def test_from_an_empty_start_to_a_saved_pattern_with_the_real_session(qtbot, tmp_path, monkeypatch):
    session = Session()
    window = MainWindow(session, (PATTERN,))
    qtbot.addWidget(window)
    window.resize(1280, 720)
    window.show()
    place = window.workspace
    place.controls.size_fields.width_field.setValue(264)
    place.controls.size_fields.height_field.setValue(264)
    place.take(session.icon("lucide:heart"))
    settled(place, qtbot, timeout=60000)
    first = place.picture.icon
    assert first.size == (264, 264)  # there is room for each of the nine hearts
    place.colour.chosen.emit("#000000")  # nothing is chosen
    click(place, middle(place))
    assert len(place.page.chosen) == 1
    place.colour.chosen.emit("#112233")
    settled(place, qtbot, timeout=60000)
    assert "#112233" in {fill.colour for fill in place.picture.icon.fills}
    path = tmp_path / "hearts.svg"
    save_to(place, monkeypatch, path)
    place.actions_by_name["svg"].trigger()
    qtbot.waitUntil(path.exists)
    assert "lucide:heart" in [one.id for one in own_svg(path.read_bytes(), str(path)).origins]
    window.close()
    assert not threads_alive(window)
