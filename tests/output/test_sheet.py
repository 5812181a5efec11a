"""Contact sheets: each thing is where it belongs."""

from dataclasses import replace

import numpy as np
import pytest
from PIL import Image

from iconstudio.algorithms.raster import placed_ink
from iconstudio.model import Edit, IconstudioError, Polygon, Sketch
from iconstudio.output import figure as pages
from iconstudio.output import request
from iconstudio.output.colours import palette, source_colours
from iconstudio.output.figure import PAPER, Figure, font, shortened
from iconstudio.output.request import edit_request, sketch_request
from iconstudio.output.sheet import Row, Subject, gallery_sheet, grid_sheet, search_sheet
from iconstudio.workflows.editing.placing import place_edit
from tests.output.made import BLOCK, DISC, RING, SOURCES, SQUARE, made, quarters

LAMBDAS = (0.05, 0.2, 0.75)
REQUEST = sketch_request(Sketch(SQUARE, "dog"))


@pytest.fixture(scope="module")
def rows():
    whole = np.zeros((256, 256), np.uint8)
    remixes = made(quarters(), 0.05), made(whole, 0.75)
    return [Row("light", 40, remixes), Row("dark", 2, (), "The collection has too few icons.")]


@pytest.fixture()
def drawn(monkeypatch):
    """What is drawn on pages, and where: (kind, x, y, what)."""
    calls = []

    def watched(kind, what):
        original = getattr(Figure, kind)

        def method(self, x, y, *args, **options):
            calls.append((kind, x, y, args[what]))
            return original(self, x, y, *args, **options)

        monkeypatch.setattr(pages.Figure, kind, method)

    for kind, what in (("text", 0), ("paragraph", 0), ("stencil", 1), ("image", 0), ("frame", 2)):
        watched(kind, what)
    return calls


def texts(drawn):
    return [what for kind, *_, what in drawn if kind in ("text", "paragraph")]


def pixels(picture):
    return np.asarray(picture).astype(int)


def test_every_cell_lies_in_its_column_above_its_colour_code(rows, drawn):
    sheet = grid_sheet(REQUEST, LAMBDAS, rows)
    coverages = [icon.drawing.coverage for icon in rows[0].remixes]
    icons = [(x, y) for kind, x, y, what in drawn
             if kind == "stencil" and any(what is one for one in coverages)]  # fmt: skip
    codes = [(x, y) for kind, x, y, _ in drawn if kind == "image"]
    (first, second), step = icons, (icons[1][0] - icons[0][0]) / 2
    assert first[1] == second[1]  # one row
    heads = [x for kind, x, _, what in drawn if kind == "text" and what.startswith("λ")]
    assert np.diff(heads) == pytest.approx([step, step])  # the middle column stays empty
    for icon, code in zip(icons, codes, strict=True):
        assert code[0] == icon[0] and code[1] - icon[1] >= 168
        assert code[1] + 168 <= sheet.height and code[0] + 168 <= sheet.width


def test_the_cells_show_ink_and_colours(rows, drawn):
    sheet = pixels(grid_sheet(REQUEST, LAMBDAS, rows))
    (x, y) = next((round(x), round(y)) for kind, x, y, _ in drawn if kind == "image")
    code = sheet[y : y + 168, x : x + 168]
    composites = [icon.composite for icon in rows[0].remixes]
    colours = source_colours(composites[0], palette(composites)).astype(int)
    for label, (cy, cx) in {0: (84, 36), 1: (36, 120), 2: (120, 120)}.items():
        assert np.abs(code[cy, cx] - colours[label]).max() < 12
    icon = sheet[y - 180 : y - 12, x : x + 168]
    assert icon[84, 36].max() < 60  # ink
    assert (icon[2, 2] == PAPER).all()


def test_words_on_the_sheet(rows, drawn):
    grid_sheet(REQUEST, LAMBDAS, rows)
    said = texts(drawn)
    for words in ("dog", "closer to the sketch", "smoother", "Light", "Dark", "λ 0.05", "λ 0.75",
                  "40 icons", "2 icons", "The collection has too few icons."):  # fmt: skip
        assert words in said
    assert {"ring", "block"} <= set(said) and "disc" not in said  # the sources with ink
    shares = [int(words[:-1]) for words in said if words.endswith("%")]
    assert shares == sorted(shares, reverse=True)
    assert sum(shares) == pytest.approx(100, abs=2)


def test_sources_lie_in_place_with_their_part_in_colour(rows, drawn):
    sheet = pixels(grid_sheet(REQUEST, LAMBDAS, rows))
    thumbs = [(round(x), round(y), what) for kind, x, y, what in drawn
              if kind == "stencil" and what.shape == (256, 256)][1:]  # fmt: skip
    composites = [icon.composite for icon in rows[0].remixes]
    colours = palette(composites)
    shares = np.mean([composite.shares for composite in composites], axis=0)
    order = np.argsort(-shares)[:3]
    for label, (x, y, whole), (again_x, again_y, part) in zip(
        order, thumbs[::2], thumbs[1::2], strict=True
    ):
        source = SOURCES[label]
        ink, _ = placed_ink(source.exemplar, source.placement)
        owned = np.any([composite.labels == label for composite in composites], axis=0)
        assert (x, y) == (again_x, again_y)
        assert np.array_equal(whole > 0, ink)
        assert np.array_equal(part > 0, ink & owned)
        thumb = sheet[y : y + 104, x : x + 104].reshape(-1, 3).tolist()
        assert list(colours[source.exemplar.id, source.placement]) in thumb


def test_the_sketch_is_on_the_sheet(rows):
    sheet = pixels(grid_sheet(REQUEST, LAMBDAS, rows))
    corner = sheet[24:174, 32:182]
    share = (np.abs(corner - pages.MUTED).max(axis=-1) < 8).mean()
    assert share == pytest.approx((224 / 256) ** 2, abs=0.03)


def test_the_recommended_result_is_framed_with_its_colour_code(rows, drawn):
    light = replace(rows[0], recommended=0.75)
    sheet = pixels(grid_sheet(REQUEST, LAMBDAS, [light, rows[1]]))
    assert "recommended" in texts(drawn)
    assert len([1 for kind, *_ in drawn if kind == "frame"]) == 1 + 1  # and the legend
    x, y = [(x, y) for kind, x, y, _ in drawn if kind == "image"][1]
    middle, left = sheet[:, x + 84], sheet[y + 84]
    framed = (middle == pages.ACCENT).all(axis=-1).nonzero()[0]
    assert framed.min() < y - 168 and framed.max() > y + 168
    assert (left[x - 6 : x] == pages.ACCENT).all(axis=-1).any()


def test_without_a_recommendation_nothing_is_framed(rows, drawn):
    grid_sheet(REQUEST, LAMBDAS, rows)
    assert not [1 for kind, *_ in drawn if kind == "frame"]
    assert "recommended" not in texts(drawn)


def test_an_edit_is_shown_as_red_and_green_on_its_icon(rows):
    edit = Edit(
        BLOCK.pictogram,
        "dog",
        remove=(Polygon.of([(48, 48), (128, 48), (128, 208), (48, 208)]),),
        add=(Polygon.of([(208, 100), (246, 100), (246, 150), (208, 150)]),),
    )
    sheet = pixels(grid_sheet(edit_request(place_edit(edit, BLOCK)), LAMBDAS, rows))

    def at(x, y):
        return tuple(sheet[24 + y * 150 // 256, 32 + x * 150 // 256])

    assert at(88, 128) == request.REMOVED
    assert at(168, 128) == pages.INK
    assert at(230, 128)[1] > max(at(230, 128)[0], at(230, 128)[2]) + 20  # green
    assert at(20, 128) == PAPER


def test_what_is_added_beyond_the_canvas_is_still_on_the_sheet():
    beyond = Polygon.of([(208, 100), (400, 100), (400, 150), (208, 150)])
    edit = Edit(BLOCK.pictogram, "dog", add=(beyond,))
    change = place_edit(edit, BLOCK)
    asked = edit_request(change)
    (_, (added, _), *_) = asked.layers
    assert np.array_equal(added, asked.change.mask == 0)
    assert not added[:, -1].any()


def test_a_sheet_of_one_column_and_of_none(rows):
    one = grid_sheet(REQUEST, (0.1,), [Row("light", 40, rows[0].remixes[:1])])
    none = grid_sheet(REQUEST, (0.1,), [])
    assert one.height > none.height > 0 and one.width == none.width


def test_search_sheet(tmp_path, drawn):
    exemplars = [RING, DISC, BLOCK] * 5
    search_sheet(exemplars, "dog", tmp_path / "dog.png")
    with Image.open(tmp_path / "dog.png") as sheet:
        width, height = sheet.size
    places = [(x, y) for kind, x, y, _ in drawn if kind == "stencil"]
    assert len(set(places)) == 15
    assert len({y for _, y in places}) == 2  # ten across
    assert all(0 <= x <= width - 120 and 0 <= y <= height - 120 for x, y in places)
    said = texts(drawn)
    assert said.count("ring") == said.count("disc") == said.count("block") == 5
    assert said.count("test:") == 15
    assert "dog" in said and "15 icons" in said


def test_a_search_sheet_that_cannot_be_written(tmp_path):
    with pytest.raises(IconstudioError, match="cannot be written"):
        search_sheet([RING], "dog", tmp_path / "no" / "dog.png")


def test_the_gallery_frames_failures_red_and_single_icons_yellow(rows, drawn):
    remixed, whole = rows[0].remixes
    subjects = [
        Subject("Dog", SQUARE, remixed),
        Subject("Cat", SQUARE, whole, "as drawn"),
        Subject("Cow", SQUARE, remixed, "no tail", failed=True),
        Subject("Yak", SQUARE, None),
    ]
    sheet = gallery_sheet(subjects, across=2)
    frames = [(x, y, what) for kind, x, y, what in drawn if kind == "frame"]
    assert len(frames) == 4 + 3  # and the legend
    assert len({x for x, *_ in frames[:4]}) == len({y for _, y, _ in frames[:4]}) == 2
    assert len([1 for kind, *_ in drawn if kind == "image"]) == 3
    assert {"Dog", "Cat", "as drawn", "Cow", "no tail", "Yak", "failed"} <= set(texts(drawn))
    assert sheet.width > 900


def test_frames_have_the_colour_of_their_verdict(rows, monkeypatch):
    colours = []
    original = Figure.frame
    monkeypatch.setattr(
        Figure, "frame", lambda self, *a: (colours.append(a[-1]), original(self, *a))[1]
    )
    remixed, whole = rows[0].remixes
    subjects = [
        Subject("a", SQUARE, remixed),
        Subject("b", SQUARE, whole),
        Subject("c", SQUARE, whole, failed=True),
        Subject("d", SQUARE, None),
    ]
    gallery_sheet(subjects)
    blue, yellow, red = colours[4:]
    assert colours[:4] == [blue, yellow, red, red]
    assert len({blue, yellow, red}) == 3


def test_long_text_ends_in_an_ellipsis():
    face = font(20)
    assert shortened("dog", face, 500) == "dog"
    short = shortened("a very long identifier", face, 100)
    assert short.endswith("…") and face.getlength(short) <= 100
    assert "a very long identifier".startswith(short[:-1])


def test_paragraphs_break_at_words():
    figure = Figure(300, 200)
    figure.paragraph(10, 10, "several words that need more than one line", 20, 200, (0, 0, 0))
    inked = (pixels(figure.picture).min(axis=-1) < 128).nonzero()
    assert inked[1].max() <= 215
    assert inked[0].max() > 60


@pytest.mark.parametrize("bold", [False, True])
def test_the_font_has_latin_letters(bold):
    face = font(24, bold)
    missing = face.getmask("\uffff").getbbox(), bytes(face.getmask("\uffff"))
    for letter in "aZ0éßøłžλ…“”·":
        assert (face.getmask(letter).getbbox(), bytes(face.getmask(letter))) != missing, letter
