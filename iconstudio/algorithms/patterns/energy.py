"""The energy of a pattern: how its neighbourhoods differ from the exemplar's (equations 1 and 6).

A picture is held as channels, whole numbers in which the weights of equation 6 are contained: the
squared difference of two neighbourhoods is the sum over all their channels, exact and the same on
every machine. The paper does not tell its units. Here colours go from 0 to 1, their differences
are averaged over red, green and blue, and distances go from -1 to 1, at ``REACH`` pixels from a
contour.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TypeVar

import numpy as np
from numpy.typing import NDArray

from iconstudio.algorithms.patterns.exemplar import Colours, Distances

Channels = NDArray[np.int16]
"""(h, w, C), C = 1 or 3 of colours and L of distances."""

Number = TypeVar("Number", np.int16, np.float32)

REACH = 2.0
"""Pixels of the finest resolution at which distances are clamped when they are compared. Farther,
they outweigh the contours themselves: over five exemplars and three seeds, 0.40 of the ink was torn
with 8, 0.35 with 4, and 0.30 with 1.5."""
UNIT = 1000
ALPHA, ALPHA_MONOCHROME = 0.4, 0.1
"""The weight of appearance (section 4)."""


@dataclass(frozen=True, slots=True)
class Weights:
    """How a picture becomes channels, and channels a picture."""

    alpha: float
    grey: bool
    """Whether one channel holds all colours."""

    def channels(self, colours: Colours, distances: Distances) -> Channels:
        """Return the channels (h, w, C) of colours (h, w, 3) and distances (L, h, w)."""
        shown = colours[..., :1] if self.grey else colours
        near = np.moveaxis(np.clip(distances, -REACH, REACH), 0, -1)
        values = np.concatenate([shown * self._colour, near * self._distance], axis=2)
        rounded: Channels = np.rint(values).astype(np.int16)
        return rounded

    def colours(self, channels: NDArray[np.generic]) -> Colours:
        """Return the colours (h, w, 3) of channels (h, w, C)."""
        shown = channels[..., : self.shown].astype(np.float32) / np.float32(self._colour or 1)
        return np.broadcast_to(np.clip(shown, 0, 1), (*shown.shape[:2], 3))

    def distances(self, channels: NDArray[np.generic]) -> Distances:
        """Return the distances (L, h, w) in pixels of channels (h, w, C)."""
        near = channels[..., self.shown :].astype(np.float32) / np.float32(self._distance or 1)
        return np.ascontiguousarray(np.moveaxis(near, -1, 0))

    @property
    def shown(self) -> int:
        """How many channels hold the colours."""
        return 1 if self.grey else 3

    @property
    def _colour(self) -> float:
        return float(UNIT * np.sqrt(self.alpha / self.shown))

    @property
    def _distance(self) -> float:
        return float(UNIT * np.sqrt(1 - self.alpha) / REACH)


def reduced_shape(shape: Sequence[int], factor: int) -> tuple[int, int]:
    """Return the rows and columns of a picture once it is reduced."""
    rows, columns = (-(-length // factor) for length in shape)
    return rows, columns


def reduced(picture: NDArray[Number], factor: int) -> NDArray[Number]:
    """Return the means over squares of a picture (h, w, C); the last ones may be smaller."""
    if factor == 1:
        return picture
    height, width, count = picture.shape
    rows, columns = reduced_shape((height, width), factor)
    missing = (0, rows * factor - height), (0, columns * factor - width), (0, 0)
    whole = np.pad(picture, missing, mode="edge")
    squares = whole.reshape(rows, factor, columns, factor, count)
    mean = squares.mean(axis=(1, 3))
    rounded = np.rint(mean) if picture.dtype == np.int16 else mean
    result: NDArray[Number] = rounded.astype(picture.dtype)
    return result


def per_pixel(costs: NDArray[np.int64], window: int) -> float:
    """Return equation 6 of neighbourhoods with these squared differences, per pixel of them."""
    return float(costs.mean()) / (window**2 * UNIT**2)
