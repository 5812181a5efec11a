"""Decodes pictures made of pixels: the adapter of Pillow, and of pillow-heif where it is there.

Only formats whose readers run nothing and read no other file; they are told by content. Call this
in a worker process: a picture comes from outside, and may be made to crash or to fill the memory.
"""

import io
import math
import re
import warnings
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from iconstudio.images.truncated import coarser, without_missing
from iconstudio.model import IconstudioError
from iconstudio.svg import signatures

if TYPE_CHECKING:
    from PIL.Image import Image as PillowImage

FORMATS = (
    *("PNG", "JPEG", "MPO", "WEBP", "AVIF", "HEIF", "TIFF", "GIF", "BMP", "JPEG2000"),
    *("PPM", "QOI", "ICO", "ICNS", "PSD", "SGI", "PCX", "DDS", "TGA"),
)
"""What is tried, in this order: TGA last, for nothing but its numbers tells it."""

MAX_PIXELS = 300_000_000
"""Of a picture when it is decoded: 1.2 GB."""

_MAGIC = re.compile(
    rb"\x89PNG|\xff\xd8\xff|RIFF....WEBP|GIF8[79]a|II[*+]\0|MM\0[*+]|BM......|P[1-6]\s|qoif"
    rb"|....ftyp(?:avi|hei|hev|mif1|msf1)|\0\0\0\x0cjP  |\xff\x4f\xff\x51|8BPS|icns|DDS "
    rb"|\0\0[\x01\x02]\0|\x0a[\0-\x05]\x01|\x01\xda[\0\x01][\x01\x02]",
    re.DOTALL,
)
"""How files of images begin."""
_BAND = 1 << 24
"""Pixels that are turned into plain colours at a time."""
_TURNED = {2: 0, 3: 3, 4: 1, 5: 5, 6: 4, 7: 6, 8: 2}
"""For each orientation that EXIF knows, Pillow's number of the transposition that undoes it."""
_PREVIEW = 1
"""Bit of TIFF's NewSubfileType: a smaller version of another picture in the file."""
_BLOCK = 16
"""Rows that JPEG decodes at a time."""
_ONE_PICTURE = ("MPO", "PSD", "ICO", "ICNS")
"""Formats whose further pictures are layers, sizes or views of the same."""

CUT_SHORT = "The file is cut short or damaged; what can be read of it is shown."
DAMAGED = "The file is cut short or damaged."
_UNREADABLE = "It is cut short or damaged: nothing of it can be shown. Save or copy it again."


def is_image(data: bytes, name: str = "") -> bool:
    """Whether ``data`` begin as the file of an image does; a TGA file is known by its name."""
    return _MAGIC.match(data) is not None or name.lower().endswith(".tga")


def decode(data: bytes, longest: int) -> tuple[NDArray[np.uint8], tuple[int, int], str]:
    """Decode the first picture in ``data``, upright, in sRGB, at most ``longest`` pixels a side.

    Returns
    -------
    pixels, size, remark:
        The picture, (height, width, 3) or, where some of it is transparent, (height, width, 4);
        its width and height before it was made smaller; a sentence about what is not shown, or "".

    Raises
    ------
    IconstudioError
        If it is in no format of ``FORMATS``, damaged, or too large; the sentence calls it “it”.
    """
    with _as_pillow_likes_it(truncated=False), warnings.catch_warnings():
        warnings.simplefilter("ignore")
        try:
            return _decoded(data, longest)
        except (IconstudioError, MemoryError):
            raise
        except Exception:  # whatever readers of foreign formats raise; a little may be there still
            pixels, size = _what_is_there(data, longest)
    if (pixels == pixels[:1, :1]).all():
        raise IconstudioError(_UNREADABLE)
    return pixels, size, CUT_SHORT


def _what_is_there(data: bytes, longest: int) -> tuple[NDArray[np.uint8], tuple[int, int]]:
    """Decode as much as can be read of a damaged file; see ``decode``."""
    from PIL import UnidentifiedImageError

    try:
        with _as_pillow_likes_it(truncated=True):
            return _decoded(data, longest, damaged=True)[:2]
    except (IconstudioError, MemoryError):
        raise
    except UnidentifiedImageError:
        raise IconstudioError(_what(data)) from None
    except Exception:
        raise IconstudioError(_UNREADABLE) from None


def _decoded(
    data: bytes, longest: int, damaged: bool = False
) -> tuple[NDArray[np.uint8], tuple[int, int], str]:
    from PIL import Image

    with _opened(data) as file:
        width, height = file.size
        if max(width, height) > longest:
            file.draft(None, (longest, longest))  # JPEG can be decoded smaller
        if file.width * file.height > MAX_PIXELS:
            raise IconstudioError(
                f"It is too large ({width:,} × {height:,} pixels): at most {MAX_PIXELS:,} pixels "
                f"are read. Scale it down, for example to {longest:,} a side: more are not used."
            )
        remark = _remark(file)
        interlaced = damaged and _interlaced(file)
        file.load()
        turned = _TURNED.get(_orientation(file, data))
        image = _smaller(_coarser(file) if interlaced else file, longest)
        image = _in_srgb(image, file.info.get("icc_profile"))
        if damaged:
            block = _BLOCK if file.format in ("JPEG", "MPO") else 1
            image = Image.fromarray(
                without_missing(np.asarray(image), block, upwards=file.format == "BMP")
            )
    if turned is not None:
        image = image.transpose(Image.Transpose(turned))
        if turned in (2, 4, 5, 6):
            width, height = height, width
    if image.mode == "RGBA" and image.getchannel("A").getextrema()[0] == 255:
        image = image.convert("RGB")
    return np.asarray(image), (width, height), remark


def _opened(data: bytes) -> Any:
    from PIL import Image

    Image.init()
    with suppress(ImportError):  # not on every system
        from pillow_heif import register_heif_opener

        register_heif_opener(thumbnails=False)
    return Image.open(io.BytesIO(data), formats=[one for one in FORMATS if one in Image.OPEN])


def _what(data: bytes) -> str:
    """Say why data are no picture."""
    start = data[:512].lower()
    if start.startswith(b"%pdf") or start.startswith(b"%!"):
        return "It is a PDF or PostScript document. Save its page as a PNG file."
    if start[4:8] == b"ftyp" and start[8:12] in (b"heic", b"heix", b"mif1", b"msf1"):
        return "It is an HEIC picture that cannot be read here. Save it as a JPEG file."
    if is_image(data):
        return _UNREADABLE
    return signatures.binary(data) or (
        "It is no picture that can be read. Choose a PNG, JPEG, WebP, AVIF, HEIC, TIFF, GIF, BMP, "
        "JPEG 2000 or TGA file."
    )


def _remark(file: Any) -> str:
    """Say what of a file is not shown."""
    if file.format == "TIFF" and file.tag_v2.get(254, 0) & _PREVIEW:
        return "This is the small preview of a camera's raw file. Develop it to see it sharp."
    count = getattr(file, "n_frames", 1)
    if count > 1 and file.format not in _ONE_PICTURE:
        return f"This is the first of {count:,} pictures in the file."
    return ""


def _interlaced(file: Any) -> bool:
    """Whether the rows of a file that is not loaded yet come in passes, ever finer."""
    if file.format == "GIF":
        return bool(file.tile and file.tile[0][3][1])
    return bool(file.format == "PNG" and file.info.get("interlace"))


def _coarser(file: Any) -> "PillowImage":
    """Return an interlaced image as it is after its last whole pass, at its own size."""
    from PIL import Image

    plain = _plain(file, file.info.get("transparency"), _range(file))
    found = Image.fromarray(coarser(np.asarray(plain)), plain.mode)
    return found.resize(file.size, Image.Resampling.BILINEAR)


def _orientation(file: Any, data: bytes) -> int:
    """Return the orientation that EXIF or XMP tells; 1 if none."""
    from PIL.ExifTags import Base

    if file.format == "HEIF":  # its own turns, which are done already, count for more than EXIF's
        own = b"irot" in data or b"imir" in data
        return 1 if own else int(file.info.get("original_orientation") or 1)
    try:
        return int(file.getexif().get(Base.Orientation, 1))
    except Exception:  # damaged EXIF: the picture is worth more than its orientation
        return 1


def _smaller(image: "PillowImage", longest: int) -> "PillowImage":
    """Return an image in plain colours with at most ``longest`` pixels a side.

    Band by band, so that a gigantic image is never in memory twice.
    """
    from PIL import Image

    transparency, stretch = image.info.get("transparency"), _range(image)
    scale = max(image.size) / longest
    if scale <= 1:
        return _plain(image.copy(), transparency, stretch)
    width, height = (max(1, round(side / scale)) for side in image.size)
    rows = max(1, round(_BAND / image.width / scale))
    reach = math.ceil(scale) + 1  # of the filter, beyond a band
    whole = None
    for top in range(0, height, rows):
        bottom = min(top + rows, height)
        first, last = top * image.height / height, bottom * image.height / height
        above = max(0, math.floor(first) - reach)
        below = min(image.height, math.ceil(last) + reach)
        band = _plain(image.crop((0, above, image.width, below)), transparency, stretch)
        band = band.resize(
            (width, bottom - top),
            Image.Resampling.HAMMING,
            (0, first - above, image.width, last - above),
        )
        whole = whole or Image.new(band.mode, (width, height))
        whole.paste(band, (0, top))
    assert whole is not None
    return whole


def _plain(image: "PillowImage", transparency: Any, stretch: tuple[float, float]) -> "PillowImage":
    """Return an image of 8 bits a channel: L, RGB, RGBA, CMYK or LAB."""
    from PIL import Image

    mode = image.mode
    if mode[0] in "IF":
        low, high = stretch
        values = np.nan_to_num(np.asarray(image, np.float32), nan=low, posinf=high, neginf=low)
        scaled = np.clip((values - low) * (255 / (high - low)), 0, 255)
        return Image.fromarray(np.rint(scaled).astype(np.uint8))
    if transparency is not None and mode in ("1", "L", "P", "RGB"):
        image.info["transparency"] = transparency
        return image.convert("RGBA")
    if mode in ("PA", "LA", "La", "RGBa"):
        return image.convert("RGBA")
    if mode == "1":
        return image.convert("L")
    if mode in ("L", "RGB", "RGBA", "CMYK", "LAB"):
        return image
    return image.convert("RGB")


def _range(image: "PillowImage") -> tuple[float, float]:
    """Return the values of black and white of an image with more than 8 bits a channel."""
    if image.mode.startswith("I;16"):
        return 0.0, 65535.0
    if image.mode not in ("I", "F"):
        return 0.0, 255.0
    low, high = 0.0, 0.0
    for top in range(0, image.height, 256):
        band = np.asarray(image.crop((0, top, image.width, min(top + 256, image.height))))
        band = band[np.isfinite(band)]
        if band.size:
            low, high = min(low, float(band.min())), max(high, float(band.max()))
    # What programs take for white; else, as for measurements, the largest value that occurs.
    usual = (1.0, 255.0, 65535.0) if image.mode == "F" else (255.0, 65535.0)
    white = next((one for one in usual if high <= one), high)
    return (0.0 if low >= 0 else low), (white if low >= 0 else max(high, low + 1))


def _in_srgb(image: "PillowImage", profile: bytes | None) -> "PillowImage":
    """Return an image as RGB or RGBA in sRGB; ``profile`` says what its numbers mean."""
    from PIL import ImageCms

    mode = "RGBA" if image.mode == "RGBA" else "RGB"
    try:
        if profile:
            given = ImageCms.ImageCmsProfile(io.BytesIO(profile))
        elif image.mode == "LAB":
            given = ImageCms.ImageCmsProfile(ImageCms.createProfile("LAB"))
        else:
            return image.convert(mode)
        srgb = ImageCms.createProfile("sRGB")
        converted = ImageCms.profileToProfile(image, given, srgb, outputMode=mode)
        return image if converted is None else converted  # None: in place, which is not asked for
    except (ImageCms.PyCMSError, OSError, ValueError):  # no good, or for other channels than these
        if image.mode == "LAB":
            return image.getchannel("L").convert(mode)
        return image.convert(mode)


@contextmanager
def _as_pillow_likes_it(truncated: bool) -> Iterator[None]:
    """Let Pillow read large pictures, which have limits of our own, and perhaps ``truncated`` ones.

    Its settings are those of the whole process, which has other uses for Pillow.
    """
    from PIL import Image, ImageFile

    before = Image.MAX_IMAGE_PIXELS, ImageFile.LOAD_TRUNCATED_IMAGES
    Image.MAX_IMAGE_PIXELS, ImageFile.LOAD_TRUNCATED_IMAGES = None, truncated
    try:
        yield
    finally:
        Image.MAX_IMAGE_PIXELS, ImageFile.LOAD_TRUNCATED_IMAGES = before
