"""The elements that an exemplar repeats, as far as they are seen whole (beyond the paper)."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy import ndimage
from scipy.sparse import coo_array
from scipy.sparse.csgraph import connected_components, minimum_spanning_tree

from iconstudio.algorithms.patterns.distance import CLAMP, signed_distance
from iconstudio.algorithms.patterns.exemplar import Exemplar, Masks
from iconstudio.algorithms.raster import solid

Bitmap = NDArray[np.bool_]
Labels = NDArray[np.int32]
Integers = NDArray[np.int64]
Numbers = NDArray[np.float64]

EIGHT = np.ones((3, 3), np.bool_)
MARGIN = int(CLAMP) + 1
_SPECK = 4
"""Pixels of ink that are no element."""
_THIN = 2.0
"""What covers so many times as much as what is ink of it is drawn in lines too thin for pixels."""
_PART_MOST, _JUMP = 3.0, 2.0
"""Components are parts of one element if they are at most so many pixels apart, and all others are
so many times as far."""
_CONNECTED = 0.25
"""If more of the ink goes on beyond the exemplar, nothing is an element."""
_DENSER = 1.018
"""How many times the exemplar's share of ink a pattern aims at, at most; what is then filled in
brings it to 1.1."""
_FAR, _EMPTIEST = 0.9, 0.95
"""So many elements are nearer to the next one than those that are farthest, and so many places
nearer to ink than the emptiest ones."""
_TOUCHING = 0.02
"""If no more of a layer's ink lies over or below others, it is apart from them."""
_RUNNING = 0.5
"""What touches the border and is so long, of the exemplar's side, is no element that was cut."""


@dataclass(frozen=True, slots=True, eq=False)
class Element:
    """An element, in the smallest rectangle around it and ``MARGIN`` pixels more."""

    layer: int
    number: int
    label: int
    """Its number among the labels of the layer, from 1."""
    top: int
    left: int
    """Of that rectangle, in the exemplar."""
    ink: Bitmap
    """(n, m)"""
    distance: NDArray[np.float32]
    """(n, m), of the element alone."""


@dataclass(frozen=True, slots=True, eq=False)
class Elements:
    """What a layer consists of."""

    whole: Sequence[Element]
    running: Bitmap
    """(h, w), ink that goes on beyond the exemplar, such as stripes and vines."""
    gap: float
    """Pixels between the elements that are nearest to each other,"""
    spacing: float
    """of a common one, to the next,"""
    farthest: float
    """and of those that are farthest from all others."""
    emptiness: float
    """How far from all ink the emptiest places are, in pixels."""
    share: float
    """Of the rectangle around the ink of all layers, and half the spacing, that is ink: a blank
    frame around an exemplar is no part of its pattern, unless that makes it much denser."""
    independent: bool
    """Whether nothing says where they lie but each other: no other layer lies over or below them,
    and nothing runs between them."""


def components(ink: Bitmap) -> tuple[Labels, int]:
    """Return the components of ink (h, w), numbered from 1; what lies in a hole belongs to it."""
    labels, count = ndimage.label(solid(ink), EIGHT)
    return np.where(ink, labels, 0).astype(np.int32), count


def elements_of(exemplar: Exemplar, layer: int) -> Elements:
    """Return the elements of a layer: those with labels, or else its components."""
    mask = exemplar.masks[layer]
    ink = mask > 0.5
    if exemplar.labels is None:
        labels = known = grouped(*components(ink))
    else:
        known = exemplar.labels[layer]
        labels = np.where(ink, known, 0)
    whole: list[Element] = []
    numbers: list[int] = []
    running = np.zeros(ink.shape, np.bool_)
    wide_mask, wide_labels = np.pad(mask, MARGIN), np.pad(labels, MARGIN)
    for number, box in enumerate(ndimage.find_objects(labels), 1):
        if box is None:
            continue
        own = labels[box] == number
        sides = [(one.start == 0, one.stop == n, (one.stop - one.start) / n)
                 for one, n in zip(box, ink.shape, strict=True)]  # fmt: skip
        if any(first or last for first, last, _ in sides):
            if any(extent >= _RUNNING for *_, extent in sides):
                running[box] |= own
        elif own.sum() > max(_SPECK, mask[known == number].sum() / _THIN):
            crop = tuple(slice(one.start, one.stop + 2 * MARGIN) for one in box)
            alone = _alone(wide_mask[crop], wide_labels[crop], number)
            distance = signed_distance(alone - np.float32(0.5))
            top, left = (one.start - MARGIN for one in box)
            whole.append(Element(layer, len(whole), number, top, left, distance < 0, distance))
            numbers.append(number)
    gap, spacing, farthest = _distances(labels, numbers)
    if running.sum() > _CONNECTED * ink.sum():
        whole = []  # of a network of lines, a closed one is no element by itself
    used = _used(exemplar.masks, round(spacing / 2))
    return Elements(
        tuple(whole), running, gap, spacing, farthest, emptiness(ink[_used(exemplar.masks)]),
        float(min(ink[used].mean(), _DENSER * ink.mean())) if ink.any() else 0.0,
        not running.any() and _is_apart(exemplar.masks, layer),
    )  # fmt: skip


def _distances(labels: Labels, numbers: Sequence[int]) -> tuple[float, float, float]:
    """Return how far what is nearest to an element is: at least, commonly, and at most."""
    if len(np.unique(labels[labels > 0])) < 2 or not numbers:
        return 2.0, 4.0, 4.0
    count = int(labels.max())
    own = _nearest(*_gaps(labels, count), count)[np.array(numbers) - 1]
    return float(own.min()), float(np.median(own)), float(np.quantile(own, _FAR))


def _is_apart(masks: Masks, layer: int) -> bool:
    inks = masks > 0.5
    others = np.any(np.delete(inks, layer, axis=0), axis=0)
    return bool((inks[layer] & others).sum() <= _TOUCHING * inks[layer].sum())


def _used(masks: Masks, margin: int = 0) -> tuple[slice, ...]:
    """Return the rectangle around the ink of all layers, and a margin."""
    inked = np.any(masks > 0.5, axis=0)
    if not inked.any():
        return np.s_[:, :]
    return tuple(
        slice(max(int(used[0]) - margin, 0), int(used[-1]) + 1 + margin)
        for used in (np.flatnonzero(inked.any(axis=axis)) for axis in (1, 0))
    )


def emptiness(ink: Bitmap, where: Bitmap | None = None) -> float:
    """Return how far from all ink (h, w) the emptiest places are, in pixels."""
    if not ink.any():
        return float(max(ink.shape))
    away = ndimage.distance_transform_edt(~ink)
    return float(np.quantile(away if where is None else away[where], _EMPTIEST))


def overlaps(exemplar: Exemplar, elements: Sequence[Elements]) -> Numbers:
    """Return (L, L): of an element of a layer, the most that lies over or below another one."""
    inked = np.pad(exemplar.masks > 0.5, ((0, 0), (MARGIN, MARGIN), (MARGIN, MARGIN)))
    found = np.zeros((len(inked), len(inked)))
    for m, layer in enumerate(elements):
        for one in layer.whole:
            rows, columns = (
                slice(begin + MARGIN, begin + MARGIN + length)
                for begin, length in zip((one.top, one.left), one.ink.shape, strict=True)
            )
            both = (inked[:, rows, columns] & one.ink).sum(axis=(1, 2))
            found[m] = np.maximum(found[m], both / one.ink.sum())
    return found


def _alone(mask: NDArray[np.float32], labels: Labels, number: int) -> NDArray[np.float32]:
    """Return a mask (n, m) of one element only, with its soft edge."""
    own = labels == number
    alone: NDArray[np.float32] = mask * ndimage.binary_dilation(
        own, EIGHT, mask=own | (labels == 0)
    )
    return alone


def _gaps(labels: Labels, count: int) -> tuple[Integers, Numbers]:
    """Return which components are neighbours, (n, 2) from 1, and how many pixels apart (n,)."""
    away, nearest = ndimage.distance_transform_edt(labels == 0, return_indices=True)
    owner = labels[tuple(nearest)]
    firsts, seconds, apart = [], [], []
    for one, other in ((np.s_[:, :-1], np.s_[:, 1:]), (np.s_[:-1], np.s_[1:])):
        meeting = owner[one] != owner[other]
        firsts.append(owner[one][meeting])
        seconds.append(owner[other][meeting])
        apart.append((away[one] + away[other])[meeting])
    ends = np.sort(np.stack([np.concatenate(firsts), np.concatenate(seconds)], axis=1), axis=1)
    number, which = np.unique(ends[:, 0] * (count + 1) + ends[:, 1], return_inverse=True)
    least = np.full(len(number), np.inf)
    np.minimum.at(least, which, np.concatenate(apart))
    return np.stack(np.divmod(number, count + 1), axis=1), least


def _nearest(pairs: Integers, apart: Numbers, count: int) -> Numbers:
    """Return how far each component, from 1, is from the nearest other (count,)."""
    least = np.full(count + 1, np.inf)
    np.minimum.at(least, pairs.ravel(), np.repeat(apart, 2))
    return least[1:]


def grouped(labels: Labels, count: int) -> Labels:
    """Return components with those joined that are parts of one element, such as both eyes.

    Those are the short edges of the minimum spanning tree, if the next longer ones are far longer.
    """
    if count < 3:
        return labels
    pairs, apart = _gaps(labels, count)
    tree = minimum_spanning_tree(coo_array((apart + 1, pairs.T), (count + 1, count + 1))).tocoo()
    edges = np.sort(tree.data - 1)
    jumps = (edges[:-1] <= _PART_MOST) & (edges[1:] >= _JUMP * np.maximum(edges[:-1], 1))
    if not jumps.any():
        return labels
    short = tree.data - 1 <= edges[:-1][jumps].max()
    parts = coo_array((tree.data[short], (tree.row[short], tree.col[short])), tree.shape)
    _, groups = connected_components(parts, directed=False)
    return np.where(labels > 0, groups[labels] + 1, 0).astype(np.int32)
