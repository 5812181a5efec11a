"""Photos and sketches: opened, dropped, pasted; good and bad ones."""

import json

import pytest
from hands import SQUARE, click, trace, type_keyword
from PySide6.QtCore import QMimeData, QPointF, Qt, QUrl
from PySide6.QtGui import QDropEvent, QImage
from PySide6.QtWidgets import QApplication, QFileDialog

from iconstudio.gui.photo import LONGEST, photo_from_image, read_photo
from iconstudio.inputs.examples import examples
from iconstudio.inputs.sketch import example, read_sketch
from iconstudio.model import IconstudioError


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
    assert "300 × 200" in sketching.window().desk.strip.label.text()
    sketching.document.undo_stack.undo()
    assert sketching.document.page.empty


def test_a_dropped_photo_is_opened(sketching, qtbot, photo_file):
    data = QMimeData()
    data.setUrls([QUrl.fromLocalFile(str(photo_file))])
    drop = QDropEvent(
        QPointF(50, 50),
        Qt.DropAction.CopyAction,
        data,
        Qt.MouseButton.LeftButton,
        Qt.KeyboardModifier.NoModifier,
    )
    sketching.view.dropEvent(drop)
    qtbot.waitUntil(has_photo(sketching))


def test_a_photo_on_the_clipboard_is_pasted(sketching, qtbot, picture):
    QApplication.clipboard().setImage(picture)
    sketching.actions_by_name["paste"].trigger()
    qtbot.waitUntil(has_photo(sketching))
    assert sketching.document.page.photo.path == ""


def test_pasting_words_says_what_to_do(sketching):
    QApplication.clipboard().setText("dog")
    sketching.actions_by_name["paste"].trigger()
    assert "no photo to paste" in sketching.window().desk.notice.label.text()


def test_a_file_that_is_no_photo_is_told_and_nothing_is_lost(sketching, qtbot, tmp_path):
    trace(sketching)
    before = sketching.document.page
    path = tmp_path / "letter.png"
    path.write_text("Dear dog")
    sketching.opener.open_file(str(path))
    qtbot.waitUntil(sketching.window().desk.notice.isVisible)
    assert "“letter.png” is not a photo" in sketching.window().desk.notice.label.text()
    assert sketching.document.page == before


def test_a_file_that_is_cut_short_or_gone_is_told(tmp_path, photo_file):
    half = tmp_path / "half.png"
    half.write_bytes(photo_file.read_bytes()[:40])
    with pytest.raises(IconstudioError, match=r"half\.png"):
        read_photo(str(half))
    with pytest.raises(IconstudioError, match="no file"):
        read_photo(str(tmp_path / "gone.png"))


def test_a_gigantic_photo_is_kept_smaller_with_its_own_coordinates(tmp_path):
    path = tmp_path / "wide.png"
    image = QImage(20000, 1000, QImage.Format.Format_Grayscale8)
    image.fill(128)
    assert image.save(str(path))
    photo = read_photo(str(path))
    assert (photo.width, photo.height) == (20000, 1000)
    assert photo.scaled_down
    assert photo.picture.width == LONGEST


def test_a_photo_beyond_the_memory_is_told(tmp_path):
    """A bomb: a header that promises 60,000 by 60,000 pixels."""
    path = tmp_path / "bomb.bmp"
    header = b"BM" + (0).to_bytes(8, "little") + (54).to_bytes(4, "little")
    header += (40).to_bytes(4, "little") + (60000).to_bytes(4, "little") * 2
    header += (1).to_bytes(2, "little") + (24).to_bytes(2, "little") + bytes(24)
    path.write_bytes(header)
    with pytest.raises(IconstudioError, match=r"too large|not a photo"):
        read_photo(str(path))


def test_a_turned_photo_is_turned_back(tmp_path):
    from PIL import Image

    path = tmp_path / "turned.jpg"
    exif = Image.Exif()
    exif[0x0112] = 6
    Image.new("RGB", (60, 40)).save(path, exif=exif)
    photo = read_photo(str(path))
    assert (photo.width, photo.height) == (40, 60)
    assert photo.picture.levels[0].size().toTuple() == (40, 60)


def test_an_empty_image_is_no_photo():
    with pytest.raises(IconstudioError, match="holds no image"):
        photo_from_image(QImage())


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
    sketching.opener.open_example(example("coffee"))
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
    assert "without its photo" in sketching.window().desk.notice.label.text()


@pytest.mark.parametrize("text", ["", "{", "[]", '{"polygon": 3}', '{"polygon": [[1, "a"]]}'])
def test_a_broken_sketch_is_told_and_nothing_is_lost(sketching, qtbot, tmp_path, text):
    click(sketching, SQUARE[0])
    before = sketching.document.page
    path = tmp_path / "broken.json"
    path.write_text(text)
    sketching.opener.open_work(str(path))
    qtbot.waitUntil(sketching.window().desk.notice.isVisible)
    assert sketching.window().desk.notice.label.text()
    assert sketching.document.page == before
