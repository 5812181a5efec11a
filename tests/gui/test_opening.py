"""Photos and sketches: opened, dropped, pasted; good and bad ones."""

import json

import numpy as np
import pytest
from hands import SQUARE, click, drop, trace, type_keyword
from images import assert_alike
from PySide6.QtCore import QMimeData, Qt, QUrl
from PySide6.QtGui import QImage
from PySide6.QtWidgets import QApplication, QFileDialog

from iconstudio.gui.pictures.mipmap import Mipmap
from iconstudio.gui.pictures.photo import image_of, mipmap_of, qt_image
from iconstudio.images.photo import photo_of
from iconstudio.images.reading import Image
from iconstudio.inputs.examples import examples
from iconstudio.model import IconstudioError
from iconstudio.workflows.modelling.file import example, read_sketch


@pytest.fixture
def picture():
    image = QImage(300, 200, QImage.Format.Format_RGB32)
    image.fill(Qt.GlobalColor.red)
    return image


@pytest.fixture
def photo_file(picture, tmp_path):
    path = tmp_path / "bike.png"
    assert picture.save(str(path))
    return path


def has_photo(sketching):
    return lambda: sketching.document.page.photo is not None


def test_a_photo_is_opened_from_the_menu(sketching, qtbot, photo_file, monkeypatch):
    monkeypatch.setattr(QFileDialog, "getOpenFileName", lambda *_: (str(photo_file), ""))
    sketching.actions_by_name["photo"].trigger()
    qtbot.waitUntil(has_photo(sketching))
    photo = sketching.document.page.photo
    assert (photo.width, photo.height) == (300, 200)
    assert sketching.dim.slider.isVisible()
    assert "300 × 200" in sketching.window().pane.status.label.text()
    sketching.document.undo_stack.undo()
    assert sketching.document.page.empty


def test_a_dropped_photo_is_opened(sketching, qtbot, photo_file):
    data = QMimeData()
    data.setUrls([QUrl.fromLocalFile(str(photo_file))])
    drop(sketching.view, data)
    qtbot.waitUntil(has_photo(sketching))


def test_a_photo_on_the_clipboard_is_pasted(sketching, qtbot, picture):
    QApplication.clipboard().setImage(picture)
    sketching.actions_by_name["paste"].trigger()
    qtbot.waitUntil(has_photo(sketching))
    assert sketching.document.page.photo.path == ""


def test_pasting_words_says_what_to_do(sketching):
    QApplication.clipboard().setText("dog")
    sketching.actions_by_name["paste"].trigger()
    assert "no photo to paste" in sketching.window().pane.notice.label.text()


def test_a_file_that_is_no_photo_is_told_and_nothing_is_lost(sketching, qtbot, tmp_path):
    trace(sketching)
    before = sketching.document.page
    path = tmp_path / "letter.png"
    path.write_text("Dear dog")
    sketching.opener.open_file(str(path))
    qtbot.waitUntil(sketching.window().pane.notice.isVisible)
    assert "“letter.png” cannot be opened" in sketching.window().pane.notice.label.text()
    assert sketching.document.page == before


@pytest.mark.parametrize("name", ["photo.jpg", "drawing.svg"])
def test_an_svg_opened_as_a_photo_reaches_no_reader(sketching, qtbot, tmp_path, name):
    path = tmp_path / name
    path.write_text('<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 9 9"/>')
    sketching.opener.open_file(str(path))
    qtbot.waitUntil(sketching.window().pane.notice.isVisible)
    assert "cannot be opened" in sketching.window().pane.notice.label.text()
    assert sketching.document.page.empty


def test_a_photo_keeps_its_pixels_and_its_own_size():
    random = np.random.default_rng(0)
    for channels in (3, 4):
        pixels = random.integers(0, 256, (7, 5, channels), np.uint8)
        photo = photo_of(Image(pixels, 50, 70), "a.png")
        assert_alike(mipmap_of(photo).levels[0], qt_image(Image(pixels, 5, 7)), 0.01)
        assert (photo.width, photo.height, photo.path, photo.scaled_down) == (50, 70, "a.png", True)
        assert np.array_equal(image_of(qt_image(Image(pixels, 5, 7))).pixels, pixels)


def test_the_copies_of_a_photo_are_as_qt_would_make_them():
    y, x = np.mgrid[:1100, :900]
    alpha = 255 - x % 200
    pixels = np.stack([x % 256, y % 256, (x + y) % 256, alpha], axis=-1).astype(np.uint8)
    image = Image(pixels, 900, 1100)
    levels, expected = mipmap_of(photo_of(image)).levels, Mipmap.of(qt_image(image), 256).levels
    assert [one.size() for one in levels] == [one.size() for one in expected]
    for one, other in zip(levels, expected, strict=True):
        assert one.format() == other.format()
        assert_alike(one, other, 0.03)


def test_an_image_of_another_program_is_read_by_its_bytes_not_by_qt(sketching, qtbot, photo_file):
    data = QMimeData()
    data.setData("image/png", photo_file.read_bytes())
    data.setData("image/svg+xml", b"<svg xmlns='http://www.w3.org/2000/svg'/>")
    data.imageData = data.hasImage = lambda: pytest.fail("Qt was asked to decode it")
    sketching.opener.open_mime(data)
    qtbot.waitUntil(has_photo(sketching))
    assert sketching.document.page.photo.width == 300


def test_an_empty_image_is_no_photo():
    with pytest.raises(IconstudioError, match="holds no image"):
        image_of(QImage())


def test_a_photo_that_is_cut_short_is_shown_with_a_remark(sketching, qtbot, tmp_path):
    noise = QImage(200, 200, QImage.Format.Format_RGB32)
    for x in range(200):
        for y in range(200):
            noise.setPixel(x, y, (x * 7919 + y * 104729) * 2654435761 & 0xFFFFFF)
    path = tmp_path / "half.png"
    assert noise.save(str(path))
    path.write_bytes(path.read_bytes()[: path.stat().st_size * 2 // 3])
    sketching.opener.open_file(str(path))
    qtbot.waitUntil(has_photo(sketching))
    assert "cut short" in sketching.window().pane.status.label.text()


def test_the_dim_slider_fades_the_photo(sketching, qtbot, photo_file):
    sketching.opener.open_file(str(photo_file))
    qtbot.waitUntil(has_photo(sketching))
    middle = sketching.view.rect().center()
    saturations = []
    for percent in (0, 50, 100):
        sketching.dim.slider.setValue(percent)
        saturations.append(sketching.view.grab().toImage().pixelColor(middle).hsvSaturation())
    assert saturations[0] > 250 > saturations[1] > 60 > saturations[2]


def test_every_example_of_the_menu_opens(sketching, qtbot):
    shipped = [read_sketch(one.path) for one in examples("")]
    menu = sketching.actions_by_name["examples"].menu().actions()
    assert [action.text() for action in menu] == [one.title for one in shipped]
    assert len(menu) >= 5
    for action, sketch in zip(menu, shipped, strict=True):
        action.trigger()
        qtbot.waitUntil(lambda sketch=sketch: sketching.document.page.sketch == sketch.sketch)
        assert sketching.document.page.closed
        assert (sketching.document.page.photo is None) == (sketch.photo is None)
        assert sketching.keyword_panel.field.text() == sketch.sketch.keyword


def test_another_sketch_can_be_undone(sketching, qtbot):
    trace(sketching)
    type_keyword(sketching, "dog")
    before = sketching.document.page
    sketching.open_sketch(example("coffee"))
    qtbot.waitUntil(lambda: sketching.document.page != before)
    sketching.actions_by_name["undo"].trigger()
    assert sketching.document.page == before
    sketching.actions_by_name["new"].trigger()
    assert sketching.document.page.empty
    sketching.actions_by_name["undo"].trigger()
    assert sketching.document.page == before


def test_a_sketch_without_its_photo_is_opened_all_the_same(sketching, qtbot, tmp_path):
    path = tmp_path / "dog.json"
    path.write_text(json.dumps({"keyword": "dog", "polygon": SQUARE, "photo": "gone.jpg"}))
    data = QMimeData()
    data.setUrls([QUrl.fromLocalFile(str(path))])
    sketching.opener.open_mime(data)
    qtbot.waitUntil(lambda: sketching.document.page.closed)
    assert sketching.document.page.photo is None
    assert "without its photo" in sketching.window().pane.notice.label.text()


@pytest.mark.parametrize("text", ["", "{", "[]", '{"polygon": 3}', '{"polygon": [[1, "a"]]}'])
def test_a_broken_sketch_is_told_and_nothing_is_lost(sketching, qtbot, tmp_path, text):
    click(sketching, SQUARE[0])
    before = sketching.document.page
    path = tmp_path / "broken.json"
    path.write_text(text)
    sketching.opener.open_work(str(path))
    qtbot.waitUntil(sketching.window().pane.notice.isVisible)
    assert sketching.window().pane.notice.label.text()
    assert sketching.document.page == before
