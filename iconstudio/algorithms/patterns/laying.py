"""A layer on which whole elements are laid (beyond the paper)."""

from collections import Counter
from collections.abc import Callable, Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray
from scipy import ndimage

from iconstudio.algorithms.patterns.distance import CLAMP, signed_distance
from iconstudio.algorithms.patterns.elements import EIGHT, Element, Elements, emptiness
from iconstudio.algorithms.patterns.exemplar import Placed, Places
from iconstudio.algorithms.patterns.fourier import Field, Spectrum, backward, forward
from iconstudio.algorithms.patterns.spacing import spread

Bitmap = NDArray[np.bool_]

_REACH = 3.0
"""Pixels around its contour in which an element is compared with a layer."""
_VISIBLE = 0.25
"""Of an element's ink, so much lies in the pattern at least."""
_APART = 1.5
"""Elements move apart until they are so many times as far from the next as the farthest are in the
exemplar; if those that lie close to each other do so in groups, hardly at all."""
_CLOSEST = 1.5, 4.0
"""Pixels between elements: the least and the most that is kept free in any case."""


class Mended(NamedTuple):
    """A layer of whole elements."""

    distance: Field
    """(H, W)"""
    source: Places
    """(H, W, 2)"""
    placed: tuple[Placed, ...]
    owner: NDArray[np.int32]
    """(H, W), whose ink it is: a number in ``placed``, from 1; 0 for none."""

    @classmethod
    def nothing(cls, distance: Field, source: Places) -> "Mended":
        """Return a layer as it was."""
        return cls(distance, source, (), np.zeros(distance.shape, np.int32))


class Other(NamedTuple):
    """Another layer of the pattern."""

    ink: Bitmap
    """(H, W)"""
    most: float
    """The part of an element that may lie over or below it."""


class Candidate(NamedTuple):
    """An element, where it may lie, and how unlike it the layer is there: 0 to 1 or more."""

    unlikeness: float
    element: Element
    top: int
    left: int


class Sheet:
    """A layer that elements are laid on; if it is no tile, with a border as wide as the largest."""

    def __init__(
        self,
        distance: Field,
        source: Places,
        elements: Elements,
        tile: bool,
        allowed: Bitmap | None,
        others: Sequence[Other],
    ) -> None:
        self._elements, self._tile = elements, tile
        self._distance, self._source = distance, source
        largest = max(max(one.ink.shape) for one in elements.whole)
        self._border = 0 if tile else largest
        near = np.pad(np.clip(distance, -_REACH, _REACH), self._border)
        self._shape = near.shape
        visible = np.pad(np.ones(distance.shape, np.float32), self._border)
        allowed = np.ones(distance.shape, np.bool_) if allowed is None else allowed
        allowed = np.pad(allowed, self._border, mode="edge")
        self._visible, self._area = visible, visible * allowed
        self._near = forward(near, self._shape)
        self._squares = forward(near**2, self._shape)
        self._seen = None if tile else forward(visible, self._shape)
        self._others = [
            Other(np.pad(one.ink, self._border, mode="edge"), one.most) for one in others
        ]
        self._spectra = [forward(one.ink.astype(np.float32), self._shape) for one in self._others]
        self._kept = self._running()
        self._running_ink, self._forbidden = np.pad(self._kept, self._border), ~allowed
        low, high = _CLOSEST
        self._near_gap = min(max(elements.gap, low), high)
        self._wide_gap = max(elements.spacing, low)
        self._near_disk, self._wide_disk = _disk(self._near_gap), _disk(self._wide_gap)
        self._lay_all([])

    def _lay_all(self, candidates: Sequence[Candidate]) -> None:
        """Lay these elements, and no others."""
        self._laid = list(candidates)
        ink = self._ink()
        self._inked = float((ink * self._area).sum())
        margin = int(self._wide_gap) + 1
        wide = np.pad(ink, margin, mode="wrap")
        away = ndimage.distance_transform_edt(~wide)[margin:-margin, margin:-margin]
        if not ink.any():
            away = np.full(ink.shape, np.inf)
        # Where no further ink may lie: at the least distance, and at a common one.
        self.densely = (away <= self._near_gap) | self._forbidden
        self.sparsely = (away <= self._wide_gap) | self._forbidden

    def _ink(self) -> Bitmap:
        ink = self._running_ink.copy()
        for one in self._laid:
            ink[self._place(one)] |= one.element.ink
        return ink

    def _running(self) -> Bitmap:
        """Return the ink that comes from what is no element, and goes on beyond the exemplar."""
        ink: Bitmap = self._distance < 0
        labels, count = ndimage.label(ink, EIGHT)
        running = self._elements.running[self._source[..., 0], self._source[..., 1]]
        share = ndimage.mean(running, labels, np.arange(1, count + 1)) if count else np.zeros(0)
        kept: Bitmap = np.append(False, share > 0.5)[labels]
        return kept

    def correlated(self, spectrum: Spectrum, weights: Field) -> Field:
        """Return the sums over a rectangle of weights (n, m) at all places (H, W)."""
        return backward(spectrum * np.conj(forward(weights, self._shape)), self._shape)

    def unlikeness(self, element: Element) -> Field:
        """Return how much the layer differs from an element wherever its rectangle may begin.

        As a part of what emptiness differs from it; infinite where too little of it is visible.
        """
        own = np.clip(element.distance, -_REACH, _REACH)
        weight = (element.distance < _REACH).astype(np.float32)
        empty = weight * (_REACH - own) ** 2
        different = self.correlated(self._squares, weight) - 2 * self.correlated(
            self._near, weight * own
        )
        if self._seen is None:
            values = (different + (weight * own**2).sum()) / empty.sum()
        else:
            seen = self.correlated(self._seen, weight * own**2)
            most = self.correlated(self._seen, empty)
            inked = self.correlated(self._seen, element.ink.astype(np.float32))
            enough = inked > _VISIBLE * element.ink.sum()
            values = np.where(enough, (different + seen) / np.maximum(most, 1e-3), np.inf)
        unlike: Field = values.astype(np.float32)
        return unlike

    def has_room(self, candidate: Candidate) -> bool:
        """Return whether nothing lies too near, nor too much of other layers there."""
        at, ink = self._place(candidate), candidate.element.ink
        return not (self.densely[at] & ink).any() and self._is_clear(candidate)

    def _is_clear(self, candidate: Candidate) -> bool:
        """Return whether not too much of other layers lies on an element."""
        at, ink = self._place(candidate), candidate.element.ink
        return all((one.ink[at] & ink).sum() <= one.most * ink.sum() for one in self._others)

    def clear_of_others(self, element: Element) -> Bitmap:
        """Return where (H, W) not too much of other layers lies on an element."""
        clear = np.ones(self._shape, np.bool_)
        ink = element.ink.astype(np.float32)
        for one, spectrum in zip(self._others, self._spectra, strict=True):
            clear &= self.correlated(spectrum, ink) <= one.most * ink.sum() + 0.5
        return clear

    def lay(self, candidate: Candidate) -> None:
        """Lay an element."""
        at, ink = self._place(candidate), candidate.element.ink
        self._laid.append(candidate)
        self._inked += float((ink * self._area[at]).sum())
        for blocked, disk in ((self.densely, self._near_disk), (self.sparsely, self._wide_disk)):
            margin = len(disk) // 2
            place = self._place(candidate, margin)
            blocked[place] |= ndimage.binary_dilation(np.pad(ink, margin), disk)

    @property
    def laid(self) -> Sequence[Candidate]:
        """What was laid so far."""
        return tuple(self._laid)

    def exchange(self, one: Candidate, other: Candidate) -> bool:
        """Lay another element in one's place, if it has room there; return whether it has."""
        self._lay_all([laid for laid in self._laid if laid is not one])
        fits = self.has_room(other)
        self.lay(other if fits else one)
        return fits

    def spread(self, ask: Callable[[], None]) -> None:
        """Move what was laid apart."""
        laid, enough = self._laid, _APART * self._elements.farthest
        beyond = ndimage.distance_transform_edt(self._visible == 0) > enough / 2

        def may_lie(number: int, place: NDArray[np.int64]) -> bool:
            there = laid[number]._replace(top=int(place[0]), left=int(place[1]))
            inside = not (there.element.ink & (self._visible[self._place(there)] == 0)).any()
            return inside and self._is_clear(there)

        inks = [one.element.ink for one in laid]
        places = np.array([(one.top, one.left) for one in laid]).reshape(-1, 2)
        fixed = self._running_ink | self._forbidden | beyond
        places = spread(inks, places, fixed, enough, may_lie, ask)
        self._lay_all([
            one._replace(top=top, left=left)
            for one, (top, left) in zip(laid, places.tolist(), strict=True)
        ])  # fmt: skip

    def is_uneven(self) -> bool:
        """Return whether there are emptier places than in the exemplar."""
        return emptiness(self._ink(), self._area > 0) > self._elements.emptiness

    def counts(self, elements: Sequence[Element]) -> list[int]:
        """Return how often each element was laid."""
        laid = Counter(id(one.element) for one in self._laid)
        return [laid[id(one)] for one in elements]

    @property
    def area(self) -> float:
        """Pixels of the pattern where elements may lie."""
        return float(self._area.sum())

    def _place(
        self, candidate: Candidate, margin: int = 0
    ) -> tuple[NDArray[np.int64], NDArray[np.int64]]:
        rows, columns = (
            np.arange(begin - margin, begin + length + margin) % n
            for begin, length, n in zip(
                (candidate.top, candidate.left), candidate.element.ink.shape, self._shape,
                strict=True,
            )
        )  # fmt: skip
        return np.ix_(rows, columns)

    @property
    def share(self) -> float:
        """The share of the pattern, where it may lie, that is ink."""
        return self._inked / float(self._area.sum())

    def share_with(self, candidate: Candidate) -> float:
        """Return the share of ink once an element lies there."""
        more = (candidate.element.ink * self._area[self._place(candidate)]).sum()
        return self.share + float(more / self._area.sum())

    def result(self, ask: Callable[[], None]) -> Mended:
        """Return the layer of what was laid, and of what goes on beyond the exemplar."""
        height, width = self._distance.shape
        begin = self._border
        inside = slice(begin, begin + height), slice(begin, begin + width)
        distance = np.full(self._shape, CLAMP, np.float32)
        if self._kept.any():
            kept = np.where(self._kept, -self._distance, np.minimum(-self._distance, -0.01))
            away = ndimage.distance_transform_edt(~self._kept)
            kept = np.where(away > 2, -CLAMP, kept).astype(np.float32)
            distance[inside] = signed_distance(kept, self._tile)
        source = np.pad(self._source, ((begin, begin), (begin, begin), (0, 0)), "edge")
        most = np.array(self._elements.running.shape) - 1
        owner = np.zeros(self._shape, np.int32)
        placed = []
        for number, one in enumerate(self._laid, 1):
            ask()
            at = self._place(one)
            element = one.element
            nearer = element.distance < distance[at]
            corner = np.array([element.top, element.left])
            own = np.indices(element.ink.shape).transpose(1, 2, 0) + corner
            source[at] = np.where(nearer[..., None], np.clip(own, 0, most), source[at])
            distance[at] = np.minimum(element.distance, distance[at])
            down = int(one.top - begin - element.top)
            right = int(one.left - begin - element.left)
            placed.append(Placed(element.layer, element.number, down, right, element.label))
            owner[at] = np.where(element.ink, number, owner[at])
        return Mended(distance[inside], source[inside], tuple(placed), owner[inside])


def _disk(radius: float) -> Bitmap:
    whole = int(radius)
    y, x = np.ogrid[-whole : whole + 1, -whole : whole + 1]
    disk: Bitmap = y * y + x * x <= radius * radius
    return disk
