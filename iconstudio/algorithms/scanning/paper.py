"""Where the paper lies on a photo, and how brightly each part of it is lit."""

from collections.abc import Iterator

import numpy as np
import scipy
from numpy.typing import NDArray

from iconstudio.algorithms.scanning.quadratic import quadratic
from iconstudio.algorithms.scanning.sheet import sheet_on_desk

_EDGE = 1 / 30
"""Width of the edge of the paper, as part of the picture's shorter side; it holds no drawing."""
_ROUNDS = 3
_NEAR = 0.15
"""By how much paper may differ from what its lighting is thought to be, as part of that."""
_BLUR = 1.5
"""Pixels over which brightness is averaged before it is asked how steeply it falls."""
_STEEP = 0.03
"""Where the logarithm of brightness changes by more from pixel to pixel, paper ends."""
_NOISY, _STEEPEST = 3.5, 0.1
"""So many times what is usual on a picture is steep, too, but no more than this."""
_DIM = 0.1
"""Brightness below which logarithms would tell of noise alone."""
_FEWEST = 20
"""Pixels of the smallest piece of paper."""
_ENOUGH = 0.3
"""Where so much of the surroundings is paper, nothing farther away tells of the lighting."""
_DARKEST = 0.04
_REACHING = 0.12
"""So much of the edge of the sheet is of a piece of paper in the shadow."""
_BESIDE = 0.2
"""So much of a piece of paper in the shadow is nearer to other paper there than to any in light."""
_SHADE, _TINGE = 0.4, 0.12
"""Paper in the shadow is so bright at least, and its colour differs by no more, as parts of those
of paper in the light."""
_DEEPEST, _INK, _DRAWN, _BESIDE_IT = 0.12, 0.6, 0.001, 6
"""It may be darker if ink is on it: so dark beside it, as part of its brightness, covering so much,
and no more than so many pixels away."""


def page(picture: NDArray[np.float32], sheet: NDArray[np.bool_] | None = None) -> NDArray[np.bool_]:
    """Return (h, w) where the sheet lies that is drawn upon; everywhere if no desk is seen.

    Where the ``sheet`` is may be known.
    """
    if sheet is None:
        sheet = sheet_on_desk(picture)
    if sheet is None:
        return np.ones(picture.shape[:2], bool)
    width = max(2, round(_EDGE * min(sheet.shape) / 2))
    inner: NDArray[np.bool_]
    inner = scipy.ndimage.binary_erosion(sheet, iterations=width, border_value=1)
    return inner


def lighting(picture: NDArray[np.float32], valid: NDArray[np.bool_]) -> NDArray[np.float32]:
    """Return (h, w, 3) the colour of the paper everywhere, also below a drawing darker than it.

    Light changes gradually, but where ink begins brightness falls steeply. So paper is what the
    edge of the sheet is part of, up to such a fall; and other such pieces if they are as bright
    as the paper around lets expect.
    """
    labels, count = scipy.ndimage.label(valid & ~_steep(picture))
    sizes = np.bincount(labels.ravel(), minlength=count + 1)
    edge = _edge(valid)
    at_edge = np.bincount(labels[edge], minlength=count + 1)
    at_edge[0] = 0
    paper = labels == np.argmax(at_edge)
    if at_edge.max() < _FEWEST:
        middle = np.clip(np.median(picture[edge], axis=0), 0, None)
        return np.broadcast_to(middle, picture.shape).astype(np.float32)
    shade = np.isin(labels, _in_shadow(picture, labels, at_edge)) & ~paper
    paper |= shade
    pieces = 1 + np.flatnonzero(sizes[1:] >= _FEWEST)
    for _ in range(_ROUNDS):
        ground = _surface(picture, paper)
        grown = paper | np.isin(labels, pieces[_alike(picture, ground, labels, pieces)])
        if shade.any():
            # What a drawing encloses in the shadow, next to its edge.
            beside = scipy.ndimage.mean(_nearest(shade, paper), labels, pieces) > _BESIDE
            dark = beside & _alike(picture, _surface(picture, shade), labels, pieces)
            shade |= np.isin(labels, pieces[dark])
            grown |= shade
        if (grown == paper).all():
            break
        paper = grown
    return ground


def _alike(
    picture: NDArray[np.float32],
    ground: NDArray[np.float32],
    labels: NDArray[np.int32],
    pieces: NDArray[np.int64],
) -> NDArray[np.bool_]:
    """Return which pieces have the colour of the ground, on average."""
    off = (picture - ground) / np.maximum(ground, _DARKEST)
    means = [scipy.ndimage.mean(off[..., c], labels, pieces) for c in range(3)]
    alike: NDArray[np.bool_] = np.all(abs(np.stack(means)) < _NEAR, axis=0)
    return alike


def _nearest(shape: NDArray[np.bool_], among: NDArray[np.bool_]) -> NDArray[np.bool_]:
    """Return (h, w) whether ``shape`` has the nearest pixel ``among`` all others."""
    rows, columns = scipy.ndimage.distance_transform_edt(
        ~among, return_distances=False, return_indices=True
    )
    nearest: NDArray[np.bool_] = shape[rows, columns]
    return nearest


def _in_shadow(
    picture: NDArray[np.float32], labels: NDArray[np.int32], at_edge: NDArray[np.int64]
) -> NDArray[np.int64]:
    """Return pieces of paper that a shadow with a sharp edge parts from the largest.

    They are darker, of the same colour, and reach the edge of the sheet, as a drawing rarely does.
    What is so dark that it may be ink has a drawing upon it that is darker still.
    """
    pieces = np.flatnonzero(at_edge > _REACHING * at_edge.sum())
    means = np.stack([scipy.ndimage.mean(picture[..., c], labels, pieces) for c in range(3)])
    means = np.clip(means, _DARKEST, None)
    ratio = means / means[:, pieces == np.argmax(at_edge)]
    same = np.ptp(ratio, axis=0) < _TINGE * ratio.mean(axis=0)
    shade = ratio.mean(axis=0)
    deep = np.minimum(shade, 1 / shade)
    darker = np.where(shade < 1, pieces, np.argmax(at_edge))
    paper = same & (deep > _DEEPEST)
    for i in np.flatnonzero(paper & (deep <= _SHADE)):
        paper[i] = _is_drawn_upon(picture.mean(axis=2), labels == darker[i])
    found: NDArray[np.int64] = pieces[paper]
    return found


def _is_drawn_upon(light: NDArray[np.float32], piece: NDArray[np.bool_]) -> bool:
    """Whether something much darker lies beside a piece of paper, in it or around it."""
    beside = scipy.ndimage.binary_dilation(piece, iterations=_BESIDE_IT) & ~piece
    ink = beside & (light < _INK * np.median(light[piece]))
    return bool(ink.sum() > _DRAWN * piece.sum())


def _steep(picture: NDArray[np.float32]) -> NDArray[np.bool_]:
    """Return (h, w) where brightness falls as light does not."""
    logarithm = np.log(np.clip(picture, 0, None) + _DIM)
    slopes = [
        scipy.ndimage.gaussian_gradient_magnitude(logarithm[..., c], _BLUR, mode="nearest")
        for c in range(3)
    ]
    slope = np.max(slopes, axis=0)
    least = np.clip(_NOISY * np.median(slope), _STEEP, _STEEPEST)
    steep: NDArray[np.bool_] = scipy.ndimage.binary_dilation(slope > least)
    return steep


def trend(picture: NDArray[np.float32], valid: NDArray[np.bool_]) -> NDArray[np.float32]:
    """Return (h, w, 3) what the edge of the sheet alone lets expect of the paper's colour."""
    return quadratic(picture, _edge(valid))


def _edge(valid: NDArray[np.bool_]) -> NDArray[np.bool_]:
    width = max(2, round(_EDGE * min(valid.shape)))
    edge: NDArray[np.bool_] = valid & ~scipy.ndimage.binary_erosion(valid, iterations=width)
    return edge


def _surface(picture: NDArray[np.float32], paper: NDArray[np.bool_]) -> NDArray[np.float32]:
    """Return (h, w, 3): the trend of the paper, and what differs from it near by."""
    surface = quadratic(picture, paper)
    known = paper[..., None].astype(np.float32)
    lit: NDArray[np.float32] = surface + _filled((picture - surface) * known, known)
    return np.clip(lit, 0, None)


def _filled(sums: NDArray[np.float32], weights: NDArray[np.float32]) -> NDArray[np.float32]:
    """Return means of what is known near by, of ever larger surroundings where little is.

    ``sums`` are (h, w, c) values times their ``weights``, (h, w, 1) (S. Gortler et al., The
    Lumigraph, 1996: pull and push).
    """
    soft = [scipy.ndimage.gaussian_filter(one, (2, 2, 0)) for one in (sums, weights)]
    mean: NDArray[np.float32] = soft[0] / np.maximum(soft[1], 1e-6)
    if min(weights.shape[:2]) < 4:
        return np.where(soft[1] > 1e-6, mean, np.float32(0))
    farther = _filled(*_halved(sums, weights))
    height, width = weights.shape[:2]
    farther = _doubled(farther)[:height, :width]
    sure: NDArray[np.float32] = np.clip(soft[1] / _ENOUGH, 0, 1)
    return farther + sure * (mean - farther)


def _halved(*pictures: NDArray[np.float32]) -> Iterator[NDArray[np.float32]]:
    for one in pictures:
        even = np.pad(one, [(0, one.shape[0] % 2), (0, one.shape[1] % 2), (0, 0)])
        four = even[::2, ::2] + even[1::2, ::2] + even[::2, 1::2] + even[1::2, 1::2]
        yield four / np.float32(4)


def _doubled(values: NDArray[np.float32]) -> NDArray[np.float32]:
    """Return a picture at twice the resolution, between pixels linear."""
    for axis in (0, 1):
        first, last = np.take(values, [0], axis), np.take(values, [-1], axis)
        before = np.concatenate([first, values], axis).take(range(values.shape[axis]), axis)
        after = np.concatenate([values, last], axis).take(range(1, values.shape[axis] + 1), axis)
        pair = np.stack([0.75 * values + 0.25 * before, 0.75 * values + 0.25 * after], axis + 1)
        shape = list(values.shape)
        shape[axis] *= 2
        values = pair.reshape(shape)
    return values
