"""Which colours of an image are of one layer: those that together make its elements.

The centre of a flower, the pupil in an eye and the shaded side of a fruit are details of what they
lie on or beside, and would go astray in a layer by themselves; elements that do not touch share a
layer, so that they keep clear of each other. Flowers over a vine are in another layer than it: one
vine joins several flowers, and one flower several parts of the vine.
"""

from dataclasses import dataclass
from itertools import combinations

import numpy as np
from numpy.typing import NDArray
from scipy import ndimage
from scipy.sparse import coo_array, csr_array
from scipy.sparse.csgraph import connected_components
from skimage.measure import label

Integers = NDArray[np.int64]
Bitmap = NDArray[np.bool_]

_CHAINED = 0.1
"""If more of the ink of two layers is in chains of several elements of each that go on beyond the
image, they stay apart."""
_RUNNING = 0.5
"""An area that touches the border, and is so long, of the side of the image, goes on beyond it."""
_RUNNING_MOST = 0.25
"""If more of a layer's ink does, it has no elements."""
_CONTACT = 3
"""Sides of pixels that areas share if they touch."""


@dataclass(frozen=True, slots=True, eq=False)
class Areas:
    """The n connected areas of one colour each."""

    colour: Integers
    """(n,)"""
    size: Integers
    """(n,), in pixels."""
    bounds: Integers
    """(n, 4): first and last row and column."""
    shape: tuple[int, int]
    """Of the image."""
    contacts: csr_array
    """(n, n), the sides of pixels that two of them share."""

    @classmethod
    def of(cls, seen: NDArray[np.int16]) -> "Areas":
        """Return the areas of an image (h, w) of numbered colours."""
        pieces = label(seen.astype(np.int64) + 1, connectivity=2) - 1
        count = int(pieces.max()) + 1
        colour = np.zeros(count, np.int64)
        colour[pieces.ravel()] = seen.ravel()
        ends = []
        for one, other in ((np.s_[:, :-1], np.s_[:, 1:]), (np.s_[:-1], np.s_[1:])):
            meet = pieces[one] != pieces[other]
            ends.append(np.stack([pieces[one][meet], pieces[other][meet]]))
        pairs = np.concatenate(ends, axis=1)
        graph = coo_array((np.ones(pairs.shape[1], np.int64), pairs), (count, count)).tocsr()
        boxes = ndimage.find_objects(pieces + 1)
        bounds = np.array([[y.start, x.start, y.stop - 1, x.stop - 1] for y, x in boxes])
        sizes = np.bincount(pieces.ravel())
        return cls(colour, sizes, bounds, (seen.shape[0], seen.shape[1]), graph + graph.T)

    @property
    def ground(self) -> int:
        """The colour of which there is most in the image, at its border, and along contours."""
        count = int(self.colour.max()) + 1
        height, width = self.shape
        ends = self.bounds == [0, 0, height - 1, width - 1]
        spans = self.bounds[:, 2:] - self.bounds[:, :2] + 1
        border = (ends * np.concatenate([spans[:, ::-1], spans[:, ::-1]], axis=1)).sum(axis=1)
        contour = np.asarray(self.contacts.sum(axis=1)).ravel()
        shares = (np.bincount(self.colour, one, count) / one.sum()
                  for one in (self.size, border, contour))  # fmt: skip
        return int(sum(shares, np.zeros(count)).argmax())

    def elements(self, which: Bitmap) -> Integers:
        """Return the number of the element (n,) that each area of some is part of; -1 of others."""
        some = np.flatnonzero(which)
        numbers = np.full(len(which), -1, np.int64)
        numbers[some] = connected_components(self.contacts[some][:, some] >= _CONTACT, False)[1]
        return numbers

    def running(self, elements: Integers) -> Bitmap:
        """Return which elements go on beyond the image."""
        some = elements >= 0
        count = int(elements.max()) + 1
        least, most = np.full((count, 2), 1 << 30), np.zeros((count, 2), np.int64)
        np.minimum.at(least, elements[some], self.bounds[some, :2])
        np.maximum.at(most, elements[some], self.bounds[some, 2:])
        sides = np.array(self.shape)
        at_border = ((least == 0) | (most == sides - 1)).any(axis=1)
        long = (most - least + 1 >= _RUNNING * sides).any(axis=1)
        running: Bitmap = at_border & long
        return running


def grouped_colours(areas: Areas, count: int) -> Integers:
    """Return the group (count,) of each colour; that of the ground, which is alone, is 0.

    Two groups become one as long as that joins no chains of elements, the one with most contact
    first.
    """
    group = np.arange(count)
    group[[0, areas.ground]] = areas.ground, 0
    known: dict[tuple[int, int], float] = {}
    while True:
        left = np.unique(group[group > 0]).tolist()
        pairs = list(combinations(left, 2))
        for pair in pairs:
            if pair not in known:
                known[pair] = _contact(areas, group, *pair) if _fit(areas, group, *pair) else -1.0
        best = max(pairs, key=known.__getitem__, default=None)
        if best is None or known[best] < 0:
            return np.unique(group, return_inverse=True)[1]
        group[group == best[1]] = best[0]
        known = {pair: one for pair, one in known.items() if not {*pair} & {*best}}


def _contact(areas: Areas, group: Integers, one: int, other: int) -> float:
    """Return how much of the contour of one of two groups is shared by the other, at most."""
    of = group[areas.colour]
    firsts, seconds = areas.contacts[of == one], areas.contacts[of == other]
    shared = firsts[:, of == other].sum()
    around = [some[:, of != number].sum() for some, number in ((firsts, one), (seconds, other))]
    return float(shared / max(1, min(around)))


def _fit(areas: Areas, group: Integers, one: int, other: int) -> bool:
    """Whether two groups can be one layer."""
    of = group[areas.colour]
    both = areas.elements((of == one) | (of == other))
    chains = areas.running(both)
    for number in (one, other):
        own = areas.elements(of == number)
        some = own >= 0
        inked = np.bincount(own[some], areas.size[some])
        if inked[areas.running(own)].sum() > _RUNNING_MOST * inked.sum():
            return False
        pairs = np.unique(np.stack([both[some], own[some]]), axis=1)
        chains &= np.bincount(pairs[0], minlength=len(chains)) > 1
    inked = np.bincount(both[both >= 0], areas.size[both >= 0])
    return bool(inked[chains].sum() <= _CHAINED * inked.sum())
