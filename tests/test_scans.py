"""Scans of real icons become icons again: by files, in works that name them, without a window."""

import io
import json
import re
from concurrent.futures import Future

import numpy as np
import pytest
from PIL import Image, ImageDraw
from skimage.data import chelsea

from iconstudio.algorithms.iconification.style import has_pale_areas
from iconstudio.images.reading import awaited, decode_image
from iconstudio.model import IconstudioError
from iconstudio.svg.resvg import render_coverage
from iconstudio.workflows.editing.file import read_edit
from tests import scans

pytestmark = pytest.mark.thorough(but=1)

WORDS = ("dog", "house", "lamp", "camera", "bicycle", "tree", "key", "cup", "phone", "cloud")
EACH = 3


@pytest.fixture(scope="module")
def icons(session):
    """Real icons of many styles, of one tone, and not of lines thinner than a scan can tell."""
    found = []
    for word in WORDS:
        pictograms = session.search(word)
        drawn = (session.exemplar(one) for one in pictograms[:: len(pictograms) // 9])
        usable = [
            one for one in drawn if not has_pale_areas(one.coverage) and one.ink.mean() > 0.08
        ]
        found += usable[:EACH]
    assert len(found) == EACH * len(WORDS)
    return found


@pytest.mark.thorough
def test_scans_of_real_icons_become_these_icons(session, icons, tmp_path):
    off = {}
    for number, icon in enumerate(icons):
        kind = scans.KINDS[number % len(scans.KINDS)]
        coverage = render_coverage(icon.pictogram.svg, icon.frame, scans.SIDE) / 255
        path = tmp_path / f"scan-{number}.png"
        Image.fromarray(scans.scan(coverage, kind, number)).save(path, compress_level=1)
        again = session.exemplar(session.icon(str(path)))
        found = scans.iou(again.ink, icon.ink)
        if found < 0.9:
            off[icon.id, kind.__name__] = found
    assert not off


def test_a_scan_is_an_icon_of_ones_own(session, tmp_path):
    path = tmp_path / "my lamp.jpeg"
    pixels = np.full((300, 300, 3), 250, np.uint8)
    pixels[100:200, 50:250] = 20
    Image.fromarray(pixels).save(path)
    icon = session.icon(str(path))
    assert icon.id.startswith("own:my lamp-")
    assert icon.credit.title == "my lamp.jpeg" and icon.credit.author == "an unnamed author"
    assert icon.svg.count("<path") == 1 and "currentColor" in icon.svg and "viewBox" in icon.svg
    ink = session.exemplar(icon).ink
    assert ink[128, 20:236].all() and not ink[60].any()
    assert session.icon(str(path)) == icon


def test_a_scan_is_known_by_its_content_whatever_its_name(session, tmp_path):
    path = tmp_path / "scan.svg"
    pixels = np.full((60, 60, 3), 255, np.uint8)
    pixels[20:40, 10:50] = 0
    Image.fromarray(pixels).save(path, "PNG")
    assert session.exemplar(session.icon(str(path))).ink.any()


def test_a_small_drawing_on_a_scan_is_restyled_as_large_as_the_canvas(session, tmp_path):
    pixels = np.full((300, 400, 3), 255, np.uint8)
    pixels[30:80, 20:120] = 0
    Image.fromarray(pixels).save(tmp_path / "scan.png")
    (line,) = session.lines(session.icon(str(tmp_path / "scan.png")))
    x, y = np.array(line.points).T
    found = x.min(), y.min(), x.max(), y.max()
    assert found == pytest.approx((16, 72, 240, 184), abs=2)


def test_a_scan_can_be_named_in_a_work(session, tmp_path):
    pixels = np.full((60, 60, 3), 255, np.uint8)
    pixels[20:40, 10:50] = 0
    Image.fromarray(pixels).save(tmp_path / "scan.webp")
    work = tmp_path / "edit.json"
    area = [[[100, 100], [150, 100], [150, 150]]]
    work.write_text(json.dumps({"icon": "scan.webp", "keyword": "cup", "remove": area, "add": []}))
    assert read_edit(work).resolved(session.icon).icon.id.startswith("own:scan-")


def test_a_photo_is_taken_with_a_remark(session, tmp_path):
    path = tmp_path / "cat.png"
    Image.fromarray(chelsea()[::2, ::2]).save(path)
    assert "photo rather than a drawing" in session.icon(str(path)).remarks[0]


def test_of_a_faint_drawing_it_is_told_what_to_do(session, tmp_path):
    path = tmp_path / "pencil.png"
    pixels = np.full((300, 300, 3), 200, np.uint8)
    pixels[100:200, 150:153] = 185
    Image.fromarray(pixels).save(path)
    with pytest.raises(IconstudioError, match=r"darker pen.*contrast.*threshold"):
        session.icon(str(path))


@pytest.mark.parametrize(("pencil", "faint"), [(160, True), (60, False)])
def test_of_a_faint_drawing_that_is_read_it_is_told_that_parts_may_be_missing(
    session, tmp_path, pencil, faint
):
    path = tmp_path / "pencil.png"
    pixels = np.full((300, 300, 3), 200, np.uint8)
    pixels[100:200, 120:180] = pencil
    Image.fromarray(pixels).save(path)
    remarks = session.icon(str(path)).remarks
    assert any("is faint" in remark for remark in remarks) == faint


@pytest.mark.parametrize(("whiskers", "kept", "told"), [(80, True, False), (185, False, True)])
def test_lines_that_are_fainter_than_others_are_kept_or_told(
    session, tmp_path, whiskers, kept, told
):
    pixels = np.random.default_rng(0).normal(225, 5, (600, 600))
    y, x = np.mgrid[:600, :600]
    pixels[(abs(y - 300) < 3) & (abs(x - 300) < 290)] = whiskers
    pixels[abs(np.hypot(y - 300, x - 300) - 170) < 5] = 40
    pixels *= 0.6 + 0.4 * x / 600
    path = tmp_path / "cat.png"
    Image.fromarray(np.clip(pixels, 0, 255).astype(np.uint8)).save(path)
    icon = session.icon(str(path))
    height, width = (np.ptp(np.flatnonzero(session.exemplar(icon).ink.any(a))) for a in (1, 0))
    assert (width > 1.5 * height) == kept
    assert any("fainter" in remark for remark in icon.remarks) == told


def test_of_an_animation_that_begins_with_nothing_it_is_told_what_was_read(session, tmp_path):
    path = tmp_path / "blank first.gif"
    blank, black = (Image.new("L", (60, 60), grey) for grey in (255, 0))
    blank.save(path, save_all=True, append_images=[black])
    with pytest.raises(IconstudioError, match=r"the first of 2 pictures.*No drawing"):
        session.icon(str(path))


@pytest.mark.parametrize(("data", "said"), [(b"hello", "no picture"), (b"", "empty")])
def test_what_is_only_called_an_image_is_no_svg(session, tmp_path, data, said):
    path = tmp_path / "note.png"
    path.write_bytes(data)
    with pytest.raises(IconstudioError, match=said):
        session.icon(str(path))
    for encoding in ("utf-8-sig", "utf-16"):
        path.write_text('<svg viewBox="0 0 9 9"><path d="M2 2h5v5H2z"/></svg>', encoding)
        assert session.icon(str(path)).svg.count("<path") == 1


def test_what_a_scan_lacks_is_told(session, tmp_path):
    blank = tmp_path / "blank.png"
    Image.new("RGB", (50, 50), "white").save(blank)
    with pytest.raises(IconstudioError, match=r"blank\.png.*No drawing can be made out"):
        session.icon(str(blank))
    broken = tmp_path / "broken.png"
    broken.write_bytes(blank.read_bytes()[:60])
    with pytest.raises(IconstudioError, match=r"broken\.png.*cut short"):
        session.icon(str(broken))
    paper = np.random.default_rng(0).integers(225, 256, (200, 200, 3), np.uint8)
    paper[40:90, 40:160] //= 9
    half = tmp_path / "half.png"
    Image.fromarray(paper).save(half)
    half.write_bytes(half.read_bytes()[: half.stat().st_size * 9 // 10])
    assert "cut short" in session.icon(str(half)).remarks[0]


@pytest.mark.parametrize(("radius", "told"), [(3, True), (12, False), (0, False)])
def test_small_dots_that_are_left_out_are_told(session, tmp_path, radius, told):
    picture = Image.new("RGB", (600, 600), "white")
    draw = ImageDraw.Draw(picture)
    draw.ellipse([100, 100, 400, 400], outline="black", width=24)
    if radius:
        draw.ellipse([500 - radius, 250 - radius, 500 + radius, 250 + radius], fill="black")
    path = tmp_path / "ring.png"
    picture.save(path)
    assert any("specks" in remark for remark in session.icon(str(path)).remarks) == told


@pytest.mark.parametrize("colour", ["white", "black", "#123456"])
@pytest.mark.parametrize(("side", "kind"), [(1, "PNG"), (200, "PNG"), (200, "JPEG")])
def test_of_a_plain_area_it_is_told_that_it_is_one_and_nothing_of_pens(
    session, tmp_path, colour, side, kind
):
    path = tmp_path / "plain"
    Image.new("RGB", (side, side), colour).save(path, kind)
    with pytest.raises(IconstudioError, match="one plain area of a single colour") as told:
        session.icon(str(path))
    assert not re.search(r"\bpens?\b", str(told.value))


def roof_of_a_house(ground="white", roof="#a22", walls="#a22"):
    picture = Image.new("RGB", (200, 200), ground)
    draw = ImageDraw.Draw(picture)
    draw.polygon([(100, 24), (30, 80), (170, 80)], fill=roof)
    draw.rectangle([50, 84, 150, 180], fill=walls)
    return picture


@pytest.mark.parametrize(
    ("kind", "options"), [("JPEG", {"quality": 90}), ("PNG", {}), ("GIF", {"interlace": 0})]
)
@pytest.mark.parametrize("colours", [(), ("#111", "#eee", "#e33"), ("white", "#222", "#28c")])
def test_what_a_file_lacks_that_is_cut_short_is_no_ink(session, tmp_path, kind, options, colours):
    whole = roof_of_a_house(*colours)
    file = io.BytesIO()
    whole.save(file, kind, **options)
    cut = (file.getvalue()[:size] for size in range(file.tell() - 20, 0, -20))
    data, height = next(
        (one, height) for one in cut if 80 < (height := len(decode_image(one).was_read)) < 170
    )
    path, cropped = tmp_path / "house", tmp_path / "cropped.png"
    path.write_bytes(data)
    whole.crop((0, 0, 200, height)).save(cropped)
    found, right = session.icon(str(path)), session.icon(str(cropped))
    assert "cut short" in found.remarks[0]
    assert scans.iou(session.exemplar(found).ink, session.exemplar(right).ink) > 0.95


def test_a_file_cut_short_of_which_only_what_is_transparent_was_read_is_told(session, tmp_path):
    levels = np.random.default_rng(0).integers(0, 255, (200, 200, 4), np.uint8)
    levels[:150, :, 3] = 0
    whole = io.BytesIO()
    Image.fromarray(levels).save(whole, "PNG")
    file = tmp_path / "clear.png"
    file.write_bytes(whole.getvalue()[: len(whole.getvalue()) // 2])
    with pytest.raises(IconstudioError, match=r"cut short.*transparent all over"):
        session.icon(str(file))


def test_of_a_file_cut_short_that_is_refused_it_is_not_said_that_it_is_shown(session, tmp_path):
    data = io.BytesIO()
    Image.fromarray(chelsea() // 8 + 120).save(data, "JPEG")
    (tmp_path / "cut.jpg").write_bytes(data.getvalue()[: data.tell() // 3])
    with pytest.raises(IconstudioError, match="cut short or damaged") as caught:
        session.icon(str(tmp_path / "cut.jpg"))
    assert "is shown" not in str(caught.value)


def test_a_file_of_which_nothing_can_be_read_is_refused(session, tmp_path):
    path = tmp_path / "house.webp"
    roof_of_a_house().save(path)
    path.write_bytes(path.read_bytes()[:-100])
    with pytest.raises(IconstudioError, match=r"cut short.*Save or copy it again"):
        session.icon(str(path))


@pytest.mark.parametrize("shape", [(10, 3000), (3000, 10)])
def test_a_line_that_is_too_thin_for_an_icon_is_drawn_thicker_and_that_is_told(
    session, tmp_path, shape
):
    pixels = np.full((*shape, 3), 255, np.uint8)
    pixels[3:-3, 3:-3] = 0
    path = tmp_path / "line.png"
    Image.fromarray(pixels).save(path)
    icon = session.icon(str(path))
    assert any("too thin" in remark for remark in icon.remarks)
    assert session.exemplar(icon).ink.any()


def test_of_a_line_of_one_pixel_it_is_told_that_nothing_is_made_out(session, tmp_path):
    pixels = np.full((1, 3000, 3), 255, np.uint8)
    pixels[:, 50:2950] = 0
    path = tmp_path / "row.png"
    Image.fromarray(pixels).save(path)
    with pytest.raises(IconstudioError, match=r"row\.png.*No drawing can be made out"):
        session.icon(str(path))


def test_of_an_image_that_takes_too_long_it_is_told_what_to_do():
    slow: Future = Future()
    slow.set_exception(TimeoutError())
    with pytest.raises(IconstudioError, match=r"takes too long\. Scale it down"):
        next(awaited(slow))
