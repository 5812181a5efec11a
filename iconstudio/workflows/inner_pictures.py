"""The paper's inner pictures: what guides a cut, to be looked at."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from iconstudio.model import Point


@dataclass(frozen=True, eq=False)
class InnerPicture:
    """A field on the canvas, and positions on it."""

    title: str
    values: NDArray[np.float32]
    """(n, n), from 0 to 1."""
    positions: tuple[Point, ...] = ()
    """In canvas units, in their order."""


def scaled(values: NDArray[np.floating]) -> NDArray[np.float32]:
    """Return values moved and scaled to lie between 0 and 1.

    >>> scaled(np.array([2.0, 3.0, 4.0]))
    array([0. , 0.5, 1. ], dtype=float32)
    """
    low, span = values.min(), np.ptp(values)
    between: NDArray[np.float32] = ((values - low) / (span or 1)).astype(np.float32)
    return between
