"""PNG files."""

import io

import numpy as np
import pytest
from PIL import Image

from iconstudio.files import write_bytes
from iconstudio.model import IconstudioError
from iconstudio.output import png


@pytest.mark.parametrize(("white", "value"), [(False, 0), (True, 255)])
def test_ink_in_one_colour_on_transparent_ground(result, white, value):
    pixels = png.icon_pixels(result, 512, white)
    assert (pixels[..., :3] == value).all()
    drawn, wanted = pixels[..., 3] > 127, result.drawing.coverage > 127
    assert (drawn & wanted).sum() / (drawn | wanted).sum() > 0.995
    assert pixels[0, 0, 3] == 0


def test_large_pictures_are_drawn_anew(result):
    """Edges stay a pixel wide, where enlarging would blur them."""

    def soft(picture):
        return ((picture > 5) & (picture < 250)).sum()

    enlarged = Image.fromarray(result.drawing.coverage).resize((2048, 2048))
    drawn = png.coverage(result.path, 2048)
    assert soft(drawn) < 0.4 * soft(np.asarray(enlarged))
    assert ((drawn > 127) != (np.asarray(enlarged) > 127)).mean() < 0.005


def test_a_file_can_be_read_again(result, tmp_path):
    pixels = png.icon_pixels(result, 64)
    write_bytes(tmp_path / "icon.png", png.encoded(pixels))
    with Image.open(tmp_path / "icon.png") as picture:
        assert np.array_equal(np.asarray(picture), pixels)
    with Image.open(io.BytesIO(png.encoded(Image.fromarray(pixels)))) as picture:
        assert picture.size == (64, 64)
    assert [path.name for path in tmp_path.iterdir()] == ["icon.png"]


def test_a_file_that_cannot_be_written(tmp_path):
    with pytest.raises(IconstudioError, match="cannot be written"):
        write_bytes(tmp_path / "missing" / "icon.png", b"")
