"""What is given and what is made: exemplars with their layers, and patterns (section 3)."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from iconstudio.model import IconstudioError

if TYPE_CHECKING:
    from iconstudio.algorithms.patterns.elements import Elements

Colours = NDArray[np.float32]
"""(h, w, 3), red, green and blue from 0 to 1."""
Masks = NDArray[np.float32]
"""(L, h, w), how much of each pixel the foreground of a layer covers, from 0 to 1."""
Distances = NDArray[np.float32]
"""(L, h, w), signed distances in pixels, negative in the foreground, clamped."""
Places = NDArray[np.int32]
"""(h, w, 2), a row and a column of the exemplar for each pixel."""

Owners = NDArray[np.int32]
"""(L, H, W), a number among elements that are placed, from 1; 0 for none."""

MOST_LAYERS = 8
SMALLEST, LARGEST = 16, 1024
"""Pixels of an exemplar's sides."""


@dataclass(frozen=True, slots=True, eq=False)
class Exemplar:
    """A picture, and its layers in their order: the first occludes all others.

    Raises
    ------
    IconstudioError
        If it cannot be an exemplar.
    """

    colours: Colours
    masks: Masks
    labels: NDArray[np.int32] | None = None
    """(L, h, w), which element each pixel of a layer belongs to, from 1, where that is known."""

    def __post_init__(self) -> None:
        height, width = self.colours.shape[:2]
        if self.masks.shape[1:] != (height, width) or not 1 <= len(self.masks) <= MOST_LAYERS:
            raise IconstudioError(f"An exemplar has 1 to {MOST_LAYERS} layers of its own size.")
        if min(height, width) < SMALLEST:
            raise IconstudioError(
                f"An exemplar of {width} x {height} pixels is too small. "
                f"Give one of at least {SMALLEST} x {SMALLEST}."
            )
        if max(height, width) > LARGEST:
            raise IconstudioError(
                f"An exemplar of {width} x {height} pixels is too large. "
                f"Reduce it to {LARGEST} pixels a side."
            )
        if not (np.isfinite(self.colours).all() and np.isfinite(self.masks).all()):
            raise IconstudioError("The exemplar has pixels that are no numbers.")
        if all(mask.min() > 0.5 or mask.max() < 0.5 for mask in self.masks):
            raise IconstudioError("The exemplar has no contours: give one with several colours.")

    @property
    def monochrome(self) -> bool:
        """Whether nearly all of it is black or white."""
        extreme = (self.colours.min(axis=2) > 0.9) | (self.colours.max(axis=2) < 0.1)
        spread = np.ptp(self.colours, axis=2).max()
        return bool(spread < 0.05 and extreme.mean() > 0.7)


@dataclass(frozen=True, slots=True)
class Placed:
    """An element of the exemplar that stands whole in a pattern, moved by whole pixels."""

    layer: int
    element: int
    """Its number among the elements of its layer, from 0."""
    down: int
    right: int
    label: int
    """Its number among the labels of its layer, from 1."""


@dataclass(frozen=True, slots=True, eq=False)
class Pattern:
    """What is synthesised, or a preview of it."""

    colours: Colours
    distances: Distances
    """Those of its layers: their zero level sets are the contours."""
    energy: float
    """Equation 6, per pixel of all neighbourhoods of the smallest size."""
    torn: float
    """The share of its ink in torn elements, the mean of its layers; not measured of previews."""
    tile: bool
    """Whether opposite borders meet."""
    finished: bool = False
    placed: tuple[Placed, ...] = ()
    owners: Owners | None = None
    """Whose ink each pixel of a layer is, if anything is placed."""
    elements: "Sequence[Elements]" = ()
    """Those of the exemplar's layers, if anything is placed."""
