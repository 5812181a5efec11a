"""The palette of a bitmap that a computer drew: the colours that its areas are painted with.

A colour is flat, or the shade that an area has as its own: a gradient, or a blurred shadow. Colours
are sRGB times alpha, and alpha, from 0 to 255, so that nothing is a colour, too.
"""

from collections.abc import Callable, Iterator
from itertools import combinations
from typing import NamedTuple

import numpy as np
import scipy
from numpy.typing import NDArray

from iconstudio.algorithms.extremes import greatest_channel, maximum_filter, minimum_filter
from iconstudio.algorithms.scanning.blending import unblended
from iconstudio.algorithms.scanning.ground import CLEAR, Ground, are_alike, unevenness
from iconstudio.algorithms.scanning.pieces import pieces_alike
from iconstudio.algorithms.tones.regions import Mask, nearest

_EVEN = 20.0
"""Levels by which a channel differs within three pixels of an evenly painted area, at most."""
_FLAT, _STEEP, _BAND = 6.0, 60.0, 5
"""As _EVEN, where colours change by degrees on small bitmaps; pixels across that they do so."""
SMALL = 64
"""Pixels of the longer side of a bitmap in which there is as much of edges as of colours."""
_BIN = 8
"""Levels of a channel that are counted as one."""
_CLOSE = 10.0
"""Levels by which a channel of a colour differs from the ground's, or is no other."""
_SHARE, _FEWEST = 0.0015, 6
"""Least part of the evenly painted pixels that have a colour of the palette, and their number."""
_BLOCK = 64
"""Pixels of a block, of which lossy files leave noise beside edges."""
_SPREAD = 9.0
"""Levels by which the pixels of one colour stray, as root of the mean square."""
_GRAINY = 4.0
"""Levels by which the pixels of a shade stray from those around, at most."""
_GRAIN = 0.05
"""How much of the evenly painted pixels may belong to such, as JPEG leaves beside edges."""
_BESIDE = 0.1
"""So many pixels, as part of its own, an edge has beside it of what it lies between, at least."""
_OF_MEDIAN = 1.48
"""Root of the mean square of noise, as a multiple of the median."""
_MOST = 20
"""Colours of a palette."""


class Palette(NamedTuple):
    """The k colours of a bitmap (h, w)."""

    colours: NDArray[np.float32]
    """(k, 4); of a shade, the median."""
    counts: NDArray[np.intp]
    """(k,): pixels that are evenly painted so."""
    number: NDArray[np.intp]
    """(h, w): the number of each evenly painted pixel's colour, else -1."""
    shades: dict[int, NDArray[np.float32]]
    """Of the colours that are no flat ones, (h, w, 4) what each is everywhere."""
    lossy: bool = False
    """Whether pixels stray from their colours, as in lossy files."""

    def at(self, one: int, mask: NDArray[np.bool_]) -> NDArray[np.float32]:
        """Return a colour where the mask says: (n, 4), or (1, 4) if it is flat."""
        shade = self.shades.get(one)
        return self.colours[one][None] if shade is None else shade[mask]

    def with_colour(self, colour: NDArray[np.float32]) -> "Palette":
        """Return it with a colour (4,) of what is too small to be evenly painted."""
        colours = np.concatenate([self.colours, colour[None]])
        return self._replace(colours=colours, counts=np.append(self.counts, 0))

    def without_blends(self, blended: NDArray[np.float32]) -> "Palette":
        """Return it without the colours of edges: slim, between others in place and in colour.

        The first colour stays.
        """
        wide = evenly_painted(blended, 3)
        flat = [one for one in range(len(self.colours)) if one not in self.shades]
        alike = {one: greatest_channel(abs(blended - self.colours[one])) < _EVEN for one in flat}
        kept = set(range(len(self.colours)))
        for one in flat[:0:-1]:
            area = self.number == one if self.counts[one] else alike[one]
            if not area.any() or (area & wide).any():
                continue
            around = scipy.ndimage.binary_dilation(area, np.ones((5, 5))) & ~area
            least = _BESIDE * area.sum()
            near = [n for n in flat if n in kept - {one} and (around & alike[n]).sum() > least]
            others = [self.colours[n] for n in near]
            others += [np.median(shade[area], axis=0) for shade in self.shades.values()]
            if _is_blend(self.colours[one], others):
                kept.remove(one)
        return self._only(sorted(kept))

    def has_blends_of(self, one: int) -> bool:
        """Whether a colour blends another with this one, so that it cannot be told from edges."""
        ways = self.colours - self.colours[one]
        shares = ways @ ways.T / np.maximum((ways**2).sum(axis=1), 1)
        away = np.linalg.norm(ways[:, None] - shares[..., None] * ways, axis=2)
        return bool(((shares > 0.1) & (shares < 0.9) & (away < 2 * _EVEN)).any())

    def _only(self, kept: list[int]) -> "Palette":
        """Return it with some of its colours."""
        renamed = np.full(len(self.colours) + 1, -1)
        renamed[kept] = np.arange(len(kept))
        shades = {int(renamed[one]): shade for one, shade in self.shades.items()}
        return Palette(
            self.colours[kept], self.counts[kept], renamed[self.number], shades, self.lossy
        )

    def noise(self, one: int, blended: NDArray[np.float32]) -> float:
        """Return by how many levels the pixels of a colour stray, but for those beside edges."""
        here = blended[self.number == one]
        away = abs(here - np.median(here, axis=0))
        return _OF_MEDIAN * float(np.median(away, axis=0).max())

    def is_exact(self, blended: NDArray[np.float32]) -> bool:
        """Whether most of what is flat has the very same colour, as lossy files do not keep it."""
        flat = (self.number >= 0) & ~np.isin(self.number, list(self.shades))
        return are_alike(blended[flat], self.colours[self.number[flat]])

    def without(self, one: int, other: int) -> "Palette":
        """Return it with the pixels of one colour given to another."""
        number = np.where(self.number == one, other, self.number)
        counts = self.counts.copy()
        counts[other] += counts[one]
        counts[one] = 0
        return self._replace(counts=counts, number=number)


def palette_of(blended: NDArray[np.float32], ground: Ground | None) -> Palette | None:
    """Return the palette of a bitmap (h, w, 4); None if it is too coarse, or has too many colours.

    It has two colours at least, the first of them that of its ``ground``.
    """
    small = max(blended.shape[:2]) <= SMALL
    wide = evenly_painted(blended, 3)
    even = wide | evenly_painted(blended, 2) if small else wide
    if not even.any():
        return None
    least = max(_FEWEST, _SHARE * even.sum())
    drawn = even if ground is None else even & ~ground.mask
    pieces = _pieces(blended, wide & drawn, least)
    shaded = [piece for piece in pieces if _strays(blended[piece]) > _SPREAD]
    if small and (ground is None or not ground.is_lossy(blended)):
        shaded += _steeply_shaded(blended, shaded, least)
    shaded = [_grown(blended, piece, drawn) for piece in shaded]
    flat = drawn & ~np.any(shaded, axis=0) if shaded else drawn
    areas = list(_clusters(blended, flat, least))
    behind: list[NDArray[np.bool_]] = []
    if ground is not None:
        if not (small and ground.is_exact(blended)):
            areas = list(_without_rings(blended, areas, ground))
        areas, behind = _without_ground(blended, areas, ground)
    if small:
        areas = [_trimmed(blended, area) for area in areas]
    if len(areas) > _MOST:
        return None
    shaded, grainy = _divided(shaded, lambda piece: _is_grainy(blended, piece))
    areas, straying = _divided(areas, lambda area: _strays(blended[area]) > _SPREAD)
    if sum(map(np.sum, grainy + straying)) > _GRAIN * even.sum():
        return None
    areas = behind + areas
    colours = [np.median(blended[area], axis=0) for area in areas]
    number = np.full(even.shape, -1)
    for one, area in enumerate(areas):
        number[area] = one
    number[_at_edges(blended, number, colours)] = -1
    shades = {}
    for piece in _joined(blended, shaded):
        number[piece] = len(colours)
        shades[len(colours)] = _extended(blended, piece)
        colours.append(np.median(blended[piece], axis=0))
    if not 2 - small <= len(colours) <= _MOST:
        return None
    counts = np.bincount(number[number >= 0], minlength=len(colours))
    palette = Palette(np.stack(colours).astype(np.float32), counts, number, shades)
    return palette.without_blends(blended) if small else palette


def evenly_painted(blended: NDArray[np.float32], size: int) -> NDArray[np.bool_]:
    """Return which pixels lie in a square of even colour, that many pixels wide, or show nothing.

    Of a square of three pixels, only the middle.
    """
    even: NDArray[np.bool_] = unevenness(blended, size) < _EVEN
    if size == 2:
        even[0] = even[:, 0] = False
        even = scipy.ndimage.binary_dilation(even, np.ones((2, 2)))
    return even | (blended[..., 3] < CLEAR)


def is_in_one_colour(blended: NDArray[np.float32]) -> bool:
    """Whether a bitmap (h, w, 4) shows one colour on one ground, and else the blends of edges."""
    even = evenly_painted(blended, 3)
    ground = np.median(blended[even] if even.any() else blended.reshape(-1, 4), axis=0)
    away = np.linalg.norm(blended - ground, axis=2)
    colour = blended[np.unravel_index(away.argmax(), away.shape)]
    way = colour - ground
    share = np.clip((blended - ground) @ way / max(way @ way, 1), 0, 1)
    strays = np.linalg.norm(blended - ground - share[..., None] * way, axis=2)
    between = np.minimum(share, 1 - share) * np.linalg.norm(way) > _EVEN
    shaded = scipy.ndimage.binary_erosion(between, np.ones((3, 3)))
    return bool(strays.max() < _EVEN and not shaded.any())


def _clusters(
    blended: NDArray[np.float32], even: NDArray[np.bool_], least: float
) -> Iterator[NDArray[np.bool_]]:
    """Yield (h, w) the pixels of each colour that has many: what lies in bins side by side."""
    bins = tuple((blended[even] / _BIN).astype(np.intp).T)
    counts = np.zeros((256 // _BIN,) * 4, np.intp)
    np.add.at(counts, bins, 1)
    frequent = counts >= least / 4
    clusters, count = scipy.ndimage.label(frequent, np.ones((3, 3, 3, 3)))
    of = clusters[bins]
    sizes = np.bincount(of, minlength=count + 1)
    for one in 1 + np.flatnonzero(sizes[1:] >= least):
        cluster = np.zeros_like(even)
        cluster[even] = of == one
        yield cluster


def _at_edges(
    blended: NDArray[np.float32], number: NDArray[np.intp], colours: list[NDArray[np.float32]]
) -> NDArray[np.bool_]:
    """Return which pixels of a flat colour blend it with one that lies beside it, as pale as it."""
    high = maximum_filter(number, 3)
    low = minimum_filter(np.where(number < 0, high, number), 3)
    edge: NDArray[np.bool_] = (number >= 0) & (high != low)
    away = abs(blended[edge] - np.reshape(colours, (-1, 4))[number[edge]]).max(axis=1)
    edge[edge] = away > _CLOSE / 2
    return edge


def _without_rings(
    blended: NDArray[np.float32], areas: list[NDArray[np.bool_]], ground: Ground
) -> Iterator[NDArray[np.bool_]]:
    """Yield the areas without what lossy files leave at edges: slim, and nearly as the ground."""
    for area in areas:
        if abs(np.median(blended[area], axis=0) - ground.colour).max() < 2 * _EVEN:
            area = scipy.ndimage.binary_opening(area, np.ones((3, 3)))
            pieces, count = scipy.ndimage.label(area)
            beside = np.unique(pieces[scipy.ndimage.binary_dilation(ground.mask, np.ones((5, 5)))])
            noise = np.isin(np.arange(count + 1), beside) & (np.bincount(pieces.ravel()) < _BLOCK)
            area = area & ~noise[pieces]
        if area.any():
            yield area


def _without_ground(
    blended: NDArray[np.float32], areas: list[NDArray[np.bool_]], ground: Ground
) -> tuple[list[NDArray[np.bool_]], list[NDArray[np.bool_]]]:
    """Return the areas of other colours than that of the ground, and the one area of that."""
    others, alike = _divided(
        areas, lambda area: abs(np.median(blended[area], axis=0) - ground.colour).max() < _CLOSE
    )
    return others, [np.any([ground.mask, *alike], axis=0)]


def _trimmed(blended: NDArray[np.float32], area: NDArray[np.bool_]) -> NDArray[np.bool_]:
    """Return an area without what goes over into another colour, as edges that run aslant do."""
    away = greatest_channel(abs(blended - np.median(blended[area], axis=0)))
    trimmed: NDArray[np.bool_] = area & (away < _EVEN)
    return trimmed


def _is_blend(colour: NDArray[np.float32], others: list[NDArray[np.float32]]) -> bool:
    """Whether a colour (4,) blends two or three others."""
    some = (one for size in (2, 3) for one in combinations(others, size))
    return any(unblended(colour[None], [one[None] for one in of])[1] < _EVEN**2 for of in some)


def _pieces(
    blended: NDArray[np.float32], even: NDArray[np.bool_], least: float, leap: float = _EVEN
) -> Iterator[NDArray[np.bool_]]:
    """Yield (h, w) the evenly painted pieces, in which colours do not leap, if large enough."""
    labels = pieces_alike(blended, even, leap)
    for label in np.flatnonzero(np.bincount(labels[even]) >= least):
        yield labels == label


def _steeply_shaded(
    blended: NDArray[np.float32], shaded: list[NDArray[np.bool_]], least: float
) -> list[NDArray[np.bool_]]:
    """Return pieces of a small bitmap in which colours change by degrees, but fast.

    They are wider than an edge, or the band between two flat colours that differ little.
    """
    change = unevenness(blended, 3)
    by_degrees = (change > _FLAT) & (change < _STEEP)
    for piece in shaded:
        by_degrees &= ~piece
    wide = scipy.ndimage.binary_opening(by_degrees, np.ones((_BAND, _BAND)))
    pieces = _pieces(blended, by_degrees, least, _STEEP / 2)
    wide_enough = (piece for piece in pieces if (piece & wide).any())
    return [piece for piece in wide_enough if not _is_grainy(blended, piece)]


def _joined(
    blended: NDArray[np.float32], pieces: list[NDArray[np.bool_]]
) -> list[NDArray[np.bool_]]:
    """Join pieces that continue each other's shade, as on both sides of a line."""
    joined: list[NDArray[np.bool_]] = []
    for piece in sorted(pieces, key=np.sum, reverse=True):
        for n, other in enumerate(joined):
            away = _extended(blended, other)[piece] - blended[piece]
            if (away**2).mean(axis=0).max() ** 0.5 <= _SPREAD:
                joined[n] = other | piece
                break
        else:
            joined.append(piece)
    return joined


def _grown(
    blended: NDArray[np.float32], piece: NDArray[np.bool_], even: NDArray[np.bool_]
) -> NDArray[np.bool_]:
    """Return a piece with what continues its shade: beside it, or, as within a ring, beyond."""
    beside = greatest_channel(abs(_extended(blended, piece) - blended)) < _EVEN
    beyond = greatest_channel(abs(_polynomial(blended, piece) - blended)) < _EVEN / 2
    grown: NDArray[np.bool_] = scipy.ndimage.binary_propagation(piece, mask=piece | (beside & even))
    grown |= beyond & even
    return grown


def _polynomial(blended: NDArray[np.float32], piece: NDArray[np.bool_]) -> NDArray[np.float32]:
    """Return (h, w, 4) the polynomial of the second degree that fits a piece best."""
    y, x = np.mgrid[-1 : 1 : piece.shape[0] * 1j, -1 : 1 : piece.shape[1] * 1j]
    terms = np.stack([np.ones_like(x), x, y, x * x, x * y, y * y], axis=2).astype(np.float32)
    weights = np.linalg.lstsq(terms[piece], blended[piece], rcond=None)[0]
    fitted: NDArray[np.float32] = terms @ weights
    return fitted


def _strays(colours: NDArray[np.float32]) -> float:
    return float(((colours - np.median(colours, axis=0)) ** 2).mean(axis=0).max() ** 0.5)


def _is_grainy(blended: NDArray[np.float32], piece: NDArray[np.bool_]) -> bool:
    """Whether colours leap from pixel to pixel, as on photos."""
    weight = scipy.ndimage.gaussian_filter(piece.astype(np.float32), 1)
    known = np.where(piece[..., None], blended, 0)
    smooth = scipy.ndimage.gaussian_filter(known, (1, 1, 0)) / np.maximum(weight, 1e-6)[..., None]
    inner = scipy.ndimage.binary_erosion(piece)
    rest = (blended - smooth)[inner if inner.any() else piece]
    return bool((rest**2).mean(axis=0).max() ** 0.5 > _GRAINY)


def _extended(blended: NDArray[np.float32], piece: NDArray[np.bool_]) -> NDArray[np.float32]:
    """Return (h, w, 4) the colours of a piece, and around it those of its nearest pixel."""
    extended: NDArray[np.float32] = blended[nearest(piece)]
    return extended


def _divided(masks: list[Mask], bad: Callable[[Mask], bool]) -> tuple[list[Mask], list[Mask]]:
    """Return which masks are good, and which are bad."""
    good: list[Mask] = []
    others: list[Mask] = []
    for mask in masks:
        (others if bad(mask) else good).append(mask)
    return good, others
