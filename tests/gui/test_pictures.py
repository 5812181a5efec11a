"""What is drawn: paths, stencils, placements, icons."""

import numpy as np
import pytest
from fake_session import FakeSession, drawing
from hands import SQUARE, trace
from images import assert_alike, blank, difference, pixels
from PySide6.QtCore import QPoint, QPointF, QRectF, QSize, Qt
from PySide6.QtGui import QColor, QIcon, QPainter
from PySide6.QtWidgets import QCheckBox

from iconstudio.gui.canvas.tools.polygon import PolygonTool
from iconstudio.gui.gallery.large import LargePicture
from iconstudio.gui.gallery.sheet import Sheet
from iconstudio.gui.gallery.sheet_delegate import Look
from iconstudio.gui.pictures.mipmap import Mipmap
from iconstudio.gui.pictures.picture import (
    Display,
    Picture,
    picture_of,
    pictured,
    placed,
    stencil,
)
from iconstudio.gui.pictures.vector import painter_path
from iconstudio.gui.theme import icons, theme
from iconstudio.gui.theme.layout import card
from iconstudio.model import (
    CANVAS,
    ColouredLayer,
    Contour,
    Fill,
    Icon,
    Path,
    Patterned,
    Placement,
    Polygon,
    Sketch,
)
from iconstudio.workflows.grid import GridSettings
from tests.shapes import outline


def test_the_comparer_can_fail():
    first, second = blank(64, 64), blank(64, 64)
    assert_alike(first, second)
    with QPainter(second) as painter:
        painter.fillRect(10, 0, 3, 64, Qt.GlobalColor.black)
    assert difference(first, second) > 0.3
    with pytest.raises(AssertionError, match="differ by"):
        assert_alike(first, second, tolerance=0.3)
    with pytest.raises(AssertionError, match="is not"):
        assert_alike(first, blank(64, 32))


def test_the_comparer_forgives_antialiasing():
    first, second = blank(64, 64), blank(64, 64)
    for image, smooth in ((first, True), (second, False)):
        with QPainter(image) as painter:
            painter.setRenderHint(QPainter.RenderHint.Antialiasing, smooth)
            painter.drawEllipse(QPointF(32, 32), 25, 25)
    assert first != second
    assert difference(first, second) < 0.25


def test_a_path_becomes_the_same_outline():
    square = [(10, 10), (90, 10), (90, 90), (10, 90)]
    bow = Contour((30, 30), (((70, 30),), ((70, 70), (30, 70), (30, 30))))
    path = painter_path(Path((*outline(square).contours, bow)))
    assert path.boundingRect() == QRectF(10, 10, 80, 80)
    assert path.elementCount() == 5 + 5
    assert path.fillRule() == Qt.FillRule.WindingFill
    assert path.contains(QPointF(50, 40)), "filled with the nonzero rule"


def test_a_stencil_has_the_colour_and_the_coverage():
    coverage = np.arange(256, dtype=np.uint8).reshape(16, 16)
    image = stencil(coverage, QColor(255, 128, 0, 10))
    assert image.size().toTuple() == (16, 16)
    shown = pixels(image)
    assert shown[..., 3] == pytest.approx(coverage / 255, abs=1e-6)
    assert shown[..., 0] == pytest.approx(coverage / 255, abs=1 / 255)
    assert shown[..., 1] == pytest.approx(coverage / 255 * 128 / 255, abs=1.5 / 255)


@pytest.mark.parametrize(
    ("placement", "expected"),
    [
        (Placement(), (40, 60)),
        (Placement(dx=5, dy=-7), (45, 53)),
        (Placement(flip=True), (215, 60)),
        (Placement(flip=True, dx=5), (220, 60)),
        (Placement(scale=1.1), (31.2, 53.2)),
        (Placement(scale=0.9, flip=True, dx=-3, dy=2), (203.8, 68.8)),
    ],
)
def test_a_placement_moves_a_dot_as_its_definition_says(placement, expected):
    coverage = np.zeros((CANVAS, CANVAS), np.uint8)
    coverage[58:63, 38:43] = 255
    ink = pixels(placed(stencil(coverage, QColor("black")), placement))[..., 3]
    y, x = np.average(np.indices(ink.shape).reshape(2, -1), axis=1, weights=ink.ravel())
    assert (x, y) == pytest.approx(expected, abs=0.6)


def test_an_icon_is_drawn_as_its_path_at_any_size():
    sketch = Sketch(Polygon(tuple(SQUARE)))
    icon = drawing(sketch, 1, 1)
    picture = Picture(Icon(icon.path, "house"), painter_path(icon.path))
    small, large = blank(64, 64), blank(512, 512)
    for image in (small, large):
        with QPainter(image) as painter:
            picture.paint(painter, QRectF(image.rect()), QColor("black"))
    smooth = Qt.TransformationMode.SmoothTransformation
    ratio = Qt.AspectRatioMode.KeepAspectRatio
    assert_alike(small, large.scaled(64, 64, ratio, smooth))
    assert pixels(large)[256, 256, 0] == 1, "the hole"
    assert pixels(large)[256, 100, 0] == 0, "the ink"


def test_a_preview_is_shown_before_its_colour_code_is_made_and_a_result_with_it():
    sketch = Sketch(Polygon(tuple(SQUARE)), "bicycle")
    shown = []
    for event in pictured(FakeSession().model(sketch, GridSettings(previews=True)), "bicycle"):
        if isinstance(event, Picture):
            assert ("coded" in vars(event)) != event.preview
            shown.append(event)
    assert shown
    assert all("coded" in vars(picture) for picture in shown)


def painted(picture, display):
    image = blank(100, 100)
    with QPainter(image) as painter:
        picture.paint(painter, QRectF(image.rect()), QColor("black"), display)
    return pixels(image)


def test_both_shows_the_icon_with_its_colour_code_small_beside_it():
    sketch = Sketch(Polygon(tuple(SQUARE)), "bicycle")
    events = pictured(FakeSession().model(sketch), "bicycle")
    picture = next(event for event in events if isinstance(event, Picture))
    plain, both, coded = (painted(picture, one) for one in Display)
    colourful = [np.ptp(image[..., :3], axis=-1) > 0.25 for image in (plain, both, coded)]
    assert not colourful[0].any()
    assert colourful[1][66:, 66:].any() and not colourful[1][:66, :66].any()
    assert colourful[2].sum() > 5 * colourful[1].sum()
    black = [image[..., :3].max(axis=-1) < 0.25 for image in (plain, both)]
    assert black[1][:76, :76].sum() == pytest.approx(0.76**2 * black[0].sum(), rel=0.1)


def test_what_has_no_sources_is_shown_as_an_icon_in_any_case():
    path = drawing(Sketch(Polygon(tuple(SQUARE))), 1, 1).path
    picture = Picture(Icon(path, "house"), painter_path(path))
    plain, *others = (painted(picture, one) for one in Display)
    assert all(np.array_equal(plain, one) for one in others)


@pytest.mark.parametrize("name", sorted(icons._shapes()))
@pytest.mark.parametrize("colours", [theme.LIGHT, theme.DARK], ids=["light", "dark"])
def test_every_small_icon_shows_something(name, colours):
    shown = pixels(icons.pixmap(name, colours.color("text")).toImage())
    assert 0.02 < shown[..., 3].mean() < 0.6
    edge = np.concatenate([shown[0], shown[-1], shown[:, 0], shown[:, -1]])
    assert edge[..., 3].max() < 0.3, "nothing is cut off"


def test_an_icon_of_no_size_is_no_picture_and_no_warning():
    assert icons.pixmap("add", theme.LIGHT.color("text"), 0).isNull()


@pytest.mark.parametrize("ratio", [1.0, 1.5, 2.0])
def test_an_icon_has_the_colours_of_the_theme_in_use(monkeypatch, ratio):
    drawn = icons.icon("add", "accent")
    for look in (theme.LIGHT, theme.DARK, theme.LIGHT):
        monkeypatch.setattr(theme, "current", lambda look=look: look)
        picture = drawn.pixmap(QSize(20, 20), ratio)
        assert picture.width() == 20 * ratio
        assert picture.devicePixelRatio() == ratio
        shown = pixels(picture.toImage())
        ink = shown[shown[..., 3] > 0.95][:, :3].mean(axis=0)
        expected = look.color("accent")
        colour = [expected.redF(), expected.greenF(), expected.blueF()]
        assert ink == pytest.approx(colour, abs=0.03)


def test_a_disabled_icon_is_faint(qtbot):
    drawn = icons.icon("add")
    normal, disabled = (
        pixels(drawn.pixmap(QSize(20, 20), 1.0, mode).toImage())[..., 3].mean()
        for mode in (QIcon.Mode.Normal, QIcon.Mode.Disabled)
    )
    assert disabled == pytest.approx(0.35 * normal, abs=0.01)


def contrast(one, other):
    """The contrast of two colours, from 1 to 21 (WCAG 2)."""

    def luminance(color):
        channels = [
            c / 12.92 if c <= 0.03928 else ((c + 0.055) / 1.055) ** 2.4 for c in color.getRgbF()[:3]
        ]
        return float(np.dot(channels, (0.2126, 0.7152, 0.0722)))

    dark, light = sorted((luminance(one), luminance(other)))
    return (light + 0.05) / (dark + 0.05)


@pytest.mark.parametrize("colours", [theme.LIGHT, theme.DARK], ids=["light", "dark"])
def test_words_can_be_read_in_both_themes(colours):
    for ink, ground in [
        ("text", "surface"),
        ("text", "window"),
        ("muted", "surface"),
        ("muted", "window"),
        ("on_accent", "accent"),
        ("accent", "surface"),
        ("danger", "surface"),
        ("text", "danger_soft"),
    ]:
        assert contrast(colours.color(ink), colours.color(ground)) >= 4.5, (ink, ground)


@pytest.mark.parametrize("colours", [theme.LIGHT, theme.DARK], ids=["light", "dark"])
def test_the_border_of_a_check_box_can_be_seen_in_both_themes(qtbot, colours):
    off, on = QCheckBox("Off"), QCheckBox("On", checked=True)
    frame = card(off, on)
    qtbot.addWidget(frame)
    frame.setStyleSheet(theme._style_sheet(colours))
    shown = frame.grab().toImage()
    for box in (off, on):
        at = box.mapTo(frame, QPoint(0, box.height() // 2))
        border, ground = (shown.pixelColor(at + QPoint(x, 0)) for x in (0, -4))
        assert ground.name() == colours.surface
        assert contrast(border, ground) >= 3, box.text()


def test_the_outline_is_drawn_where_it_was_traced(sketching):
    before = sketching.view.grab().toImage()
    trace(sketching)
    sketching.view.set_tool(PolygonTool(sketching.outline))
    after = sketching.view.grab().toImage()
    camera = sketching.view.camera
    inside = camera.to_view((250, 250)).toPoint()
    outside = camera.to_view((460, 250)).toPoint()
    assert before.pixelColor(inside) != after.pixelColor(inside)
    assert before.pixelColor(outside) == after.pixelColor(outside)


def test_a_picture_drawn_small_is_drawn_from_a_small_copy():
    image = blank(1000, 600)
    mipmap = Mipmap.of(image, 100)
    assert [level.size().toTuple() for level in mipmap.levels] == [
        (1000, 600),
        (500, 300),
        (250, 150),
    ]
    assert [mipmap.at(width).width() for width in (9999, 1000, 501, 500, 1)] == [
        1000,
        1000,
        1000,
        500,
        250,
    ]


RED, BLUE = "#ff0000", "#0000ff"


def patterned(*fills, size=(200, 100)):
    """A pattern of rectangles, each with its colour."""
    shapes = tuple(
        Fill(outline([(x, y), (x + w, y), (x + w, y + h), (x, y + h)]), colour)
        for (x, y, w, h), colour in fills
    )
    width, height = size
    return Patterned(
        shapes[0].path, "p", layers=(ColouredLayer("layer-1", shapes),), ground="",
        width=width, height=height, tile=True, torn=0.0,
    )  # fmt: skip


def test_a_pattern_is_painted_in_its_colours_in_the_middle_of_a_square():
    icon = patterned(((0, -40, 100, 300), RED), ((100, 0, 50, 100), ""), ((110, 0, 40, 50), BLUE))
    image = blank(80, 80)
    with QPainter(image) as painter:
        picture_of(icon).paint(painter, QRectF(0, 0, 80, 80), QColor("lime"))
    shown = {
        name: image.pixelColor(x, y).name()
        for name, x, y in (
            ("above", 10, 18), ("below", 10, 61), ("left", 10, 22), ("bottom", 10, 58),
            ("ink", 42, 30), ("over it", 50, 30), ("under it", 50, 50), ("nothing", 70, 40),
        )
    }  # fmt: skip
    assert shown == {
        "above": "#ffffff", "below": "#ffffff", "left": RED, "bottom": RED,
        "ink": "#00ff00", "over it": BLUE, "under it": "#00ff00", "nothing": "#ffffff",
    }  # fmt: skip


def test_the_image_of_a_pattern_is_as_wide_for_its_height_as_the_pattern():
    image = picture_of(patterned(((0, 0, 100, 100), RED))).image(80)
    assert image.size().toTuple() == (80, 40)
    assert pixels(image)[20, 10].tolist() == [1, 0, 0, 1]
    assert pixels(image)[20, 60].tolist() == [0, 0, 0, 0]
    assert picture_of(Icon(outline([(0, 0), (99, 0), (0, 99)]), "i")).image(64).size() == QSize(
        64, 64
    )


def test_colours_stay_in_dark_sheets_and_details(qtbot, monkeypatch):
    monkeypatch.setattr(theme, "current", lambda: theme.DARK)
    picture = picture_of(patterned(((0, 0, 200, 100), RED), ((0, 0, 100, 100), "")))
    sheet = Sheet(Look(80), lambda picture, marked: ("p", "p"), "Patterns")
    large = LargePicture()
    for widget in (sheet, large):
        qtbot.addWidget(widget)
        widget.resize(160, 160)
    sheet.show_entries([picture])
    large.show_picture(picture)
    for widget in (sheet, large):
        widget.show()
        shown = widget.grab().toImage()
        colours = {shown.pixelColor(x, y).name() for x in range(0, 160, 4) for y in (40, 80)}
        assert RED in colours
        assert theme.DARK.text in colours
