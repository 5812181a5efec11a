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
DRAWINGS = {
    "image": IMAGE,
    "by an old attribute": IMAGE.replace("href", "xlink:href"),
    "JPEG": IMAGE.replace(PNG, JPEG),
    "without base64": IMAGE.replace(PNG, f"data:image/png,{quote_from_bytes(house())}"),
    "in a pattern": '<pattern id="p" width="1" height="1"><use href="#i"/></pattern>'
    '<rect width="200" height="200" fill="url(#p)"/>'
    + IMAGE.replace("<image", '<image id="i"').join(("<defs>", "</defs>")),
    "larger, elsewhere": f'<g transform="matrix(2 0 0 3 9 9)">{IMAGE}</g>',
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


@pytest.mark.parametrize(
    ("content", "said"),
    [
        (IMAGE + IMAGE.replace(PNG, JPEG), "A bitmap was left out"),
        (IMAGE + IMAGE, "A bitmap was left out"),
        (f'<g transform="rotate(90 100 100)">{IMAGE}</g>', "A bitmap was left out"),
        (f'<g transform="matrix(-1 0 0 1 200 0)">{IMAGE}</g>', "A bitmap was left out"),
        (f'<g style="clip-path:circle(50px)">{IMAGE}</g>', "A bitmap was left out"),
        (IMAGE.replace("<image", '<image preserveAspectRatio="none"'), "A bitmap was left out"),
        (f'<rect width="200" height="200" fill="red"/>{IMAGE}{IMAGE}', "A bitmap was left out"),
        (f'<g display="none">{IMAGE}</g>', "nothing to be seen"),
        (IMAGE.replace(PNG, "data:image/png;base64,iVBORw0KGgo="), "drawing.svg.*damaged"),
        (IMAGE.replace(PNG, "house.png"), "in another file"),
    ],
    ids=[
        "two",
        "twice",
        "turned",
        "mirrored",
        "cut",
        "stretched",
        "two on a page",
        "hidden",
        "damaged",
        "elsewhere",
    ],
)
def test_what_is_not_one_whole_bitmap_is_refused(session, tmp_path, content, said):
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
