"""Line styles by mouse and pen, in the real window with the session that needs no icons."""

import json
import math
import threading
from dataclasses import replace

import numpy as np
import pytest
from fake_session import exemplar
from hands import action, at, go_to, press, save_to, threads_alive
from images import pixels
from PySide6.QtCore import QEvent, QPoint, QPointF, Qt
from PySide6.QtGui import QInputDevice, QPointingDevice, QTabletEvent
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QFileDialog

from iconstudio.gui.project import questions
from iconstudio.gui.window.main_window import MainWindow
from iconstudio.gui.workspaces.line_style import own_styles, styles
from iconstudio.inputs.line_style import read_style, write_style
from iconstudio.inputs.styles import bundled, named
from iconstudio.model import LineStyle, StylePair
from iconstudio.session import Session
from iconstudio.svg.reading import own_svg
from iconstudio.workflows.line_style import page as edits
from iconstudio.workflows.line_style.page import OWN
from iconstudio.workflows.line_style.spec import LINE_STYLE
from tests.shapes import outline

LEFT = Qt.MouseButton.LeftButton
NONE, SHIFT = Qt.KeyboardModifier.NoModifier, Qt.KeyboardModifier.ShiftModifier
RING, FRAME = (exemplar(number).pictogram for number in range(2))
WAVE = [QPoint(20 + 2 * n, round(50 + 15 * math.sin(n / 3))) for n in range(100)]


@pytest.fixture
def place(window, qtbot):
    return go_to(window, "Line style")


@pytest.fixture
def restyled(place, qtbot):
    """A ring in ink."""
    place.take(RING)
    qtbot.waitUntil(lambda: place.page.has_lines and len(place.scene.lines) == 2)
    choose(place, qtbot, "Ink")
    settled(place, qtbot)
    return place


def settled(place, qtbot, timeout=10000):
    """Wait until the result of the page as it is now is in sight."""

    def done():
        made = place.restyler.made
        return not place.restyler.live.running and made is not None and made.work == place.page.work

    qtbot.waitUntil(done, timeout=timeout)


def choose(place, qtbot, name, timeout=10000):
    """Click the sample of a style."""
    sheet = place.styles.sheet
    qtbot.waitUntil(lambda: len(sheet.pictures) == len(place.styles.styles), timeout=timeout)
    row = [style.name for style in place.styles.styles].index(name)
    index = sheet.model().index(row, 0)
    sheet.scrollTo(index)
    QTest.mouseClick(sheet.viewport(), LEFT, pos=sheet.visualRect(index).center())


def drag(widget, spots, modifiers=NONE):
    QTest.mousePress(widget, LEFT, modifiers, spots[0])
    for spot in spots:
        QTest.mouseMove(widget, spot)
    QTest.mouseRelease(widget, LEFT, modifiers, spots[-1])


def select(place, *points, modifiers=NONE):
    drag(place.view, [at(place, point) for point in points], modifiers)


def works(session):
    return [call[1] for call in session.calls if call[0] == "restyle"]


def test_an_empty_page_says_what_to_do_and_offers_it(place, qtbot):
    assert place.scene.empty
    assert place.start_buttons.isVisible()
    assert place.examples.actions()
    with qtbot.waitSignal(place.hinted) as hint:
        place.run()
    assert "no lines" in hint.args[0]
    assert not place.actions_by_name["style_out"].isEnabled()


def test_every_style_is_shown_by_a_sample_drawn_once(window, place, qtbot, session):
    qtbot.waitUntil(lambda: not place.styles.runner.running, timeout=10000)
    assert all(one.icon.path for one in place.styles.sheet.pictures)
    drawn = [work.style for work in works(session)]
    assert sorted(drawn, key=lambda style: style.name) == sorted(
        bundled(), key=lambda style: style.name
    )
    go_to(window, "Sketch")
    go_to(window, "Line style")
    assert len(works(session)) == len(drawn)


def test_styles_can_be_chosen_by_name_before_any_sample_is_drawn(window, qtbot, session):
    session.gate = threading.Semaphore(0)
    first = bundled()[0]
    session.kept_samples[first.name] = outline([(0, 0), (9, 0), (9, 9)])
    place = go_to(window, "Line style")
    sheet = place.styles.sheet
    qtbot.waitUntil(lambda: bool(sheet.pictures[0].icon.path))
    assert [one.title for one in sheet.pictures] == [one.name for one in bundled()]
    assert works(session)[0].style != first, "it is kept from an earlier start"
    assert not any(one.icon.path for one in sheet.pictures[1:])
    assert all(one.outline.boundingRect().width() > 60 for one in sheet.pictures[1:])
    choose(place, qtbot, "Ink")
    assert place.page.style == named("Ink")
    session.gate.release(100)
    qtbot.waitUntil(lambda: not place.styles.runner.running, timeout=10000)
    assert all(one.icon.path for one in sheet.pictures)


def test_a_style_is_asked_for_and_the_result_follows(place, qtbot):
    place.take(RING)
    qtbot.waitUntil(lambda: len(place.scene.lines) == 2)
    assert "Choose a style" in place.tools["select"].hint
    assert place.picture is None
    choose(place, qtbot, "Waves")
    settled(place, qtbot)
    assert place.scene.result is place.picture
    assert place.picture.title == "ring 0, Waves"
    assert place.picture.icon.credits[0] == RING
    qtbot.waitUntil(lambda: len(place.variations.sheet.pictures) == 12, timeout=10000)


def test_one_drag_of_a_slider_is_one_step(restyled, qtbot, session):
    slider, stack = restyled.controls.strength.slider, restyled.document.undo_stack
    before, steps = restyled.page, stack.count()
    for target in (150, 180):
        slider.sliderPressed.emit()
        for value in range(110, target, 10):
            slider.setValue(value)
        slider.sliderReleased.emit()
    assert stack.count() == steps + 2
    assert restyled.page.work.strength == 1.7
    settled(restyled, qtbot)
    stack.undo()
    assert restyled.page.work.strength == 1.4
    stack.undo()
    assert restyled.page == before
    assert slider.value() == 100
    settled(restyled, qtbot)
    assert threading.get_ident() not in session.thread_ids


def test_undo_shows_result_and_variations_that_were_there_at_once(restyled, qtbot, session):
    sheet, first = restyled.variations.sheet, restyled.picture
    qtbot.waitUntil(lambda: len(sheet.pictures) == 12 and not restyled.restyler.varying.running)
    variations = list(sheet.pictures)
    restyled.controls.strength.slider.setValue(180)
    settled(restyled, qtbot)
    assert restyled.picture is not first
    count = len(works(session))
    restyled.document.undo_stack.undo()
    assert restyled.picture is first and restyled.scene.result is first
    assert list(sheet.pictures) == variations
    restyled.document.undo_stack.redo()
    assert restyled.picture is not first
    assert len(works(session)) == count


def test_an_old_result_turns_pale_and_is_not_offered_until_the_new_one_is_there(
    restyled, qtbot, monkeypatch
):
    names, canvas, detail = ("svg", "png", "copy", "strokes"), restyled.view, restyled.detail.large
    for paling in (restyled.scene.paling, detail.paling):
        paling.timer.setInterval(1)
    for widget in (canvas, detail):  # a splitter may move by a pixel while styles change
        widget.setFixedSize(widget.size())
    fresh = pixels(canvas.grab().toImage()), pixels(detail.grab().toImage())
    with monkeypatch.context() as patch:
        patch.setattr(restyled.restyler.live, "request", lambda _: None)
        choose(restyled, qtbot, "Loops")
        assert not any(restyled.actions_by_name[name].isEnabled() for name in names)
        assert not any(button.isEnabled() for button in restyled.detail.buttons.values())
        qtbot.waitUntil(lambda: detail.paling.opacity < 1 and restyled.scene.paling.opacity < 1)
        assert pixels(detail.grab().toImage()).std() < 0.6 * fresh[1].std()
        assert pixels(canvas.grab().toImage()).std() < 0.8 * fresh[0].std()
        restyled.document.undo_stack.undo()
    assert all(restyled.actions_by_name[name].isEnabled() for name in names)
    assert np.array_equal(pixels(detail.grab().toImage()), fresh[1])
    assert np.array_equal(pixels(canvas.grab().toImage()), fresh[0])


def test_a_variation_is_as_old_as_what_it_varies(restyled, qtbot, monkeypatch):
    sheet = restyled.variations.sheet
    qtbot.waitUntil(lambda: len(sheet.pictures) == 12 and not restyled.restyler.varying.running)
    sheet.chosen.emit(sheet.pictures[5])
    assert restyled.takeable
    monkeypatch.setattr(restyled.restyler.live, "request", lambda _: None)
    restyled.document.change(
        "choose style", edits.RestylePage(replace(restyled.page.work, style=named("Loops")))
    )
    assert restyled.stale and not restyled.takeable
    sheet.chosen.emit(sheet.pictures[6])
    assert restyled.stale


def test_what_becomes_of_pale_parts_is_told(place, qtbot, session, monkeypatch):
    ring = exemplar(0)
    pale = replace(ring, coverage=np.where(ring.ink, 90, 0).astype(np.uint8))
    monkeypatch.setattr(session, "exemplar", lambda _: pale)
    said = []
    place.remarked.connect(said.append)
    place.take(RING)
    qtbot.waitUntil(lambda: place.page.has_lines)
    assert said[-1].startswith("“ring 0” is on the canvas. Its pale parts were left out")


def test_turning_says_nothing_as_long_as_it_is_the_styles_own(restyled):
    box = restyled.controls.turning
    own = named("Ink").rotation
    assert box.isChecked() == own
    box.click()
    assert restyled.page.work.turning is (not own)
    box.click()
    assert restyled.page.work.turning is None


def test_a_selected_line_takes_a_style_of_its_own(restyled, qtbot):
    select(restyled, (128, 131))
    assert restyled.page.selected == {1}
    choose(restyled, qtbot, "Loops")
    assert restyled.page.work.others == ((1, named("Loops")),)
    assert restyled.page.work.style == named("Ink")
    settled(restyled, qtbot)
    assert {one.name for one in restyled.page.styles} == {"Ink", "Loops"}
    select(restyled, (10, 10))
    assert restyled.page.selected == frozenset()


def test_a_box_selects_lines_and_shift_adds(restyled):
    select(restyled, (90, 110), (120, 140), (140, 150))
    assert restyled.page.selected == {1}
    select(restyled, (60, 100), modifiers=SHIFT)
    assert restyled.page.selected == {0, 1}
    select(restyled, (60, 100), modifiers=SHIFT)
    assert restyled.page.selected == {1}
    press(restyled, Qt.Key.Key_Escape)
    assert restyled.page.selected == frozenset()


def test_the_picture_follows_while_an_example_is_drawn(restyled, qtbot, session):
    pad, before = restyled.example.pad, restyled.page
    QTest.mousePress(pad, LEFT, pos=WAVE[0])
    for spot in WAVE:
        QTest.mouseMove(pad, spot)
    qtbot.waitUntil(lambda: any(work.style.name == OWN for work in works(session)), timeout=5000)
    assert restyled.page == before
    QTest.mouseRelease(pad, LEFT, pos=WAVE[-1])
    assert restyled.page.work.style.name == OWN
    settled(restyled, qtbot)
    drag(pad, WAVE)
    assert len(restyled.page.work.style.pairs) == 2
    restyled.example.clear.click()
    assert restyled.page.work.style is None
    assert restyled.picture is None
    restyled.document.undo_stack.undo()
    assert len(restyled.page.work.style.pairs) == 2


def test_an_example_may_be_a_plain_stroke_and_a_styled_one(restyled):
    restyled.example.both.click()
    pad = restyled.example.pad
    straight = [QPoint(20, 50), QPoint(120, 50), QPoint(220, 50)]
    drag(pad, straight)
    assert pad.plain
    restyled.example.clear.click()
    assert not pad.plain
    drag(pad, straight)
    assert restyled.page.work.style == named("Ink")
    drag(pad, WAVE)
    (pair,) = restyled.page.work.style.pairs
    assert pair.plain
    assert len(pair.styled) > len(pair.plain)
    restyled.example.alone.click()
    drag(pad, WAVE)
    (pair,) = restyled.page.work.style.pairs
    assert not pair.plain


def test_an_example_too_short_to_learn_from_is_told(restyled, qtbot):
    before = restyled.page
    with qtbot.waitSignal(restyled.hinted) as hint:
        drag(restyled.example.pad, [QPoint(20, 20), QPoint(22, 20), QPoint(24, 22)])
    assert "Draw it longer" in hint.args[0]
    assert restyled.page == before
    drag(restyled.example.pad, [QPoint(20, 20)])
    assert restyled.page == before


def write(widget, spots, pressures):
    """Draw with a pen."""
    device = QPointingDevice(
        "pen", 1, QInputDevice.DeviceType.Stylus, QPointingDevice.PointerType.Pen,
        QInputDevice.Capability.Pressure, 1, 1,
    )  # fmt: skip
    kinds = [QEvent.Type.TabletPress, *[QEvent.Type.TabletMove] * (len(spots) - 2)]
    for kind, spot, pressed in zip(
        [*kinds, QEvent.Type.TabletRelease], map(QPointF, spots), pressures, strict=True
    ):
        event = QTabletEvent(kind, device, spot, spot, pressed, 0, 0, 0, 0, 0, NONE, LEFT, LEFT)
        QApplication.sendEvent(widget, event)


PRESSED = [n / 100 for n in range(100)]


def test_a_pen_draws_an_example_with_its_pressure(restyled):
    write(restyled.example.pad, WAVE, PRESSED)
    (pair,) = restyled.page.work.style.pairs
    assert len(pair.widths) == len(pair.styled)
    assert pair.widths[0] < pair.widths[-1]


def test_a_pen_draws_lines_with_its_pressure(restyled, qtbot):
    """They had one width."""
    restyled.actions_by_name["pen"].trigger()
    write(restyled.view, [at(restyled, (40 + 1.5 * n, 220.0)) for n in range(100)], PRESSED)
    (line,) = restyled.page.work.strokes
    assert len(line.widths) == len(line.points)
    assert line.widths[0] < 5 < 12 < line.widths[-1] <= line.width
    settled(restyled, qtbot)
    made = restyled.picture.icon.lines[-1]
    assert np.mean(made.widths[:20]) < 6 < 10 < np.mean(made.widths[-20:])


def test_lines_can_be_drawn_and_removed(restyled, qtbot):
    restyled.actions_by_name["pen"].trigger()
    select(restyled, *[(40 + 2 * n, 220.0) for n in range(60)])
    assert len(restyled.page.work.strokes) == 1
    settled(restyled, qtbot)
    assert len(restyled.scene.lines) == 3
    restyled.actions_by_name["select"].trigger()
    press(restyled, Qt.Key.Key_A, Qt.KeyboardModifier.ControlModifier)
    assert restyled.page.selected == {0, 1, 2}
    press(restyled, Qt.Key.Key_Delete)
    assert len(restyled.scene.lines) == 2
    assert restyled.page.work.icon == RING
    restyled.document.undo_stack.undo()
    assert len(restyled.scene.lines) == 3
    restyled.actions_by_name["clear"].trigger()
    assert restyled.scene.empty
    assert restyled.picture is None


def test_a_variation_is_looked_at_and_its_settings_are_taken_over(restyled, qtbot):
    sheet = restyled.variations.sheet
    qtbot.waitUntil(lambda: len(sheet.pictures) == 12, timeout=10000)
    seventh = sheet.pictures[6]
    QTest.mouseClick(
        sheet.viewport(), LEFT, pos=sheet.visualRect(sheet.model().index(6, 0)).center()
    )
    assert restyled.picture is restyled.scene.result is seventh
    before = restyled.page.work
    restyled.variations.button.click()
    work = restyled.page.work
    assert work.seed == before.seed + 2
    assert work.strength == pytest.approx(0.6)
    settled(restyled, qtbot)
    assert restyled.picture.icon.looks_like(seventh.icon)
    restyled.document.undo_stack.undo()
    assert restyled.page.work == before


def test_styles_are_saved_and_opened(restyled, qtbot, monkeypatch, tmp_path):
    drag(restyled.example.pad, WAVE)
    path = tmp_path / "mine.json"
    save_to(restyled, monkeypatch, path)
    restyled.actions_by_name["style_out"].trigger()
    qtbot.waitUntil(path.exists)
    assert read_style(path).pairs[0].styled
    other = LineStyle("Hers", (StylePair(((0.0, 0.0), (20.0, 5.0), (40.0, 0.0))),))
    write_style(tmp_path / "hers.json", other)
    monkeypatch.setattr(
        QFileDialog, "getOpenFileName", lambda *_: (str(tmp_path / "hers.json"), "")
    )
    restyled.actions_by_name["style_in"].trigger()
    qtbot.waitUntil(lambda: restyled.page.work.style == other)
    settled(restyled, qtbot)
    assert other in restyled.styles.styles
    found = {style.name for style in own_styles.known_styles()}
    assert found == {"mine", "Hers"}


def test_icons_are_saved_with_strokes_and_credits(restyled, qtbot, monkeypatch, tmp_path):
    path = tmp_path / "ring.svg"
    save_to(restyled, monkeypatch, path)
    restyled.actions_by_name["strokes"].trigger()
    qtbot.waitUntil(path.exists)
    svg = path.read_text()
    assert "stroke-width" in svg
    assert "Ada Example" in svg


def test_the_work_is_saved_and_opened(restyled, qtbot, monkeypatch, tmp_path):
    path = tmp_path / "work.json"
    save_to(restyled, monkeypatch, path)
    restyled.actions_by_name["save"].trigger()
    qtbot.waitUntil(path.exists)
    assert json.loads(path.read_text())["style"] == "Ink"
    work = restyled.page.work
    restyled.actions_by_name["new"].trigger()
    assert restyled.page.empty
    restyled.opener.open_work(str(path))
    qtbot.waitUntil(lambda: restyled.page.work == work)


def test_a_result_goes_elsewhere_and_icons_come_here(window, restyled, qtbot):
    restyled.send_picture(restyled.picture, "Montage")
    montage = window.workspace
    assert montage.workflow.title == "Montage"
    qtbot.waitUntil(lambda: len(montage.page.layers) == 1)
    assert montage.page.current.icon.pictogram.made_of[0] == RING
    titles = [one.title for one in restyled.destinations]
    assert "Montage" in titles
    assert "Line style" not in titles
    assert "Restyle its lines" in [one.invitation for one in montage.destinations]


def test_the_page_is_kept_in_a_project(window, restyled, qtbot, tmp_path, monkeypatch):
    drag(restyled.example.pad, WAVE)
    select(restyled, (128, 131))
    choose(restyled, qtbot, "Loops")
    page, path = restyled.page, tmp_path / "mine.iconstudio"
    monkeypatch.setattr(questions, "ask_where", lambda *_: path)
    action(window, "save_project").trigger()
    qtbot.waitUntil(lambda: path.exists() and not window.project.modified)
    window.project.new()
    qtbot.waitUntil(lambda: restyled.page.empty)
    window.project.open(path)
    qtbot.waitUntil(lambda: restyled.page == page)
    assert not window.project.modified
    select(restyled, (10, 10))
    assert not window.project.modified
    settled(restyled, qtbot)


@pytest.mark.thorough
def test_from_an_empty_start_to_a_saved_icon_with_the_real_session(qtbot, tmp_path, monkeypatch):
    shown_styles = tuple(map(named, ("Loops", "Waves")))
    monkeypatch.setattr(styles, "bundled", lambda: shown_styles)
    session = Session()
    window = MainWindow(session, (LINE_STYLE,))
    qtbot.addWidget(window)
    window.resize(1280, 720)
    window.show()
    place = window.workspace
    place.take(session.icon("lucide:house"))
    qtbot.waitUntil(lambda: len(place.scene.lines) == 2, timeout=60000)
    choose(place, qtbot, "Waves", timeout=60000)
    settled(place, qtbot, timeout=60000)
    waves = place.picture.icon
    place.controls.strength.slider.setValue(150)
    settled(place, qtbot, timeout=60000)
    stronger = place.picture.icon
    assert not stronger.looks_like(waves)
    place.document.undo_stack.undo()
    settled(place, qtbot, timeout=60000)
    assert place.picture.icon.looks_like(waves)
    points = place.scene.lines[0].points
    select(place, points[len(points) // 2])  # apart from where the lines meet
    assert place.page.selected == {0}
    choose(place, qtbot, "Loops")
    settled(place, qtbot, timeout=60000)
    assert not place.picture.icon.looks_like(waves)
    drag(place.example.pad, WAVE)
    settled(place, qtbot, timeout=60000)
    assert place.page.drawn is not None
    path = tmp_path / "icon.svg"
    save_to(place, monkeypatch, path)
    place.actions_by_name["svg"].trigger()
    qtbot.waitUntil(path.exists)
    assert "lucide:house" in [one.id for one in own_svg(path.read_bytes(), str(path)).origins]
    window.close()
    assert not threads_alive(window)
