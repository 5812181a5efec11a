"""Long flat shadows on app icons: of SVG and of bitmaps, what casts them is all that is drawn."""

import io

import numpy as np
import pytest
from PIL import Image

from iconstudio.algorithms.scanning.binarisation import ink_of, recognised
from iconstudio.algorithms.tones.alternation import Omission
from iconstudio.algorithms.tones.cast import is_cast
from tests import scans
from tests.algorithms.test_tone import as_svg, rgba

pytestmark = pytest.mark.thorough(but=1)

TILES = {
    "tile": '<rect x="4" y="4" width="92" height="92" rx="22" {}/>',
    "disc": '<circle cx="50" cy="50" r="46" {}/>',
    "square": '<rect width="100" height="100" {}/>',
}
NOTES = (
    '<path d="M35 28v44h8V44l21-5v21h8V28z" fill="{0}"/>'
    '<circle cx="36" cy="70" r="9" fill="{0}"/><circle cx="65" cy="62" r="9" fill="{0}"/>'
)
STAR = '<path d="M50 20l9 21 23 2-17 15 5 22-20-12-20 12 5-22-17-15 23-2z" fill="{0}"/>'


def app_icon(shape: str, colour: str, figure: str, opacity: float) -> str:
    """Return a figure on a tile that casts a shadow down and to the right."""
    steps = (
        figure.format("#000").join((f'<g transform="translate({n} {n})">', "</g>"))
        for n in range(1, 75)
    )
    return (
        f'<clipPath id="c">{TILES[shape].format("")}</clipPath>'
        + TILES[shape].format(f'fill="{colour}"')
        + f'<g clip-path="url(#c)"><g opacity="{opacity}">{"".join(steps)}</g></g>'
        + figure.format("#fff")
    )


@pytest.mark.parametrize(
    ("shape", "colour", "figure", "opacity"),
    [
        ("tile", "#e74c3c", NOTES, 0.4),
        ("tile", "#f1c40f", STAR, 0.3),
        ("disc", "#3498db", NOTES, 0.3),
        ("square", "#95a5a6", STAR, 0.25),
    ],
)
def test_a_drawing_is_as_without_its_long_shadow(shape, colour, figure, opacity):
    drawn = as_svg(app_icon(shape, colour, figure, opacity))
    plain = as_svg(TILES[shape].format(f'fill="{colour}"') + figure.format("#fff"))
    assert Omission.SHADOW in drawn.omissions
    assert drawn.omissions - {Omission.SHADOW} == plain.omissions
    assert scans.iou(*(scans.fitted(one.coverage / 255) for one in (drawn, plain))) > 0.96


PALETTE = [("#26a69a", "#00796b"), ("#f39c12", "#d35400"), ("#3498db", "#2471a3")]


@pytest.mark.parametrize(("colour", "darker"), PALETTE)
@pytest.mark.parametrize("shape", TILES)
def test_a_shadow_may_be_a_darker_colour_of_a_palette(shape, colour, darker):
    """One stripe from the corners of a letter to the edge, as designers draw it."""
    plain = TILES[shape].format(f'fill="{colour}"')
    letter = '<path d="M30 30h40v11H56v33H44V41H30z" fill="#fff"/>'
    stripe = f'<path clip-path="url(#c)" d="M70 30l70 70v60L44 74z" fill="{darker}"/>'
    drawn = as_svg(f'<clipPath id="c">{TILES[shape].format("")}</clipPath>{plain}{stripe}{letter}')
    assert Omission.SHADOW in drawn.omissions
    both = scans.fitted(drawn.coverage / 255), scans.fitted(as_svg(plain + letter).coverage / 255)
    assert scans.iou(*both) > 0.96


@pytest.mark.parametrize("kind", ["PNG", "JPEG"])
@pytest.mark.parametrize(
    ("shape", "colour", "side"), [("tile", "#e74c3c", 96), ("square", "#2ecc71", 180)]
)
def test_a_bitmap_is_as_its_drawing(shape, colour, side, kind):
    pixels = rgba(app_icon(shape, colour, NOTES, 0.4), side, "0 0 100 100")
    page = Image.new("RGBA", (side, side), "white")
    page.alpha_composite(Image.fromarray(pixels))
    file = io.BytesIO()
    page.convert("RGB").save(file, kind, quality=85)
    scan = recognised(np.asarray(Image.open(file)))
    right = scans.fitted(rgba(NOTES.format("#000"), 512, "0 0 100 100")[..., 3] / 255)
    assert scans.iou(scans.fitted(ink_of(scan).astype(float)), right) > 0.88


def test_what_lies_elsewhere_is_no_shadow():
    figure, ground, beside = (np.zeros((200, 200), bool) for _ in range(3))
    figure[60:120, 60:120] = True
    beside[60:140, 124:180] = True
    ground |= ~figure & ~beside
    assert not is_cast(beside, figure, ground)
    behind = np.zeros_like(figure)
    for step in range(80):
        behind[60 + step : 120 + step, 60 + step : 120 + step] = True
    behind &= ~figure
    assert is_cast(behind, figure, ~figure & ~behind)


def test_dark_lines_of_a_drawing_are_no_shadow():
    rows, columns = np.indices((200, 200))
    inside = (abs(rows - 100) < 50) & (abs(columns - 100) < 50)
    lines = inside & ((rows // 5 % 4 == 2) | (columns // 5 % 4 == 2))
    assert not is_cast(lines, inside & ~lines, ~inside)
