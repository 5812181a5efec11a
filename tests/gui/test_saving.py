"""Sketches and icons taken out of the sketching."""

import xml.etree.ElementTree as ET
from dataclasses import replace

import numpy as np
import pytest
from hands import save_to, trace, type_keyword
from PySide6.QtGui import QImage
from PySide6.QtWidgets import QApplication

from iconstudio.gui.exchange import saving
from iconstudio.gui.gallery.display import setting
from iconstudio.gui.pictures.picture import Display
from iconstudio.model import IconstudioError
from iconstudio.output.png import coverage
from iconstudio.output.svg import svg_document
from iconstudio.svg.rasterise import rasterise
from iconstudio.svg.reading import own_svg
from iconstudio.workflows.modelling.file import example, read_sketch

pytestmark = pytest.mark.thorough(but=1)


def rgba(image):
    image = image.convertToFormat(QImage.Format.Format_RGBA8888)
    flat = np.array(image.constBits(), np.uint8)
    return flat.reshape(image.height(), image.width(), 4)


def colours(image):
    """The colours of all that is opaque."""
    pixels = rgba(image)
    return {tuple(map(int, one)) for one in np.unique(pixels[pixels[..., 3] == 255], axis=0)[:, :3]}


def opened_menu(strip):
    strip.chosen.emit(strip.pictures[0])
    strip.menu.hide()
    return strip.menu


@pytest.fixture
def done(sketching, qtbot):
    """A window with a finished run."""
    trace(sketching)
    type_keyword(sketching, "Motor cycle")
    sketching.run()
    qtbot.waitUntil(lambda: not sketching.runner.running, timeout=20000)
    return sketching


def test_a_saved_sketch_is_read_back_the_same(sketching, qtbot, tmp_path, monkeypatch):
    shown = example("coffee")
    sketching.open_sketch(shown)
    qtbot.waitUntil(lambda: sketching.document.page.closed)
    path = tmp_path / "sketch.json"
    save_to(sketching, monkeypatch, path)
    sketching.actions_by_name["save"].trigger()
    qtbot.waitUntil(path.exists)
    saved = read_sketch(path)
    assert saved.sketch == shown.sketch
    assert saved.photo == shown.photo
    label = sketching.window().pane.status.label
    qtbot.waitUntil(lambda: label.text() == f"Saved “{path.name}”.")
    assert label.toolTip() == f"Saved “{path}”."


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
    assert [one.get("d") for one in paths] == [done.browser.detail.picture.icon.path.svg()]
    assert "Ada Example" in path.read_text("utf-8")


@pytest.mark.thorough
@pytest.mark.parametrize("display", list(Display))
def test_png_is_of_the_icon_and_the_colour_code_has_its_own(
    done, qtbot, tmp_path, monkeypatch, display
):
    """Whatever is shown."""
    setting.choose(display)
    images = []
    for name in ("png", "code_png"):
        path = tmp_path / f"{name}.png"
        save_to(done, monkeypatch, path)
        done.actions_by_name[name].trigger()
        qtbot.waitUntil(path.exists)
        images.append(QImage(str(path)))
        assert images[-1].size().toTuple() == (1024, 1024)
        assert images[-1].pixelColor(2, 2).alpha() == 0
    icon, code = map(colours, images)
    assert icon == {(0, 0, 0)}
    assert len(code) > 1


def test_the_colour_code_is_offered_where_png_is(done):
    for menu in (done.window()._menus["&File"], opened_menu(done.window().recent)):
        words = [action.text().replace("&", "") for action in menu.actions()]
        png = next(n for n, text in enumerate(words) if text in ("Save PNG…", "Save icon as PNG…"))
        assert words[png + 1] == "Save colour code as PNG…"


def test_the_colour_code_of_a_recent_result_is_saved(done, qtbot, tmp_path, monkeypatch):
    path = tmp_path / "code.png"
    save_to(done, monkeypatch, path)
    menu = opened_menu(done.window().recent)
    next(one for one in menu.actions() if "colour code" in one.text()).trigger()
    qtbot.waitUntil(path.exists)
    assert len(colours(QImage(str(path)))) > 1


@pytest.mark.thorough
def test_an_icon_is_copied_as_svg_as_words_and_as_a_picture(done):
    setting.choose(Display.CODED)
    done.actions_by_name["copy"].trigger()
    data, icon = QApplication.clipboard().mimeData(), done.browser.detail.picture.icon
    svg = svg_document(replace(icon, title="Motor cycle"))
    assert data.text() == svg
    assert data.data("image/svg+xml").data().decode() == svg
    shown = QImage.fromData(data.data("image/png"), "PNG")
    for image in (shown, QImage(data.imageData())):
        alpha = rgba(image)[..., 3]
        assert colours(image) == {(0, 0, 0)}
        drawn = coverage(icon.path, image.width())
        assert np.abs(alpha.astype(int) - drawn).mean() < 0.5
    assert "clipboard" in done.window().pane.status.label.text()


def test_what_is_saved_is_read_back_the_same(done, qtbot, tmp_path, monkeypatch):
    path = tmp_path / "icon.svg"
    save_to(done, monkeypatch, path)
    done.actions_by_name["svg"].trigger()
    qtbot.waitUntil(path.exists)
    own, made = own_svg(path.read_bytes(), str(path)), done.browser.detail.picture.pictogram()
    plain = (
        '<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 256 256">'
        f'<path d="{done.browser.detail.picture.icon.path.svg()}"/></svg>'
    )
    frames, pictures = zip(*map(rasterise, (own.svg, plain)), strict=True)
    assert frames[0] == frames[1]
    assert np.array_equal(*pictures)
    assert [one.credit for one in own.origins] == [one.credit for one in made.origins]


def test_no_file_gets_the_name_of_another_kind(done, qtbot, tmp_path, monkeypatch):
    save_to(done, monkeypatch, tmp_path / "icon 1.2")
    done.actions_by_name["svg"].trigger()
    saved = tmp_path / "icon 1.2.svg"
    qtbot.waitUntil(saved.exists)
    saved.write_text("mine")
    done.actions_by_name["svg"].trigger()
    assert "is there already" in done.window().pane.notice.label.text()
    assert saved.read_text() == "mine"


def test_several_results_never_share_a_name(done, qtbot, tmp_path, monkeypatch):
    """Nor the name of what is there, be it only a link to nothing."""
    (tmp_path / "motor-cycle-lightest.svg").write_text("mine")
    (tmp_path / "motor-cycle-lightest-3.svg").symlink_to("nowhere")
    monkeypatch.setattr(done.saver, "ask_folder", lambda: tmp_path)
    picture = done.browser.detail.picture
    pictures = 3 * [replace(picture, icon=replace(picture.icon, title="Motor cycle"))]
    other = replace(picture, icon=replace(picture.icon, title="很" * 300))
    done.saver.save_svgs([*pictures, other])
    qtbot.waitUntil(lambda: len(list(tmp_path.iterdir())) == 6)
    numbers = ("", "-2", "-3", "-4", "-5")
    names = [f"motor-cycle-lightest{number}.svg" for number in numbers]
    names.append("很" * 50 + ".svg")
    assert {one.name for one in tmp_path.iterdir()} == set(names)
    assert (tmp_path / names[0]).read_text() == "mine"
    assert (tmp_path / names[2]).is_symlink()
    qtbot.waitUntil(lambda: "4 icons" in done.window().pane.status.label.text())


def test_a_disk_that_fills_up_is_told_with_what_is_saved(done, qtbot, tmp_path, monkeypatch):
    write = saving.write_bytes

    def full(path, content):
        if path.stem.endswith("2"):
            raise IconstudioError("The disk is full.")
        write(path, content)

    monkeypatch.setattr(saving, "write_bytes", full)
    monkeypatch.setattr(done.saver, "ask_folder", lambda: tmp_path)
    done.saver.save_svgs([done.browser.detail.picture] * 3)
    qtbot.waitUntil(done.window().pane.notice.isVisible)
    assert done.window().pane.notice.label.text() == "1 icon of 3 saved. The disk is full."


def test_a_folder_that_cannot_be_written_is_told(done, qtbot, tmp_path, monkeypatch):
    save_to(done, monkeypatch, tmp_path / "gone" / "icon.svg")
    done.actions_by_name["svg"].trigger()
    qtbot.waitUntil(done.window().pane.notice.isVisible)
    assert "cannot be written" in done.window().pane.notice.label.text()


def test_nothing_can_be_saved_before_there_is_something(sketching):
    names = ("svg", "png", "code_png", "copy", "save", "clear", "cancel")
    assert not any(sketching.actions_by_name[name].isEnabled() for name in names)
    trace(sketching)
    assert sketching.actions_by_name["save"].isEnabled()


def test_a_new_try_takes_the_place_of_what_failed_before(done, tmp_path, monkeypatch, qtbot):
    notice = done.window().pane.notice
    for name in ("one", "two"):
        save_to(done, monkeypatch, tmp_path / name / "dog.svg")
        done.actions_by_name["svg"].trigger()
        qtbot.waitUntil(lambda name=name: f"{name}/dog.svg" in notice.label.toolTip())
    assert "one/dog.svg" not in notice.label.toolTip()
    save_to(done, monkeypatch, tmp_path / "dog.svg")
    done.actions_by_name["svg"].trigger()
    qtbot.waitUntil(lambda: not notice.isVisible())
