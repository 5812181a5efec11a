"""The elements that an exemplar repeats, as far as they are seen whole."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy import ndimage

from iconstudio.algorithms.patterns.distance import CLAMP, signed_distance
from iconstudio.algorithms.patterns.exemplar import Exemplar
from iconstudio.algorithms.raster import solid

Bitmap = NDArray[np.bool_]
Labels = NDArray[np.int32]

EIGHT = np.ones((3, 3), np.bool_)
MARGIN = int(CLAMP) + 1
_SPECK = 4
"""Pixels of ink that are no element."""
_RUNNING = 0.5
"""What touches the border and is so long, of the exemplar's side, is no element that was cut."""


@dataclass(frozen=True, slots=True, eq=False)
class Element:
    """An element, in the smallest rectangle around it and ``MARGIN`` pixels more."""

    layer: int
    number: int
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
    """and, of a common one, to the next."""
    share: float
    """Of the rectangle around all ink, and half the spacing, that is ink: a blank frame around
    an exemplar is no part of its pattern."""


def components(ink: Bitmap) -> tuple[Labels, int]:
    """Return the components of ink (h, w), numbered from 1; what lies in a hole belongs to it."""
    labels, count = ndimage.label(solid(ink), EIGHT)
    return np.where(ink, labels, 0).astype(np.int32), count


def elements_of(exemplar: Exemplar, layer: int) -> Elements:
    """Return the elements of a layer: those with labels, or else its components."""
    mask = exemplar.masks[layer]
    ink = mask > 0.5
    if exemplar.labels is None:
        labels, _ = components(ink)
    else:
        labels = np.where(ink, exemplar.labels[layer], 0)
    whole: list[Element] = []
    numbers: list[int] = []
    running = np.zeros(ink.shape, np.bool_)
    for number, box in enumerate(ndimage.find_objects(labels), 1):
        if box is None:
            continue
        own = labels == number
        sides = [(one.start == 0, one.stop == n, (one.stop - one.start) / n)
                 for one, n in zip(box, ink.shape, strict=True)]  # fmt: skip
        if any(first or last for first, last, _ in sides):
            if any(extent >= _RUNNING for *_, extent in sides):
                running |= own
        elif own.sum() > _SPECK:
            alone = mask * ndimage.binary_dilation(own, EIGHT, mask=own | (labels == 0))
            whole.append(_cropped(alone, box, layer, len(whole)))
            numbers.append(number)
    gap, spacing = _gaps(labels, numbers)
    return Elements(tuple(whole), running, gap, spacing, _share(ink, round(spacing / 2)))


def _share(ink: Bitmap, margin: int) -> float:
    rows, columns = (np.flatnonzero(ink.any(axis=axis)) for axis in (1, 0))
    if not len(rows):
        return 0.0
    height, width = (
        min(used[-1] + 1 + margin, n) - max(used[0] - margin, 0)
        for used, n in zip((rows, columns), ink.shape, strict=True)
    )
    return float(ink.sum() / (height * width))


def _cropped(
    alone: NDArray[np.float32], box: tuple[slice, slice], layer: int, number: int
) -> Element:
    crop = tuple(slice(one.start, one.stop + 2 * MARGIN) for one in box)
    distance = signed_distance(np.pad(alone, MARGIN)[crop] - np.float32(0.5))
    top, left = (one.start - MARGIN for one in box)
    return Element(layer, number, top, left, distance < 0, distance)


def _gaps(labels: Labels, numbers: Sequence[int]) -> tuple[float, float]:
    """Return the least and a common distance from an element to the nearest other, in pixels."""
    if len(numbers) < 2:
        return 2.0, 4.0
    gaps = []
    for number in numbers:
        own = labels == number
        away = ndimage.distance_transform_edt(own | (labels == 0))
        gaps.append(away[own].min() - 1)
    return float(min(gaps)), float(np.median(gaps))
