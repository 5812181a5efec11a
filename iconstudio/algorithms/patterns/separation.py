"""An image's layers, separated by colour, and what of them is hidden completed (section 3).

In the paper a person separates the layers and recovers what is hidden. Here flat colours are found;
those that make elements together are one layer; and the junctions of contours tell which layers
occlude others. A person may correct which layer is seen where.
"""

from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray
from scipy import ndimage

from iconstudio.algorithms.patterns.clusters import Pixels, sums_of
from iconstudio.algorithms.patterns.completion import completed
from iconstudio.algorithms.patterns.exemplar import MOST_LAYERS, Masks
from iconstudio.algorithms.patterns.flat_colours import FlatColours, flat_colours
from iconstudio.algorithms.patterns.grouping import Areas, grouped_colours
from iconstudio.algorithms.patterns.occlusion import contests, hides, occlusions, order_of
from iconstudio.algorithms.tones.regions import cielab

_CONTESTED = 0.3
"""How much of a layer another one may hide, or regain of it, where they hide each other."""

Layers = NDArray[np.uint8]
"""(h, w), the number of the layer that is seen in each pixel, from the ground, 0, up."""


@dataclass(frozen=True, slots=True, eq=False)
class Separated:
    """The layers of an image."""

    flat: FlatColours
    layer: NDArray[np.int64]
    """(k,), that of each colour, from the ground, 0, up."""
    hides: NDArray[np.bool_]
    """(L + 1, L + 1), which layers hide others."""
    contests: NDArray[np.bool_]
    """(L + 1, L + 1), which of them hide each other, one here and the other there."""
    found: int
    """Layers above the ground that there would be, if there might be more."""
    seen: Layers

    @property
    def count(self) -> int:
        """Layers above the ground."""
        return len(self.hides) - 1

    def masks(self) -> Masks:
        """Return the masks (L, h, w) of the layers above the ground, the uppermost first."""
        return np.stack([self._mask(number) for number in range(self.count, 0, -1)])

    def _mask(self, number: int) -> NDArray[np.float32]:
        own = self.flat.coverage(self.layer == number)
        own = np.where(self.layer[self.flat.first] == self.seen, own, self.seen == number)
        whole = completed(own.astype(np.float32), self._seen_of(self.hides[:, number]))
        for other in np.flatnonzero(self.contests[:, number]):
            area = self.seen == other
            more = completed(whole, area, ends=False)
            if ((more > 0.5) & area).sum() <= _CONTESTED * area.sum():
                whole = more
        return whole

    def _seen_of(self, which: NDArray[np.bool_]) -> NDArray[np.bool_]:
        seen: NDArray[np.bool_] = which[self.seen]
        return seen

    def repainted(self, pixels: Pixels, masks: Masks) -> Pixels:
        """Return the image with these masks, in their order, where they cover what is seen now."""
        painted = pixels.copy()
        for number in range(1, self.count + 1):
            upper = (masks[self.count - number] > 0.5) & (self.seen < number)
            own = (self.seen == number) & (self.layer[self.flat.first] == number)
            if upper.any() and own.any():
                nearest = ndimage.distance_transform_edt(
                    ~own, return_distances=False, return_indices=True
                )
                painted[upper] = self.flat.colours[self.flat.first[tuple(nearest)][upper]]
        return painted

    def corrected(self, seen: Layers) -> "Separated":
        """Return them with other layers seen, as far as there are such."""
        return replace(self, seen=np.minimum(seen, self.count).astype(np.uint8))


def separated(pixels: Pixels, count: int | None = None) -> Separated:
    """Return the layers of an image. The ground is below all others.

    Parameters
    ----------
    count
        How many colours there are at most, with the ground; None: as many as cover enough.

    Raises
    ------
    IconstudioError
        If it has no flat colours, or only one.
    """
    flat = flat_colours(pixels, count)
    first = flat.first
    group = grouped_colours(Areas.of(first), len(flat.colours))
    found = int(group.max())
    group = _fewer(group, flat)
    sizes = np.bincount(group[first].ravel(), minlength=group.max() + 1)
    coverage = np.stack([flat.coverage(group == one) for one in range(len(sizes))])
    votes = occlusions(group[first].astype(np.int16), coverage)
    order = order_of(votes, sizes)
    rank = np.argsort(order)
    layer = rank[group]
    over = hides(votes)[np.ix_(order, order)] & np.tri(len(order), k=-1, dtype=np.bool_)
    both = contests(votes)[np.ix_(order, order)]
    return Separated(flat, layer, over, both, found, layer[first].astype(np.uint8))


def _fewer(group: NDArray[np.int64], flat: FlatColours) -> NDArray[np.int64]:
    """Return at most ``MOST_LAYERS`` groups: the smallest joins the one of the nearest colour."""
    lab = cielab(flat.colours)
    sizes = np.bincount(flat.first.ravel(), minlength=len(lab))
    while group.max() > MOST_LAYERS:
        inked = np.bincount(group, sizes)
        inked[0] = np.inf
        smallest = int(inked.argmin())
        means = sums_of(group, (lab.T * sizes).T) / np.bincount(group, sizes)[:, None]
        away = np.linalg.norm(means - means[smallest], axis=1)
        away[[0, smallest]] = np.inf
        joined = np.where(group == smallest, away.argmin(), group)
        group = np.unique(joined, return_inverse=True)[1]
    return group
