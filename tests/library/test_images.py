"""Images from outside: every format, upright, in sRGB, within limits, or a sentence."""

import io
import os
import struct
import time
import warnings
import zlib
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from PIL import Image, ImageCms, PngImagePlugin

from iconstudio.images import pillow
from iconstudio.images.pillow import decode, is_image
from iconstudio.images.reading import LONGEST, read_image
from iconstudio.model import IconstudioError
from iconstudio.reading import FileReader, returned
from iconstudio.workers import Workers
from iconstudio.workflows.registry import workflows

pytestmark = pytest.mark.thorough(but=1)

COLOURS = np.zeros((40, 60, 3), np.uint8)
COLOURS[:20, :30], COLOURS[:20, 30:] = [255, 0, 0], [255, 255, 255]
COLOURS[20:, 30:] = [0, 0, 255]
PICTURE = Image.fromarray(COLOURS)
UNDONE = {1: None, 2: 0, 3: 3, 4: 1, 5: 5, 6: 2, 7: 6, 8: 4}
"""What makes of an upright picture one with each orientation."""


@pytest.fixture(scope="module")
def workers():
    with Workers(1) as workers:
        yield workers


def read(source, workers):
    reading = read_image(source, workers)
    try:
        while True:
            next(reading)
    except StopIteration as end:
        return end.value


def saved(picture, kind, **options) -> bytes:
    if kind == "HEIF":
        pytest.importorskip("pillow_heif").register_heif_opener()
    file = io.BytesIO()
    picture.save(file, kind, **options)
    return file.getvalue()


def off(pixels, expected=COLOURS) -> float:
    assert pixels.shape[:2] == expected.shape[:2]
    return float(np.abs(pixels[..., :3].astype(int) - expected).mean())


LOSSLESS = ["PNG", "TIFF", "GIF", "BMP", "TGA", "PPM", "QOI", "JPEG2000", "PCX", "SGI"]
LOSSY = ["JPEG", "WEBP", "AVIF", "HEIF"]


@pytest.mark.parametrize("kind", LOSSLESS + LOSSY)
def test_every_format_is_read_by_its_content(kind):
    data = saved(PICTURE, kind)
    pixels, size, remark = decode(data, LONGEST)
    assert size == (60, 40) and remark == ""
    assert off(pixels) < (1 if kind in LOSSLESS else 4)
    assert is_image(data, "it.tga" if kind == "TGA" else "it")


@pytest.mark.parametrize("orientation", range(1, 9))
@pytest.mark.parametrize("kind", ["PNG", "TIFF", *LOSSY])
def test_every_orientation_is_upright(kind, orientation):
    turn = UNDONE[orientation]
    picture = PICTURE if turn is None else PICTURE.transpose(Image.Transpose(turn))
    exif = Image.Exif()
    exif[0x0112] = orientation
    pixels, size, _ = decode(saved(picture, kind, exif=exif), LONGEST)
    assert size == (60, 40)
    assert off(pixels) < 6


def test_an_orientation_in_xmp_counts_too():
    info = PngImagePlugin.PngInfo()
    info.add_itxt("XML:com.adobe.xmp", '<x tiff:Orientation="3"/>')
    data = saved(PICTURE.transpose(Image.Transpose.ROTATE_180), "PNG", pnginfo=info)
    assert off(decode(data, LONGEST)[0]) == 0


@pytest.mark.parametrize("mode", ["1", "L", "P", "CMYK", "YCbCr", "LAB", "I;16", "I", "F"])
def test_every_kind_of_pixel_becomes_plain_colours(mode):
    grey = np.asarray(PICTURE.convert("L"))
    if mode in ("I;16", "I", "F"):
        kind, white = {"I;16": ("<u2", 257), "I": ("<i4", 257), "F": ("<f4", 1 / 255)}[mode]
        picture = Image.fromarray((grey * np.float64(white)).astype(kind))
        expected = np.repeat(grey[..., None], 3, axis=2)
    elif mode == "LAB":
        lab = ImageCms.createProfile("LAB")
        srgb = ImageCms.createProfile("sRGB")
        picture = ImageCms.profileToProfile(PICTURE, srgb, lab, outputMode="LAB")
        expected = COLOURS
    else:
        picture = PICTURE.convert(mode)
        expected = np.asarray(picture.convert("RGB"))
    pixels, _, _ = decode(saved(picture, "TIFF"), LONGEST)
    assert pixels.shape == (40, 60, 3) and pixels.dtype == np.uint8
    assert off(pixels, expected.astype(int)) < 5


def test_16_bits_a_channel_keep_their_shades():
    ramp = np.tile(np.linspace(0, 65535, 256).astype(np.uint16), (4, 1))
    pixels, _, _ = decode(saved(Image.fromarray(ramp), "PNG"), LONGEST)
    assert np.abs(pixels[0, :, 0].astype(int) - np.arange(256)).max() <= 1


def test_a_colour_profile_is_applied():
    """The primaries exchanged: red of that profile is blue."""
    srgb = ImageCms.ImageCmsProfile(ImageCms.createProfile("sRGB")).tobytes()
    exchanged = srgb.replace(b"rXYZ", b"????").replace(b"bXYZ", b"rXYZ").replace(b"????", b"bXYZ")
    data = saved(Image.new("RGB", (8, 8), "red"), "PNG", icc_profile=exchanged)
    assert decode(data, LONGEST)[0][0, 0] == pytest.approx([0, 0, 255], abs=3)
    broken = saved(Image.new("RGB", (8, 8), "red"), "PNG", icc_profile=b"no profile")
    assert decode(broken, LONGEST)[0][0, 0].tolist() == [255, 0, 0]


@pytest.mark.parametrize("mode", ["RGBA", "LA", "P"])
def test_transparency_stays(mode):
    picture = PICTURE.convert("RGBA")
    picture.putpixel((0, 0), (255, 0, 0, 0))
    if mode == "LA":
        picture = picture.convert("LA")
    options = {}
    if mode == "P":
        picture, options = (
            PICTURE.convert("P"),
            {"transparency": PICTURE.convert("P").getpixel((0, 0))},
        )
    pixels, _, _ = decode(saved(picture, "PNG", **options), LONGEST)
    assert pixels.shape == (40, 60, 4)
    assert pixels[0, 0, 3] == 0 and pixels[-1, -1, 3] == 255


def test_transparency_is_dropped_where_there_is_none():
    assert decode(saved(PICTURE.convert("RGBA"), "PNG"), LONGEST)[0].shape == (40, 60, 3)


@pytest.mark.parametrize("kind", ["PNG", "JPEG", "TIFF", "WEBP"])
def test_a_large_image_becomes_smaller_all_the_same(kind):
    large = PICTURE.resize((600, 400), Image.Resampling.NEAREST)
    pixels, size, _ = decode(saved(large, kind), 60)
    assert size == (600, 400)
    assert off(pixels) < 6


def test_bands_leave_no_trace(monkeypatch):
    """As Pillow makes it smaller in one go; the bands are one row high."""
    random = np.random.default_rng(1)
    picture = Image.fromarray(random.integers(0, 256, (347, 211, 3), np.uint8))
    monkeypatch.setattr(pillow, "_BAND", 1)
    pixels, _, _ = decode(saved(picture, "PNG"), 100)
    whole = picture.resize((61, 100), Image.Resampling.HAMMING)
    assert np.abs(pixels.astype(int) - np.asarray(whole)).max() <= 1


def png(width, height, bits=8, rows=None) -> bytes:
    """A PNG in one grey, with so many ``rows``; they are compressed but once."""
    count = height if rows is None else rows
    row = b"\0" + bytes([200]) * (width * 3 * bits // 8)
    compressor = zlib.compressobj(1, zlib.DEFLATED, -15)
    packed = compressor.compress(row) + compressor.flush(zlib.Z_FULL_FLUSH)
    checksum = 1
    for _ in range(count):
        checksum = zlib.adler32(row, checksum)
    pixels = b"\x78\x01" + packed * count + b"\3\0" + struct.pack(">I", checksum)

    def chunk(name, data):
        checksum = struct.pack(">I", zlib.crc32(name + data))
        return struct.pack(">I", len(data)) + name + data + checksum

    header = struct.pack(">IIBBBBB", width, height, bits, 2, 0, 0, 0)
    parts = chunk(b"IHDR", header), chunk(b"IDAT", pixels), chunk(b"IEND", b"")
    return b"\x89PNG\r\n\x1a\n" + b"".join(parts)


@pytest.mark.thorough
@pytest.mark.parametrize(("width", "height", "bits"), [(15000, 10000, 8), (9000, 8000, 16)])
def test_gigantic_pngs_are_read_within_the_memory(workers, width, height, bits):
    image = read(png(width, height, bits), workers)
    assert (image.width, image.height) == (width, height)
    assert image.pixels.shape[1] == LONGEST
    assert image.pixels.flags.c_contiguous
    assert np.abs(image.pixels.astype(int) - 200).max() <= 1


def test_what_is_too_large_even_so_is_told_with_its_size(workers):
    with pytest.raises(IconstudioError, match="60,000 × 60,000 pixels"):
        read(png(60000, 60000, rows=1), workers)


@pytest.mark.parametrize("kind", ["PNG", "JPEG", "GIF", "BMP", "TIFF", "WEBP", "AVIF", "JPEG2000"])
def test_half_a_file_is_shown_with_a_remark_or_told(kind):
    random = np.random.default_rng(0)
    noise = Image.fromarray(random.integers(0, 256, (200, 200, 3), np.uint8))
    data = saved(noise, kind)
    try:
        pixels, size, remark = decode(data[: len(data) * 2 // 3], LONGEST)
    except IconstudioError as error:
        assert "cut short or damaged" in str(error)
    else:
        assert size == (200, 200) and "cut short" in remark
        there = pixels[-80:] if kind == "BMP" else pixels[:80]  # which begins with the last row
        assert there.std() > 40
    if kind in ("PNG", "JPEG"):
        assert remark


def drawing(paper: int, ink: int) -> Image.Image:
    """A thick frame on paper that is a little uneven, as scanned."""
    grey = np.full((120, 160), paper) + np.random.default_rng(0).integers(-3, 4, (120, 160))
    grey[20:100, 20:30] = grey[20:100, 130:140] = grey[20:30, 20:140] = ink
    return Image.fromarray(grey.astype(np.uint8))


CUT = [
    *(("PNG", mode) for mode in ("L", "1", "P", "RGB", "RGBA", "LA", "I;16")),
    *(("JPEG", mode) for mode in ("L", "RGB", "CMYK")),
    *(("TIFF", "L"), ("BMP", "RGB")),
]


@pytest.mark.parametrize(("paper", "ink"), [(240, 10), (12, 250)], ids=["black", "white"])
@pytest.mark.parametrize(("kind", "mode"), CUT)
def test_what_is_missing_of_a_file_that_is_cut_short_is_not_there(kind, mode, paper, ink):
    whole = drawing(paper, ink)
    if mode == "I;16":
        picture = Image.fromarray(np.asarray(whole).astype(np.uint16) * 257)
    else:
        plain = kind == "GIF" or mode == "1"
        picture = whole.point(lambda v: 255 * (v > 127)) if plain else whole
        picture = picture.convert("RGB").quantize(8) if mode == "P" else picture.convert(mode)
    data = saved(picture, kind, **({"interlace": 0} if kind == "GIF" else {}))
    pixels, _, remark = decode(data[: round(0.8 * len(data))], LONGEST)
    assert "cut short" in remark
    assert pixels.shape[2] == 4  # transparent: as paper
    seen = np.where(pixels[..., 3] > 0, pixels[..., 0], paper).astype(int)
    changed = abs(seen - np.asarray(whole)) > 90
    # Wherever the picture differs from the whole, it has lost ink, and gained none.
    at_paper = abs(np.asarray(whole).astype(int) - paper) < 20
    assert changed[at_paper].mean() < 0.01
    assert changed.mean() < 0.06


def interlaced(grey: np.ndarray) -> bytes:
    passes = ((0, 0, 8, 8), (4, 0, 8, 8), (0, 4, 4, 8), (2, 0, 4, 4), (0, 2, 2, 4), (1, 0, 2, 2))
    raw = b""
    for x, y, dx, dy in (*passes, (0, 1, 1, 2)):
        raw += b"".join(b"\0" + row.tobytes() for row in grey[y::dy, x::dx])

    def chunk(kind: bytes, data: bytes) -> bytes:
        return (
            struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))
        )

    header = struct.pack(">IIBBBBB", grey.shape[1], grey.shape[0], 8, 0, 0, 0, 1)
    packed = zlib.compress(raw)
    return (
        b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"IDAT", packed) + chunk(b"IEND", b"")
    )


@pytest.mark.parametrize("part", [0.35, 0.7, 0.95])
def test_an_interlaced_file_that_is_cut_short_is_coarser(part):
    grey = np.asarray(drawing(240, 10))
    data = interlaced(grey)
    assert np.array_equal(decode(data, LONGEST)[0][..., 0], grey)
    pixels, _, remark = decode(data[: int(part * len(data))], LONGEST)
    assert "cut short" in remark
    inner = np.s_[4:-4, 4:-4]
    assert ((pixels[..., 0] < 128) != (grey < 128))[inner].mean() < 0.05


@pytest.mark.parametrize("kind", ["PNG", "JPEG"])
def test_a_file_that_ends_in_its_header_is_told(kind):
    with pytest.raises(IconstudioError):
        decode(saved(PICTURE, kind)[:45], LONGEST)


def test_further_pictures_are_mentioned():
    other = PICTURE.transpose(Image.Transpose.ROTATE_180)
    for kind in ("GIF", "TIFF", "WEBP"):
        data = saved(PICTURE, kind, save_all=True, append_images=[other])
        pixels, _, remark = decode(data, LONGEST)
        assert "first of 2 pictures" in remark
        assert off(pixels) < 6


@pytest.mark.parametrize(
    "text",
    [
        '<svg xmlns="http://www.w3.org/2000/svg"/>',
        '\n<?xml version="1.0"?>\n<svg/>',
        "<!-- a --><svg/>",
        "<!DOCTYPE svg><svg/>",
        "<svg:svg/>",
    ],
)
@pytest.mark.parametrize("coded", ["utf-8", "utf-8-sig", "utf-16", "gzip"])
def test_an_svg_goes_to_no_reader_and_is_told(text, coded):
    import gzip

    data = gzip.compress(text.encode()) if coded == "gzip" else text.encode(coded)
    reader = FileReader()
    with pytest.raises(IconstudioError) as told:
        returned(reader.image(data))
    assert "SVG drawing, not a photo" in str(told.value)
    assert all(one.title in str(told.value) for one in workflows() if one.invitation)


@pytest.mark.parametrize(
    ("data", "sentence"),
    [
        (b"", "empty"),
        (b"Dear dog", "no picture that can be read"),
        (b"%PDF-1.7 ...", "PDF"),
        (b"%!PS-Adobe-3.0 EPSF-3.0\n%%BoundingBox: 0 0 9 9\n", "PostScript"),
        (b"\xd7\xcd\xc6\x9a" + bytes(100), "no picture"),  # WMF
        (bytes(1000), "no picture"),
        (b"\x00\x00\x00\x18ftypheic" + bytes(99), "cut short|HEIC"),
    ],
)
def test_anything_else_is_told(workers, data, sentence):
    with pytest.raises(IconstudioError, match=sentence):
        read(data, workers)


def test_what_is_no_file_is_refused_at_once(workers, tmp_path):
    start = time.monotonic()
    sources = [tmp_path, tmp_path / "gone.png", Path(os.devnull)]
    if hasattr(os, "mkfifo"):
        os.mkfifo(tmp_path / "pipe.png")
        sources.append(tmp_path / "pipe.png")
    for source in sources:
        with pytest.raises(IconstudioError, match=source.name):
            read(source, workers)
    assert time.monotonic() - start < 2


@settings(max_examples=60)
@given(st.data())
def test_damaged_files_end_in_a_picture_or_a_sentence(data):
    kind = data.draw(st.sampled_from(["PNG", "JPEG", "WEBP", "TIFF", "GIF", "BMP", "TGA", "PPM"]))
    damaged = bytearray(saved(PICTURE, kind))
    for _ in range(data.draw(st.integers(1, 8))):
        damaged[data.draw(st.integers(0, len(damaged) - 1))] = data.draw(st.integers(0, 255))
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        try:
            pixels, _, _ = decode(bytes(damaged), 64)
        except (IconstudioError, MemoryError):
            return
    assert pixels.dtype == np.uint8 and max(pixels.shape) <= 64


def test_the_settings_of_pillow_stay_as_they_were():
    from PIL import ImageFile

    before = Image.MAX_IMAGE_PIXELS
    decode(saved(PICTURE, "PNG"), LONGEST)
    with pytest.raises(IconstudioError):
        decode(b"nothing", LONGEST)
    assert before == Image.MAX_IMAGE_PIXELS and not ImageFile.LOAD_TRUNCATED_IMAGES


def test_closing_the_reading_ends_the_work(workers):
    reading = read_image(png(9000, 8000, 16), workers)
    next(reading)
    reading.close()
    start = time.monotonic()
    assert read(saved(PICTURE, "PNG"), workers).width == 60
    assert time.monotonic() - start < 20


def test_an_image_that_is_too_large_is_told_how_small_it_should_be(monkeypatch):
    monkeypatch.setattr(pillow, "MAX_PIXELS", 100)
    file = io.BytesIO()
    PICTURE.save(file, "PNG")
    with pytest.raises(IconstudioError, match=r"at most 100 pixels are read.*4,096 a side"):
        decode(file.getvalue(), 4096)
