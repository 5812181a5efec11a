"""Images and coloured SVG drawings as exemplars of patterns."""

import io
from dataclasses import replace

import msgspec
import numpy as np
import pytest
from PIL import Image as Pixels

from iconstudio.algorithms.patterns.exemplar import MOST_LAYERS
from iconstudio.images.photo import photo_of
from iconstudio.images.reading import Image
from iconstudio.model import Correction, IconstudioError, Patterning, Separation, Stroke
from iconstudio.reading import returned
from iconstudio.resources import resource
from iconstudio.svg import artwork
from iconstudio.workflows.events import Remark, Result
from iconstudio.workflows.files import read_file
from iconstudio.workflows.pages import StoredPhoto
from iconstudio.workflows.pattern import imaging
from iconstudio.workflows.pattern.imaging import ImageExemplar, reduction_of, unheeded
from iconstudio.workflows.pattern.page import PatternPage
from iconstudio.workflows.pattern.page_format import PatternPages
from iconstudio.workflows.pattern.patterning import run
from iconstudio.workflows.pattern.spec import PATTERN

SAMPLES = 0.5
DOTS = "".join(
    f'<circle cx="{x}" cy="{y}" r="13" fill="#c2185b"/><circle cx="{x}" cy="{y}" r="5" '
    'fill="#f0a202"/>'
    for y in (24, 72, 120)
    for x in (24 + y % 16, 72 + y % 16, 120 + y % 16)
)
RDF = (
    '<metadata><rdf:RDF xmlns:rdf="http://www.w3.org/1999/02/22-rdf-syntax-ns#" '
    'xmlns:cc="http://creativecommons.org/ns#" xmlns:dc="http://purl.org/dc/elements/1.1/">'
    '<cc:Work rdf:about=""><dc:title>Dots</dc:title><dc:creator>Ada</dc:creator>'
    "<dc:rights>CC-BY-4.0</dc:rights></cc:Work></rdf:RDF></metadata>"
)
SVG = (
    f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 144 144">{RDF}'
    f'<rect width="144" height="144" fill="#fdf6e3"/>{DOTS}'
    '<path d="M160 9h9v9h-9z"/></svg>'
)


def separation(pixels, **options):
    pixels = np.ascontiguousarray(pixels, np.uint8)
    return Separation(photo_of(Image(pixels, pixels.shape[1], pixels.shape[0])), **options)


def exemplar(pixels, **options):
    return ImageExemplar.of(separation(pixels, **options)).layout(SAMPLES)


@pytest.fixture(scope="module")
def drawn():
    pixels, _, _ = artwork.artwork(SVG.encode())
    return np.asarray(Pixels.fromarray(pixels).reduce(2))


@pytest.fixture(scope="module")
def file(tmp_path_factory):
    path = tmp_path_factory.mktemp("dots") / "dots.svg"
    path.write_text(SVG)
    return path


def test_its_longer_side_is_that_of_a_canvas(drawn):
    layout = exemplar(drawn[:160])
    assert layout.exemplar.colours.shape == (80, 128, 3)
    assert layout.exemplar.masks.shape == layout.exemplar.labels.shape == (1, 80, 128)
    assert layout.ground == "#fdf6e3" and not layout.remark


def test_its_elements_are_known_with_their_details(drawn):
    layout = exemplar(drawn)
    (elements,) = layout.elements
    assert len(elements) == layout.exemplar.labels.max() == 9
    assert all([one.colour for one in element] == ["#c2185b", "#f0a202"] for element in elements)
    for number, element in enumerate(elements, start=1):
        rows, columns = np.nonzero(layout.exemplar.labels[0] == number)
        points = np.array([point for one in element for part in one.path.contours
                           for point in part.points])  # fmt: skip
        middle = (points.min(axis=0) + points.max(axis=0)) / 2
        assert np.abs(middle - (columns.mean() + 0.5, rows.mean() + 0.5)).max() < 0.2
        assert np.ptp(points, axis=0) == pytest.approx(26 * 128 / 144, abs=0.3)


def test_what_is_transparent_is_white(drawn):
    free = np.dstack([drawn[..., :3], np.where(drawn[..., 0] > 250, 0, 255)])
    layout = exemplar(free)
    assert layout.ground == "#ffffff" and len(layout.elements[0]) == 9


def test_a_jpeg_has_the_same_layers(drawn):
    file = io.BytesIO()
    large = Pixels.fromarray(drawn[..., :3]).resize((512, 512))
    large.save(file, "JPEG", quality=60)
    pixels = np.asarray(Pixels.open(file))
    layout = exemplar(pixels)
    assert len(layout.elements) == 1 and len(layout.elements[0]) == 9
    assert {len(element) for element in layout.elements[0]} == {2}


def test_corrections_are_in_pixels_of_the_original(drawn, monkeypatch):
    monkeypatch.setattr(imaging, "LARGEST", 256)
    large = np.asarray(Pixels.fromarray(drawn[..., :3]).resize((384, 384), 0))
    x = 24 * 384 / 144
    stroke = Stroke(384 * 32 / 144, ((32 * 384 / 144, x), (32 * 384 / 144 + 1, x)))
    layout = exemplar(large, corrections=(Correction(0, stroke),))
    assert len(layout.elements[0]) == 8
    assert reduction_of(separation(large).photo) == (
        "The image of 384 x 384 pixels is reduced to 256 a side."
    )


def test_a_gradient_is_told(drawn):
    ramp = np.linspace(60, 200, 24).astype(np.uint8)
    graded = np.full((96, 96, 3), 255, np.uint8)
    for x in (12, 60):
        graded[12:36, x : x + 24] = graded[60:84, x : x + 24] = np.stack([ramp, ramp, 0 * ramp], 1)
    assert exemplar(graded).remark == "A gradient of the image becomes one even colour."
    rng = np.random.default_rng(0)
    noisy = np.clip(drawn + rng.normal(0, 3, drawn.shape), 0, 255)
    assert exemplar(noisy).remark == ""


def test_its_ground_can_be_left_out(drawn):
    image = separation(drawn)
    assert ImageExemplar.of(image, transparent=True).layout(SAMPLES).ground == ""


def test_what_an_image_does_not_heed_is_told(drawn):
    work = Patterning(image=separation(drawn))
    assert unheeded(work) == unheeded(replace(work, ground="")) == ""
    assert unheeded(Patterning(density=2)) == ""
    said = unheeded(replace(work, density=2.0, turn=30.0))
    assert said == "An image keeps its own density and turn; what was asked for is passed over."


def test_too_many_layers_are_told():
    pixels = np.full((128, 128, 3), 255, np.uint8)
    for n in range(11):
        pixels[:, 6 + 11 * n : 14 + 11 * n] = (22 * n, 255 - 23 * n, 95 * n % 256)
    layout = exemplar(pixels)
    assert len(layout.elements) == MOST_LAYERS
    assert "11 layers" in layout.remark and str(MOST_LAYERS) in layout.remark


@pytest.mark.parametrize("spoilt", ["grain", "dither"])
def test_grain_and_dithering_are_no_colours(drawn, spoilt):
    large = Pixels.fromarray(drawn[..., :3]).resize((512, 512))
    if spoilt == "dither":
        pixels = np.asarray(large.convert("P").convert("RGB"))
    else:
        noise = np.random.default_rng(0).normal(0, 6, (512, 512, 3))
        pixels = np.clip(large + noise, 0, 255)
    layout = exemplar(pixels)
    assert len(layout.elements) == 1 and len(layout.elements[0]) == 9
    assert {len(element) for element in layout.elements[0]} == {2}


@pytest.mark.parametrize("name", ["flower", "shuttle"])
def test_photographs_are_told(name):
    path = resource(f"examples/{name}.jpg")
    with Pixels.open(path) as photo, pytest.raises(IconstudioError, match="a photograph, or noise"):
        exemplar(np.asarray(photo.convert("RGB")))


@pytest.mark.parametrize(
    "pixels, said",
    [
        (np.full((64, 64, 3), 9), "only one colour"),
        (np.full((15, 64, 3), 9), "at least 16 x 16"),
        (np.random.default_rng(0).integers(0, 256, (64, 64, 3)), "a photograph, or noise"),
        (np.dstack([np.full((64, 64, 3), 9), np.zeros((64, 64))]), "only one colour"),
    ],
)
def test_what_is_no_exemplar_is_told(pixels, said):
    with pytest.raises(IconstudioError, match=said):
        exemplar(pixels)


def test_an_svg_drawing_is_an_exemplar_in_its_colours(session, file):
    image = returned(session.artwork(file))
    (thanks,) = image.credits
    assert thanks.credit.author == "Ada" and thanks.remarks == (artwork.ONE_OUTSIDE,)
    assert image.photo.width == image.photo.height == artwork.SIDE
    assert image.photo.suffix == ".png" and image.photo.data.startswith(b"\x89PNG")
    work = Patterning(image=image, width=128, height=128)
    (icon,) = (one.icon for one in run(session, work) if isinstance(one, Result))
    assert icon.title == "pattern of dots" and [one.credit.author for one in icon.credits] == [
        "Ada"
    ]
    colours = [fill.colour for fill in icon.fills]
    assert icon.ground == "#fdf6e3" and {"#c2185b", "#f0a202"} <= set(colours)


def test_an_svg_drawing_is_named_in_a_file(session, file):
    path = file.with_suffix(".json")
    path.write_text('{"image": "dots.svg", "colours": 3, "width": 96, "height": 96}')
    told = []
    work = returned(read_file(path, PATTERN, session, told.append))
    assert work.image.credits[0].credit.title == "Dots" and work.image.colours == 3
    assert PATTERN.file.of(work, str).image == file


def test_a_bitmap_is_read_as_before(session, file, drawn):
    path = file.with_suffix(".png")
    Pixels.fromarray(drawn).save(path)
    image = returned(session.artwork(path))
    assert image.credits == () and image.photo.width == drawn.shape[1]
    with pytest.raises(IconstudioError, match="cannot be used"):
        returned(session.artwork(path.with_name("none.svg")))


def test_a_remark_comes_before_the_result(session, drawn, monkeypatch):
    pixels = np.full((128, 128, 3), 255, np.uint8)
    for n in range(9):
        pixels[:, 6 + 13 * n : 16 + 13 * n] = (27 * n, 255 - 28 * n, 95 * n % 256)
    work = replace(Patterning(image=separation(pixels)), width=64, height=64)
    told = [one for one in run(session, work) if isinstance(one, (Remark, Result))]
    assert isinstance(told[0], Remark) and "9 layers" in told[0].sentence
    assert isinstance(told[-1], Result)


def test_a_page_keeps_whom_to_thank_for_its_image(session, file):
    class Parts:
        def photo(self, photo):
            return StoredPhoto("photos/x.png", photo.width, photo.height)

        icon = str

    class Stored:
        icon, complaints = session.icon, []

        def photo(self, stored):
            return image.photo
            yield

    image = returned(session.artwork(file))
    pages = PatternPages(PATTERN)
    page = PatternPage(Patterning(image=image))
    stored = msgspec.json.decode(msgspec.json.encode(pages.write(page, Parts())), type=pages.stored)
    (thanks,) = returned(pages.read(stored, Stored())).work.image.credits
    assert thanks.credit == image.credits[0].credit and thanks.id == image.credits[0].id
