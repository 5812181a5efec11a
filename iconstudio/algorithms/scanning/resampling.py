"""Bitmaps at other resolutions."""

from functools import lru_cache

import numpy as np
import scipy
from numpy.typing import NDArray

from iconstudio.algorithms.extremes import maximum_filter

COARSE = 6
"""How many times a bitmap must be enlarged for its shapes to be reconstructed."""
_FINER, _FINEST = 8, 160
"""Pixels to a side into which one is divided for that, so that there are no more than so many."""
_ROUNDS, _WIDTH, _STEEP = 12, 0.3, 3.0
"""How often shapes are smoothed and corrected; by how much, in pixels; how steep edges are then."""
_GAIN, _KEPT = 1.5, 0.7
"""What of an error is added each time, and what of it is kept."""
_SOFT, _FULL, _BROAD, _NEAR = 0.5, 0.9, 4, 5
"""Pixels by which edges between wide shapes are smoothed in the end; how much of a pixel such a
shape takes, how many of these it is wide, and within how many across it lies."""
_CORNER = 0.16
"""How much less or more than half is inside a contour, seen so, where it has a corner."""
_SLACK, _NOISY = 0.25, 0.15
"""What part of a pixel may be amiss where there are no greys, and in lossy files."""
_TINY, _PAINTS, _CLEAR = 12, 4, 32
"""Pixels of the longer side of tiny pixel art, and its colours, at most; pixels by which it is told
as what it is."""
_PURE, _FEW = 0.95, 0.2
"""How much of a pixel a shape takes that has it all; how many greys a corner has at least."""


def in_squares(pixels: NDArray[np.uint8]) -> NDArray[np.uint8]:
    """Return tiny pixel art (h, w, c) with larger squares: of so few pixels, none is an edge.

    Anything else, as what has the greys of edges, is as it is.
    """
    longest = max(pixels.shape[:2])
    if longest > _TINY or len(np.unique(pixels.reshape(-1, pixels.shape[2]), axis=0)) > _PAINTS:
        return pixels
    times = -(-_CLEAR // longest)
    return pixels.repeat(times, axis=0).repeat(times, axis=1)


def shrunk(pixels: NDArray[np.uint8], step: int) -> NDArray[np.float32]:
    """Return means of ``step`` x ``step`` pixels, from 0 to 1; colours weighted by their alpha."""
    height, width, channels = pixels.shape
    pad = [(0, -height % step), (0, -width % step), (0, 0)]
    padded = np.pad(pixels, pad, mode="edge") if step > 1 else pixels
    rows, columns = padded.shape[0] // step, padded.shape[1] // step
    blocks = padded.reshape(rows, step, columns, step, channels)
    if channels == 3 or step == 1:
        means: NDArray[np.float32] = blocks.mean(axis=(1, 3), dtype=np.float32)
        return means / np.float32(255)
    alpha = blocks[..., 3:].astype(np.float32)
    total = alpha.sum(axis=(1, 3))
    colours = (blocks[..., :3] * alpha).sum(axis=(1, 3)) / np.maximum(total, 1)
    return np.concatenate([colours, total / step**2], axis=2, dtype=np.float32) / np.float32(255)


def reconstructed(
    parts: NDArray[np.float32], shape: tuple[int, ...], slack: float = 0.0
) -> NDArray[np.float32]:
    """Return how much of each pixel each of k shapes covers, at a higher resolution.

    ``parts`` (k, h, w) add up to 1. Of a small bitmap, the shapes have short, smooth contours and
    cover as much of each of its pixels as is given: by turns they are smoothed, made sharp, and
    corrected by what is amiss (threshold dynamics: B. Merriman, J. Bence, S. Osher, 1992; S.
    Esedoglu, F. Otto, 2015). So lines of a pixel are straight, and keep their width. Where there
    are no greys, squares are squares, but steps of one pixel are contours that run aslant. So much
    as ``slack`` of a pixel may be amiss.
    """
    count, height, width = parts.shape
    if shape[0] < COARSE * height:
        return np.stack([resized(one, shape) for one in parts])
    jagged = _has_no_greys(parts)
    if jagged and not _has_steps(parts.argmax(axis=0)):
        rows, columns = (
            np.arange(n) * old // n for n, old in zip(shape, parts.shape[1:], strict=True)
        )
        return parts[:, rows[:, None], columns]
    slack = max(slack, _SLACK if jagged else 0)
    finer = max(2, min(_FINER, _FINEST // max(height, width)))
    block = np.ones((1, finer, finer), np.float32)
    sharp = _sharpened(np.stack([resized(one, (height * finer, width * finer)) for one in parts]))
    error = np.zeros_like(parts)
    for _ in range(_ROUNDS):
        smooth = scipy.ndimage.gaussian_filter(
            sharp + np.kron(error, block), (0, _WIDTH * finer, _WIDTH * finer), mode="nearest"
        )
        sharp = _sharpened(smooth)
        covered = sharp.reshape(count, height, finer, width, finer).mean(axis=(2, 4))
        amiss = parts - covered
        if slack:
            amiss -= np.clip(amiss, -slack, slack)
        error = _KEPT * error + _GAIN * amiss
    if count == 2:
        softer = scipy.ndimage.gaussian_filter(smooth, (0, _SOFT * finer, _SOFT * finer))
        between = _between_wide_shapes(parts).repeat(finer, 0).repeat(finer, 1)
        smooth = np.where(between & ~_at_corners(smooth[0], softer[0], finer), softer, smooth)
    return np.stack([resized(np.clip(one, 0, 1), shape) for one in smooth])


def _between_wide_shapes(parts: NDArray[np.float32]) -> NDArray[np.bool_]:
    """Return which pixels (h, w) lie where two shapes meet that are no lines.

    There, what is left of steps can be smoothed away without making anything thinner.
    """
    wide = scipy.ndimage.binary_opening(parts > _FULL, np.ones((1, _BROAD, _BROAD)))
    near = maximum_filter(wide, (1, _NEAR, _NEAR))
    every: NDArray[np.bool_] = np.logical_and.reduce(near)
    return every


def _at_corners(
    part: NDArray[np.float32], softer: NDArray[np.float32], pixel: int
) -> NDArray[np.bool_]:
    """Return where within a pixel of a contour there is a corner of it, which would be lost."""
    inside = part > 0.5
    contour = inside & ~scipy.ndimage.binary_erosion(inside, border_value=1)
    corners = contour & (abs(softer - 0.5) > _CORNER)
    near: NDArray[np.bool_] = maximum_filter(corners, 2 * pixel + 1)
    return near


def numbered(
    parts: NDArray[np.float32], shape: tuple[int, ...], ground: int | None, lossy: bool = False
) -> NDArray[np.intp]:
    """Return the number of the shape (k, h, w) that each pixel at a higher resolution is of.

    Where the ``ground`` is, if one is given, is told by its own part alone, whatever meets there.
    ``lossy`` files tell how much of a pixel a shape takes but nearly.
    """
    slack = _NOISY if lossy else 0.0
    larger = reconstructed(parts, shape, slack)
    if ground is not None and not _has_no_greys(parts):
        outside = reconstructed(np.stack([parts[ground], 1 - parts[ground]]), shape, slack)[0] > 0.5
        larger[ground] = np.where(outside, 2, -1)
    number: NDArray[np.intp] = larger.argmax(axis=0)
    return number


def _sharpened(parts: NDArray[np.float32]) -> NDArray[np.float32]:
    """Return parts (k, h, w) that are nearly 1 where they are the largest, and else nearly 0."""
    second, first = np.partition(parts, -2, axis=0)[-2:]
    others = np.where(parts == first, second, first)
    sharp: NDArray[np.float32] = np.clip(0.5 + (parts - others) / 2 * _STEEP, 0, 1)
    return sharp


def _has_no_greys(parts: NDArray[np.float32]) -> bool:
    """Whether pixels at the corners of shapes have no greys, which tell how round these are."""
    labels = parts.argmax(axis=0)
    one, right, below, across = _squares(labels)
    corners = ((one != right) | (below != across)) & ((one != below) | (right != across))
    greys = parts.max(axis=0) < _PURE
    return bool(greys.sum() <= _FEW * corners.sum())


def _has_steps(labels: NDArray[np.intp]) -> bool:
    """Whether contours run in steps of one pixel, as aslant or round ones do without greys.

    Where pixels touch at their corners, steps are the shape's own.
    """
    one, right, below, across = _squares(labels)
    falling = (one == across) & (one != right) & (one != below)
    rising = (right == below) & (right != one) & (right != across)
    if (falling | rising).any():
        return False
    for turned in (labels, labels.T):
        a, b, c = turned[:-1, :-2], turned[:-1, 1:-1], turned[:-1, 2:]
        d, e, f = turned[1:, :-2], turned[1:, 1:-1], turned[1:, 2:]
        up = (a == b) & (b != c) & (d != e) & (e == f)
        down = (a != b) & (b == c) & (d == e) & (e != f)
        if ((b != e) & (up | down)).any():
            return True
    return False


def _squares(labels: NDArray[np.intp]) -> tuple[NDArray[np.intp], ...]:
    """Return the upper left, upper right, lower left and lower right of all four pixels."""
    return labels[:-1, :-1], labels[:-1, 1:], labels[1:, :-1], labels[1:, 1:]


def resized(values: NDArray[np.float32], shape: tuple[int, ...]) -> NDArray[np.float32]:
    """Return (h, w) or (h, w, c) values at another resolution: smooth, without overshooting."""
    from skimage.transform import resize

    if values.shape[:2] == tuple(shape):
        return values
    if shape[0] >= values.shape[0]:
        (height, width), (rows, columns) = values.shape[:2], shape
        tall = np.tensordot(_enlarging(height, rows), values, 1)
        large = np.moveaxis(np.tensordot(tall, _enlarging(width, columns), (1, 1)), -1, 1)
        return np.clip(large, values.min(), values.max())
    reduced: NDArray[np.float32] = resize(
        values, shape, order=1, mode="edge", anti_aliasing=True, clip=True
    ).astype(np.float32)
    return reduced


@lru_cache(maxsize=8)
def _enlarging(before: int, after: int) -> NDArray[np.float32]:
    """Return the matrix (after, before) of a cubic spline through pixels.

    It is what becomes of single pixels. Its product with a picture is the picture enlarged, 20
    times as fast as by way of all pixels of all channels around each.
    """
    from skimage.transform import resize

    pixels = np.eye(before)
    matrix: NDArray[np.float32] = resize(
        pixels, (after, before), order=3, mode="edge", anti_aliasing=False, clip=False
    ).astype(np.float32)
    return matrix


def premultiplied(pixels: NDArray[np.float32]) -> NDArray[np.float32]:
    """Return colours (h, w, 3 or 4), of levels up to 255, times alpha, and alpha: (h, w, 4)."""
    alpha = pixels[..., 3:] if pixels.shape[2] == 4 else np.full_like(pixels[..., :1], 255)
    return np.concatenate([pixels[..., :3] * (alpha / 255), alpha], axis=2)
