"""Regions of even colour: where the colours of a drawing meet, and how much they differ there.

Within a region colours may flow, as those of a gradient do; two regions meet at an edge, where
colours leap. The pixels of an edge, which blend both, go to the nearer region. Colours are CIELAB,
differences CIEDE2000.
"""

from dataclasses import dataclass

import numpy as np
import scipy
from numpy.typing import NDArray

from iconstudio.algorithms.extremes import maximum_filter, minimum_filter

Mask = NDArray[np.bool_]
Places = tuple[NDArray[np.int32], NDArray[np.int32]]
"""Rows and columns of pixels."""

LEAP = 7.0
"""How much a channel of CIELAB differs within three pixels at an edge; in a gradient, less."""
BLEND = 25.0
"""How far a pixel's colour is from that of the region beside it, if it is a line of its own."""
WHITE, GREY = 92.0, 8.0
"""Near white is lighter than this, and has less chroma."""
ALIKE = 14.0
"""Colours that differ by less, by their distance in CIELAB, are alike."""
PALE, TINT = 85.0, 24.0
"""Pale paper is lighter than this, and has less chroma."""
STRIKING = 35.0
"""Neighbours that differ by more (CIEDE2000) are told apart where a line can do so."""
VISIBLE, VIVID = 18.0, 50.0
"""As STRIKING, for those whose distance in CIELAB is above the second."""
ROOMY = 24.0
"""Width in pixels of the narrowest of these."""
UPON = 0.9
"""How much of its contour a mark upon a region shares with that."""
MOST = 256
"""Regions that are told apart; where there are more, small ones join their neighbours."""
_SMALLEST = 6
"""Fewest pixels of even colour that a region is recognised by."""
_NEAR = 3
"""Pixels on either side of an edge that may be blends."""


@dataclass(frozen=True, eq=False)
class Regions:
    """The k regions of a drawing, numbered from 1; 0 is what surrounds it."""

    labels: NDArray[np.intp]
    """(n, n): the region of each pixel, 0 outside."""
    extended: NDArray[np.intp]
    """(n, n): the region of each pixel, outside that of the nearest."""
    pure: Mask
    """(n, n): the pixels that blend no colours, and are no detail too small for a region."""
    colours: NDArray[np.float64]
    """(k + 1, 3): the mean colours, in CIELAB; the first is white."""
    areas: NDArray[np.float64]
    """(k + 1,): the numbers of pixels."""
    widths: NDArray[np.float64]
    """(k + 1,): the mean widths, in pixels."""
    lengths: NDArray[np.float64]
    """(k + 1, k + 1): the number of pixel sides along which two regions meet."""
    contrasts: NDArray[np.float64]
    """(k + 1, k + 1): the mean difference of their colours there; 0 where they do not meet."""

    @property
    def white(self) -> Mask:
        """(k + 1,): the regions that are near white."""
        white = near_white(self.colours)
        white[0] = False
        return white

    @property
    def around(self) -> NDArray[np.float64]:
        """(k + 1,): the lengths of their contours, in pixel sides, at least 1."""
        around: NDArray[np.float64] = np.maximum(self.lengths.sum(axis=1), 1)
        return around

    @property
    def beside(self) -> NDArray[np.float64]:
        """(k + 1, k + 1): how long each is beside others, not counting the marks upon it."""
        return np.where(self.lengths > UPON * self.around, 0, self.lengths)

    @property
    def striking(self) -> Mask:
        """(k + 1, k + 1): which neighbours differ strikingly, by CIEDE2000 or by colour alone.

        CIEDE2000 weighs chroma little where it is high: a strong yellow is near white by it. What
        is narrow, as the white of an eye, has no room for that difference.
        """
        apart = np.linalg.norm(self.colours[:, None] - self.colours, axis=2)
        wide = self.widths > ROOMY
        vivid = (self.contrasts > VISIBLE) & (apart > VIVID) & wide & wide[:, None]
        striking: Mask = (self.contrasts > STRIKING) | vivid
        return striking

    def pieces(self) -> NDArray[np.intp]:
        """Return which separate piece of the drawing each region belongs to; 0 is one, too."""
        meet = self.lengths > 0
        meet[0] = meet[:, 0] = False
        number: NDArray[np.intp]
        _, number = scipy.sparse.csgraph.connected_components(meet)
        return number


def sums(
    number: NDArray[np.intp], values: NDArray[np.integer | np.floating], count: int = 0
) -> NDArray[np.float64]:
    """Return the sums of the values of each number, of ``count`` at least."""
    found: NDArray[np.float64] = np.bincount(number, values, count)  # type: ignore[assignment]  # NumPy tells only of counts
    return found


def near_white(lab: NDArray[np.floating]) -> Mask:
    """Return which colours (..., 3), in CIELAB, are near white."""
    lightness, a, b = np.moveaxis(lab, -1, 0)
    white: Mask = (lightness > WHITE) & (np.hypot(a, b) < GREY)
    return white


def pale(lab: NDArray[np.floating]) -> Mask:
    """Return which colours (..., 3), in CIELAB, are those of paper: near white, or a mere tint."""
    lightness, a, b = np.moveaxis(lab, -1, 0)
    found: Mask = (lightness > PALE) & (np.hypot(a, b) < TINT)
    return found


def regions(
    lab: NDArray[np.float32],
    inside: Mask,
    contrast: float,
    smallest: float,
    cores: NDArray[np.intp] | None = None,
    leap: float = LEAP,
) -> Regions:
    """Divide what is ``inside`` (n, n) of a drawing (n, n, 3), in CIELAB, into regions.

    Neighbours whose colours differ by less than ``contrast`` are one region; a region of fewer
    than ``smallest`` pixels joins the neighbour that is most like it. Something must be inside.
    The regions grow from ``cores`` (n, n), numbered from 1; by default, from what is of even colour
    and from lines; colours are even where no channel differs by ``leap``.
    """
    pure = inside
    if cores is None:
        cores = even_pieces(lab, inside, leap)
        pure = cores > 0
        hairlines = _hairlines(lab, inside, cores, nearest(pure))
        cores = np.where(hairlines > 0, hairlines + cores.max(), cores)
    at = nearest(cores > 0)
    extended, flat = cores[at], lab[at]
    labels = np.where(inside, extended, 0)
    lengths, differences = _meetings(labels, flat)
    areas = np.bincount(labels.ravel(), minlength=len(lengths)).astype(float)
    totals = [sums(labels.ravel(), flat[..., c].ravel(), len(areas)) for c in range(3)]
    root, small = _joined(lengths, differences, areas.copy(), contrast, smallest)
    pure = pure & ~small[labels]
    kept, number = np.unique(root, return_inverse=True)
    areas = sums(number, areas)
    colours = np.stack([sums(number, total) for total in totals], axis=1)
    colours /= np.maximum(areas, 1)[:, None]
    colours[0] = 100, 0, 0
    pairs = np.ix_(kept, kept)
    contrasts = differences[pairs] / np.maximum(lengths[pairs], 1)
    labels = number[labels]
    widths = _widths(labels, areas)
    return Regions(
        labels, number[extended], pure, colours, areas, widths, lengths[pairs], contrasts
    )


def pieces(lab: NDArray[np.float32], inside: Mask, dark: Mask) -> Regions:
    """Divide what is ``inside`` of a drawing into the pieces that are dark, and those that are not.

    ``lab`` (2, 3) are the colours of the pale and of the dark ones.
    """
    found = scipy.ndimage.label(inside & dark, np.ones((3, 3)))[0]
    pale = scipy.ndimage.label(inside & ~dark)[0]
    cores = _largest(np.where(pale > 0, pale + found.max(), found), 1)
    return regions(lab[dark.astype(np.intp)], inside, 0, 0, cores)


def cielab(rgb: NDArray[np.uint8]) -> NDArray[np.float32]:
    """Return sRGB colours (..., 3) in CIELAB; a drawing has few, so each is converted once."""
    from skimage.color import rgb2lab

    packed = (rgb.astype(np.uint32) @ np.array([1 << 16, 1 << 8, 1], np.uint32)).ravel()
    begins = np.flatnonzero(np.diff(packed, prepend=~packed[:1]))  # a run of one colour
    found, number = np.unique(packed[begins], return_inverse=True)
    colours = np.stack([found >> 16, found >> 8 & 255, found & 255], axis=1).astype(np.uint8)
    lab: NDArray[np.float32] = rgb2lab(colours).astype(np.float32)
    number = np.repeat(number, np.diff(begins, append=packed.size))
    return lab[number].reshape(rgb.shape)


def even_pieces(lab: NDArray[np.float32], inside: Mask, leap: float) -> NDArray[np.intp]:
    """Number the pieces of even colour; 0 at edges and outside."""
    even = inside.copy()
    for channel in np.moveaxis(lab, 2, 0):
        high = maximum_filter(np.where(inside, channel, -np.inf), 3)
        low = minimum_filter(np.where(inside, channel, np.inf), 3)
        even &= high - low < leap
    cores = _largest(scipy.ndimage.label(even)[0], _SMALLEST)
    # A piece without any even colour, as of thin strokes, is one region.
    pieces, count = scipy.ndimage.label(inside)
    bare = np.ones(count + 1, bool)
    bare[pieces[cores > 0]] = bare[0] = False
    strokes = _largest(np.where(bare[pieces], pieces, 0), 1)
    return np.where(strokes > 0, strokes + cores.max(), cores)


def _hairlines(
    lab: NDArray[np.float32], inside: Mask, cores: NDArray[np.intp], at: Places
) -> NDArray[np.intp]:
    """Number the lines that are too thin for even colour; 0 elsewhere."""
    labels = cores[at]
    size = 2 * _NEAR + 1
    alone = maximum_filter(labels, size) == minimum_filter(labels, size)
    thin = alone & inside & (cores == 0)
    thin[thin] = np.linalg.norm(lab[thin] - lab[at][thin], axis=1) > BLEND
    return _largest(scipy.ndimage.label(thin, np.ones((3, 3)))[0], 4 * _SMALLEST)


def _largest(pieces: NDArray[np.intp], smallest: int) -> NDArray[np.intp]:
    """Number the largest pieces anew."""
    sizes = np.bincount(pieces.ravel())
    sizes[0] = 0
    kept = np.argsort(-sizes, kind="stable")[:MOST]
    kept = kept[sizes[kept] >= smallest]
    number = np.zeros(len(sizes), np.intp)
    number[kept] = np.arange(1, len(kept) + 1)
    return number[pieces]


def nearest(marked: Mask) -> Places:
    """Return rows and columns of the marked pixel that is nearest to each pixel."""
    rows, columns = scipy.ndimage.distance_transform_edt(
        ~marked, return_distances=False, return_indices=True
    )
    return rows, columns


def hull(mask: Mask) -> Mask:
    """Return the convex hull of a mask (h, w)."""
    from skimage.morphology import convex_hull_image

    whole: Mask = convex_hull_image(mask) if mask.any() else mask
    return whole


def _meetings(
    labels: NDArray[np.intp], lab: NDArray[np.float32]
) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Return at how many pixel sides each two labels meet, and the sum of the differences there."""
    from skimage.color import deltaE_ciede2000

    count = labels.max() + 1
    lengths, totals = np.zeros((2, count * count))
    framed = np.pad(labels, 1)
    colours = np.pad(lab, ((1, 1), (1, 1), (0, 0)))
    for one, other in (
        (np.s_[1:], np.s_[:-1]),
        (np.s_[:, 1:], np.s_[:, :-1]),
    ):
        meet = framed[one] != framed[other]
        pairs = framed[one][meet] * count + framed[other][meet]
        differences = deltaE_ciede2000(colours[one][meet], colours[other][meet])
        lengths += np.bincount(pairs, minlength=count * count)
        totals += np.bincount(pairs, differences, count * count)
    lengths, totals = lengths.reshape(count, count), totals.reshape(count, count)
    return lengths + lengths.T, totals + totals.T


def _widths(labels: NDArray[np.intp], areas: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return the mean width of each region."""
    contour = maximum_filter(labels, 2) != minimum_filter(labels, 2)
    contour[[0, -1]] = contour[:, [0, -1]] = True
    depth = scipy.ndimage.distance_transform_edt(~contour)
    # Across a line of width w, the mean distance from its sides is w / 4.
    return 4 * sums(labels.ravel(), depth.ravel()) / np.maximum(areas, 1)


def _joined(
    lengths: NDArray[np.float64],
    differences: NDArray[np.float64],
    areas: NDArray[np.float64],
    contrast: float,
    smallest: float,
) -> tuple[NDArray[np.intp], Mask]:
    """Join regions, in all three arrays, the most alike first.

    Return which each belongs to, and which were too small to be one.
    """
    root, too_small = np.arange(len(areas)), np.zeros(len(areas), bool)
    mean = np.full(lengths.shape, np.inf)
    np.divide(differences, lengths, out=mean, where=lengths > 0)
    mean[0] = mean[:, 0] = np.inf

    def join(one: int, other: int) -> None:
        for array in (lengths, differences):
            array[one] += array[other]
            array[:, one] += array[:, other]
            array[other] = array[:, other] = array[one, one] = 0
        areas[one] += areas[other]
        areas[other] = 0
        root[root == other] = one
        mean[other] = mean[:, other] = np.inf
        row = np.full(len(areas), np.inf)
        np.divide(differences[one], lengths[one], out=row, where=lengths[one] > 0)
        row[0] = np.inf
        mean[one] = mean[:, one] = row

    while mean.min() < contrast:
        join(*sorted(map(int, np.unravel_index(mean.argmin(), mean.shape))))
    while True:
        small = np.flatnonzero((areas > 0) & (areas < smallest) & np.isfinite(mean).any(axis=1))
        if not len(small):
            return root, too_small
        one = small[areas[small].argmin()]
        too_small |= root == one
        join(int(mean[one].argmin()), int(one))
