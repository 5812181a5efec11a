"""Multiresolution, multilayer synthesis by expectation maximisation (Algorithm 1).

Resolutions double up to the target's; at each, neighbourhoods halve from a quarter of the picture
down to 8 x 8; for each size, M-step and E-step take turns. The paper's bounds of the resolutions
contradict each other. Here the first is the coarsest at which the exemplar still has ``COARSEST``
pixels a side.
"""

from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray
from scipy.ndimage import zoom

from iconstudio.algorithms.patterns import level_set
from iconstudio.algorithms.patterns.distance import Field, signed_distance
from iconstudio.algorithms.patterns.energy import Channels, per_pixel, reduced, reduced_shape
from iconstudio.algorithms.patterns.exemplar import Colours, Distances, Pattern, Places
from iconstudio.algorithms.patterns.layers import collapse
from iconstudio.algorithms.patterns.laying import Mended, Other
from iconstudio.algorithms.patterns.loose_ends import joined
from iconstudio.algorithms.patterns.matching import (
    Integers,
    Neighbourhoods,
    differences,
    matched,
)
from iconstudio.algorithms.patterns.mending import mended
from iconstudio.algorithms.patterns.prepared import Prepared
from iconstudio.algorithms.patterns.quilting import quilted
from iconstudio.algorithms.patterns.texture import means, robust_weights, sources
from iconstudio.algorithms.patterns.torn import torn_ink
from iconstudio.algorithms.patterns.warping import warped
from iconstudio.model import IconstudioError

COARSEST = 32
SMALLEST_WINDOW, LARGEST_WINDOW = 8, 64
_CONVERGED = 0.005
"""By how much of itself the energy sinks at least in an iteration that another one follows."""
_FIRST, _CHANGE = 0.2, 0.75
"""lambda at first, and by how much it grows and mu = 1 - lambda sinks."""


@dataclass(frozen=True, slots=True, eq=False)
class Settings:
    """What is wanted."""

    size: tuple[int, int]
    """Rows and columns."""
    tile: bool = False
    seed: int = 0
    iterations: int = 10
    """At most, for each size of neighbourhoods."""
    mend: bool = True
    """Whether torn elements are made whole."""
    guidance: NDArray[np.float32] | None = None
    """How much of each pixel lies where ink may be, from 0 to 1, of the size of the pattern; None
    for everywhere. It needs mending."""


def synthesised(
    prepared: Prepared, settings: Settings, ask: Callable[[], None] = lambda: None
) -> Iterator[Pattern]:
    """Give previews, finer and finer, and at last the finished pattern.

    The same settings make the same bytes.

    Parameters
    ----------
    ask
        Called at least every 50 ms; what it raises ends the synthesis.

    Raises
    ------
    IconstudioError
        If the exemplar or the size is too small.
    """
    guidance = settings.guidance
    if guidance is not None and (guidance.shape != settings.size or not (guidance > 0.5).any()):
        raise IconstudioError("The shape to fill is empty, or not as large as the pattern.")
    if min(settings.size) < 2 * SMALLEST_WINDOW:
        raise IconstudioError("A pattern is at least 16 pixels wide and high.")
    yield from _Synthesis(prepared, settings, ask).run()


class _Synthesis:
    """One run."""

    def __init__(self, prepared: Prepared, settings: Settings, ask: Callable[[], None]) -> None:
        self._prepared, self._settings, self._ask = prepared, settings, ask
        self._weights = prepared.weights
        self._random = np.random.default_rng(settings.seed)

    def run(self) -> Iterator[Pattern]:
        """Go through the resolutions."""
        source: Places | None = None
        factor = self._first()
        while True:
            shape = reduced_shape(self._settings.size, factor)
            exemplar = reduced(self._prepared.channels, factor)
            if source is None:
                source = self._quilted(exemplar, shape, factor)
            else:
                source = upsampled(source, shape, exemplar.shape[:2])
            picture = exemplar[source[..., 0], source[..., 1]]
            energy = 0.0
            for window in windows(min(shape), min(exemplar.shape[:2])):
                picture, source, energy = self._optimised(
                    picture, source, exemplar, window, factor == 1
                )
            if factor == 1:
                break
            yield self._preview(picture, source, factor, energy)
            factor //= 2
        yield self._finished(picture, source)

    def _first(self) -> int:
        sides = *self._settings.size, *self._prepared.exemplar.colours.shape[:2]
        factor = 16
        while factor > 1 and min(sides) < COARSEST * factor:
            factor //= 2
        return factor

    def _quilted(self, exemplar: Channels, shape: tuple[int, int], factor: int) -> Places:
        side = max(SMALLEST_WINDOW, min(exemplar.shape[:2]) // 2)
        solidity = reduced(self._prepared.solidity[..., None], factor)[..., 0]
        return quilted(
            exemplar, solidity, shape, side, self._settings.tile, self._random, self._ask
        )

    def _optimised(
        self, picture: Channels, source: Places, exemplar: Channels, window: int, finest: bool
    ) -> tuple[Channels, Places, float]:
        """Return a picture, and where it comes from, after M-steps and E-steps; and its energy."""
        where = Neighbourhoods.of(picture.shape[:2], window, self._settings.tile)
        matches = where.matches(source, exemplar)
        before = np.inf
        for n in range(self._settings.iterations):
            seed = int(self._random.integers(1 << 62))
            matches, costs = matched(picture, exemplar, where, matches, seed, self._ask)
            energy = per_pixel(costs, window)
            if energy == 0 or before - energy < _CONVERGED * before:
                break
            before = energy
            attraction = _FIRST + _CHANGE * n / self._settings.iterations
            self._ask()
            picture = self._expected(picture, exemplar, where, matches, costs, attraction, finest)
        self._ask()
        return picture, sources(picture, exemplar, where, matches, costs), energy

    def _expected(
        self,
        picture: Channels,
        exemplar: Channels,
        where: Neighbourhoods,
        matches: Places,
        costs: Integers,
        attraction: float,
        finest: bool,
    ) -> Channels:
        """Return the picture of the E-step.

        The robust weights and the curvature may raise equation 6; the plain means, which minimise
        it, are then taken instead.
        """
        window = where.window
        if finest:
            mean = means(exemplar, where, matches, robust_weights(costs, window))
            picture = self._evolved(picture, mean, attraction)
            moved = differences(picture, exemplar, where, matches)
            mean = means(exemplar, where, matches, robust_weights(moved, window))
            shown = self._weights.shown
            after = np.concatenate([mean[..., :shown], picture[..., shown:]], axis=2)
        else:
            after = means(exemplar, where, matches, robust_weights(costs, window))
        self._ask()
        if differences(after, exemplar, where, matches).sum() > costs.sum():
            after = means(exemplar, where, matches, np.ones(costs.shape))
        return after

    def _evolved(self, picture: Channels, mean: Channels, attraction: float) -> Channels:
        """Return the picture with its zero level sets moved, and its colours warped along."""
        tile = self._settings.tile
        before, goal = self._weights.distances(picture), self._weights.distances(mean)
        after = np.empty_like(before)
        for m, (one, to) in enumerate(zip(before, goal, strict=True)):
            self._ask()
            after[m] = level_set.evolved(one, to, attraction, 1 - attraction, tile)
        colours = self._weights.colours(picture)[..., : self._weights.shown]
        moved = colours
        for m in reversed(range(len(after))):  # collapse: the first layer over all others
            self._ask()
            layer = warped(colours, before[m], after[m], tile)
            foreground = (after[m] < 0) | (before[m] < 0)
            moved = np.where(foreground[..., None], layer, moved)
        return self._weights.channels(moved, after)

    def _preview(self, picture: Channels, source: Places, factor: int, energy: float) -> Pattern:
        """Return a coarse picture as large as the finished one."""
        while factor > 1:
            factor //= 2
            shape = reduced_shape(self._settings.size, factor)
            most = reduced_shape(self._prepared.exemplar.colours.shape[:2], factor)
            source = upsampled(source, shape, most)
        coarse = self._weights.distances(picture)
        distances = [enlarged(one, self._settings.size) for one in coarse]
        # What it is made of is whole in a preview, too: coarse icons are rubble.
        random = np.random.default_rng(self._settings.seed)
        pattern = self._joined(self._layers(distances, source, random), source)
        return replace(pattern, energy=energy)

    def _finished(self, picture: Channels, source: Places) -> Pattern:
        tile = self._settings.tile
        layers = self._layers(self._weights.distances(picture), source, self._random)
        pattern = self._joined(layers, source)
        self._ask()
        torn = np.mean([
            torn_ink(distance < 0, mask > 0.5, tile, self._ask)
            for distance, mask in zip(pattern.distances, self._prepared.exemplar.masks, strict=True)
        ])  # fmt: skip
        self._ask()
        energy = self._energy(pattern.colours, pattern.distances, layers[0].source)
        return replace(pattern, energy=energy, torn=float(torn), finished=True)

    def _layers(
        self, distances: Iterable[Field], source: Places, random: np.random.Generator
    ) -> list[Mended]:
        layers: list[Mended] = []
        for m, distance in enumerate(distances):
            self._ask()
            exact = signed_distance(-distance, self._settings.tile, self._ask)
            self._ask()
            layers.append(
                self._mended(m, exact, source, layers, random)
                if self._settings.mend
                else Mended.nothing(exact, source)
            )
        return layers

    def _joined(self, layers: Sequence[Mended], source: Places) -> Pattern:
        """Return a pattern of layers, whose energy and torn ink are not measured yet."""
        distances = np.stack([one.distance for one in layers])
        self._ask()
        colours = collapse(
            distances, [one.source for one in layers] + [source], self._prepared.paints
        )
        placed = tuple(one for layer in layers for one in layer.placed)
        before = np.cumsum([0] + [len(one.placed) for one in layers])
        owners = np.stack([
            np.where(one.owner, one.owner + first, 0).astype(np.int32)
            for one, first in zip(layers, before, strict=False)
        ])  # fmt: skip
        return Pattern(
            colours, distances, 0.0, 0.0, self._settings.tile, False, placed, owners,
            self._prepared.elements,
        )  # fmt: skip

    def _mended(
        self,
        m: int,
        distance: Field,
        source: Places,
        above: Sequence[Mended],
        random: np.random.Generator,
    ) -> Mended:
        """Return a layer of whole elements, which go with those above as in the exemplar."""
        others = [
            Other(one.distance < 0, share)
            for one, share in zip(above, self._prepared.overlaps[m], strict=False)
        ]
        elements, tile = self._prepared.elements[m], self._settings.tile
        if self._prepared.endless[m]:
            over = np.any([one.distance < 0 for one in above], axis=0) if above else None
            distance = joined(distance, over, tile, self._ask)
        return mended(
            distance, source, elements, tile, random, self._ask, self._settings.guidance,
            others, evenly=True,
        )  # fmt: skip

    def _energy(self, colours: Colours, distances: Distances, source: Places) -> float:
        """Return the energy of a finished picture, of its smallest neighbourhoods."""
        exemplar = self._prepared.channels
        picture = self._weights.channels(colours, distances)
        where = Neighbourhoods.of(picture.shape[:2], SMALLEST_WINDOW, self._settings.tile)
        start = where.matches(source, exemplar)
        _, costs = matched(picture, exemplar, where, start, self._settings.seed, self._ask)
        return per_pixel(costs, SMALLEST_WINDOW)


def windows(side: int, exemplar: int) -> list[int]:
    """Return the sizes of neighbourhoods for a picture and an exemplar with these sides."""
    most = max(SMALLEST_WINDOW, min(side // 4, exemplar // 2, LARGEST_WINDOW))
    size, sizes = SMALLEST_WINDOW, []
    while size <= most:
        sizes.append(size)
        size *= 2
    return sizes[::-1]


def enlarged(field: NDArray[np.float32], size: tuple[int, int]) -> NDArray[np.float32]:
    """Return a field (h, w) that is interpolated, (H, W)."""
    scale = [wanted / had for wanted, had in zip(size, field.shape, strict=True)]
    large: NDArray[np.float32] = zoom(field, scale, order=1, mode="nearest", grid_mode=True)
    return large


def upsampled(source: Places, shape: tuple[int, ...], exemplar: tuple[int, ...]) -> Places:
    """Return the places (H, W, 2) at twice the resolution, in an exemplar of that shape (h, w)."""
    y, x = np.indices(shape)
    fine = 2 * source[y // 2, x // 2] + np.stack([y % 2, x % 2], axis=2)
    clipped: Places = np.minimum(fine, np.array(exemplar) - 1).astype(np.int32)
    return clipped
