"""Sketches and icons taken out of the sketching."""

import xml.etree.ElementTree as ET

import pytest
from hands import save_to, trace, type_keyword
from PySide6.QtGui import QImage
from PySide6.QtWidgets import QApplication

from iconstudio.inputs.sketch import example, read_sketch


@pytest.fixture
def done(sketching, qtbot):
    """A window with a finished run."""
    trace(sketching)
    type_keyword(sketching, "Motor cycle")
    sketching.run()
    qtbot.waitUntil(lambda: not sketching.runs.running, timeout=20000)
    return sketching


def test_a_saved_sketch_is_read_back_the_same(sketching, qtbot, tmp_path, monkeypatch):
    shown = example("coffee")
    sketching.opener.open_example(shown)
    qtbot.waitUntil(lambda: sketching.document.page.closed)
    path = tmp_path / "sketch.json"
    save_to(sketching, monkeypatch, path)
    sketching.actions_by_name["save"].trigger()
    qtbot.waitUntil(path.exists)
    saved = read_sketch(path)
    assert saved.sketch == shown.sketch
    assert saved.photo == shown.photo
    qtbot.waitUntil(lambda: str(path) in sketching.window().desk.strip.label.text())


def test_nothing_is_written_if_the_user_thinks_better_of_it(done, tmp_path, monkeypatch):
    save_to(done, monkeypatch, None)
    done.actions_by_name["svg"].trigger()
    assert not list(tmp_path.iterdir())


def test_an_icon_is_saved_as_svg_with_its_credits(done, qtbot, tmp_path, monkeypatch):
    asked = []
    path = tmp_path / "icon.svg"
    monkeypatch.setattr(done.saver, "ask_path", lambda *words: asked.append(words) or path)
    done.actions_by_name["svg"].trigger()
    qtbot.waitUntil(path.exists)
    assert asked == [("icon", "motor-cycle-lightest", "svg")]
    root = ET.fromstring(path.read_text("utf-8"))
    paths = root.findall(".//{http://www.w3.org/2000/svg}path")
    assert [one.get("d") for one in paths] == [done.board.detail.picture.result.drawing.path]
    assert "Ada Example" in path.read_text("utf-8")


def test_an_icon_is_saved_as_png_as_it_is_shown(done, qtbot, tmp_path, monkeypatch):
    for coded in (False, True):
        path = tmp_path / f"{coded}.png"
        save_to(done, monkeypatch, path)
        done.board.results.set_coded(coded)
        done.board.detail.save_png.emit()
        qtbot.waitUntil(path.exists)
        image = QImage(str(path))
        assert image.size().toTuple() == (1024, 1024)
        assert image.pixelColor(2, 2).alpha() == 0
    plain, colours = (QImage(str(tmp_path / f"{coded}.png")) for coded in (False, True))
    assert plain != colours


def test_an_icon_is_copied_as_svg(done):
    done.actions_by_name["copy"].trigger()
    assert QApplication.clipboard().text().lstrip().startswith("<")
    assert done.board.detail.picture.result.drawing.path in QApplication.clipboard().text()


def test_a_folder_that_cannot_be_written_is_told(done, qtbot, tmp_path, monkeypatch):
    save_to(done, monkeypatch, tmp_path / "gone" / "icon.svg")
    done.actions_by_name["svg"].trigger()
    qtbot.waitUntil(done.window().desk.notice.isVisible)
    assert "cannot be written" in done.window().desk.notice.label.text()


def test_nothing_can_be_saved_before_there_is_something(sketching):
    names = ("svg", "png", "copy", "save", "clear", "cancel")
    assert not any(sketching.actions_by_name[name].isEnabled() for name in names)
    trace(sketching)
    assert sketching.actions_by_name["save"].isEnabled()
