"""Drawings that show nothing but a bitmap are read as that bitmap."""

import base64
import io
from urllib.parse import quote_from_bytes

import numpy as np
import pytest
from PIL import Image, ImageDraw

from iconstudio.model import IconstudioError
from iconstudio.svg.bitmaps import file_of

pytestmark = pytest.mark.thorough(but=1)

HOUSE = [(100, 20), (180, 90), (150, 90), (150, 170), (50, 170), (50, 90), (20, 90)]


def house(kind="PNG"):
    image = Image.new("RGB", (200, 200), "white")
    ImageDraw.Draw(image).polygon(HOUSE, fill=(30, 60, 120))
    stream = io.BytesIO()
    image.save(stream, kind)
    return stream.getvalue()


def in_base64(data, kind="png"):
    return f"data:image/{kind};base64,{base64.b64encode(data).decode()}"


def svg(content):
    return (
        '<svg xmlns="http://www.w3.org/2000/svg" xmlns:xlink="http://www.w3.org/1999/xlink"'
        f' viewBox="0 0 200 200">{content}</svg>'
    )


PNG, JPEG = in_base64(house()), in_base64(house("JPEG"), "jpeg")
IMAGE = f'<image width="200" height="200" href="{PNG}"/>'
NAMED = IMAGE.replace("<image", '<image id="i"')
DRAWINGS = {
    "image": IMAGE,
    "by an old attribute": IMAGE.replace("href", "xlink:href"),
    "JPEG": IMAGE.replace(PNG, JPEG),
    "without base64": IMAGE.replace(PNG, f"data:image/png,{quote_from_bytes(house())}"),
    "in a pattern": '<pattern id="p" width="1" height="1"><use href="#i"/></pattern>'
    '<rect width="200" height="200" fill="url(#p)"/>'
    f"<defs>{NAMED}</defs>",
    "smaller, elsewhere": f'<g transform="matrix(.7 0 0 .7 9 9)">{IMAGE}</g>',
    "beside the page": f'<g transform="translate(500)">{IMAGE}</g>',
    "on a white page": f'<rect width="200" height="200" fill="#fff"/>{IMAGE}',
    "on a page of a colour": f'<rect width="100%" height="100%" fill="#fd8"/>{IMAGE}',
}


@pytest.mark.parametrize("kind", DRAWINGS)
def test_a_drawing_of_a_bitmap_is_that_bitmap(session, tmp_path, kind):
    (tmp_path / "plain.png").write_bytes(house())
    (tmp_path / "drawing.svg").write_text(svg(DRAWINGS[kind]))
    expected = session.exemplar(session.icon(str(tmp_path / "plain.png")))
    found = session.icon(str(tmp_path / "drawing.svg"))
    ink = session.exemplar(found).ink
    assert (ink & expected.ink).sum() / (ink | expected.ink).sum() > 0.98
    assert found.remarks[0] == "All that it shows is a bitmap, which was traced."
    assert found.credit.title == "drawing.svg"


def test_what_is_drawn_beside_a_bitmap_is_the_drawing(session, tmp_path):
    path = tmp_path / "drawing.svg"
    path.write_text(svg(f'{IMAGE}<path d="M10 180h180v10H10z"/>'))
    assert session.icon(str(path)).remarks == (
        "A bitmap was left out. Trace it, or open it as a picture.",
    )


TURNED = {
    "turned": (f'<g transform="rotate(90 100 100)">{IMAGE}</g>', Image.Transpose.ROTATE_270),
    "mirrored": (
        f'<g transform="matrix(-1 0 0 1 200 0)">{IMAGE}</g>',
        Image.Transpose.FLIP_LEFT_RIGHT,
    ),
    "upside down, repeated": (
        f'<defs>{NAMED}</defs><use href="#i" transform="matrix(1 0 0 -1 0 200)"/>',
        Image.Transpose.FLIP_TOP_BOTTOM,
    ),
    "turned beside the page": (
        f'<g transform="translate(500) rotate(90 100 100)">{IMAGE}</g>',
        Image.Transpose.ROTATE_270,
    ),
    "turned in a pattern": (
        '<pattern id="p" patternContentUnits="objectBoundingBox" width="1" height="1">'
        '<use href="#i" transform="matrix(-.005 0 0 .005 1 0)"/></pattern>'
        '<rect width="200" height="200" rx="2" fill="url(#p)"/>'
        f"<defs>{NAMED}</defs>",
        Image.Transpose.FLIP_LEFT_RIGHT,
    ),
}


def lined(session, path):
    found = session.icon(str(path))
    return session.exemplar(found).ink, found.remarks


def similarity(one, other):
    return (one & other).sum() / (one | other).sum()


@pytest.mark.parametrize("kind", TURNED)
def test_a_bitmap_that_is_turned_is_read_so(session, tmp_path, kind):
    content, how = TURNED[kind]
    (tmp_path / "drawing.svg").write_text(svg(content))
    with Image.open(io.BytesIO(house())) as image:
        image.transpose(how).save(tmp_path / "plain.png")
    ink, remarks = lined(session, tmp_path / "drawing.svg")
    assert similarity(ink, lined(session, tmp_path / "plain.png")[0]) > 0.98
    assert "traced as it is seen" in remarks[0]


WINDOW = "M40 60h130v60H40z"
SEEN = {
    "cut": f'<clipPath id="c"><path d="{WINDOW}"/></clipPath><g clip-path="url(#c)">{IMAGE}</g>',
    "cut by a shape of CSS": f"<g style=\"clip-path:path('{WINDOW}')\">{IMAGE}</g>",
    "cut by a mask": f'<mask id="c"><path fill="#fff" d="{WINDOW}"/></mask>'
    f'<g fill="none" mask="url(#c)">{IMAGE}</g>',
    "cut by its frame": f'<svg x="40" y="60" width="130" height="60" viewBox="40 60 130 60">'
    f"{IMAGE}</svg>",
    "on a page": '<rect width="200" height="200" fill="#fff"/>'
    f"<g style=\"clip-path:path('{WINDOW}')\">{IMAGE}</g>",
}


@pytest.mark.parametrize("kind", SEEN)
def test_a_bitmap_that_is_cut_is_read_so(session, tmp_path, kind):
    (tmp_path / "drawing.svg").write_text(svg(SEEN[kind]))
    window = Image.new("RGB", (200, 200), "white")
    with Image.open(io.BytesIO(house())) as image:
        window.paste(image.crop((40, 60, 170, 120)), (40, 60))
    window.save(tmp_path / "plain.png")
    ink, remarks = lined(session, tmp_path / "drawing.svg")
    assert similarity(ink, lined(session, tmp_path / "plain.png")[0]) > 0.97
    assert "traced as it is seen" in remarks[0]


def test_a_bitmap_that_the_page_cuts_is_read_so(session, tmp_path):
    (tmp_path / "drawing.svg").write_text(svg(f'<g transform="translate(0 -90)">{IMAGE}</g>'))
    with Image.open(io.BytesIO(house())) as image:
        image.crop((0, 90, 200, 200)).save(tmp_path / "plain.png")
    ink, _ = lined(session, tmp_path / "drawing.svg")
    assert similarity(ink, lined(session, tmp_path / "plain.png")[0]) > 0.97


def test_what_is_clear_of_a_cut_bitmap_is_no_white_paper(session, tmp_path):
    image = Image.new("RGBA", (200, 200))
    ImageDraw.Draw(image).polygon(HOUSE, fill="white")
    stream = io.BytesIO()
    image.save(stream, "PNG")
    content = SEEN["cut"].replace(PNG, in_base64(stream.getvalue()))
    (tmp_path / "drawing.svg").write_text(svg(content))
    ink, _ = lined(session, tmp_path / "drawing.svg")
    assert ink.any() and not ink[:, :100].all()


def test_bitmaps_beside_each_other_are_one_picture(session, tmp_path):
    half = IMAGE.replace('width="200" height="200"', 'width="100" height="100" y="50"')
    other = half.replace("<image", '<image x="100"').replace(PNG, JPEG)
    (tmp_path / "drawing.svg").write_text(svg(half + other))
    pair = Image.new("RGB", (400, 400), "white")
    with Image.open(io.BytesIO(house())) as image:
        pair.paste(image, (0, 100))
        pair.paste(image, (200, 100))
    pair.save(tmp_path / "plain.png")
    ink, remarks = lined(session, tmp_path / "drawing.svg")
    assert similarity(ink, lined(session, tmp_path / "plain.png")[0]) > 0.96
    assert "traced as they are seen" in remarks[0]


def test_a_bitmap_that_is_stretched_is_read_so(session, tmp_path):
    wide = IMAGE.replace('height="200"', 'height="100" y="50" preserveAspectRatio="none"')
    (tmp_path / "drawing.svg").write_text(svg(wide))
    ink, _ = lined(session, tmp_path / "drawing.svg")
    rows, columns = np.nonzero(ink)
    assert np.ptp(columns) / np.ptp(rows) == pytest.approx(160 / 75, rel=0.03)


@pytest.mark.parametrize(
    ("content", "said"),
    [
        (f'<g display="none">{IMAGE}</g>', "nothing to be seen"),
        (f'<g opacity="0">{IMAGE}{IMAGE}</g>', "nothing to be seen"),
        (IMAGE.replace(PNG, "data:image/png;base64,iVBORw0KGgo="), "drawing.svg.*damaged"),
        (f"{IMAGE}{IMAGE.replace(PNG, PNG[:400])}", "A bitmap was left out"),
        (IMAGE.replace(PNG, in_base64(house("BMP"), "bmp")) * 2, "A bitmap was left out"),
        (IMAGE.replace(PNG, "house.png"), "in another file"),
        (IMAGE + IMAGE.replace(PNG, "house.png"), "in another file"),
    ],
    ids=[
        "hidden",
        "transparent",
        "damaged",
        "one damaged",
        "not drawn",
        "elsewhere",
        "one elsewhere",
    ],
)
def test_what_is_no_bitmap_that_is_seen_is_refused(session, tmp_path, content, said):
    path = tmp_path / "drawing.svg"
    path.write_text(svg(content))
    with pytest.raises(IconstudioError, match=said):
        session.icon(str(path))


def test_the_artwork_of_a_drawing_of_a_bitmap_is_its_pixels(session, tmp_path):
    from iconstudio.reading import returned

    path = tmp_path / "drawing.svg"
    path.write_text(svg(IMAGE))
    separation = returned(session.artwork(path))
    decoded = np.asarray(Image.open(io.BytesIO(separation.photo.data)).convert("RGB"))
    assert np.array_equal(decoded, np.asarray(Image.open(io.BytesIO(house()))))


@pytest.mark.parametrize("address", ["", "a.png", "data:image/png;base64,A", "data:text/plain,a"])
def test_what_is_no_bitmap_here(address):
    assert file_of(address) is None
