"""Torn elements made whole (beyond the paper).

The exemplar's own whole elements are laid where the synthesised layer is most like them, the best
first, unless they would touch one that lies there already. What ink is then left is torn, and taken
out; where a gap remains that has room for an element, the most likely one is laid there.
"""

from collections.abc import Callable, Sequence
from statistics import median
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray
from scipy import ndimage

from iconstudio.algorithms.patterns.distance import CLAMP, signed_distance
from iconstudio.algorithms.patterns.elements import EIGHT, Element, Elements
from iconstudio.algorithms.patterns.exemplar import Placed, Places
from iconstudio.algorithms.patterns.fourier import Field, Spectrum, backward, forward

Bitmap = NDArray[np.bool_]

_REACH = 3.0
"""Pixels around its contour in which an element is compared with a layer."""
_LIKELY = 0.75
"""Of what an element differs from emptiness, it may differ so much from what it replaces."""
_AS_LIKELY = 0.02
"""Elements are as likely in a place if their unlikeness differs by less."""
_VISIBLE = 0.25
"""Of an element's ink, so much lies in the pattern at least."""
_FULL = 0.97
"""Of the exemplar's share of ink, how much a pattern has before narrow gaps are left empty."""
_LIKELY_FULL = 1.03
"""How much of it elements make before less likely ones are left out."""
_FULLEST = 1.08
"""How much of it a pattern has at most; up to that, wide gaps are filled."""
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


class _Candidate(NamedTuple):
    """An element, where it may lie, and how unlike it the layer is there: 0 to 1 or more."""

    unlikeness: float
    element: Element
    top: int
    left: int


def mended(
    distance: Field,
    source: Places,
    elements: Elements,
    tile: bool,
    random: np.random.Generator,
    ask: Callable[[], None] = lambda: None,
    guidance: Field | None = None,
    others: Sequence[Other] = (),
) -> Mended:
    """Return a layer (H, W) in which no element is torn.

    Parameters
    ----------
    distance, source
        Signed distances, and where in the exemplar each pixel comes from.
    elements
        Of the exemplar's layer. If none is whole, the layer stays as it is.
    guidance
        (H, W), how much of each pixel lies where ink may be, from 0 to 1: elements lie there
        wholly, what else there is ends at its contour.
    others
        Layers that are mended already.
    """
    allowed = None
    if guidance is not None:
        allowed = guidance > 0.5
        distance = np.maximum(distance, signed_distance(guidance - np.float32(0.5), tile))
    if not elements.whole:
        return Mended.nothing(distance, source)
    sheet = _Sheet(distance, source, elements, tile, allowed, others)
    unlikeness: list[Field] = []
    candidates: list[_Candidate] = []
    for element in elements.whole:
        ask()
        values = sheet.unlikeness(element)
        places = np.argwhere(_least(values, tile) & (values < _LIKELY))
        candidates += [_Candidate(float(values[y, x]), element, y, x) for y, x in places]
        unlikeness.append(values)
    for one in sorted(candidates, key=lambda candidate: candidate.unlikeness):
        ask()
        one = _rarest(one, sheet, elements.whole, unlikeness)
        if sheet.has_room(one) and sheet.share_with(one) <= _LIKELY_FULL * elements.share:
            sheet.lay(one)
    usual = median(int(element.ink.sum()) for element in elements.whole)
    for blocked, most, least in (
        (sheet.sparsely, _FULLEST, usual),
        (sheet.sparsely, _FULL, 0),
        (sheet.densely, _FULL, 0),
    ):
        while sheet.share < most * elements.share:
            found = _fitting(sheet, blocked, elements.whole, unlikeness, random, ask, least)
            if found is None or sheet.share_with(found) > _FULLEST * elements.share:
                break
            sheet.lay(found)
    return sheet.result(ask)


def _rarest(
    one: _Candidate, sheet: "_Sheet", whole: Sequence[Element], unlikeness: list[Field]
) -> _Candidate:
    """Return that of the elements which is laid least often, of those as likely in one's place.

    Elements of one shape may differ in their colours.
    """
    middle_y = one.top + one.element.ink.shape[0] / 2
    middle_x = one.left + one.element.ink.shape[1] / 2
    best, least = one, sheet.count(one.element)
    for other, values in zip(whole, unlikeness, strict=True):
        rows, columns = values.shape
        top = round(middle_y - other.ink.shape[0] / 2) % rows
        left = round(middle_x - other.ink.shape[1] / 2) % columns
        likely = values[top, left]
        if likely <= one.unlikeness + _AS_LIKELY and sheet.count(other) < least:
            best, least = _Candidate(float(likely), other, top, left), sheet.count(other)
    return best


def _least(values: Field, tile: bool) -> Bitmap:
    mode = "wrap" if tile else "nearest"
    lowest: Bitmap = values == ndimage.minimum_filter(values, 5, mode=mode)
    return lowest


def _fitting(
    sheet: "_Sheet",
    blocked: Bitmap,
    whole: Sequence[Element],
    unlikeness: list[Field],
    random: np.random.Generator,
    ask: Callable[[], None],
    least: float,
) -> _Candidate | None:
    """Return the rarest element, large enough, that fits into a gap, where it is least unlike."""
    spectrum = forward(blocked.astype(np.float32), blocked.shape)
    order = random.permutation(len(whole))
    for k in sorted(order, key=lambda k: sheet.count(whole[k])):
        ask()
        if whole[k].ink.sum() < least:
            continue
        room = sheet.correlated(spectrum, whole[k].ink.astype(np.float32)) < 0.5
        room &= np.isfinite(unlikeness[k]) & sheet.clear_of_others(whole[k])
        if room.any():
            y, x = np.unravel_index(np.argmin(np.where(room, unlikeness[k], np.inf)), room.shape)
            return _Candidate(float(unlikeness[k][y, x]), whole[k], int(y), int(x))
    return None


class _Sheet:
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
        self._area = visible * allowed
        self._near = forward(near, self._shape)
        self._squares = forward(near**2, self._shape)
        self._seen = None if tile else forward(visible, self._shape)
        self._laid: list[_Candidate] = []
        self._others = [
            Other(np.pad(one.ink, self._border, mode="edge"), one.most) for one in others
        ]
        self._spectra = [forward(one.ink.astype(np.float32), self._shape) for one in self._others]
        self._kept = self._running()
        ink = np.pad(self._kept, self._border)
        self._inked = float(self._kept.sum())
        low, high = _CLOSEST
        near_gap, wide_gap = min(max(elements.gap, low), high), max(elements.spacing, low)
        self._near_disk, self._wide_disk = _disk(near_gap), _disk(wide_gap)
        # Where no further ink may lie: at the least distance, and at a common one.
        away = ndimage.distance_transform_edt(~ink) if ink.any() else np.full(ink.shape, np.inf)
        self.densely = (away <= near_gap) | ~allowed
        self.sparsely = (away <= wide_gap) | ~allowed

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

    def has_room(self, candidate: _Candidate) -> bool:
        """Return whether nothing lies too near, nor too much of other layers there."""
        at, ink = self._place(candidate), candidate.element.ink
        return not (self.densely[at] & ink).any() and all(
            (one.ink[at] & ink).sum() <= one.most * ink.sum() for one in self._others
        )

    def clear_of_others(self, element: Element) -> Bitmap:
        """Return where (H, W) not too much of other layers lies on an element."""
        clear = np.ones(self._shape, np.bool_)
        ink = element.ink.astype(np.float32)
        for one, spectrum in zip(self._others, self._spectra, strict=True):
            clear &= self.correlated(spectrum, ink) <= one.most * ink.sum() + 0.5
        return clear

    def lay(self, candidate: _Candidate) -> None:
        """Lay an element."""
        at, ink = self._place(candidate), candidate.element.ink
        self._laid.append(candidate)
        self._inked += float((ink * self._area[at]).sum())
        for blocked, disk in ((self.densely, self._near_disk), (self.sparsely, self._wide_disk)):
            margin = len(disk) // 2
            place = self._place(candidate, margin)
            blocked[place] |= ndimage.binary_dilation(np.pad(ink, margin), disk)

    def count(self, element: Element) -> int:
        """Return how often an element was laid."""
        return sum(one.element is element for one in self._laid)

    def _place(
        self, candidate: _Candidate, margin: int = 0
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

    def share_with(self, candidate: _Candidate) -> float:
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
