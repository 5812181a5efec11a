"""Photos to trace over, made of images."""

import io
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from iconstudio.files import read_bytes, write_bytes
from iconstudio.images.reading import MAX_BYTES, SUFFIXES, Image
from iconstudio.model import Photo

_LARGE = 64_000_000
"""Of a file with more bytes, only the pixels that are shown are kept."""
_HEADS = {".png": b"\x89PNG", ".jpg": b"\xff\xd8", ".webp": b"RIFF", ".gif": b"GIF8"}
"""How files of images begin."""
_SMALLEST = 256
"""A copy's shorter side has no fewer pixels."""


def photo_of(image: Image, path: str = "", data: bytes = b"") -> Photo:
    """Return an image as a photo.

    Parameters
    ----------
    path, data
        The file that it was read from, if any, and what is in it.
    """
    # By NumPy, which lets other threads work on.
    levels = [_premultiplied(image.pixels)]
    while min(levels[-1].shape[:2]) >= 2 * _SMALLEST:
        levels.append(_halved(levels[-1]))
    kept, suffix = _file_of(image, path, data)
    words = tuple(map(_packed, levels))
    return Photo(path, image.width, image.height, words, image.remark, kept, suffix)


def photo_from(path: Path, image: Image) -> Photo:
    """Return the image that was read from a file as a photo.

    Raises
    ------
    IconstudioError
        If the file cannot be read any more.
    """
    return photo_of(image, str(path), read_bytes(path, MAX_BYTES))


def file_beside(photo: Photo, path: Path) -> Path:
    """Return the file of a photo; what was in none, pasted say, is written beside ``path``.

    Raises
    ------
    IconstudioError
        If it cannot be written.
    """
    if photo.path:
        return Path(photo.path)
    file = path.resolve().parent / f"{path.stem}-photo{photo.suffix}"
    write_bytes(file, photo.data)
    return file


def _file_of(image: Image, path: str, data: bytes) -> tuple[bytes, str]:
    """Return a file of an image, and its suffix: the one it was in, unless that is huge."""
    if 0 < len(data) <= _LARGE:
        suffix = Path(path).suffix.lower()
        if suffix[1:] not in SUFFIXES:
            suffix = next((one for one, head in _HEADS.items() if data.startswith(head)), ".image")
        return data, suffix
    from PIL import Image as Pixels

    file = io.BytesIO()
    Pixels.fromarray(image.pixels).save(file, "PNG", compress_level=1)
    return file.getvalue(), ".png"


def _premultiplied(pixels: NDArray[np.uint8]) -> NDArray[np.uint8]:
    """Return (h, w, 4) RGBA, the colours multiplied by alpha."""
    height, width, channels = pixels.shape
    whole = np.full((height, width, 4), 255, np.uint8)
    whole[..., :channels] = pixels
    if channels == 4:
        alpha = pixels[..., 3:].astype(np.uint16)
        whole[..., :3] = (pixels[..., :3] * alpha + 127) // 255
    return whole


def _halved(pixels: NDArray[np.uint8]) -> NDArray[np.uint8]:
    """Return half as many pixels a side, each the mean of four; an odd last one is left out."""
    height, width = pixels.shape[0] // 2 * 2, pixels.shape[1] // 2 * 2
    total = np.full((height // 2, width // 2, 4), 2, np.uint16)
    for y in (0, 1):
        for x in (0, 1):
            total += pixels[y:height:2, x:width:2]
    return (total // 4).astype(np.uint8)


def _packed(pixels: NDArray[np.uint8]) -> NDArray[np.uint32]:
    """Return premultiplied (h, w, 4) RGBA as words 0xAARRGGBB, which screens draw fastest."""
    words = np.zeros(pixels.shape[:2], np.uint32)
    for channel, shift in enumerate((16, 8, 0, 24)):
        words |= pixels[..., channel].astype(np.uint32) << np.uint32(shift)
    return words
