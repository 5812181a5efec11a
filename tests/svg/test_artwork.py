"""SVG drawings in their own colours."""

import numpy as np
import pytest

from iconstudio.model import IconstudioError, SpriteError
from iconstudio.svg import artwork
from iconstudio.svg.reading import own_artwork


def read(body, root='viewBox="0 0 40 20"', **options):
    svg = f'<svg xmlns="http://www.w3.org/2000/svg" {root}>{body}</svg>'
    return own_artwork(svg.encode(), "folder/vine.svg", **options)


RECT = '<rect x="10" width="20" height="20" fill="#c2185b"/>'


def test_it_is_in_its_colours_as_large_as_its_canvas():
    pixels, thanks = read(RECT)
    assert pixels.shape == (artwork.SIDE // 2, artwork.SIDE, 4)
    assert tuple(pixels[100, 250]) == (0xC2, 0x18, 0x5B, 255)
    assert (pixels[:, :125, 3] == 0).all() and (pixels[:, 130:380, 3] == 255).all()
    assert thanks.id.startswith("own:vine-") and thanks.svg == "" and not thanks.remarks
    assert thanks.credit.title == "vine.svg"


def test_its_credits_are_kept():
    rdf = (
        '<metadata><rdf:RDF xmlns:rdf="http://www.w3.org/1999/02/22-rdf-syntax-ns#" '
        'xmlns:cc="http://creativecommons.org/ns#" xmlns:dc="http://purl.org/dc/elements/1.1/">'
        '<cc:Work rdf:about=""><dc:title>Vine</dc:title><dc:creator>Ada</dc:creator>'
        "<dc:rights>CC-BY-4.0</dc:rights></cc:Work></rdf:RDF></metadata>"
    )
    _, thanks = read(rdf + RECT)
    assert thanks.credit.title == "Vine" and thanks.credit.author == "Ada"
    assert thanks.credit.license == "CC-BY-4.0"


def test_gradients_styles_and_references_are_drawn():
    pixels, _ = read(
        '<style>.a{fill:url(#g)}</style><defs><linearGradient id="g">'
        '<stop stop-color="red"/><stop offset="1" stop-color="blue"/></linearGradient>'
        '<rect id="r" class="a" width="20" height="20"/></defs><use href="#r" x="20"/>'
    )
    assert pixels[50, 260, 0] > 240 > 15 > pixels[50, 260, 2]
    assert pixels[50, 505, 2] > 240 and pixels[50, 50, 3] == 0


@pytest.mark.parametrize(
    "body, said",
    [
        ('<circle cx="90" cy="9" r="5"/>', artwork.ONE_OUTSIDE),
        ('<path d="M60 0h5v5h-5zM80 0h5v5h-5z"/>', artwork.SOME_OUTSIDE.format(2)),
        ('<circle cx="-30" cy="-40" r="5"/><circle cx="5" cy="90" r="5"/>',
         artwork.SOME_OUTSIDE.format(2)),
    ],
)  # fmt: skip
def test_objects_outside_its_canvas_are_told(body, said):
    pixels, thanks = read(RECT + body)
    assert thanks.remarks == (said,)
    assert (pixels == read(RECT)[0]).all()


def test_what_only_reaches_beyond_its_canvas_is_not():
    _, thanks = read('<circle cx="38" cy="10" r="9"/><path d="M-9 9H99" stroke="red"/>')
    assert not thanks.remarks


def test_nothing_on_its_canvas_is_told():
    with pytest.raises(
        IconstudioError, match=r"“folder/vine.svg” cannot be used. Nothing of it lies"
    ):
        read('<circle cx="90" cy="9" r="5"/>')
    for body in ("", '<rect width="9" height="9" fill="none"/>', '<g opacity="0">' + RECT + "</g>"):
        with pytest.raises(IconstudioError, match="nothing to be seen"):
            read(body)


def test_without_a_canvas_it_is_as_large_as_what_is_drawn():
    pixels, _ = read('<rect x="300" y="200" width="30" height="10" fill="red"/>', root="")
    assert pixels.shape == (round(artwork.SIDE / 3), artwork.SIDE, 4)
    assert (pixels[5:-5, 5:-5] == (255, 0, 0, 255)).all()


def test_far_and_huge_coordinates():
    pixels, _ = read(
        '<rect x="5e6" y="5e6" width="100" height="50" fill="red"/>',
        root='viewBox="5e6 5e6 100 100"',
    )
    assert (pixels[50:200, 50:450, 0] == 255).all() and (pixels[300:, :, 3] == 0).all()


def test_what_is_not_safe_is_refused():
    with pytest.raises(IconstudioError, match="cannot be used"):
        own_artwork(b"no drawing", "x.svg")
    sprites = '<symbol id="a" viewBox="0 0 9 9"><path d="M0 0h9v9z" fill="red"/></symbol>'
    both = sprites + sprites.replace('"a"', '"b"').replace("red", "blue")
    with pytest.raises(SpriteError, match=r"vine\.svg#a"):
        read(both)
    pixels, _ = read(both, symbol="b")
    assert np.median(pixels[pixels[..., 3] > 250], axis=0)[:3].tolist() == [0, 0, 255]
