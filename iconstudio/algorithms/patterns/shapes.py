"""The elements of an image as shapes in flat colours: its layers traced, finer than its pixels.

Colours are painted one over the other, that of which a layer has most first: each also fills the
holes through which only later ones are seen, and runs a little beneath those beside it, so that no
hairlines show between them.
"""

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray
from scipy import ndimage

from iconstudio.algorithms.patterns.elements import components
from iconstudio.algorithms.patterns.exemplar import Masks
from iconstudio.algorithms.patterns.separation import Separated
from iconstudio.algorithms.raster import solid
from iconstudio.algorithms.tracing.vectorize import trace
from iconstudio.model import CANVAS, Contour, Fill, Path, Transform, hex_colour

Mask = NDArray[np.float32]
Labels = NDArray[np.int32]

_SPECK = 0.5
"""Square canvas units of the smallest dot."""
_SURE = 0.8
"""How much of a connected piece one element has, if it is of it."""
_SOFT, _BLUR = 0.15, 0.9
"""An edge is hard if fewer of its pixels are covered in part; it is then blurred by so many."""
_EIGHT = np.ones((3, 3), np.bool_)


def element_shapes(
    separated: Separated, masks: Masks, labels: Labels
) -> tuple[tuple[tuple[Fill, ...], ...], ...]:
    """Return of each layer the elements by their labels, from 1, each from back to front.

    They are in the pixels of ``labels``.

    Parameters
    ----------
    masks
        (L, h, w), those of the layers, the uppermost first.
    labels
        (L, n, m), which element each pixel of a layer belongs to, of any resolution.
    """
    return tuple(
        _of_layer(separated, len(masks) - m, mask, own)
        for m, (mask, own) in enumerate(zip(masks, labels, strict=True))
    )


def _of_layer(
    separated: Separated, number: int, mask: Mask, labels: Labels
) -> tuple[tuple[Fill, ...], ...]:
    owner = _owners(mask > 0.5, labels)
    scale = max(labels.shape) / CANVAS
    elements: list[list[Fill]] = [[] for _ in range(int(labels.max()))]
    for colour, coverage in _painted(separated, number, mask):
        path = _traced(coverage).transformed(Transform().scale(scale))
        contours: dict[int, list[Contour]] = {}
        for contour in path.contours:
            contours.setdefault(_owner(contour, owner, scale), []).append(contour)
        for label, own in contours.items():
            if label:
                elements[label - 1].append(Fill(Path(tuple(own)), colour))
    return tuple(map(tuple, elements))


def _painted(separated: Separated, number: int, mask: Mask) -> Sequence[tuple[str, Mask]]:
    """Return the colours of a layer, ``#rrggbb``, in the order to paint them, and their masks."""
    flat = separated.flat
    seen = separated.seen == number
    own = np.flatnonzero(separated.layer == number)
    colour = np.where(np.isin(flat.first, own), flat.first, own[0])
    if seen.any():
        nearest = ndimage.distance_transform_edt(~seen, return_distances=False, return_indices=True)
        colour = colour[tuple(nearest)]
    shown = flat.coverage(separated.layer == number)
    hidden = mask > shown
    sizes = np.bincount(colour[mask > 0.5], minlength=len(flat.colours))
    order = [int(one) for one in own[np.argsort(-sizes[own], kind="stable")] if sizes[one]]
    painted = []
    for place, one in enumerate(order):
        which = np.arange(len(flat.colours)) == one
        covered = np.where(hidden, mask * (colour == one), np.minimum(flat.coverage(which), mask))
        later = np.isin(colour, order[place + 1 :]) & (mask > 0.5)
        painted.append((hex_colour(flat.colours[one]), _run_on(covered.astype(np.float32), later)))
    return painted


def _run_on(covered: Mask, later: NDArray[np.bool_]) -> Mask:
    """Return a mask with the holes that later colours fill, and a pixel more below those."""
    ink = covered > 0.5
    holes, count = ndimage.label(solid(ink | later) & ~ink)
    filled = np.zeros(ink.shape, np.bool_)
    if count:
        only = ndimage.minimum(later, holes, np.arange(count + 1)).astype(np.bool_)
        only[0] = False
        filled = only[holes] & solid(ink)
    below = filled | (ndimage.binary_dilation(ink, _EIGHT) & later)
    return np.where(below, np.float32(1), covered)


def _traced(coverage: Mask) -> Path:
    side = max(coverage.shape)
    square = np.zeros((side, side), np.uint8)
    square[: coverage.shape[0], : coverage.shape[1]] = np.rint(_smoothed(coverage) * 255)
    return trace(square, _SPECK)


def _smoothed(coverage: Mask) -> Mask:
    """Return a mask whose edges are soft: of hard ones, every pixel would be a corner."""
    soft = (coverage > 0.1) & (coverage < 0.9)
    edge = ndimage.binary_dilation(coverage > 0.5, _EIGHT) & (coverage <= 0.5)
    if soft.sum() > _SOFT * edge.sum():
        return coverage
    smoothed: Mask = ndimage.gaussian_filter(coverage, _BLUR, mode="nearest")
    return smoothed


def _owners(ink: NDArray[np.bool_], labels: Labels) -> Labels:
    """Return which element each pixel (h, w) is nearest to; 0 for what is part of several."""
    pieces, count = components(ink)
    scale = max(labels.shape) / max(ink.shape)
    rows, columns = (np.minimum((np.arange(n) * scale).astype(int), m - 1)
                     for n, m in zip(ink.shape, labels.shape, strict=True))  # fmt: skip
    fine = labels[np.ix_(rows, columns)]
    votes = np.zeros((count + 1, int(labels.max()) + 1), np.int64)
    np.add.at(votes, (pieces[ink], fine[ink]), 1)
    votes[:, 0] = 0
    best = votes.argmax(axis=1)
    best[votes.max(axis=1) < _SURE * votes.sum(axis=1)] = 0
    nearest = ndimage.distance_transform_edt(~ink, return_distances=False, return_indices=True)
    owners: Labels = best[pieces[tuple(nearest)]].astype(np.int32)
    return owners


def _owner(contour: Contour, owner: Labels, scale: float) -> int:
    """Return the element of most of a contour."""
    points = np.array([contour.start, *(segment[-1] for segment in contour.segments)]) / scale
    points *= max(owner.shape) / CANVAS
    columns, rows = np.clip(points.T.astype(int), 0, np.array(owner.shape)[::-1, None] - 1)
    return int(np.bincount(owner[rows, columns]).argmax())
