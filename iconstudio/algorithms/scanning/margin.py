"""Bitmaps that are cropped tightly get back the margin of their page, and lose half a pixel."""

from typing import TypeVar

import numpy as np
import scipy
from numpy.typing import NDArray

T = TypeVar("T", bound=np.generic)

PAPER = 225.0
"""Levels from which a colour is that of white paper."""
TINGE = 70.0
"""Levels by which the channels of paper differ, at most."""
_LEAST, _ALL = 0.2, 0.995
"""How much of the rim shows the page, at least; a page that shows nearly all along is margin."""
_CLEAN = 2.5
"""Levels by which a page that a computer drew strays in the median; that of a scan does by more."""
_EDGE, _STEP = 3, 40.0
"""Pixels within which an edge falls from the page to a drawing, and by how many levels at least."""
_WHOLE = 0.98
"""How much of a side is all of it."""
_DARKENED, _DARKEST = 0.6, 10.0
"""How bright the last line of a picture is, as part of the line before, if it is half missing; and
grey levels that tell of noise alone."""
_FINE = 100
"""Pixels of the shorter side of a picture of which one pixel is no frame."""
_RUNS = 2
"""Pieces of the rim that are white where it is so along one side, at most."""
_STRIPE = 0.9
"""How much of its bounding box a stripe of a flag fills."""
_BROAD, _PLAIN, _OBLONG = 0.03, 0.6, 1.2
"""The least height of a stripe on white, as part of the picture's; how much of the lines beside it
is white; and how oblong a picture with a cross, or a banner, is at least."""
_MARGIN = 0.06
"""Width of the margin that is added, as part of the longer side."""


def with_margin(pixels: NDArray[np.uint8], tiles: bool = False) -> NDArray[np.uint8]:
    """Return a bitmap (h, w, 3) with more of its white page around, if what it shows is cut by it.

    So letters that touch the edge of a wordmark are neither scraps nor ground. It is as it is where
    its page shows in stripes or takes a whole side, as on flags, or, unless ``tiles``, in the
    corners alone, as beside an app icon.
    """
    if pixels.shape[2] != 3 or min(pixels.shape[:2]) < 8:
        return pixels
    rim = rim_of(pixels)
    white = rim.min(axis=1) > PAPER
    if not _LEAST < white.mean() < _ALL:
        return pixels
    page = np.median(rim[white], axis=0)
    if np.median(abs(rim[white] - page).max(axis=1)) > _CLEAN:
        return pixels
    light = pixels.min(axis=2) > PAPER
    if _is_blurred(pixels) or (not tiles and _is_in_corners(light)) or _is_flag(light):
        return pixels
    wide = round(_MARGIN * max(light.shape)) + 2
    padded = np.empty((light.shape[0] + 2 * wide, light.shape[1] + 2 * wide, 3), np.uint8)
    padded[:] = page
    padded[wide:-wide, wide:-wide] = pixels
    return padded


def without_half_lines(pixels: NDArray[np.uint8]) -> NDArray[np.uint8]:
    """Return a picture (h, w, 3) without first and last rows and columns that are dark all along.

    A drawing of a height or width of no whole pixels covers the last line in part, and in files
    without transparency the rest of that is black. Where there is a page, it is a frame.
    """
    if pixels.shape[2] == 4 or min(pixels.shape[:2]) < _FINE:
        return pixels
    height, width = pixels.shape[:2]
    turned = pixels.swapaxes(0, 1)
    top, bottom, left, right = (
        _is_half(line, inner)
        for side in (pixels, turned)
        for line, inner in ((side[0], side[2]), (side[-1], side[-3]))
    )
    return pixels[int(top) : height - bottom, int(left) : width - right]


def _is_half(line: NDArray[np.uint8], inner: NDArray[np.uint8]) -> bool:
    light = inner.max(axis=1)
    dark = (line.max(axis=1) <= _DARKENED * light + _DARKEST).mean() > _WHOLE
    on_page = (inner.min(axis=1) > PAPER).mean() > _WHOLE
    return bool(dark and light.max() > 4 * _DARKEST and not on_page)


def _is_blurred(pixels: NDArray[np.uint8]) -> bool:
    """Whether the page goes over by degrees along the rim, as into a shadow."""
    steps = []
    for side in (pixels[0], pixels[-1], pixels[:, 0], pixels[:, -1]):
        level = np.pad(side.min(axis=1).astype(float), _EDGE, mode="edge")
        at = np.flatnonzero(np.diff(level[_EDGE:-_EDGE] > PAPER)) + _EDGE
        steps += list(abs(level[at + _EDGE] - level[at - _EDGE + 1]))
    return bool(steps and np.median(steps) < _STEP)


def rim_of(pixels: NDArray[T]) -> NDArray[T]:
    """Return the pixels (n, ...) along the edge of a picture (h, w, ...), each once."""
    return np.concatenate([pixels[0], pixels[-1], pixels[1:-1, 0], pixels[1:-1, -1]])


def corners_of(pixels: NDArray[T]) -> NDArray[T]:
    """Return the pixels (4, ...) in the corners of a picture (h, w, ...)."""
    corners: NDArray[T] = pixels[[0, 0, -1, -1], [0, -1, 0, -1]]
    return corners


def box_of(mask: NDArray[np.bool_]) -> tuple[slice, slice] | None:
    """Return the rows and columns (h, w) that a mask spans; None if it is empty."""
    rows, columns = np.flatnonzero(mask.any(axis=1)), np.flatnonzero(mask.any(axis=0))
    if not len(rows):
        return None
    return slice(int(rows[0]), int(rows[-1]) + 1), slice(int(columns[0]), int(columns[-1]) + 1)


def _is_in_corners(light: NDArray[np.bool_]) -> bool:
    """Whether all corners are of the page, and the middles of all sides are not."""
    middle, centre = light.shape[0] // 2, light.shape[1] // 2
    sides = light[[0, -1, middle, middle], [centre, centre, 0, -1]]
    return bool(corners_of(light).all() and not sides.any())


def _is_flag(light: NDArray[np.bool_]) -> bool:
    """Whether what is white is a stripe, or all along one side while the other shows no page.

    What is cropped tightly touches all sides, and letters touch them more than once.
    """
    around = np.concatenate([light[0], light[:, -1], light[-1, ::-1], light[::-1, 0]])
    once = (around & ~np.roll(around, 1)).sum() <= _RUNS
    for one, other in ((light[0], light[-1]), (light[:, 0], light[:, -1])):
        least, most = sorted([one.mean(), other.mean()])
        if once and least < 1 - _WHOLE and most > _WHOLE:
            return True
    return _is_striped(light) or has_stripes(light, _WHOLE)


def _is_striped(light: NDArray[np.bool_]) -> bool:
    """Whether most of what is white along the rim belongs to rectangles."""
    pieces, _ = scipy.ndimage.label(light)
    on_rim = np.bincount(rim_of(pieces).ravel(), minlength=pieces.max() + 1)
    on_rim[0] = 0
    stripes = 0
    boxes = scipy.ndimage.find_objects(pieces)
    for number in np.flatnonzero(on_rim):
        if (pieces[boxes[number - 1]] == number).mean() > _STRIPE:
            stripes += on_rim[number]
    return bool(2 * stripes > on_rim.sum())


def has_stripes(light: NDArray[np.bool_], beside: float = _PLAIN) -> bool:
    """Whether stripes or a cross that are not ``light`` run from side to side, as on flags.

    Of the lines beside a stripe, so much is light. One stripe is none, and in a square picture, a
    cross may be a plus sign.
    """
    down, across = _stripes(light, beside), _stripes(light.T, beside)
    height, width = light.shape
    return max(down, across) > 1 or (down + across > 1 and width > _OBLONG * height)


def is_banner(ground: NDArray[np.bool_]) -> bool:
    """Whether what is around (h, w) holds letters or the like, as a banner does, and no page."""
    height, width = ground.shape
    _, pieces = scipy.ndimage.label(~ground)
    return bool(pieces > 1 and width > _OBLONG * height)


def _stripes(light: NDArray[np.bool_], least: float) -> int:
    """Return how many stripes run across, with straight edges and light beside them."""
    across = np.pad(light.mean(axis=1) < 1 - _WHOLE, _EDGE, mode="edge")
    # Of an edge, some lines may be light.
    across = scipy.ndimage.binary_closing(across, np.ones(_EDGE))[_EDGE:-_EDGE]
    bands, _ = scipy.ndimage.label(across)
    found = 0
    for (band,) in scipy.ndimage.find_objects(bands):
        beside = [
            row for row in (band.start - _EDGE, band.stop + _EDGE - 1) if 0 <= row < len(light)
        ]
        straight = all(light[row].mean() > least for row in beside)
        found += straight and band.stop - band.start > _BROAD * len(light)
    return found
